// Weights on the ground at rest that have no mass in the dynamics: foot-protection blocks, armour on a berm.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fem/space.h"

namespace upbead {

/// Horizontal length (m) of a face that a surcharge covers.
double covered(const Surcharge& surcharge, const dealii::Point<dim>& from, const dealii::Point<dim>& to);

/// A part of a face of what is not water, under a surcharge: the face is on the outside, or free water is beyond it.
struct SurchargePiece {
  dealii::Triangulation<dim>::active_cell_iterator cell;
  unsigned face = 0;
  double begin = 0., end = 0.;  ///< shares of the way from its first to its second vertex
  double from = 0., to = 0.;    ///< x of the ends, from < to (m)
  double weight = 0.;           ///< Pa, per horizontal length
};

/// Of all surcharges, one after the other.
std::vector<SurchargePiece> surcharge_pieces(const Scene& scene, const Mesh& mesh);

/// Calls add(cell, force upwards on each of its degrees of freedom (N/m)) for every face under a surcharge; `space`
/// has no cells of water.
void for_each_surcharge(const Scene& scene, const Space& space,
                        const std::function<void(const Cell&, const std::vector<double>&)>& add);

}  // namespace upbead
