// Walks over the faces of the ground that the caisson stands on, and over their nodes.
#pragma once

#include <functional>

#include "fem/faces.h"

namespace upbead {

/// Calls visit(cell of the ground, face) where it touches the caisson.
void for_each_bottom_face(const Space& space, const std::function<void(const Cell&, unsigned)>& visit);

/// Calls visit(index in the cell, component, node's point) for the displacements of a face.
void for_each_displacement(
    const Space& space, const Cell& cell, unsigned f,
    const std::function<void(unsigned index, unsigned component, const dealii::Point<dim>& at)>& visit);

}  // namespace upbead
