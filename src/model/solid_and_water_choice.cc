#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "model/choices.h"

namespace upbead {

namespace {

// Measured on the shipped prototype, so that peak F_T moves by less than 0.1 %: docs/skipping.md.
constexpr double largest_of_incompressible = 0.2;  ///< omega h / c
constexpr double largest_of_rigid = 0.01;          ///< G of what it touches over its own, times (height/width)^2
constexpr double largest_crossing = 0.3;           ///< omega height / V_s

/// Frequency of the loads (rad/s); infinite where one jumps, 0 where none has a duration.
double frequency(const Scene& scene) {
  const double duration = shortest_duration(scene);
  return duration > 0. ? pi / duration : infinity;
}

/// The largest shear modulus of the regions that a region touches (Pa).
double stiffest_neighbour(const Surroundings& at, const Scene& scene) {
  double G = 0.;
  for (const std::string& name : at.touches) {
    const Region& other = scene.regions.at(name);
    if (other.kind == RegionKind::rigid) return infinity;
    G = std::max(G, material(other, scene.fluid, scene.gravity).G);
  }
  return G;
}

}  // namespace

CompressibilityChoice choose_compressibility(const Region& region, const Surroundings& at, const Scene& scene) {
  using C = Compressibility;
  if (region.compressibility != C::automatic) return {region.compressibility, "stated in the case"};
  const double c = std::sqrt(scene.fluid.bulk_modulus / scene.fluid.density), omega = frequency(scene);
  const double ratio = std::isinf(c) ? 0. : omega * at.height / c;
  const std::string text = "omega h/c = " + significant(ratio), limit = significant(largest_of_incompressible);
  if (!at.has_open_side) return {C::compressible, "it has no open level at which it could give way"};
  if (ratio > largest_of_incompressible) return {C::compressible, text + " > " + limit + ": sound takes its time"};
  return {C::incompressible, text + " <= " + limit + ": sound crosses its depth at once"};
}

DeformationChoice choose_deformation(const Region& region, const Surroundings& at, const Scene& scene) {
  using D = Deformation;
  if (region.deformation != D::automatic) return {region.deformation, "stated in the case"};
  if (at.is_held) return {D::elastic, "one of its sides is held"};
  if (at.has_probe) return {D::elastic, "it is looked into, by a probe or by fields"};
  const Material m = material(region, scene.fluid, scene.gravity);
  const double slenderness = at.width > 0. ? at.height / at.width : infinity;
  const double stiffness = stiffest_neighbour(at, scene) / m.G * std::max(1., slenderness * slenderness);
  const double crossing = frequency(scene) * at.height / std::sqrt(m.G / m.rho);
  const std::string text = "softness " + significant(stiffness) + ", omega h/V_s = " + significant(crossing);
  const std::string limits = significant(largest_of_rigid) + " and " + significant(largest_crossing);
  if (stiffness > largest_of_rigid || crossing > largest_crossing) return {D::elastic, text + ": above " + limits};
  return {D::rigid, text + " <= " + limits + ": it moves as a rigid body"};
}

}  // namespace upbead
