// Claims: on the shipped prototype with sea, the error of F_T is at most 0.3 % over time and 0.1 % at its peak, with
// at most 30 vectors for damped soil and 45 for undamped soil; the model is stable for any length of time. Source:
// SDIRK of order 4 with 64 steps per duration; A + A^T <= 0. Limits: the tolerances; round-off of |A|.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "algebra/eigenpairs.h"
#include "dynamics/projection.h"
#include "dynamics/state_space.h"
#include "reduced_case.h"

namespace upbead::test {
namespace prototype_test {

constexpr double duration = 0.15, pi = 3.14159265358979323846;
constexpr Limits asked_for{0.003, 0.001};

/// The system projected on `n_vectors` vectors.
ReducedSystem projected(const CompiledScene& compiled, double shift, int n_vectors) {
  SecondOrderKrylov krylov(compiled.system, shift, compiled.body_coordinates);
  while (krylov.n_vectors() < n_vectors && krylov.extend()) continue;
  return Projection(compiled.system, krylov).reduced();
}

TEST(ReducedMarch, PrototypeDampedAtLength) {
  Record record("reduced_march");
  const Simulation scene = simulation_of(prototype());
  const Reduction reduction = reduce_scene(scene.scene(), *scene.compiled(), {true, false, {}});
  ASSERT_TRUE(reduction.converged);
  write_down(record, "shipped prototype",
             error_against(reduction.model, scene.system(), scene.scene().time.end, duration / 64.), asked_for);
  record.at_most("shipped prototype: vectors", reduction.n_vectors, 30);
}

TEST(ReducedMarch, PrototypeUndampedAtLength) {
  Record record("reduced_march");
  const Simulation scene =
      simulation_of(prototype({"regions.seabed.damping.ratio=0", "regions.mound.damping.ratio=0"}));
  const ReducedSystem reduced = projected(*scene.compiled(), 1.75 * 2. * pi / duration, 45);
  const ModalModel model = modal_model(state_space(reduced), reduced);
  write_down(record, "shipped prototype without damping, 45 vectors",
             error_against(model, scene.system(), scene.scene().time.end, duration / 64.), asked_for);
}

/// Largest growth of |s| within one of 400 steps of a 50th of a duration, from a state after the loads.
double growth(const StateSpace& space) {
  const Eigen::MatrixXd P = (duration / 50. * space.A).exp();
  Eigen::VectorXd s = P * space.B.rowwise().sum();
  double largest = 0.;
  for (int i = 0; i < 400; ++i) {
    const double before = s.norm();
    s = P * s;
    largest = std::max(largest, s.norm() / before);
  }
  return largest;
}

/// Largest ratio over all readings: the reading in the last of 1e6 s over its largest value in the first two seconds.
double left_after_decay(const ModalModel& model, const System& system) {
  std::vector<double> time;
  for (int i = 0; i <= 1000; ++i) time.push_back(duration / 75. * i);
  const auto early = static_cast<Eigen::Index>(time.size());
  for (const double t : {1e2, 1e4, 1e5, 1e6 - 1., 1e6}) time.push_back(t);
  std::vector<TimeFunction> histories;
  for (const SystemLoad& load : system.loads) histories.push_back(load.history);
  const Eigen::MatrixXd y = respond(model, sample(histories, time)).reading;
  const Eigen::VectorXd start = y.leftCols(early).cwiseAbs().rowwise().maxCoeff(),
                        last = y.rightCols(2).cwiseAbs().rowwise().maxCoeff();
  return y.allFinite() ? last.cwiseQuotient(start).maxCoeff() : std::nan("");
}

TEST(ReducedStability, Prototype) {
  Record record("reduced_stability");
  for (const bool damped : {true, false}) {
    const std::string what = damped ? "damped: " : "undamped: ";
    const Simulation scene = simulation_of(prototype(
        damped ? std::vector<std::string>{}
               : std::vector<std::string>{"regions.seabed.damping.ratio=0", "regions.mound.damping.ratio=0"}));
    const ReducedSystem reduced = projected(*scene.compiled(), (damped ? 1.25 : 1.75) * 2. * pi / duration, 45);
    const StateSpace space = state_space(reduced);
    const ModalModel model = modal_model(space, reduced);
    const Eigen::MatrixXd symmetric = 0.5 * (space.A + space.A.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric, Eigen::EigenvaluesOnly);
    const double size = space.A.norm();
    record.at_most(what + "largest eigenvalue of (A + A^T)/2, over norm(A)", eigen.eigenvalues().maxCoeff() / size,
                   1e-12);
    record.at_most(what + "largest real part of a pole, over norm(A)",
                   eigenpairs(space.A).value.real().maxCoeff() / size, 1e-12);
    record.at_most(what + "largest real part of a mode's pole (1/s)", model.pole.real().maxCoeff(), 0.);
    record.at_most(what + "root of the energy after a step without load, over that before, minus 1", growth(space) - 1.,
                   1e-12);
    record.at_most(what + "readings after 1e6 s, of their largest before", left_after_decay(model, scene.system()), 1.);
  }
}

}  // namespace prototype_test
}  // namespace upbead::test
