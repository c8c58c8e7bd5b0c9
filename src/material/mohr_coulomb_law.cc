#include "material/mohr_coulomb_law.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Of plane strain; in the plane a >= b, in space the order of `sorted`.
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

/// A plane a . s <= limit of the sorted principal stresses, with the direction b of its flow.
struct Plane {
  Vector3d a, b;
  double limit;
};

std::array<Plane, 6> planes(double k, double m, double strength, double tension) {
  return {{{{k, 0., -1.}, {m, 0., -1.}, strength},  // the plane of shear; with one of the next two: an edge
           {{0., k, -1.}, {0., m, -1.}, strength},
           {{k, -1., 0.}, {m, -1., 0.}, strength},
           {{1., 0., 0.}, {1., 0., 0.}, tension},
           {{0., 1., 0.}, {0., 1., 0.}, tension},
           {{0., 0., 1.}, {0., 0., 1.}, tension}}};
}

/// All sets of up to three of six planes, small ones first.
const std::vector<std::vector<int>>& sets_of_planes() {
  static const std::vector<std::vector<int>> sets = [] {
    std::vector<std::vector<int>> found;
    for (unsigned bits = 1; bits < 64; ++bits) {
      std::vector<int> set;
      for (int i = 0; i < 6; ++i)
        if (bits & (1u << i)) set.push_back(i);
      if (set.size() <= 3) found.push_back(std::move(set));
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    return found;
  }();
  return sets;
}

struct Return {
  Vector3d stress;
  Matrix3d tangent;
  double excess;  ///< over the worst plane, or the most negative multiplier as a stress (Pa)
};

/// The stress on all planes of a set at once (Koiter): s = trial - D B l, A (trial - D B l) = limits.
std::optional<Return> return_to(const std::vector<int>& set, const std::array<Plane, 6>& all, const Matrix3d& D,
                                const Vector3d& trial) {
  const int n = static_cast<int>(set.size());
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> A(n, 3), B(n, 3);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> over(n);
  for (int i = 0; i < n; ++i) {
    A.row(i) = all[set[i]].a;
    B.row(i) = all[set[i]].b;
    over[i] = all[set[i]].a.dot(trial) - all[set[i]].limit;
  }
  const Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> DB = D * B.transpose();
  const Eigen::FullPivLU<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>> lu(A * DB);
  if (!lu.isInvertible()) return std::nullopt;
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> l = lu.solve(over);
  Return found{trial - DB * l, D - DB * lu.solve(A * D), 0.};
  for (const Plane& plane : all) found.excess = std::max(found.excess, plane.a.dot(found.stress) - plane.limit);
  found.excess = std::max(found.excess, -D(0, 0) * l.minCoeff());
  return found;
}

/// The first set that keeps within all planes with no negative multiplier.
Return return_of(const std::array<Plane, 6>& all, const Matrix3d& D, const Vector3d& trial) {
  const double small = 1e-10 * (trial.cwiseAbs().maxCoeff() + std::abs(all[0].limit));
  for (const std::vector<int>& set : sets_of_planes())
    if (const auto found = return_to(set, all, D, trial); found && found->excess <= small) return *found;
  throw NumericsError("no stress within the Mohr-Coulomb planes was found for a strain");
}

Matrix3d permuted(const Matrix3d& sorted, const std::array<int, 3>& order) {
  Matrix3d back;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) back(order[i], order[j]) = sorted(i, j);
  return back;
}

/// Tangent in x and y from that of a and b, with the modulus of shear between them.
Tangent in_plane(const Matrix3d& of_principal, double shear, double angle) {
  Matrix3d T = Matrix3d::Zero();
  T.topLeftCorner<2, 2>() = of_principal.topLeftCorner<2, 2>();
  T(2, 2) = shear;
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d R;                // strains along a and b, and their gamma, by those along x and y
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

}  // namespace

MohrCoulombLaw::MohrCoulombLaw(const ElasticLaw& elastic, const MohrCoulombStrength& s)
    : elastic_(elastic), k_(ratio(s.friction_angle)), m_(ratio(s.dilatancy_angle)) {
  check(s);
  strength_ = 2. * s.cohesion * std::sqrt(k_);
  tension_ = k_ > 1. ? std::min(s.tension, strength_ / (k_ - 1.)) : s.tension;
}

double MohrCoulombLaw::stored(const State& state) const {
  const PlaneStress& s = state.stress;
  const double mean = (s.xx + s.yy + s.zz) / 3., bulk = elastic_.lambda + 2. / 3. * elastic_.G;
  const double xx = s.xx - mean, yy = s.yy - mean, zz = s.zz - mean;
  return 0.5 * mean * mean / bulk + (xx * xx + yy * yy + zz * zz + 2. * s.xy * s.xy) / (4. * elastic_.G);
}

double MohrCoulombLaw::excess(const PlaneStress& stress) const {
  const Principal p = principal(stress);
  const double first = p.value[p.sorted[0]], last = p.value[p.sorted[2]];
  return std::max(k_ * first - last - strength_, first - tension_);
}

double MohrCoulombLaw::mobilised(const PlaneStress& stress) const {
  const Principal p = principal(stress);
  const double first = p.value[p.sorted[0]], last = p.value[p.sorted[2]];
  // sin phi = (k - 1)/(k + 1), c cos phi = strength/(k + 1)
  const double bearable = strength_ - 0.5 * (first + last) * (k_ - 1.), radius = 0.5 * (first - last) * (k_ + 1.);
  return first >= tension_ || radius >= bearable ? 1. : radius / bearable;
}

LawAnswer MohrCoulombLaw::update(const PlaneStrain& strain, State& state) const {
  const PlaneStrain step{strain.xx - state.strain.xx, strain.yy - state.strain.yy, strain.xy - state.strain.xy};
  const PlaneStress change = elastic_.stress(step), old = state.stress;
  const PlaneStress trial{old.xx + change.xx, old.yy + change.yy, old.xy + change.xy, old.zz + change.zz};
  state = {trial, strain};
  LawAnswer answer{trial, elastic_.tangent()};
  if (excess(trial) <= 0.) return answer;
  const Principal p = principal(trial);
  const Matrix3d D = Matrix3d::Constant(elastic_.lambda) + 2. * elastic_.G * Matrix3d::Identity();
  Vector3d sorted;
  for (int i = 0; i < 3; ++i) sorted[i] = p.value[p.sorted[i]];
  const Return back = return_of(planes(k_, m_, strength_, tension_), D, sorted);
  const Matrix3d tangent = permuted(back.tangent, p.sorted);
  Vector3d value;
  for (int i = 0; i < 3; ++i) value[p.sorted[i]] = back.stress[i];
  // The principal directions turn with the trial stress; where its circle is a point, any direction is principal.
  const double apart = p.value[0] - p.value[1];
  const double shear = apart > 1e-12 * p.value.cwiseAbs().maxCoeff() ? elastic_.G * (value[0] - value[1]) / apart
                                                                     : 0.5 * (tangent(0, 0) - tangent(0, 1));
  answer.stress = state.stress = turned(value, p.angle);
  answer.tangent = in_plane(tangent, shear, p.angle);
  answer.dissipated = back.stress.dot(D.llt().solve(sorted - back.stress));
  return answer;
}

}  // namespace upbead
