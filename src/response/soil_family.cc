#include "response/soil_family.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/interrupt.h"
#include "base/numbers.h"
#include "base/progress.h"
#include "dynamics/projection.h"
#include "dynamics/snapshot_basis.h"
#include "fem/caisson/reading_names.h"
#include "response/reduction.h"
#include "response/slip_reduction.h"
#include "system/interface.h"

namespace upbead {

namespace {

/// What a basis may leave of the snapshots of a point, in the norm of each kind of unknowns.
constexpr double rest_of_point = 1e-5;
constexpr int most_frequencies = 64;
/// Frequencies go up to this multiple of the loads' band.
constexpr double beyond_band = 1.3;
/// Estimates that are found side by side.
constexpr std::size_t estimates_at_once = 4;
/// Tolerance of the small system's own reduction, over that of the family.
constexpr double share_of_member = 0.2;

SnapshotOptions snapshot_options(const Scene& scene, const CompiledScene& compiled) {
  SnapshotOptions options;
  options.shift = krylov_shift(scene);
  options.exact = compiled.body_coordinates;
  const SampledLoads loads = sampled_loads(scene, compiled.system);
  options.frequencies = snapshot_frequencies(loads.time.back(), beyond_band * bandwidth(scene), most_frequencies);
  options.weights = snapshot_weights(loads, options.frequencies);
  const Eigen::RowVectorXd any = options.weights.colwise().maxCoeff();
  for (Eigen::Index k = 0; k < options.weights.rows(); ++k)
    if (options.weights.row(k).isZero(0.)) options.weights.row(k) = any;  // of F_T, which is known later
  return options;
}

/// The scene as it is marked for a member's own reduction.
Scene for_member(Scene scene, double tolerance) {
  scene.tolerance = share_of_member * tolerance;
  return scene;
}

Eigen::RowVectorXd shear_of(const SoilFamily& family, const Scene& scene, const Factors& factors, double share) {
  const CompiledScene compiled = family.at(factors, share);
  ReductionTargets targets;
  targets.only_shear = true;
  targets.first_vectors = first_of_member;
  targets.most_vectors = most_of_member;
  const Reduction reduction = reduce_scene(scene, compiled, targets);
  const Series series = respond(reduction.model, sampled_loads(scene, compiled.system));
  return series.reading.row(compiled.system.reading(reading::shear_force));
}

/// Basis and projections, which grow point by point.
class Builder {
 public:
  Builder(const Scene& scene, const AffineScene& affine, const Factors& first)
      : affine_(affine),
        snapshots_(snapshot_options(scene, affine.fixed)),
        basis_(affine.at(first).system, snapshots_.shift, snapshots_.exact) {
    projections_.reserve(affine.parts.size() + 1);
    add_projection(affine.fixed.system);
    for (const System& part : affine.parts) add_projection(part);
  }

  void add_point(const Factors& factors, const std::function<void(double)>& progress) {
    snapshots_.progress = progress;
    basis_.add(snapshots(affine_.at(factors).system, snapshots_), rest_of_point);
    for (Projection& projection : projections_) projection.extend();
  }

  SoilFamily family() const {
    ReducedFamily reduced{projections_.front().reduced(), {}, basis_.n_kept()};
    for (std::size_t q = 1; q < projections_.size(); ++q) reduced.parts.push_back(projections_[q].reduced());
    return {rotated(reduced, basis_.sorting()), without_matrices(affine_.fixed)};
  }

 private:
  void add_projection(const System& part) {
    projections_.emplace_back(part, basis_.displacements(), basis_.phi(), snapshots_.shift);
  }

  static CompiledScene without_matrices(CompiledScene compiled) {
    for (SparseMatrix* A : {&compiled.system.M, &compiled.system.C, &compiled.system.K, &compiled.system.radiation})
      A->resize(0, 0);
    return compiled;
  }

  const AffineScene& affine_;
  SnapshotOptions snapshots_;
  SnapshotBasis basis_;
  std::vector<Projection> projections_;  ///< of what is fixed, then of the parts
};

}  // namespace

CompiledScene SoilFamily::at(const Factors& factors, double share) const {
  ReducedSystem member = reduced.at(factors);
  if (share < 1.) member = leading(member, reduced.n_kept, share);
  CompiledScene compiled = like;
  compiled.system = as_system(member, like.system);
  for (std::size_t i = 0; i < compiled.body_coordinates.size(); ++i)
    compiled.body_coordinates[i] = unknown_of(member, member.n_prescribed + static_cast<int>(i));
  return compiled;
}

double family_error(const SoilFamily& family, const Scene& scene, const Factors& factors) {
  const Eigen::RowVectorXd all = shear_of(family, scene, factors, 1.);
  const Eigen::RowVectorXd fewer = shear_of(family, scene, factors, nested_share);
  return nested_safety * (all - fewer).cwiseAbs().maxCoeff() / all.cwiseAbs().maxCoeff();
}

namespace {

/// The candidate with the largest estimate: those that were far off before come first, and one whose older estimate is
/// below the largest new one is not looked at again, as estimates fall with every point.
std::pair<int, double> worst_candidate(const SoilFamily& family, const Scene& scene, const SoilFamilyOptions& options,
                                       std::vector<double>& estimates) {
  std::vector<std::size_t> order(estimates.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return estimates[a] > estimates[b]; });
  double largest = 0.;
  std::size_t worst = order.front();
  for (std::size_t i = 0; i < order.size() && estimates[order[i]] > largest; i += estimates_at_once) {
    const std::size_t n = std::min(estimates_at_once, order.size() - i);
    in_parallel(n, "", [&](std::size_t j) {
      double& estimate = estimates[order[i + j]];
      estimate = family_error(family, scene, options.candidates[order[i + j]]);
    });
    for (std::size_t j = i; j < i + n; ++j)
      if (estimates[order[j]] > largest) largest = estimates[worst = order[j]];
  }
  return {static_cast<int>(worst), largest};
}

}  // namespace

SoilFamilyMade make_soil_family(const Scene& scene, const AffineScene& affine, const SoilFamilyOptions& options) {
  const Scene member = for_member(scene, options.tolerance);
  Builder builder(scene, affine, options.candidates.front());
  SoilFamilyMade made;
  std::vector<double> estimates(options.candidates.size(), infinity);
  int next = 0;
  while (true) {
    check_interrupt();
    const double begin = static_cast<double>(made.points.size()) / options.most_points;
    const double end = begin + 1. / options.most_points;
    made.points.push_back(next);
    builder.add_point(options.candidates[static_cast<std::size_t>(next)],
                      part_of(options.progress, begin, 0.5 * (begin + end)));
    made.family = builder.family();
    const auto [worst, largest] = worst_candidate(made.family, member, options, estimates);
    made.estimates.push_back(largest);
    if (largest <= options.tolerance || static_cast<int>(made.points.size()) == options.most_points) return made;
    next = worst;
  }
}

SoilFamily soil_family(const Scene& scene, const AffineScene& affine, const std::vector<Factors>& points,
                       const std::function<void(double)>& progress) {
  Builder builder(scene, affine, points.front());
  const auto n = static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    check_interrupt();
    builder.add_point(points[i], part_of(progress, static_cast<double>(i) / n, static_cast<double>(i + 1) / n));
  }
  return builder.family();
}

AffineScene with_slip(const AffineScene& affine) {
  AffineScene out{affine.fixed, affine.terms, {}};
  SlipSystem slips = slip_system(affine.fixed);
  out.fixed.system = std::move(slips.system);
  out.fixed.body_coordinates = std::move(slips.exact);
  for (const System& part : affine.parts) {
    System slipping = with_rigid_slip(part);
    // what add_slip() adds is fixed
    slipping.loads.push_back({slip_name::friction, {}, {}, -1});
    for (SystemLoad& load : slipping.loads) load.vector.resize(0);
    while (slipping.readings.size() < out.fixed.system.readings.size()) slipping.readings.emplace_back();
    out.parts.push_back(std::move(slipping));
  }
  return out;
}

}  // namespace upbead
