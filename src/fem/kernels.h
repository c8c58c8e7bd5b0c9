// The blocks of M, C and K on one cell. Names (kernels.cc) are rows, columns, matrix: up_C is the block of C in the
// equation of u that multiplies the rate of phi. Tested with (du, dW, -dphi) every block is symmetric:
//
//   momentum   rho u'' + rho_f W'' - div(sigma'(u) - alpha phi' I) = 0
//   fluid      rho_f u'' + a W'' + b W' + grad phi' = 0                         (inertial flow)
//   mass       alpha div u' + div W' + phi''/Q = 0,  W' = -(1/b) grad phi'      (the latter: darcy flow)
//              b of horizontal flow; of vertical flow b k_x/k_y
//   water      div W' + phi''/K_f = 0,               W' = -grad phi / rho_f     (W the water's own displacement)
//
// Biot (1962), Zienkiewicz, Chang and Bettess (1980); the form in phi: docs/theory.md.
#pragma once

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include "fem/space.h"

namespace upbead {

/// M, C and K of one cell, over the cell's degrees of freedom.
struct CellMatrices {
  dealii::FullMatrix<double> M, C, K;
  void reinit(unsigned n) { M.reinit(n, n), C.reinit(n, n), K.reinit(n, n); }
};

/// Strain of the shape function i at the quadrature point q.
PlaneStrain strain_of(const dealii::FEValues<dim>& fe, unsigned i, unsigned q);

/// All blocks of a cell of that kind. Without inertia (consolidation) M keeps the storage pp_M only.
void assemble_cell(const dealii::FEValues<dim>& fe, const Material& material, CellKind kind, bool inertia,
                   CellMatrices& cell);

}  // namespace upbead
