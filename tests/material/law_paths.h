// Tools for tests of every law of stress: random strains, points that follow them, rotations.
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include "material/mohr_coulomb_law.h"

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

/// A point that follows strains; its stress counts from that at rest, or from zero.
class SoilPath {
 public:
  struct Answer {
    PlaneStress stress;
    double dissipated = 0.;
  };
  SoilPath(std::unique_ptr<SoilPoint> soil, const ElasticLaw& elastic, const PlaneStress& rest = {})
      : soil_(std::move(soil)), elastic_(elastic), rest_(rest) {}

  /// Without a commit.
  PlaneStress stress(const PlaneStrain& strain) const {
    PlaneStress correction;
    soil_->correct(strain, correction);
    return sum(rest_, upbead::difference(elastic_.stress(strain), correction));
  }
  Answer to(const PlaneStrain& strain) {
    Answer answer{stress(strain), 0.};
    soil_->commit(strain, answer.dissipated);
    strain_ = strain;
    return answer;
  }
  double shear_to(double gamma) { return to({0., 0., 0.5 * gamma}).stress.xy; }
  double stored() const {
    double energy = 0.;
    soil_->stored_beside_elastic(strain_, energy);
    return energy + 0.5 * work(elastic_.stress(strain_), strain_);
  }

 private:
  std::unique_ptr<SoilPoint> soil_;
  ElasticLaw elastic_;
  PlaneStress rest_;
  PlaneStrain strain_;
};

}  // namespace upbead::testing
