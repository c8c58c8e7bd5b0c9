// Soil that yields a little from the first strain on: elastic and perfectly plastic elements side by side.
#pragma once

#include <functional>
#include <vector>

#include "material/law_answer.h"

namespace upbead {

/// Shear stress (Pa) under a shear strain gamma that grows for the first time.
struct BackbonePoint {
  double gamma = 0.;
  double tau = 0.;
};

/// tau = G gamma ratio(gamma) at n strains, equally far from each other in log gamma.
std::vector<BackbonePoint> backbone(double G, const std::function<double(double)>& modulus_ratio, double from,
                                    double to, int n);
/// The same polygon up to the strength tau_max (Pa), where it reaches it.
std::vector<BackbonePoint> with_strength(const std::vector<BackbonePoint>& points, double tau_max);

/// The least concave polygon from the origin that has no point above it: a table of moduli that flattens out bends the
/// other way at its points, which no overlay can follow.
std::vector<BackbonePoint> concave(const std::vector<BackbonePoint>& points);

/// The overlay of Iwan (1967) and Mroz (1967) on the deviator; elastic in volume:
///   s = sum_i s_i,  s_i = 2 h_i (e - e_i^p),  ||s_i|| <= sqrt(2) y_i,  flow associated, return radial and exact.
/// In first shear it follows the polygon through the points, level beyond the last; it unloads and reloads by Masing's
/// rules of itself. Below the first knee its modulus is that of the elastic law. Its stress is what is added to the
/// state at rest, and so it starts from rest without any yield.
class HystereticLaw {
 public:
  struct Element {
    double h = 0.;  ///< share of the shear modulus (Pa)
    double y = 0.;  ///< shear stress at which it yields (Pa)
  };
  /// Plastic strain of an element: xx, yy and xy of the tensor; zz = -(xx + yy).
  struct State {
    PlaneStrain strain;
    std::vector<PlaneStrain> plastic;
  };

  /// Throws InputError where tau does not grow ever more slowly with gamma, below G gamma.
  HystereticLaw(const ElasticLaw& small_strain, const std::vector<BackbonePoint>& points);

  State at_rest() const { return {{}, std::vector<PlaneStrain>(elements_.size())}; }
  /// The state without strain that bears a deviator as if it had been loaded by nothing else, along the backbone; of a
  /// deviator beyond the strength its largest part. What is not a deviator does not count.
  State bearing(const PlaneStress& stress) const;
  /// Shear stress that it can bear (Pa).
  double strength() const;
  /// Share of it that a stress takes: sqrt(s : s / 2) of its deviator over the strength.
  double mobilised(const PlaneStress& stress) const;
  /// Below the first yield the stress is that of the elastic law to the last bit. Dissipation is the average stress
  /// times the plastic strain of the step: 0 or more, and with the stored energy it is the work of the average stress
  /// to round-off.
  LawAnswer update(const PlaneStrain& strain, State& state) const;
  /// Energy stored (J/m3): K eps_v^2/2 + sum h_i ||e - e_i^p||^2.
  double stored(const State& state) const;
  const std::vector<Element>& elements() const { return elements_; }
  const ElasticLaw& elastic() const { return elastic_; }

 private:
  ElasticLaw elastic_;
  std::vector<Element> elements_;
};

}  // namespace upbead
