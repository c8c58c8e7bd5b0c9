// Equality of what a scene is made of, member by member. A member that is added does not compile here until it is
// listed, so that no comparison forgets it.
#pragma once

#include <tuple>

#include "upbead/model/scene.h"

namespace upbead {

inline auto members(const Fluid& of) {
  const auto& [density, bulk_modulus, viscosity, atmospheric_pressure] = of;
  return std::tie(density, bulk_modulus, viscosity, atmospheric_pressure);
}
inline bool operator==(const Fluid& a, const Fluid& b) {
  return members(a) == members(b);
}

inline auto members(const StressLaw& of) {
  const auto& [reference, pressure, exponent, floor] = of;
  return std::tie(reference, pressure, exponent, floor);
}
inline bool operator==(const StressLaw& a, const StressLaw& b) {
  return members(a) == members(b);
}

inline auto members(const StrainLaw& of) {
  const auto& [reference_strain, smallest, largest, effective, modulus, damping] = of;
  return std::tie(reference_strain, smallest, largest, effective, modulus, damping);
}
inline bool operator==(const StrainLaw& a, const StrainLaw& b) {
  return members(a) == members(b);
}

inline auto members(const ContactLaw& of) {
  const auto& [kind, coefficient, gap] = of;
  return std::tie(kind, coefficient, gap);
}
inline bool operator==(const ContactLaw& a, const ContactLaw& b) {
  return members(a) == members(b);
}

inline auto members(const Rayleigh& of) {
  const auto& [ratio, frequencies, fit] = of;
  return std::tie(ratio, frequencies, fit);
}
inline bool operator==(const Rayleigh& a, const Rayleigh& b) {
  return members(a) == members(b);
}

inline auto members(const Strength& of) {
  const auto& [friction_angle, cohesion, dilatancy_angle, tension] = of;
  return std::tie(friction_angle, cohesion, dilatancy_angle, tension);
}
inline bool operator==(const Strength& a, const Strength& b) {
  return members(a) == members(b);
}

inline auto members(const Densification& of) {
  const auto& [relative_density, c1, c2, threshold] = of;
  return std::tie(relative_density, c1, c2, threshold);
}
inline bool operator==(const Densification& a, const Densification& b) {
  return members(a) == members(b);
}

inline auto members(const CyclicSoil& of) {
  const auto& [relative_density, alpha, beta] = of;
  return std::tie(relative_density, alpha, beta);
}
inline bool operator==(const CyclicSoil& a, const CyclicSoil& b) {
  return members(a) == members(b);
}

inline auto members(const BaseSupport& of) {
  const auto& [horizontal, vertical, rotation] = of;
  return std::tie(horizontal, vertical, rotation);
}
inline bool operator==(const BaseSupport& a, const BaseSupport& b) {
  return members(a) == members(b);
}

inline auto members(const WallWater& of) {
  const auto& [seaward, landward] = of;
  return std::tie(seaward, landward);
}
inline bool operator==(const WallWater& a, const WallWater& b) {
  return members(a) == members(b);
}

inline auto members(const BodyPart& of) {
  const auto& [x, y, density] = of;
  return std::tie(x, y, density);
}
inline bool operator==(const BodyPart& a, const BodyPart& b) {
  return members(a) == members(b);
}

inline auto members(const Region& of) {
  const auto& [kind, law, G, stress_law, strain_law, E, nu, density, mass, centre, inertia, parts, n, grain_density, k,
               kappa, forchheimer, ratio, saturation, by_depth, pore_fluid, flow, tortuosity, biot, K_s, damping,
               strength, densification, cyclic, interface, springs, dashpots, wall_water, deformation,
               compressibility] = of;
  return std::tie(kind, law, G, stress_law, strain_law, E, nu, density, mass, centre, inertia, parts, n, grain_density,
                  k, kappa, forchheimer, ratio, saturation, by_depth, pore_fluid, flow, tortuosity, biot, K_s, damping,
                  strength, densification, cyclic, interface, springs, dashpots, wall_water, deformation,
                  compressibility);
}
inline bool operator==(const Region& a, const Region& b) {
  return members(a) == members(b);
}

inline auto members(const Boundary& of) {
  const auto& [displacement, pressure, spring, dashpot] = of;
  return std::tie(displacement, pressure, spring, dashpot);
}
inline bool operator==(const Boundary& a, const Boundary& b) {
  return members(a) == members(b);
}

inline auto members(const Probe& of) {
  const auto& [at] = of;
  return std::tie(at);
}
inline bool operator==(const Probe& a, const Probe& b) {
  return members(a) == members(b);
}

inline auto members(const Cosine& of) {
  const auto& [length, origin] = of;
  return std::tie(length, origin);
}
inline bool operator==(const Cosine& a, const Cosine& b) {
  return members(a) == members(b);
}

/// Where and how a load acts, without its course in time: that is a function, which cannot be compared.
inline auto place_of(const Load& of) {
  const auto& [boundary, region, at, kind, direction, shape, over_x, along_curve, course, cosine, transducer, on_wall,
               factor, history, duration] = of;
  return std::tie(boundary, region, at, kind, direction, shape, over_x, along_curve, course, cosine, transducer,
                  on_wall);
}

}  // namespace upbead
