#include "response/soil_family.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "base/interrupt.h"
#include "base/numbers.h"
#include "base/progress.h"
#include "dynamics/basis.h"
#include "dynamics/growing_model.h"
#include "dynamics/projection.h"
#include "dynamics/snapshot_basis.h"
#include "fem/caisson/reading_names.h"
#include "response/held_readings.h"
#include "response/reduction.h"
#include "system/interface.h"

namespace upbead {

namespace {

/// Vectors of a point per independent load or reading, whose spaces have much in common.
constexpr int vectors_of_load = 40;
/// What a basis may leave of the snapshots of a point, in the norm of each kind of unknowns.
constexpr double rest_of_point = 3e-6;
constexpr int most_of_frequencies = 64;
/// Frequencies go up to this multiple of the loads' band.
constexpr double beyond_band = 1.3;
/// Estimates that are found side by side, and points that are solved so.
constexpr std::size_t estimates_at_once = 4, points_at_once = 2;
constexpr std::size_t judged_from = 2 * points_at_once;  ///< points whose last ones were judged before they became some

SnapshotOptions snapshot_options(const Scene& scene, const CompiledScene& compiled) {
  SnapshotOptions options;
  options.shift = krylov_shift(scene);
  options.exact = compiled.body_coordinates;
  options.vectors = vectors_of_load;
  const SampledLoads loads = sampled_loads(scene, compiled.system);
  options.frequencies = snapshot_frequencies(loads.time.back(), beyond_band * bandwidth(scene), most_of_frequencies);
  options.weights = snapshot_weights(loads, options.frequencies);
  const Eigen::RowVectorXd any = options.weights.colwise().maxCoeff();
  for (Eigen::Index k = 0; k < options.weights.rows(); ++k)
    if (options.weights.row(k).isZero(0.)) options.weights.row(k) = any;  // of F_T, which is known later
  options.n_readings = n_readings_as_loads;
  options.weights.conservativeResize(options.weights.rows() + n_readings_as_loads, Eigen::NoChange);
  options.weights.bottomRows(n_readings_as_loads).rowwise() = any;
  return options;
}

/// The scene as it is marked for a member's own reduction.
Scene for_member(Scene scene, double tolerance) {
  scene.tolerance = share_of_member * tolerance;
  return scene;
}

/// The scene of a member: `names` says what its loads and readings are called.
CompiledScene small_scene(const SoilFamily& family, const ReducedSystem& member, const System& names) {
  CompiledScene compiled = family.like;
  compiled.system = as_system(member, names);
  for (std::size_t i = 0; i < compiled.body_coordinates.size(); ++i)
    compiled.body_coordinates[i] = unknown_of(member, member.n_prescribed + static_cast<int>(i));
  return compiled;
}

/// How the histories are found that a family holds to its tolerance.
ReduceOptions held_options(const Scene& scene, const CompiledScene& member, std::size_t n_held) {
  ReductionTargets targets;
  targets.first_vectors = first_of_member;
  targets.most_vectors = most_of_member;
  ReduceOptions options = reduce_options(scene, member, targets);
  options.measured.resize(n_held);
  std::iota(options.measured.begin(), options.measured.end(), 0);
  return options;
}

/// The response of a model that has grown as far as it must.
Eigen::MatrixXd histories_of(GrowingModel&& model, const ReduceOptions& options) {
  while (!model.reduction().converged && model.grow()) {
  }
  return respond(model.reduction().model, options.training).reading;
}

/// Histories that the family holds to its tolerance, under the scene's own loads.
Eigen::MatrixXd held_histories(const SoilFamily& family, const Scene& scene, const Factors& factors, double share) {
  ReducedSystem member = family.reduced.bonded(factors, share);
  const HeldReadings held = held_readings(member.reading_label, family.like.caisson->bottom_width);
  member = with_readings(std::move(member), held.sums, held.labels);
  const CompiledScene compiled =
      with_courses(small_scene(family, member, names_of(member, family.like.system.loads)), scene);
  const ReduceOptions options = held_options(scene, compiled, held.labels.size());
  return histories_of(GrowingModel(compiled.system, options), options);
}

/// The same of a member in all directions, in a space that its answer goes on with: what is held are sums of the
/// readings of its modes.
Eigen::MatrixXd held_histories(const Scene& scene, const CompiledScene& member, BasisRoom& room) {
  ReduceOptions options = held_options(scene, member, 0);
  const std::shared_ptr<GrowingBasis> basis = room.basis(member.system, options);
  std::optional<HeldReadings> held;
  std::size_t look = 0;
  options.model = [&](const ReducedSystem& reduced) {
    if (!held) held = held_readings(reduced.reading_label, member.caisson->bottom_width);
    ModalModel model = basis->modes(look++, Kept::pressures).model;
    model.reading = held->sums * model.reading;
    for (Eigen::MatrixXd* direct : {&model.feedthrough, &model.impulse}) *direct = held->sums * *direct;
    model.reading_label = held->labels;
    return model;
  };
  options.measured = {0, 1, 2, 3};
  return histories_of(GrowingModel(std::static_pointer_cast<Looks>(basis), options), options);
}

void count_slip(SoilFamily& family) {
  const System &bonded = family.like.system, &slips = *family.slipping;
  family.reduced.slip_loads = static_cast<int>(slips.loads.size() - bonded.loads.size());
  family.reduced.slip_readings = static_cast<int>(slips.readings.size() - bonded.readings.size());
}

/// Largest difference of a history over its largest value in `exact`.
double difference(const Eigen::MatrixXd& y, const Eigen::MatrixXd& exact) {
  const Eigen::VectorXd far = (y - exact).cwiseAbs().rowwise().maxCoeff(),
                        largest = exact.cwiseAbs().rowwise().maxCoeff();
  return (largest.array() > 0.).select(far.cwiseQuotient(largest), 0.).maxCoeff();
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

  /// Solves the soils side by side; returns each in its own Krylov space.
  std::vector<ReducedSystem> add_points(const std::vector<Factors>& points,
                                        const std::function<void(double)>& progress) {
    std::vector<Snapshots> found(points.size());
    in_parallel(points.size(), "", [&](std::size_t i) {
      SnapshotOptions options = snapshots_;
      if (i == 0) options.progress = progress;
      found[i] = snapshots(with_readings_as_loads(affine_.at(points[i]).system), options);
    });
    for (const Snapshots& of_point : found) basis_.add(of_point, rest_of_point);
    for (Projection& projection : projections_) projection.extend();
    std::vector<ReducedSystem> own;
    for (Snapshots& of_point : found) own.push_back(without_last(std::move(of_point.own), n_readings_as_loads, 0));
    return own;
  }

  void tell(SoilFamily& family) const {
    const Eigen::MatrixXd sorting = basis_.sorting();
    ReducedFamily reduced{projections_.front().reduced(), {}, basis_.n_kept(), 0, 0, family.reduced.safety};
    for (std::size_t q = 1; q < projections_.size(); ++q) reduced.parts.push_back(projections_[q].reduced());
    family.reduced = rotated(reduced, sorting);
    family.phi = basis_.phi_in(sorting);
    if (family.slipping) count_slip(family);
  }

 private:
  void add_projection(const System& part) {
    projections_.emplace_back(part, basis_.displacements(), basis_.phi(), snapshots_.shift);
  }

  const AffineScene& affine_;
  SnapshotOptions snapshots_;
  SnapshotBasis basis_;
  std::vector<Projection> projections_;  ///< of what is fixed, then of the parts
};

}  // namespace

System without_matrices(System system) {
  for (SparseMatrix* A : {&system.M, &system.C, &system.K, &system.radiation}) A->resize(0, 0);
  return system;
}

CompiledScene SoilFamily::at(const Factors& factors, double share) const {
  return small_scene(*this, reduced.bonded(factors, share), like.system);
}

SlipSystem SoilFamily::slips_at(const Factors& factors) const {
  const ReducedSystem member = reduced.at(factors);
  SlipSystem out{as_system(member, *slipping), {}};
  for (int i = member.n_prescribed; i < reduced.n_kept; ++i) out.exact.push_back(unknown_of(member, i));
  return out;
}

double family_error(const SoilFamily& family, const Scene& scene, const Factors& factors) {
  const Eigen::MatrixXd all = held_histories(family, scene, factors, 1.);
  return family.reduced.safety * difference(held_histories(family, scene, factors, nested_share), all);
}

double family_error(const SoilFamily& family, const Scene& scene, const Factors& factors, const CompiledScene& member,
                    BasisRoom& room) {
  const Eigen::MatrixXd all = held_histories(scene, member, room);
  return family.reduced.safety * difference(held_histories(family, scene, factors, nested_share), all);
}

namespace {

/// What was true of a soil before it became a point.
struct Judged {
  double error = 0.;   ///< of the histories of held_readings() over their peaks
  double nested = 0.;  ///< difference of nested members
};

/// `own`: the soil in its own Krylov space.
Judged judge(const SoilFamily& family, const Scene& scene, const Factors& soil, const ReducedSystem& own) {
  SoilFamily alone{{own, {}, family.reduced.n_kept}, {}, family.like, family.slipping};
  if (alone.slipping) count_slip(alone);
  const Eigen::MatrixXd exact = held_histories(alone, scene, {}, 1.), all = held_histories(family, scene, soil, 1.);
  return {difference(all, exact), difference(held_histories(family, scene, soil, nested_share), exact)};
}

/// What the points told of the family before they became points, see docs/soils.md.
class Proofs {
 public:
  explicit Proofs(double tolerance) : tolerance_(tolerance) {}

  /// Looks at points that the family does not hold yet; returns whether all of them met the tolerance.
  bool see(const SoilFamily& family, const Scene& scene, const std::vector<Factors>& points,
           const std::vector<ReducedSystem>& own) {
    if (family.reduced.fixed.size() == 0) return false;  // none is made yet
    std::vector<double> ratios;
    bool all_met = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Judged judged = judge(family, scene, points[i], own[i]);
      ratios.push_back(judged.error / std::max(judged.nested, least_nested * tolerance_));
      all_met = all_met && judged.error <= tolerance_;
    }
    before_ = std::exchange(latest_, *std::max_element(ratios.begin(), ratios.end()));
    return all_met;
  }
  /// By the last two rounds.
  double safety() const { return std::max(nested_safety, over_judged * std::max(before_, latest_)); }

 private:
  static constexpr double over_judged = 1.3;    ///< the estimate stays above the largest error that was seen
  static constexpr double least_nested = 0.02;  ///< of the tolerance: nested members that agree so well tell nothing

  double tolerance_, before_ = 0., latest_ = 0.;
};

/// By the logarithms of factors.
double square_of_distance(const Factors& one, const Factors& other) {
  double square = 0.;
  for (std::size_t q = 0; q < one.size(); ++q)
    if (one[q] > 0. && other[q] > 0.) square += std::pow(std::log(one[q] / other[q]), 2);
  return square;
}

double tolerable_estimate(const SoilFamilyOptions& options) {
  return options.of_estimates.value_or(options.tolerance);
}

/// Which candidates are far off, and how far.
class Candidates {
 public:
  Candidates(const Scene& scene, const SoilFamilyOptions& options)
      : scene_(scene), options_(options), estimates_(options.candidates.size(), infinity) {}

  /// The first candidate, and one that is unlike.
  std::vector<int> first() const {
    const int other = most_unlike({0});
    return other < 0 ? std::vector<int>{0} : std::vector<int>{0, other};
  }
  /// Soils to be solved next: the one with the largest estimate, where one exceeds the tolerance, and others that are
  /// as unlike all points as can be, of which an estimate knows least. After the first round these alone, as estimates
  /// would cost what they tell.
  std::vector<int> next(const SoilFamily& family, std::size_t n) {
    std::vector<int> list = goes_on() ? std::vector<int>{} : worst(family, 1);
    while (list.size() < n) {
      const int other = most_unlike(list);
      if (other < 0) break;
      list.push_back(other);
    }
    return list;
  }
  /// Older estimates are kept as bounds; with another factor they are other numbers.
  void scale(double by) {
    for (double& estimate : estimates_) estimate *= by;
  }

  /// The candidates with the largest estimates that are no points yet. Those that were far off before are looked at
  /// first, and one whose older estimate is below the largest new one is not looked at again, as estimates fall with
  /// every point.
  std::vector<int> worst(const SoilFamily& family, std::size_t n) {
    double largest = 0.;
    std::size_t looked = 0;
    const std::vector<std::size_t> order = by_estimate();
    for (; looked < order.size() && (looked < n || estimates_[order[looked]] > largest);
         looked = std::min(looked + estimates_at_once, order.size())) {
      const std::size_t many = std::min(estimates_at_once, order.size() - looked);
      in_parallel(many, "", [&](std::size_t j) {
        estimates_[order[looked + j]] = family_error(family, scene_, options_.candidates[order[looked + j]]);
      });
      for (std::size_t j = looked; j < looked + many; ++j) largest = std::max(largest, estimates_[order[j]]);
    }
    std::vector<int> list;
    for (const std::size_t i : by_estimate())
      if (list.size() < n && estimates_[i] > tolerable_estimate(options_) && points_.count(i) == 0)
        list.push_back(static_cast<int>(i));
    return list;
  }
  double largest() const { return *std::max_element(estimates_.begin(), estimates_.end()); }
  Factors take(int candidate) {
    points_.insert(static_cast<std::size_t>(candidate));
    return options_.candidates[static_cast<std::size_t>(candidate)];
  }

 private:
  /// Whether more points follow whatever estimates say, as the errors of the first ones were never judged.
  bool goes_on() const {
    return points_.size() < judged_from &&
           judged_from <= std::min(options_.candidates.size(), static_cast<std::size_t>(options_.most_points));
  }
  /// The candidate that is farthest from the nearest point, and from those that will be points; -1 where none is left.
  int most_unlike(const std::vector<int>& chosen) const {
    std::set<std::size_t> taken = points_;
    taken.insert(chosen.begin(), chosen.end());
    int found = -1;
    double farthest = -1.;
    for (std::size_t i = 0; i < options_.candidates.size(); ++i) {
      if (taken.count(i) > 0) continue;
      double nearest = infinity;
      for (const std::size_t p : taken)
        nearest = std::min(nearest, square_of_distance(options_.candidates[i], options_.candidates[p]));
      if (nearest > farthest) {
        farthest = nearest;
        found = static_cast<int>(i);
      }
    }
    return found;
  }

  std::vector<std::size_t> by_estimate() const {
    std::vector<std::size_t> order(estimates_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return estimates_[a] > estimates_[b]; });
    return order;
  }

  const Scene& scene_;
  const SoilFamilyOptions& options_;
  std::vector<double> estimates_;
  std::set<std::size_t> points_;
};

}  // namespace

SoilFamilyMade make_soil_family(const Scene& scene, const AffineScene& affine, const CompiledScene& like,
                                const SoilFamilyOptions& options) {
  const Scene member = for_member(scene, options.tolerance);
  Builder builder(scene, affine, options.candidates.front());
  Candidates candidates(member, options);
  Proofs proofs(options.tolerance);
  SoilFamilyMade made;
  made.family.like = like;
  made.family.like.system = without_matrices(like.system);
  if (affine.fixed.system.loads.size() > like.system.loads.size())
    made.family.slipping = without_matrices(affine.fixed.system);
  std::vector<int> next = candidates.first();
  while (!next.empty()) {
    check_interrupt();
    std::vector<Factors> points;
    for (const int i : next) points.push_back(candidates.take(i));
    const double begin = static_cast<double>(made.points.size()) / options.most_points;
    made.points.insert(made.points.end(), next.begin(), next.end());
    const double end = static_cast<double>(made.points.size()) / options.most_points;
    const std::vector<ReducedSystem> own =
        builder.add_points(points, part_of(options.progress, begin, 0.5 * (begin + end)));
    const bool proven = proofs.see(made.family, member, points, own);
    candidates.scale(proofs.safety() / made.family.reduced.safety);
    made.family.reduced.safety = proofs.safety();
    builder.tell(made.family);
    next = candidates.next(made.family, points_at_once);
    if (std::isfinite(candidates.largest())) made.estimates.push_back(candidates.largest());
    if (proven && candidates.largest() <= tolerable_estimate(options)) break;
    const std::size_t left = static_cast<std::size_t>(options.most_points) - made.points.size();
    next.resize(std::min(next.size(), left));
  }
  return made;
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
