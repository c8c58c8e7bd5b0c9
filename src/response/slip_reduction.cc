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

/// F_T is cut off there for training, as friction would.
constexpr double cut_off = 0.7;
/// Per independent load: more cost more than what they are worth, as eigenvalues take the cube of their number.
constexpr int most_vectors = 60;

}  // namespace

SlipProblem slip_problem(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, const Series& bonded) {
  if (!compiled.system.interface || !compiled.caisson)
    throw std::invalid_argument("a scene whose caisson slips needs an interface under it");
  SlipProblem problem{with_rigid_slip(compiled.system), {}};
  const int slip = problem.system.n_free() - 1;
  add_slip(problem.system, slip);
  const Eigen::RowVectorXd shear = bonded.reading.row(compiled.system.reading(reading::shear_force));
  const double limit = cut_off * shear.cwiseAbs().maxCoeff();

  ReduceOptions& options = problem.options;
  options.shift = krylov_shift(scene);
  options.exact = compiled.body_coordinates;
  options.exact.push_back(slip);
  const SampledLoads loads = sampled_loads(scene, compiled.system);
  Eigen::RowVectorXd cut(static_cast<Eigen::Index>(loads.time.size()));
  for (std::size_t i = 0; i < loads.time.size(); ++i)
    cut[static_cast<Eigen::Index>(i)] = std::clamp(value_at(bonded.time, shear, loads.time[i]), -limit, limit);
  options.training = with_load(loads, cut);
  options.measured = {0, 1, 2, 3};
  options.tolerance = scene.tolerance;
  options.max_vectors = most_vectors;
  options.tolerance_of_others = infinity;
  options.model = [uplift](const ReducedSystem& reduced) {
    return stuck_and_free(reduced, slip_law(reduced, 1., uplift));
  };
  return problem;
}

SlipReduction reduce_slip(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, const Series& bonded,
                          const std::function<void(double)>& progress) {
  SlipProblem problem = slip_problem(scene, compiled, uplift, bonded);
  problem.options.progress = progress;
  Reduction reduction = reduce(problem.system, problem.options);
  const Eigen::RowVectorXd shear = bonded.reading.row(compiled.system.reading(reading::shear_force));
  const Eigen::RowVectorXd stuck =
      respond(reduction.model, sample(load_histories(problem.system), bonded.time)).reading.row(0);
  const double bonded_error = (stuck - shear).cwiseAbs().maxCoeff() / shear.cwiseAbs().maxCoeff();
  return {std::move(reduction.system), reduction.error,     bonded_error,
          reduction.converged,         reduction.n_vectors, reduction.n_solves,
          reduction.factorise_seconds};
}

}  // namespace upbead
