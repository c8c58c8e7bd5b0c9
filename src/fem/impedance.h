// How sides let waves out of a material.
#pragma once

#include "fem/cell_kind.h"
#include "upbead/model/region.h"

namespace upbead {

/// Impedance of a soil to a plane wave that leaves it (Pa s/m): traction = -(normal u_n' n + tangential u_t' t +
/// coupling p n), and water leaves through a side that absorbs pressure as well with W_n' = mobility p - coupling u_n'.
struct Impedance {
  double normal = 0., tangential = 0.;
  double coupling = 0., mobility = 0.;
};

/// Lysmer and Kuhlemeyer (1969): rho V_p and rho V_s, V_p of the undrained soil; the pores are sealed. Where the fluid
/// has inertia and the side absorbs pressure too (`open_to_waves`), both waves without drag at normal incidence: with
/// M = (rho, rho_f; rho_f, a) and A = (E + alpha^2 Q, alpha Q; alpha Q, Q), E = lambda + 2 G, the matrix Z, Z M^-1 Z =
/// A, gives (sigma_n, -p) = -Z (u_n', W_n'). Of free water 1/(rho_f c), c = sqrt(K_f/rho_f), for its pressure alone.
Impedance impedance(const Material& material, CellKind kind, bool open_to_waves);

/// The constants of one region's terms: of its cells, and of sides that let waves out of them.
struct RegionConstants {
  Material material;
  Impedance sealed, open;  ///< see impedance(): of sides whose pores are sealed, and of those that absorb pressure too
};

/// Speed of the fastest wave in a region (m/s): the undrained one; infinite in incompressible water and in soil full of
/// it, 0 in a rigid region.
double fastest_wave(const Region& region, const Fluid& fluid, double gravity);

}  // namespace upbead
