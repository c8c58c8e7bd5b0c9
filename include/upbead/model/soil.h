// How a soil's stiffness and damping depend on its effective stress and on the strain of the waves.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace upbead {

/// G = reference (sigma'_m / pressure)^exponent with the mean effective stress sigma'_m = (s'_x + s'_y + s'_z)/3 of the
/// static state; Richart, Hall and Woods (1970) have exponent 0.5 for sands.
struct StressLaw {
  double reference = 0.;   ///< G at `pressure` (Pa)
  double pressure = 98e3;  ///< Pa
  double exponent = 0.5;
  /// Least sigma'_m that counts (Pa), as G vanishes at free surfaces; none: a tenth of the region's mean, so that
  /// similar scenes stay similar.
  std::optional<double> floor;
};

/// G (Pa) at a mean effective stress (Pa), not below the floor.
double shear_modulus(const StressLaw& law, double stress, double floor);

/// Secant stiffness and damping by the amplitude gamma of the shear strain. Without tables, of Hardin and Drnevich
/// (1972): G/G_max = 1/(1 + gamma/gamma_r), damping = smallest + (largest - smallest) (1 - G/G_max).
struct StrainLaw {
  double reference_strain = 1e-3;  ///< gamma_r, where G is half of G_max
  double smallest_damping = 0.02;  ///< ratio at vanishing strain
  double largest_damping = 0.20;   ///< ratio at large strain
  double effective = 0.65;         ///< effective over largest shear strain; Schnabel, Lysmer and Seed (1972)
  std::vector<std::array<double, 2>> modulus;  ///< (gamma, G/G_max), straight over log gamma; instead of the formula
  std::vector<std::array<double, 2>> damping;  ///< (gamma, ratio), likewise
};

double modulus_ratio(const StrainLaw& law, double strain);  ///< G/G_max
double damping_ratio(const StrainLaw& law, double strain);

/// The state before the waves.
struct InitialState {
  std::optional<double> water_level;  ///< height y of still water (m); none: the top of the regions of water
  std::optional<double> k0;           ///< s'_x = s'_z = K_0 s'_y; none: all from the elastic solution
};

}  // namespace upbead
