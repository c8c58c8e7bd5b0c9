#include "material/mohr_coulomb_law.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "material/soil_by_law.h"
#include "upbead/base/error.h"

namespace upbead {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

template <class Number>
UPBEAD_IN_CLONES Number larger(const Number& a, const Number& b) {
  return a > b ? a : b;
}
template <class Number>
UPBEAD_IN_CLONES Number smaller(const Number& a, const Number& b) {
  return a < b ? a : b;
}

/// A trial stress, its Mohr circle in the plane, and its principal stresses in order.
template <class Stress>
struct Trial {
  using Number = decltype(Stress::xx);
  Stress stress;
  Number mean, half, radius, first, middle, last;
};

template <class Stress>
UPBEAD_IN_CLONES Trial<Stress> trial_of(const Stress& s) {
  Trial<Stress> trial;
  trial.stress = s;
  trial.mean = 0.5 * (s.xx + s.yy);
  trial.half = 0.5 * (s.xx - s.yy);
  detail::square_root(trial.half * trial.half + s.xy * s.xy, trial.radius);
  const auto a = trial.mean + trial.radius, b = trial.mean - trial.radius;
  trial.first = larger(a, s.zz);
  trial.middle = larger(b, smaller(a, s.zz));
  trial.last = smaller(b, s.zz);
  return trial;
}

/// Cosine and sine of twice the angle from x to the first principal direction in the plane; if all are principal, of 0.
template <class Stress, class Number>
UPBEAD_IN_CLONES void direction_of(const Trial<Stress>& trial, Number& cosine, Number& sine) {
  const Number none{};
  const auto turned = trial.radius > none;
  cosine = turned ? trial.half / trial.radius : none + 1.;
  sine = turned ? trial.stress.xy / trial.radius : none;
}

/// Turns the sorted principal stresses back into the plane; zz keeps its rank from the trial.
template <class Stress, class Number>
UPBEAD_IN_CLONES Stress turned_back(const Trial<Stress>& trial, const Number& first, const Number& middle,
                                    const Number& last) {
  const Number zz = trial.stress.zz;
  const auto is_first = zz > trial.mean + trial.radius, is_last = zz <= trial.mean - trial.radius;
  const Number a = is_first ? middle : first, b = is_last ? middle : last;
  const Number mean = 0.5 * (a + b), radius = 0.5 * (a - b);
  Number cosine, sine;
  direction_of(trial, cosine, sine);
  return {mean + radius * cosine, mean - radius * cosine, radius * sine, is_first ? first : is_last ? last : middle};
}

/// Numbers of the principal directions a >= b in the plane, 0 and 1, and zz, 2, by falling stress.
std::array<int, 3> order_of(const Trial<PlaneStress>& t) {
  if (t.stress.zz > t.mean + t.radius) return {2, 0, 1};
  if (t.stress.zz <= t.mean - t.radius) return {0, 1, 2};
  return {0, 2, 1};
}

Matrix3d permuted(const std::array<Principals, 3>& sorted, const std::array<int, 3>& order) {
  Matrix3d back;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) back(order[i], order[j]) = sorted[i][j];
  return back;
}

/// Tangent in x and y, from that in the principal directions a and b of the trial, and the shear modulus between these.
Tangent in_plane(const Matrix3d& of_principal, double shear, const Trial<PlaneStress>& trial) {
  Matrix3d T = Matrix3d::Zero();
  T.topLeftCorner<2, 2>() = of_principal.topLeftCorner<2, 2>();
  T(2, 2) = shear;
  double c, s;
  direction_of(trial, c, s);
  Matrix3d R;                                    // maps strains in x, y to those in a, b
  R << 0.5 * (1. + c), 0.5 * (1. - c), 0.5 * s,  //
      0.5 * (1. - c), 0.5 * (1. + c), -0.5 * s, -s, s, c;
  const Matrix3d turned = R.transpose() * T * R;
  Tangent out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[i][j] = turned(i, j);
  return out;
}

double ratio(double degrees) {
  const double sine = std::sin(degrees * std::acos(-1.) / 180.);
  return (1. + sine) / (1. - sine);
}

void check(const MohrCoulombStrength& s) {
  Diagnostics wrong;
  if (!(s.friction_angle >= 0. && s.friction_angle < 90.))
    wrong.add(at_key("friction_angle"), "is not from 0 to 90 degrees", "give phi', for sand 30 to 45");
  if (!(s.cohesion >= 0.)) wrong.add(at_key("cohesion"), "is negative", "give c' in Pa, 0 for sand");
  if (!(s.dilatancy_angle >= 0. && s.dilatancy_angle <= s.friction_angle))
    wrong.add(at_key("dilatancy_angle"), "is not from 0 to the friction angle", "give psi', 0 for loose sand");
  if (!(s.tension >= 0. && std::isfinite(s.tension)))
    wrong.add(at_key("tension"), "is not a number from 0 on", "give the tensile strength in Pa, 0 for soil");
  wrong.throw_if_any();
}

MohrCoulombPlanes planes_of(const ElasticLaw& elastic, const MohrCoulombStrength& s) {
  check(s);
  const double k = ratio(s.friction_angle), strength = 2. * s.cohesion * std::sqrt(k);
  return {elastic, k, ratio(s.dilatancy_angle), strength,
          k > 1. ? std::min(s.tension, strength / (k - 1.)) : s.tension};
}

}  // namespace

MohrCoulombLaw::MohrCoulombLaw(const ElasticLaw& elastic, const MohrCoulombStrength& s)
    : elastic_(elastic), planes_(planes_of(elastic, s)) {}

double MohrCoulombLaw::excess(const PlaneStress& stress) const {
  const Trial<PlaneStress> t = trial_of(stress);
  return std::max(planes_.k * t.first - t.last - planes_.strength, t.first - planes_.tension);
}

PlaneStress MohrCoulombLaw::returned(const PlaneStress& stress) const {
  const Trial<PlaneStress> t = trial_of(stress);
  const auto [first, middle, last] = planes_.from({t.first, t.middle, t.last}).stress;
  return turned_back(t, first, middle, last);
}

double MohrCoulombLaw::mobilised(const PlaneStress& stress) const {
  const Trial<PlaneStress> t = trial_of(stress);
  const MohrCoulombPlanes& p = planes_;
  // from sin phi = (k - 1)/(k + 1) and c cos phi = strength/(k + 1)
  const double bearable = p.strength - 0.5 * (t.first + t.last) * (p.k - 1.);
  const double radius = 0.5 * (t.first - t.last) * (p.k + 1.);
  return t.first >= p.tension || radius >= bearable ? 1. : radius / bearable;
}

LawAnswer MohrCoulombLaw::update(const PlaneStrain& strain, State& state) const {
  const PlaneStrain step{strain.xx - state.strain.xx, strain.yy - state.strain.yy, strain.xy - state.strain.xy};
  state = {sum(state.stress, elastic_.stress(step)), strain};
  if (excess(state.stress) <= 0.) return {state.stress, elastic_.tangent()};
  const Trial<PlaneStress> t = trial_of(state.stress);
  const MohrCoulombPlanes::Return back = planes_.from({t.first, t.middle, t.last});
  const auto [first, middle, last] = back.stress;
  const std::array<int, 3> order = order_of(t);
  const Matrix3d tangent = permuted(planes_.tangent(back), order);
  const double a = order[0] == 0 ? first : middle, b = order[2] == 1 ? last : middle;
  // The principal directions turn with the trial stress; if both stresses in the plane are equal, any direction is
  // principal.
  const double apart = 2. * t.radius;
  const double shear = apart > 1e-12 * std::max({std::abs(t.first), std::abs(t.last)})
                           ? elastic_.G * (a - b) / apart
                           : 0.5 * (tangent(0, 0) - tangent(0, 1));
  state.stress = turned_back(t, first, middle, last);
  return {state.stress, in_plane(tangent, shear, t)};
}

namespace {

template <class Number>
UPBEAD_IN_CLONES Number magnitude(const Number& a) {
  return larger<Number>(a, -a);
}
template <class Stress>
UPBEAD_IN_CLONES Stress minus(const Stress& a, const Stress& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy, a.zz - b.zz};
}

}  // namespace

/// Mohr-Coulomb soil of cells side by side.
template <int n>
struct MohrCoulombSoil {
  using Number = typename Beside<n>::Number;
  using Strain = typename Beside<n>::Strain;
  using Stress = typename Beside<n>::Stress;

  /// The stress at rest, and D eps_p, by which flow since rest reduces the elastic stress.
  struct State {
    Stress rest, taken;
  };
  struct Constants {
    Number G, lambda, k, m, strength, tension;
  };
  static constexpr double never = 1e300;
  Constants c{Number{} + 1., Number{}, Number{}, Number{}, Number{} + never, Number{} + never};
  std::vector<std::shared_ptr<const MohrCoulombLaw>> laws;  ///< by lane

  template <class Any, class Visit>
  static void visit(Any& state, const Visit& of_part) {
    of_part(state.taken);
  }
  void add(const MohrCoulombSoil<1>& one) {
    set_lane(one.c, static_cast<int>(laws.size()), c);
    laws.push_back(one.laws.front());
  }
  template <class One>
  State joined(const std::vector<const One*>& states) const {
    State all;
    for (std::size_t lane = 0; lane < states.size(); ++lane) set_lane(*states[lane], static_cast<int>(lane), all);
    return all;
  }

  UPBEAD_IN_CLONES Trial<Stress> elastic(const State& state, const Strain& strain) const {
    const Number volume = c.lambda * (strain.xx + strain.yy);
    Stress s;
    s.xx = state.rest.xx + (2. * c.G * strain.xx + volume) - state.taken.xx;
    s.yy = state.rest.yy + (2. * c.G * strain.yy + volume) - state.taken.yy;
    s.xy = state.rest.xy + 2. * c.G * strain.xy - state.taken.xy;
    s.zz = state.rest.zz + volume - state.taken.zz;
    return trial_of(s);
  }

  /// Returns the trial stresses that lie outside the planes; false where none does. Most of them return to the plane of
  /// shear alone, the others by MohrCoulombLaw::returned().
  UPBEAD_IN_CLONES bool returns(const Trial<Stress>& trial, Stress& back) const {
    const Number over = c.k * trial.first - trial.last - c.strength, none{};
    // `outside` is the negation of a comparison, so that a stress that is not a number counts as outside
    const auto outside = !((over <= none) & (trial.first <= c.tension));
    if (!detail::holds_anywhere(outside)) return false;
    const Number volume = c.lambda * (c.m - 1.), D_first = volume + 2. * c.G * c.m, D_last = volume - 2. * c.G;
    const Number l = over / (c.k * D_first - D_last);
    const Number first = trial.first - l * D_first, middle = trial.middle - l * volume, last = trial.last - l * D_last;
    const Number largest_trial = larger(magnitude(trial.first), larger(magnitude(trial.middle), magnitude(trial.last)));
    const Number small = 1e-10 * (largest_trial + c.strength);
    const Number largest = larger<Number>(c.k * middle - last, c.k * first - middle) - c.strength;
    const auto off_plane = !((over > none) & (larger<Number>(largest, larger(first, middle) - c.tension) <= small) &
                             (last - c.tension <= small));
    const Stress turned = turned_back(trial, first, middle, last), &s = trial.stress;
    back = {outside ? turned.xx : s.xx, outside ? turned.yy : s.yy, outside ? turned.xy : s.xy,
            outside ? turned.zz : s.zz};
    for (int lane = 0; lane < static_cast<int>(laws.size()); ++lane)
      if (detail::holds_in(outside, lane) && detail::holds_in(off_plane, lane))
        set_lane(laws[static_cast<std::size_t>(lane)]->returned(in_lane(s, lane)), lane, back);
    return true;
  }

  UPBEAD_IN_CLONES void correct(const State& state, const Strain& strain, Stress& correction) const {
    const Trial<Stress> trial = elastic(state, strain);
    correction = state.taken;
    if (Stress back; returns(trial, back)) grow(trial.stress, back, correction);
  }
  UPBEAD_IN_CLONES void commit(State& state, const Strain& strain, Number& dissipated) const {
    const Trial<Stress> trial = elastic(state, strain);
    Stress back;
    if (!returns(trial, back)) return;
    dissipated += energy(back, minus(trial.stress, back));
    grow(trial.stress, back, state.taken);
  }
  UPBEAD_IN_CLONES static void grow(const Stress& trial, const Stress& back, Stress& taken) {
    taken = {taken.xx + (trial.xx - back.xx), taken.yy + (trial.yy - back.yy), taken.xy + (trial.xy - back.xy),
             taken.zz + (trial.zz - back.zz)};
  }
  /// s : D^-1 : r, with D^-1 r = (r - lambda / (3 lambda + 2 G) tr r 1) / 2 G.
  UPBEAD_IN_CLONES Number energy(const Stress& s, const Stress& r) const {
    const Number mean = c.lambda / (3. * c.lambda + 2. * c.G) * (r.xx + r.yy + r.zz) * (s.xx + s.yy + s.zz);
    return (s.xx * r.xx + s.yy * r.yy + s.zz * r.zz + 2. * s.xy * r.xy - mean) / (2. * c.G);
  }
  /// With sigma = D eps - taken: taken : D^-1 : (taken/2 - eps : D) in all four components, and the work of the stress
  /// at rest on the flow.
  UPBEAD_IN_CLONES void stored(const State& state, const Strain& e, Number& stored_energy) const {
    const Stress &r = state.taken, &rest = state.rest;
    const Stress half{0.5 * r.xx - rest.xx, 0.5 * r.yy - rest.yy, 0.5 * r.xy - rest.xy, 0.5 * r.zz - rest.zz};
    stored_energy = energy(r, half) - (r.xx * e.xx + r.yy * e.yy + 2. * r.xy * e.xy);
  }
  /// The planes' excess grows by at most (k + 1) times the largest change of a principal stress, which is at most
  /// (2 G + sqrt(2) lambda) times the norm of the change of strain.
  UPBEAD_IN_CLONES void margin(const State& state, const Strain& strain, Number& least) const {
    const Trial<Stress> trial = elastic(state, strain);
    const Number inside = smaller<Number>(c.strength - c.k * trial.first + trial.last, c.tension - trial.first);
    least = inside / ((c.k + 1.) * (2. * c.G + std::sqrt(2.) * c.lambda));
  }
  double mobilised(const State& state, int lane, const PlaneStress& change) const {
    return laws[static_cast<std::size_t>(lane)]->mobilised(sum(in_lane(state.rest, lane), change));
  }
};

namespace {

using MohrCoulombPoint = SoilBy<MohrCoulombSoil, 1>;

/// Its strength follows the effective stress that is left. Plastic strain at the apex of its planes is not recovered
/// when the soil is compressed again.
class CompactingMohrCoulomb : public CompactingPoint {
 public:
  CompactingMohrCoulomb(std::unique_ptr<MohrCoulombPoint> soil, MohrCoulombPoint& inner, const ElasticLaw& elastic,
                        const ShearCompaction& law)
      : CompactingPoint(std::move(soil), elastic, law, mean_stress(inner.state().rest)), inner_(inner) {}

 private:
  void lose(double more, const PlaneStrain& strain) override {
    waiting_ += more;
    const double takes = std::clamp(mean_of(inner_, strain), 0., waiting_);
    inner_.state().taken = difference(inner_.state().taken, {takes, takes, 0., takes});
    waiting_ -= takes;
  }

  MohrCoulombPoint& inner_;
  double waiting_ = 0.;  ///< the part of K eps_v for which no stress was left (Pa)
};

std::unique_ptr<CompactingPoint> compacting(std::unique_ptr<SoilPoint> soil, const ElasticLaw& elastic,
                                            const ShearCompaction& law, double /*mean_at_rest*/) {
  std::unique_ptr<MohrCoulombPoint> own(&dynamic_cast<MohrCoulombPoint&>(*soil));
  soil.release();
  MohrCoulombPoint& inner = *own;
  return std::make_unique<CompactingMohrCoulomb>(std::move(own), inner, elastic, law);
}

std::function<CellPoints(const CellSoil&)> make(const RegionSoil& soil) {
  return [strength = *soil.strength](const CellSoil& cell) -> CellPoints {
    const auto law = std::make_shared<const MohrCoulombLaw>(cell.elastic, strength);
    return {mohr_coulomb_points(law, cell.at_rest), law->excess(cell.at_rest.front()) > 0.};
  };
}

}  // namespace

PointMaker mohr_coulomb_points(std::shared_ptr<const MohrCoulombLaw> law, std::vector<PlaneStress> at_rest) {
  const ElasticLaw& D = law->elastic();
  const MohrCoulombPlanes& p = law->planes();
  auto soil = std::make_shared<MohrCoulombSoil<1>>();
  soil->c = {D.G, D.lambda, p.k, p.m, p.strength, p.tension};
  soil->laws.push_back(law);
  return [soil, law, at_rest = std::move(at_rest)](unsigned point) {
    const PlaneStress& stress = at_rest[point % at_rest.size()];
    return std::make_unique<MohrCoulombPoint>(
        soil, MohrCoulombPoint::State{law->excess(stress) > 0. ? law->returned(stress) : stress, {}});
  };
}

const SoilLawRow mohr_coulomb_row{
    "mohr_coulomb", "Mohr-Coulomb soil", SoilNeeds::strength, RestStress::balanced, "elastic up to its strength",
    make,           compacting};

}  // namespace upbead
