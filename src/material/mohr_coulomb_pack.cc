#include <algorithm>
#include <cmath>

#include "material/soil_pack.h"

namespace upbead {

namespace {

using detail::Lanes;
using Mask = decltype(Lanes{} > Lanes{});

UPBEAD_IN_CLONES Lanes larger(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}

UPBEAD_IN_CLONES Lanes smaller(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}

UPBEAD_IN_CLONES Lanes magnitude(const Lanes& a) {
  return larger(a, -a);
}

UPBEAD_IN_CLONES bool any_of(const Mask& mask) {
  long long found = 0;
  for (int i = 0; i < detail::lanes; ++i) found |= mask[i];
  return found != 0;
}

/// Constants of the law in all cells; soil in lanes without a cell never yields.
struct Constants {
  Lanes G{}, lambda{}, k{}, m{}, strength{}, tension{};
  Lanes dG{}, dlambda{};  ///< D less the law's own constants (Pa)
};

/// History of a point: the stress at rest, and D eps_p, by which flow since rest reduces the elastic stress.
struct Flowed {
  PackStress rest, taken;
};

/// A trial stress, its Mohr circle in the plane, and its principal stresses in order.
struct Trial {
  PackStress stress;
  Lanes mean, half, radius;
  Lanes first, middle, last;  ///< principal
};

UPBEAD_IN_CLONES void try_elastic(const Constants& c, const Flowed& point, const PackTensor& strain, Trial& trial) {
  const Lanes volume = c.lambda * (strain.xx + strain.yy);
  PackStress& s = trial.stress;
  s.xx = point.rest.xx + (2. * c.G * strain.xx + volume) - point.taken.xx;
  s.yy = point.rest.yy + (2. * c.G * strain.yy + volume) - point.taken.yy;
  s.xy = point.rest.xy + 2. * c.G * strain.xy - point.taken.xy;
  s.zz = point.rest.zz + volume - point.taken.zz;
  trial.mean = 0.5 * (s.xx + s.yy);
  trial.half = 0.5 * (s.xx - s.yy);
  detail::square_root(trial.half * trial.half + s.xy * s.xy, trial.radius);
  const Lanes a = trial.mean + trial.radius, b = trial.mean - trial.radius;
  trial.first = larger(a, s.zz);
  trial.middle = larger(b, smaller(a, s.zz));
  trial.last = smaller(b, s.zz);
}

/// Turns the sorted principal stresses (first, middle, last) back into the plane; zz keeps its rank from the trial.
UPBEAD_IN_CLONES void turn(const Trial& trial, const Lanes& first, const Lanes& middle, const Lanes& last,
                           PackStress& s) {
  const Lanes a_before = trial.mean + trial.radius, b_before = trial.mean - trial.radius, zz = trial.stress.zz;
  const Mask is_first = zz > a_before, is_last = zz <= b_before;
  const Lanes a = is_first ? middle : first, b = is_last ? middle : last;
  const Lanes mean = 0.5 * (a + b), radius = 0.5 * (a - b), none = {};
  const Mask turned = trial.radius > none;
  const Lanes cosine = turned ? trial.half / trial.radius : none + 1.,
              sine = turned ? trial.stress.xy / trial.radius : none;
  s.xx = mean + radius * cosine;
  s.yy = mean - radius * cosine;
  s.xy = radius * sine;
  s.zz = is_first ? first : is_last ? last : middle;
}

/// Returns the trial stresses of a point that lie outside the planes. Most of them return to the plane of shear
/// alone; `left` marks the others, which need MohrCoulombLaw::returned().
UPBEAD_CLONES bool return_point(const Constants& c, const Flowed& point, const PackTensor& strain, Trial& trial,
                                PackStress& back, int* left) {
  try_elastic(c, point, strain, trial);
  back = trial.stress;
  const Lanes over = c.k * trial.first - trial.last - c.strength, none = {};
  // `outside` is the negation of a comparison, so that a stress that is not a number counts as outside
  const Mask outside = ~((over <= none) & (trial.first <= c.tension));
  if (!any_of(outside)) return false;
  const Lanes volume = c.lambda * (c.m - 1.), D_first = volume + 2. * c.G * c.m, D_last = volume - 2. * c.G;
  const Lanes l = over / (c.k * D_first - D_last);
  const Lanes first = trial.first - l * D_first, middle = trial.middle - l * volume, last = trial.last - l * D_last;
  const Lanes small =
      1e-10 * (larger(magnitude(trial.first), larger(magnitude(trial.middle), magnitude(trial.last))) + c.strength);
  const Lanes largest = larger(c.k * middle - last, c.k * first - middle) - c.strength;
  const Mask on_plane =
      (over > none) & (larger(largest, larger(first, middle) - c.tension) <= small) & (last - c.tension <= small);
  PackStress turned;
  turn(trial, first, middle, last, turned);
  const Mask takes = outside & on_plane;
  back.xx = takes ? turned.xx : back.xx;
  back.yy = takes ? turned.yy : back.yy;
  back.xy = takes ? turned.xy : back.xy;
  back.zz = takes ? turned.zz : back.zz;
  for (int i = 0; i < detail::lanes; ++i) left[i] = outside[i] & ~on_plane[i] ? 1 : 0;
  return true;
}

/// The planes' excess grows by at most (k + 1) times the largest change of a principal stress, which is at most
/// (2 G + sqrt(2) lambda) times the norm of the change of strain.
UPBEAD_CLONES void margin_of_flow(const Constants& c, const Flowed& point, const PackTensor& strain, Lanes& margin) {
  Trial trial;
  try_elastic(c, point, strain, trial);
  const Lanes inside = smaller(c.strength - c.k * trial.first + trial.last, c.tension - trial.first);
  margin = inside / ((c.k + 1.) * (2. * c.G + std::sqrt(2.) * c.lambda));
  const auto own = (c.dG == Lanes{}) & (c.dlambda == Lanes{});
  margin = own ? margin : Lanes{};
}

/// s : D^-1 : r, as in MohrCoulombLaw.
double dissipated_by(double G, double lambda, const PlaneStress& s, const PlaneStress& r) {
  const double mean = lambda / (3. * lambda + 2. * G) * (r.xx + r.yy + r.zz) * (s.xx + s.yy + s.zz);
  return (s.xx * r.xx + s.yy * r.yy + s.zz * r.zz + 2. * s.xy * r.xy - mean) / (2. * G);
}

PlaneStress in_lane(const PackStress& s, int lane) {
  return {s.xx[lane], s.yy[lane], s.xy[lane], s.zz[lane]};
}

void set_lane(const PlaneStress& s, int lane, PackStress& all) {
  all.xx[lane] = s.xx;
  all.yy[lane] = s.yy;
  all.xy[lane] = s.xy;
  all.zz[lane] = s.zz;
}

class MohrCoulombPack : public SoilPack {
 public:
  explicit MohrCoulombPack(const std::vector<PackedCell>& cells) : points_(cells.front().points.size()) {
    constants_.tension += infinite;
    constants_.strength += infinite;
    for (std::size_t lane = 0; lane < cells.size(); ++lane) fill(cells[lane], static_cast<int>(lane));
  }
  void correct(int n, const PackTensor& strain, PackStress& correction) override {
    const PackStress& taken = points_[static_cast<std::size_t>(n)].taken;
    correction = taken;
    if (Trial trial; admit(n, strain, trial)) correction = grown(taken, trial.stress);
    const Lanes volume = constants_.dlambda * (strain.xx + strain.yy);
    correction.xx += 2. * constants_.dG * strain.xx + volume;
    correction.yy += 2. * constants_.dG * strain.yy + volume;
    correction.xy += 2. * constants_.dG * strain.xy;
    correction.zz += volume;
  }
  void commit(int n, const PackTensor& strain, Lanes& dissipated) override {
    Trial trial;
    if (!admit(n, strain, trial)) return;
    Flowed& point = points_[static_cast<std::size_t>(n)];
    for (std::size_t lane = 0; lane < laws_.size(); ++lane) {
      const int i = static_cast<int>(lane);
      const PlaneStress s = in_lane(back_, i), t = in_lane(trial.stress, i);
      dissipated[i] +=
          dissipated_by(constants_.G[i], constants_.lambda[i], s, {t.xx - s.xx, t.yy - s.yy, t.xy - s.xy, t.zz - s.zz});
    }
    point.taken = grown(point.taken, trial.stress);
  }
  /// Energy less that of D, with sigma = D eps - taken: taken : D^-1 : (taken/2 - eps : D) in all four components,
  /// and the work of the stress at rest on the flow.
  void stored_beside_elastic(int n, const PackTensor& strain, Lanes& energy) const override {
    const Flowed& point = points_[static_cast<std::size_t>(n)];
    for (std::size_t lane = 0; lane < laws_.size(); ++lane) {
      const int i = static_cast<int>(lane);
      const double G = constants_.G[i], lambda = constants_.lambda[i];
      const PlaneStrain e{strain.xx[i], strain.yy[i], strain.xy[i]};
      const PlaneStress r = in_lane(point.taken, i), rest = in_lane(point.rest, i);
      const PlaneStress half{0.5 * r.xx - rest.xx, 0.5 * r.yy - rest.yy, 0.5 * r.xy - rest.xy, 0.5 * r.zz - rest.zz};
      energy[i] = dissipated_by(G, lambda, r, half) - (r.xx * e.xx + r.yy * e.yy + 2. * r.xy * e.xy) -
                  elastic_energy({constants_.dG[i], constants_.dlambda[i]}, e);
    }
  }
  void margin(int n, const PackTensor& strain, Lanes& margin) const override {
    margin_of_flow(constants_, points_[static_cast<std::size_t>(n)], strain, margin);
  }
  double mobilised(int n, int lane, const PlaneStress& change) const override {
    const PlaneStress rest = in_lane(points_[static_cast<std::size_t>(n)].rest, lane);
    return laws_[static_cast<std::size_t>(lane)]->mobilised(sum(rest, change));
  }
  void remember(std::vector<double>& memory) const override {
    for (const Flowed& point : points_) remember_lanes(point.taken, memory);
  }
  const double* recall(const double* memory) override {
    for (Flowed& point : points_) memory = recall_lanes(memory, point.taken);
    return memory;
  }

 private:
  static constexpr double infinite = 1e300;

  void fill(const PackedCell& cell, int lane) {
    laws_.push_back(cell.points.front()->mohr_coulomb()->law);
    const ElasticLaw& own = laws_.back()->elastic();
    const MohrCoulombPlanes& planes = laws_.back()->planes();
    constants_.G[lane] = own.G;
    constants_.lambda[lane] = own.lambda;
    constants_.k[lane] = planes.k;
    constants_.m[lane] = planes.m;
    constants_.strength[lane] = planes.strength;
    constants_.tension[lane] = planes.tension;
    constants_.dG[lane] = cell.elastic.G - own.G;
    constants_.dlambda[lane] = cell.elastic.lambda - own.lambda;
    for (std::size_t n = 0; n < points_.size(); ++n)
      set_lane(cell.points[n]->mohr_coulomb()->rest, lane, points_[n].rest);
  }
  /// Whether any stress lies outside; if so, back_ holds the stresses after the return.
  bool admit(int n, const PackTensor& strain, Trial& trial) {
    int left[detail::lanes] = {};
    if (!return_point(constants_, points_[static_cast<std::size_t>(n)], strain, trial, back_, left)) return false;
    for (std::size_t lane = 0; lane < laws_.size(); ++lane)
      if (left[lane])
        set_lane(laws_[lane]->returned(in_lane(trial.stress, static_cast<int>(lane))), static_cast<int>(lane), back_);
    return true;
  }
  PackStress grown(const PackStress& taken, const PackStress& trial) const {
    return {taken.xx + (trial.xx - back_.xx), taken.yy + (trial.yy - back_.yy), taken.xy + (trial.xy - back_.xy),
            taken.zz + (trial.zz - back_.zz)};
  }

  Constants constants_;
  std::vector<std::shared_ptr<const MohrCoulombLaw>> laws_;
  std::vector<Flowed> points_;
  PackStress back_;
};

}  // namespace

std::unique_ptr<SoilPack> mohr_coulomb_pack(const std::vector<PackedCell>& cells) {
  return std::make_unique<MohrCoulombPack>(cells);
}

}  // namespace upbead
