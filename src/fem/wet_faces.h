// Where free water meets something that moves.
#pragma once

#include "fem/faces.h"

namespace upbead {

/// Calls visit(face, terms) for every wet face but those of walls on which the force was measured while they moved
/// (Load::measured_on_wall): there the history holds the sea's answer already, and the water stands before a wall at
/// rest. The water presses on the solid with p = phi', and what the solid moves by the water gives way: with the normal
/// n out of the solid
///   up_C  +(du.n) phi  and its transpose.
/// Where the solid has pores, phi is one field through both and water flows through the face.
void for_each_wet_face_term(const Scene& scene, const Space& space,
                            const std::function<void(const WetFace&, const FaceTerms&)>& visit);

}  // namespace upbead
