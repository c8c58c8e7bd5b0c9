// The linear elastic law in plane strain. Each law of stress has a file of its own in this folder, and knows neither
// regions nor elements.
#pragma once

#include <array>
#include <cmath>

namespace upbead {

/// Extension positive; xy is the tensor's component, half of gamma.
struct PlaneStrain {
  double xx = 0., yy = 0., xy = 0.;
};

/// Tension positive (Pa).
struct PlaneStress {
  double xx = 0., yy = 0., xy = 0., zz = 0.;
};

/// sigma = 2 G eps + lambda (eps_xx + eps_yy) 1.
struct ElasticLaw {
  double G = 0.;       ///< shear modulus (Pa)
  double lambda = 0.;  ///< Lame's first constant, 2 G nu / (1 - 2 nu) (Pa)

  PlaneStress stress(const PlaneStrain& strain) const {
    const double mean = lambda * (strain.xx + strain.yy);
    return {2. * G * strain.xx + mean, 2. * G * strain.yy + mean, 2. * G * strain.xy, mean};
  }
  /// D: (sigma_xx, sigma_yy, sigma_xy) by (eps_xx, eps_yy, gamma).
  std::array<std::array<double, 3>, 3> tangent() const;
  /// Stress over strain where there is strain in one direction alone: lambda + 2 G (Pa).
  double constrained_modulus() const { return lambda + 2. * G; }
  /// The same Poisson's ratio with another G.
  ElasticLaw with_shear_modulus(double other) const { return {other, lambda * (other / G)}; }
};

ElasticLaw elastic_law(double shear_modulus, double poissons_ratio);

/// A root of D: makes values of a strain, whose sum of squares is eps : D : eps.
class ElasticRoot {
 public:
  explicit ElasticRoot(const ElasticLaw& law)
      : of_2G_(std::sqrt(2. * law.G)), of_4G_(std::sqrt(4. * law.G)), of_lambda_(std::sqrt(law.lambda)) {}
  static constexpr unsigned n_values = 4;
  void write(const PlaneStrain& strain, double* out) const {
    out[0] = of_2G_ * strain.xx;
    out[1] = of_2G_ * strain.yy;
    out[2] = of_4G_ * strain.xy;
    out[3] = of_lambda_ * (strain.xx + strain.yy);
  }

 private:
  double of_2G_, of_4G_, of_lambda_;
};

}  // namespace upbead
