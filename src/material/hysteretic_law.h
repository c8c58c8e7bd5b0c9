// Soil that begins to yield at small strain: elastic and perfectly plastic elements in parallel.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "material/soil_law.h"

namespace upbead {

/// Shear stress (Pa) in first loading to a shear strain gamma.
struct BackbonePoint {
  double gamma = 0.;
  double tau = 0.;
};

/// tau = G gamma ratio(gamma) at n strains, equally spaced in log gamma.
std::vector<BackbonePoint> backbone(double G, const std::function<double(double)>& modulus_ratio, double from,
                                    double to, int n);
/// The same polygon, cut off at the strength tau_max (Pa) where it reaches it.
std::vector<BackbonePoint> with_strength(const std::vector<BackbonePoint>& points, double tau_max);

/// The least concave polygon from the origin with no point above it: where a table of moduli becomes flat, the curve
/// through its points is convex, which no overlay can follow.
std::vector<BackbonePoint> concave(const std::vector<BackbonePoint>& points);

/// The overlay of Iwan (1967) and Mroz (1967) on the deviator; elastic in volume:
///   s = sum_i s_i,  s_i = 2 h_i (e - e_i^p),  ||s_i|| <= sqrt(2) y_i,  flow associated, return radial and exact.
/// In first shear it follows the polygon through the points, constant beyond the last; unloading and reloading follow
/// Masing's rules without further assumptions. Below the first knee its modulus is that of the elastic law. Its
/// stress is added to that of the state at rest, and so it has no yield at rest.
class HystereticLaw {
 public:
  struct Element {
    double h = 0.;  ///< share of the shear modulus (Pa)
    double y = 0.;  ///< shear stress at which it yields (Pa)
  };
  /// Throws InputError unless tau grows with gamma at slopes that fall, and is not above G gamma.
  HystereticLaw(const ElasticLaw& small_strain, const std::vector<BackbonePoint>& points);

  /// Plastic strains of the elements (xx, yy and xy of the tensor; zz = -(xx + yy)) that at zero strain bear a deviator
  /// as after loading along the backbone by that deviator alone; for a deviator beyond the strength, the part that can
  /// be borne. Only the deviator of `stress` counts.
  std::vector<PlaneStrain> bearing(const PlaneStress& stress) const;
  /// The largest shear stress (Pa).
  double strength() const;
  /// Share of the strength that a stress uses: sqrt(s : s / 2) of its deviator over the strength.
  double mobilised(const PlaneStress& stress) const;
  const std::vector<Element>& elements() const { return elements_; }
  const ElasticLaw& elastic() const { return elastic_; }

 private:
  ElasticLaw elastic_;
  std::vector<Element> elements_;
};

/// Points of a cell with these plastic strains at rest, one for each element, or none. Below the first yield their
/// stress is bitwise that of the elastic law. Dissipation is the average stress times the plastic strain of the step: 0
/// or more. Together with the change of stored energy, sum h_i ||e - e_i^p||^2, it is the work of the average stress.
PointMaker hysteretic_points(std::shared_ptr<const HystereticLaw> law, std::vector<PlaneStrain> plastic_at_rest = {});

/// The largest shear stress is c' cos phi' + s'_m sin phi' with the mean effective stress at rest; without a curve of
/// G over strain, the curve is the hyperbola that tends to this stress.
extern const SoilLawRow hysteretic_row;

}  // namespace upbead
