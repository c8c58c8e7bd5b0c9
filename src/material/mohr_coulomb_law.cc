#include "material/mohr_coulomb_law.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "upbead/base/error.h"

namespace upbead {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Principal stresses in plane strain: a >= b in the plane, and zz; `sorted` gives their order in space.
struct Principal {
  double angle = 0.;                   ///< of a against x
  Vector3d value;                      ///< a, b, zz
  std::array<int, 3> sorted{0, 1, 2};  ///< a, b, zz by falling value
};

Principal principal(const PlaneStress& s) {
  const double mean = 0.5 * (s.xx + s.yy), half = 0.5 * (s.xx - s.yy), radius = std::hypot(half, s.xy);
  Principal found{0.5 * std::atan2(s.xy, half), {mean + radius, mean - radius, s.zz}};
  std::stable_sort(found.sorted.begin(), found.sorted.end(),
                   [&](int i, int j) { return found.value[i] > found.value[j]; });
  return found;
}

Principals sorted(const Principal& p) {
  return {p.value[p.sorted[0]], p.value[p.sorted[1]], p.value[p.sorted[2]]};
}

Matrix3d permuted(const std::array<Principals, 3>& sorted, const std::array<int, 3>& order) {
  Matrix3d back;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) back(order[i], order[j]) = sorted[i][j];
  return back;
}

/// Tangent in x and y, from that in the principal directions a and b, and the shear modulus between these.
Tangent in_plane(const Matrix3d& of_principal, double shear, double angle) {
  Matrix3d T = Matrix3d::Zero();
  T.topLeftCorner<2, 2>() = of_principal.topLeftCorner<2, 2>();
  T(2, 2) = shear;
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d R;                // maps strains in x, y to those in a, b
  R << c * c, s * s, c * s,  //
      s * s, c * c, -c * s,  //
      -2. * c * s, 2. * c * s, c * c - s * s;
  const Matrix3d turned = R.transpose() * T * R;
  Tangent out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out[i][j] = turned(i, j);
  return out;
}

PlaneStress turned(const Vector3d& value, double angle) {
  const double mean = 0.5 * (value[0] + value[1]), radius = 0.5 * (value[0] - value[1]);
  return {mean + radius * std::cos(2. * angle), mean - radius * std::cos(2. * angle), radius * std::sin(2. * angle),
          value[2]};
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

double MohrCoulombLaw::stored(const State& state) const {
  const PlaneStress& s = state.stress;
  const double mean = (s.xx + s.yy + s.zz) / 3., bulk = elastic_.lambda + 2. / 3. * elastic_.G;
  const double xx = s.xx - mean, yy = s.yy - mean, zz = s.zz - mean;
  return 0.5 * mean * mean / bulk + (xx * xx + yy * yy + zz * zz + 2. * s.xy * s.xy) / (4. * elastic_.G);
}

double MohrCoulombLaw::excess(const PlaneStress& stress) const {
  const Principal p = principal(stress);
  const double first = p.value[p.sorted[0]], last = p.value[p.sorted[2]];
  return std::max(planes_.k * first - last - planes_.strength, first - planes_.tension);
}

PlaneStress MohrCoulombLaw::returned(const PlaneStress& trial) const {
  const Principal p = principal(trial);
  const Principals back = planes_.from(sorted(p)).stress;
  Vector3d value;
  for (int i = 0; i < 3; ++i) value[p.sorted[i]] = back[i];
  return turned(value, p.angle);
}

double MohrCoulombLaw::mobilised(const PlaneStress& stress) const {
  const auto [first, middle, last] = sorted(principal(stress));
  const MohrCoulombPlanes& p = planes_;
  // from sin phi = (k - 1)/(k + 1) and c cos phi = strength/(k + 1)
  const double bearable = p.strength - 0.5 * (first + last) * (p.k - 1.), radius = 0.5 * (first - last) * (p.k + 1.);
  return first >= p.tension || radius >= bearable ? 1. : radius / bearable;
}

LawAnswer MohrCoulombLaw::update(const PlaneStrain& strain, State& state) const {
  const PlaneStrain step{strain.xx - state.strain.xx, strain.yy - state.strain.yy, strain.xy - state.strain.xy};
  const PlaneStress change = elastic_.stress(step), old = state.stress;
  const PlaneStress trial{old.xx + change.xx, old.yy + change.yy, old.xy + change.xy, old.zz + change.zz};
  state = {trial, strain};
  LawAnswer answer{trial, elastic_.tangent()};
  if (excess(trial) <= 0.) return answer;
  const Principal p = principal(trial);
  const MohrCoulombPlanes::Return back = planes_.from(sorted(p));
  const Matrix3d tangent = permuted(planes_.tangent(back), p.sorted);
  Vector3d value;
  for (int i = 0; i < 3; ++i) value[p.sorted[i]] = back.stress[i];
  // The principal directions turn with the trial stress; if both stresses in the plane are equal, any direction is
  // principal.
  const double apart = p.value[0] - p.value[1];
  const double shear = apart > 1e-12 * p.value.cwiseAbs().maxCoeff() ? elastic_.G * (value[0] - value[1]) / apart
                                                                     : 0.5 * (tangent(0, 0) - tangent(0, 1));
  answer.stress = state.stress = turned(value, p.angle);
  answer.tangent = in_plane(tangent, shear, p.angle);
  const PlaneStress& s = answer.stress;
  answer.dissipated = dissipated(s, {trial.xx - s.xx, trial.yy - s.yy, trial.xy - s.xy, trial.zz - s.zz});
  return answer;
}

/// s : D^-1 : relaxed, with D^-1 r = (r - lambda / (3 lambda + 2 G) tr r 1) / 2 G.
double MohrCoulombLaw::dissipated(const PlaneStress& s, const PlaneStress& r) const {
  const double G = elastic_.G, lambda = elastic_.lambda;
  const double mean = lambda / (3. * lambda + 2. * G) * (r.xx + r.yy + r.zz) * (s.xx + s.yy + s.zz);
  return (s.xx * r.xx + s.yy * r.yy + s.zz * r.zz + 2. * s.xy * r.xy - mean) / (2. * G);
}

}  // namespace upbead
