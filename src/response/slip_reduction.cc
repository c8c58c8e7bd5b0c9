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

ReduceOptions untrained_options(const Scene& scene, UpliftKind uplift) {
  ReduceOptions options;
  options.shift = krylov_shift(scene);
  options.measured = {0, 1, 2, 3};
  options.tolerance = scene.tolerance;
  options.max_vectors = most_vectors;
  options.tolerance_of_others = infinity;
  options.model = [uplift](const ReducedSystem& reduced) {
    return stuck_and_free(reduced, slip_law(reduced, 1., uplift));
  };
  return options;
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

ReduceOptions slip_options(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, const Series& bonded) {
  ReduceOptions options = untrained_options(scene, uplift);
  options.training = training(scene, compiled, bonded);
  return options;
}

std::shared_ptr<SlipBasis> slip_basis(const Scene& scene, const CompiledScene& compiled, const SlipSystem& slips,
                                      std::shared_ptr<GrowingBasis> bonded) {
  if (!bonded) {
    ReduceOptions options;
    options.shift = krylov_shift(scene);
    options.exact = compiled.body_coordinates;
    bonded = std::make_shared<GrowingBasis>(compiled.system, options);
  }
  return std::make_shared<SlipBasis>(std::move(bonded), slip_row(slips.system));
}

SlipSpace::SlipSpace(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift,
                     std::shared_ptr<SlipBasis> basis)
    : scene_(scene), compiled_(compiled), basis_(std::move(basis)), model_(basis_, untrained_options(scene, uplift)) {}

SlipSpace::SlipSpace(const Scene& scene, const CompiledScene& compiled, const SlipSystem& slips, UpliftKind uplift)
    : SlipSpace(scene, compiled, uplift, slip_basis(scene, compiled, slips)) {}

SlipReduction SlipSpace::reduce(const Series& bonded, const std::function<void(double)>& progress) {
  model_.train(training(scene_, compiled_, bonded), progress);
  while (!model_.reduction().converged && model_.grow()) {
  }
  Reduction reduction = model_.finish();
  const Eigen::RowVectorXd shear = shear_of(bonded, compiled_);
  std::vector<TimeFunction> histories = load_histories(compiled_.system);
  histories.emplace_back();  // no F_T beyond what holds the caisson
  const Eigen::RowVectorXd stuck = respond(reduction.model, sample(histories, bonded.time)).reading.row(0);
  const double bonded_error = (stuck - shear).cwiseAbs().maxCoeff() / shear.cwiseAbs().maxCoeff();
  return {std::move(reduction.system), reduction.error,     bonded_error,
          reduction.converged,         reduction.n_vectors, reduction.n_solves,
          reduction.factorise_seconds};
}

SlipReduction reduce_slip(const Scene& scene, const CompiledScene& compiled, UpliftKind uplift, const Series& bonded,
                          const std::function<void(double)>& progress) {
  const SlipSystem slips = slip_system(compiled);
  CompiledScene glued = compiled;
  glued.system = upbead::bonded(compiled.system);
  return SlipSpace(scene, glued, slips, uplift).reduce(bonded, progress);
}

}  // namespace upbead
