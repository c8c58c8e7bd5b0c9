// Terms that faces on sides add to the system: open sides, where pores drain; absorbing sides, which let waves out;
// the free surface of water, with its waves; and faces where water meets something that moves.
//
// If phi were fixed at the nodes of an open side, soil that hardly drains within a step would need a boundary layer
// far thinner than its cells: the pressure would overshoot by a quarter from cell to cell, and a whole row of cells
// would drain that should not (Vermeer and Verruijt 1981). Imposed weakly, the side drains as much as the cells
// resolve: not at all where the layer is much thinner than a cell, fully where it is thicker.
#pragma once

#include "fem/faces.h"
#include "fem/unknowns.h"

namespace upbead {

/// Whether pore water drains freely through a face, to the outside or into a drained region.
bool drains(const Scene& scene, const Space& space, const Cell& cell, unsigned face);

/// Calls visit(terms) for every outer face where the boundary is open and the cell has pore water, and for every face
/// between pore water and a drained porous region, where the pressure is zero. With the jump
/// [phi] = phi - sum_k intensity_k phi_k over the prescribed phi_k, the mobility 1/b, a penalty g for each kind of
/// flow, and the cell's size h across the face (where flow is not alike in all directions, of grad phi the vertical
/// part counts k_y/k_x times, and g/h the k along the normal over k_x):
///
/// Darcy flow, Nitsche (1971): C gets
///   pp  -1/b ( g/h [dphi][phi] - [dphi] grad phi.n - grad dphi.n [phi] )
/// Inertial flow: the flux through the side is W.n itself (the local discontinuous Galerkin flux of Arnold, Brezzi,
/// Cockburn and Marini 2002), so C gets
///   Wp  -dW.n [phi] and its transpose;   pp  -g/(b h) [dphi][phi]
void for_each_open_face(const Scene& scene, const Space& space, const Unknowns& unknowns, const VisitFace& visit);

/// Calls visit(cell, curve, terms) for every absorbing face:
///   soil   uu_C  +normal (du.n)(u.n) + tangential (du.t)(u.t);  up_C  +coupling (du.n) phi and its transpose;
///          pp_C  -mobility dphi phi
///   water  pp_C  -1/(rho_f c) dphi phi, c = sqrt(K_f/rho_f); nothing where it is incompressible
/// and for every face with dashpots, which add to normal and tangential.
void for_each_absorbing_face(const Scene& scene, const Space& space,
                             const std::function<void(const Cell&, const std::string& curve, const FaceTerms&)>& visit);

/// Calls visit(terms) for every face with springs: uu_K  +spring_n (du.n)(u.n) + spring_t (du.t)(u.t).
void for_each_sprung_face(const Scene& scene, const Space& space, const VisitFace& visit);

/// Calls visit(terms) for every face of a free surface with gravity waves: pp_M -1/(rho_f g) dphi phi (linear waves,
/// p = rho_f g eta).
void for_each_surface_face(const Scene& scene, const Space& space, const VisitFace& visit);

/// Calls visit(face, terms) for every wet face, except on walls where the force was measured while the wall moved
/// (Load::measured_on_wall): such a history includes the water's reaction already, and the water stands before a wall
/// at rest. The water presses on the solid with p = phi', and gives way to the motion of the solid; with the normal n
/// out of the solid
///   up_C  +(du.n) phi  and its transpose.
/// Where the solid has pores, phi is one field through both, and water flows through the face.
void for_each_wet_face_term(const Scene& scene, const Space& space,
                            const std::function<void(const WetFace&, const FaceTerms&)>& visit);

}  // namespace upbead
