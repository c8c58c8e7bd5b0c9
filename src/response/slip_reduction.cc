#include "response/slip_reduction.h"

#include <algorithm>
#include <stdexcept>

#include "base/numbers.h"
#include "fem/caisson/reading_names.h"
#include "response/reduction.h"
#include "system/interface.h"
#include "upbead/base/history.h"

namespace upbead {

namespace {

/// Share of its peak at which F_T is cut off for training, as friction would do.
constexpr double cut_off = 0.7;
/// Per independent load: more vectors cost more than they gain, as the work for eigenvalues grows as the cube of
/// their number.
constexpr int most_vectors = 60;

/// The problem without its training.
SlipProblem untrained_problem(const Scene& scene, SlipSystem slips, UpliftKind uplift) {
  SlipProblem problem{std::move(slips.system), {}};
  ReduceOptions& options = problem.options;
  options.shift = krylov_shift(scene);
  options.exact = std::move(slips.exact);
  options.measured = {0, 1, 2, 3};
  options.tolerance = scene.tolerance;
  options.max_vectors = most_vectors;
  options.tolerance_of_others = infinity;
  options.model = [uplift](const ReducedSystem& reduced) {
    return stuck_and_free(reduced, slip_law(reduced, 1., uplift));
  };
  return problem;
}

Eigen::RowVectorXd shear_of(const Series& bonded, const CompiledScene& compiled) {
  return bonded.reading.row(compiled.system.reading(reading::shear_force));
}

/// The scene's loads, and F_T with its peaks cut off.
SampledLoads training(const Scene& scene, const CompiledScene& compiled, const Series& bonded) {
  const Eigen::RowVectorXd shear = shear_of(bonded, compiled);
  const double limit = cut_off * shear.cwiseAbs().maxCoeff();
  const SampledLoads loads = sampled_loads(scene, compiled.system);
  Eigen::RowVectorXd cut(static_cast<Eigen::Index>(loads.time.size()));
  for (std::size_t i = 0; i < loads.time.size(); ++i)
    cut[static_cast<Eigen::Index>(i)] = std::clamp(value_at(bonded.time, shear, loads.time[i]), -limit, limit);
  return with_load(loads, cut);
}

}  // namespace

SlipSystem slip_system(const CompiledScene& compiled) {
  if (!compiled.system.interface || !compiled.caisson)
    throw std::invalid_argument("a scene whose caisson slips needs an interface under it");
  SlipSystem out{with_rigid_slip(compiled.system), compiled.body_coordinates};
  const int slip = out.system.n_free() - 1;
  add_slip(out.system, slip);
  out.exact.push_back(slip);
  return out;
}

SlipProblem slip_problem(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, const Series& bonded) {
  SlipProblem problem = untrained_problem(scene, slip_system(compiled), uplift);
  problem.options.training = training(scene, compiled, bonded);
  return problem;
}

SlipSpace::SlipSpace(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift)
    : SlipSpace(scene, compiled, slip_system(compiled), uplift) {}

SlipSpace::SlipSpace(const Scene& scene, const CompiledScene& compiled, SlipSystem slips, UpliftKind uplift)
    : scene_(scene),
      compiled_(compiled),
      problem_(untrained_problem(scene, std::move(slips), uplift)),
      model_(problem_.system, problem_.options) {
  model_.prepare();
}

SlipReduction SlipSpace::reduce(const Series& bonded, const std::function<void(double)>& progress) {
  model_.train(training(scene_, compiled_, bonded), progress);
  while (!model_.reduction().converged && model_.grow()) {
  }
  Reduction reduction = model_.finish();
  const Eigen::RowVectorXd shear = shear_of(bonded, compiled_);
  const Eigen::RowVectorXd stuck =
      respond(reduction.model, sample(load_histories(problem_.system), bonded.time)).reading.row(0);
  const double bonded_error = (stuck - shear).cwiseAbs().maxCoeff() / shear.cwiseAbs().maxCoeff();
  return {std::move(reduction.system), reduction.error,     bonded_error,
          reduction.converged,         reduction.n_vectors, reduction.n_solves,
          reduction.factorise_seconds};
}

SlipReduction reduce_slip(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, const Series& bonded,
                          const std::function<void(double)>& progress) {
  return SlipSpace(scene, compiled, uplift).reduce(bonded, progress);
}

}  // namespace upbead
