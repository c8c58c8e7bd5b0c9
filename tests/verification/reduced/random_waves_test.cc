// Claim: one reduced model of the shipped prototype, made with the case's own triangle, has the response to other,
// random waves within its tolerance.
// Source: the discrete kernel of SDIRK, steps of 2 ms, convolved with the samples. Limit: the tolerance of 0.5 % of the
// wave's own peak F_T.

#include "random_waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "discrete_kernel.h"
#include "reduced_case.h"

namespace upbead::test {
namespace random_waves_test {

constexpr double step = 0.002;
constexpr int n = 501;

/// Loads straight between samples, the same from both sides.
SampledLoads sampled(const Eigen::VectorXd& force) {
  SampledLoads loads;
  for (int i = 0; i < n; ++i) loads.time.push_back(i * step);
  loads.begin = force.head(n - 1).transpose();
  loads.end = force.tail(n - 1).transpose();
  return loads;
}

TEST(ReducedWaves, OfThePrototypeAtLength) {
  const Simulation scene = simulation_of(prototype());
  const System& system = scene.system();
  ASSERT_EQ(system.loads.size(), 1u);
  const Reduction reduction = reduce_scene(scene.scene(), *scene.compiled(), {true, true, {}});
  ASSERT_TRUE(reduction.converged);
  const int shear = system.reading("shear_force");
  const Kernel kernel = discrete_kernel(system, {}, 0, {shear}, step, n - 1);

  std::map<std::string, std::vector<double>> errors;
  for (const RandomWave& wave : random_waves(13, step, n)) {
    const Eigen::RowVectorXd truth = convolve(kernel, wave.force).row(0);
    const Eigen::RowVectorXd found = respond(reduction.model, sampled(wave.force)).reading.row(shear);
    errors[wave.kind].push_back((found - truth).cwiseAbs().maxCoeff() / truth.cwiseAbs().maxCoeff());
  }
  Record record("reduced_waves");
  for (auto& [kind, list] : errors) {
    std::sort(list.begin(), list.end());
    record.at_most(kind + ": F_T over time, of its peak, largest of " + std::to_string(list.size()), list.back(),
                   0.005);
    record.measured(kind + ": F_T over time, of its peak, median", list[list.size() / 2]);
  }
}

}  // namespace random_waves_test
}  // namespace upbead::test
