// Open sides: the pore pressure of a load there, or none, imposed weakly.
//
// With phi fixed at the nodes, soil that hardly drains within a step would have to build a skin far thinner than its
// cells: the pressure overshoots by a quarter from cell to cell, and a whole row of cells is drained that should not be
// (Vermeer and Verruijt 1981). Imposed weakly, the side drains as much as the cells resolve: not at all where the skin
// is much thinner than a cell, fully where it is thicker.
#pragma once

#include "fem/faces.h"
#include "fem/unknowns.h"

namespace upbead {

/// Calls visit(terms) for every outer face where the boundary is open and the cell has pore water, and for every face
/// between pore water and a drained porous region, where the pressure is none. With the jump
/// [phi] = phi - sum_k intensity_k phi_k over the prescribed phi_k, the mobility 1/b, a penalty g of each flow's own
/// and the cell's size h across the face:
///
/// Darcy flow, Nitsche (1971): C gets
///   pp  -1/b ( g/h [dphi][phi] - [dphi] grad phi.n - grad dphi.n [phi] )
/// Inertial flow: the flux through the side is W.n itself (the local discontinuous Galerkin flux of Arnold, Brezzi,
/// Cockburn and Marini 2002), so C gets
///   Wp  -dW.n [phi] and its transpose;   pp  -g/(b h) [dphi][phi]
void for_each_open_face(const Scene& scene, const Space& space, const Unknowns& unknowns, const VisitFace& visit);

}  // namespace upbead
