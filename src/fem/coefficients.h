// The constants of a region that multiply terms of M, C and K: in these the System is a sum.
#pragma once

#include <array>
#include <map>
#include <string>

#include "fem/impedance.h"

namespace upbead {

/// Each multiplies terms of its own, see kernels.h and sides.h. Rayleigh damping is a product: its parts count.
enum class Coefficient {
  G,                    ///< K: 2 G eps:eps
  lambda,               ///< K: lambda (div u)^2
  rho,                  ///< M
  a,                    ///< M of W
  b,                    ///< C of W
  mobility,             ///< C: grad phi of darcy flow, and open sides of both flows
  alpha,                ///< C: div u phi
  storage,              ///< M of phi
  mass_damping_rho,     ///< C: Rayleigh's factor of M times rho
  stiffness_damping_G,  ///< C: Rayleigh's factor of K times G, and times lambda
  stiffness_damping_lambda,
  sealed_normal,  ///< C: sides whose pores are sealed, see Impedance
  sealed_tangential,
  open_normal,  ///< C: sides that absorb pressure, too
  open_tangential,
  open_coupling,
  open_mobility,
};
constexpr int n_coefficients = 17;

/// Values by Coefficient.
using Coefficients = std::array<double, n_coefficients>;

/// Those of a material in cells of that kind; 0 where such a cell has no such term.
Coefficients coefficients(const Material& material, CellKind kind);

/// Those of a region whose choices are made.
Coefficients coefficients(const Region& region, const Fluid& fluid, double gravity);

/// Those of all regions, by name.
std::map<std::string, Coefficients> coefficients(const std::map<std::string, Region>& regions, const Fluid& fluid,
                                                 double gravity);

/// A term of a System that is a sum over its soils' constants.
struct AffineTerm {
  std::string region;
  Coefficient coefficient = Coefficient::G;
};

/// Constants with which a region has the terms of that coefficient alone, multiplied by 1; of a product of Rayleigh's
/// factors beside them those of M or K.
RegionConstants unit_constants(Coefficient coefficient);

/// Whether the coefficient is a product with one of Rayleigh's factors, so that of its terms only those of C count.
bool is_of_damping(Coefficient coefficient);

/// The constants of a region without the terms of some coefficients. Where one of Rayleigh's products is left out, all
/// products with the same factor are.
RegionConstants without(RegionConstants constants, const std::array<bool, n_coefficients>& left_out);

}  // namespace upbead
