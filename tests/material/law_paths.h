// Tools for tests of every law of stress: random strains, rotations, tangents by differences.
#pragma once

#include <cmath>
#include <random>

#include "material/law_answer.h"

namespace upbead::testing {

inline PlaneStrain random_strain(std::mt19937& random, double size) {
  std::normal_distribution<double> normal(0., size);
  const double xx = normal(random), yy = normal(random);
  return {xx, yy, normal(random)};
}

inline PlaneStrain plus(const PlaneStrain& a, const PlaneStrain& b, double factor = 1.) {
  return {a.xx + factor * b.xx, a.yy + factor * b.yy, a.xy + factor * b.xy};
}

/// a : b.
inline double work(const PlaneStress& a, const PlaneStrain& b) {
  return a.xx * b.xx + a.yy * b.yy + 2. * a.xy * b.xy;
}

/// A tensor's components in axes turned by an angle.
template <class Tensor>
Tensor in_turned_axes(Tensor t, double angle) {
  const double mean = 0.5 * (t.xx + t.yy), half = 0.5 * (t.xx - t.yy);
  const double c = std::cos(2. * angle), s = std::sin(2. * angle), xy = t.xy;
  t.xx = mean + half * c + xy * s;
  t.yy = mean - half * c - xy * s;
  t.xy = xy * c - half * s;
  return t;
}

/// Column j of the tangent by a one-sided difference: d sigma / d eps_xx, eps_yy or gamma.
template <class Law>
std::array<double, 3> difference(const Law& law, const PlaneStrain& strain, const typename Law::State& state, int j,
                                 double step) {
  PlaneStrain moved = strain;
  (j == 0 ? moved.xx : j == 1 ? moved.yy : moved.xy) += j == 2 ? 0.5 * step : step;
  typename Law::State one = state, two = state;
  const PlaneStress a = law.update(strain, one).stress, b = law.update(moved, two).stress;
  return {(b.xx - a.xx) / step, (b.yy - a.yy) / step, (b.xy - a.xy) / step};
}

}  // namespace upbead::testing
