// Claim: on every shipped case, the discrete kernel convolved with the samples of the case's impulse gives the march on
// the same steps: F_T, the caisson's displacement and the probes' pressures.
// Source: the march itself. Limit 1e-9 of the peak: round-off of some hundred steps of a large system, twice.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "discrete_kernel.h"
#include "record.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace kernel_cases_test {

std::vector<std::string> shipped_cases() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(UPBEAD_CASE_DIR))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// F_T, x_G, and the pressures of all probes.
std::vector<int> compared(const System& system) {
  std::vector<int> readings{system.reading("shear_force"), system.reading("caisson/displacement_x")};
  for (std::size_t i = 0; i < system.readings.size(); ++i) {
    const ReadingName& name = system.readings[i].name;
    if (name.group == "probes" && name.quantity == "pressure") readings.push_back(static_cast<int>(i));
  }
  return readings;
}

int load_named(const System& system, const std::string& name) {
  const auto found =
      std::find_if(system.loads.begin(), system.loads.end(), [&](const SystemLoad& load) { return load.name == name; });
  return static_cast<int>(found - system.loads.begin());
}

/// Records the largest differences; those of pressures over the largest pressure of all probes, because on the axis
/// of a symmetric section pressures are only round-off.
void write_down(Record& record, const std::string& what, const std::vector<std::string>& names,
                const Eigen::MatrixXd& convolved, const Eigen::MatrixXd& marched) {
  const Eigen::VectorXd peak = marched.rowwise().lpNorm<Eigen::Infinity>(),
                        error = (convolved - marched).rowwise().lpNorm<Eigen::Infinity>();
  const double largest_pressure = peak.tail(peak.size() - 2).maxCoeff();
  for (Eigen::Index i = 0; i < peak.size(); ++i) {
    const double size = i < 2 ? peak[i] : largest_pressure;
    EXPECT_GT(size, 0.);
    record.at_most(what + ": " + names[i] + (i < 2 ? ", of its peak" : ", of the peak of all probes"), error[i] / size,
                   1e-9);
  }
}

/// Compares with 16 steps per duration of the triangular impulse, so that its kinks are ends of steps.
void compare(Record& record, const std::string& path) {
  const Case input = read_case(path);
  const Simulation scene = simulation_of(input);
  const System& system = scene.system();
  const int impulse = load_named(system, "impulse");
  const TimeFunction& P = system.loads.at(impulse).history;
  const double step = (P.kinks().back() - P.kinks().front()) / 16.;
  const int n = static_cast<int>(std::ceil(input.scene.time.end / step));

  const std::vector<int> readings = compared(system);
  ASSERT_GE(readings.size(), 4U);
  const Kernel kernel = discrete_kernel(system, {}, impulse, readings, step, n);
  Eigen::VectorXd samples(n + 1);
  for (int i = 0; i <= n; ++i) samples[i] = P(i * step);
  const Eigen::MatrixXd convolved = convolve(kernel, samples);
  const Response response = march(system, *make_scheme(system), {{{0., step, n}}, n * step});
  Eigen::MatrixXd marched(convolved.rows(), convolved.cols());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    marched.row(static_cast<Eigen::Index>(i)) = response.ends.reading.row(readings[i]);
    names.push_back(system.readings[readings[i]].name.text());
  }
  write_down(record, input.stem, names, convolved, marched);
}

TEST(Reduced, KernelOfTheFirstShippedCase) {
  Record record("reduced_kernel");
  compare(record, shipped_cases().front());
}

TEST(Reduced, KernelOfTheOtherShippedCasesAtLength) {
  const std::vector<std::string> paths = shipped_cases();
  ASSERT_GE(paths.size(), 2U);
  Record record("reduced_kernel");
  for (std::size_t i = 1; i < paths.size(); ++i) compare(record, paths[i]);
}

}  // namespace kernel_cases_test
}  // namespace upbead::test
