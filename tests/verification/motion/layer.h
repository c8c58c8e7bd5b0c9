// A layer of dry elastic soil that is shaken from below, and tools for its exact solutions.
#pragma once

#include <complex>
#include <memory>

#include "scenes.h"

namespace upbead::test {

constexpr double layer_height = 10.;  // m

/// A layer that moves along x (shear) or along y (compression).
struct Shaking {
  bool vertical = false;
  DisplacementCondition base = DisplacementCondition::fixed;
  std::optional<Rayleigh> damping{};
  double rock_stiffness = 0.;  ///< G of a second layer below over that of the first; 0: there is none
};

Region layer_soil(const Shaking& shaking);
/// Its scene under a velocity of the base (of the outcrop if the base absorbs), with probes "top" and "base".
Scene shaken_layer(const Shaking& shaking, const TimeFunction& velocity);
/// Its mesh, from y = 0 (base of the layer, or -5 m if there is rock) to y = height.
std::unique_ptr<Mesh> layer_mesh(const Shaking& shaking, int cells);
/// Modulus of the waves: G, or lambda + 2 G (Pa).
double modulus(const Region& soil, bool vertical);

/// v = sin^4(pi t/duration): smooth to its third derivative.
TimeFunction smooth_velocity(double peak, double duration);
/// A velocity that grows to sin(2 pi f t) within some periods.
TimeFunction growing_sine(double frequency, double growth);

/// The complex amplitude of a history over its last `periods`, of e^{i 2 pi f t}, by least squares.
std::complex<double> amplitude(const std::vector<double>& time, const Eigen::RowVectorXd& values, double frequency,
                               int periods);

}  // namespace upbead::test
