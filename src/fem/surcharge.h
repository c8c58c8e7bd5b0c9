// Weights on the ground at rest that have no mass in the dynamics: foot-protection blocks, armour on a berm.
#pragma once

#include <functional>

#include "fem/space.h"

namespace upbead {

/// Horizontal length (m) of a face that a surcharge covers.
double covered(const Surcharge& surcharge, const dealii::Point<dim>& from, const dealii::Point<dim>& to);

/// Calls add(cell, force upwards on each of its degrees of freedom (N/m)) for every face under a surcharge; `space`
/// has no cells of water.
void for_each_surcharge(const Scene& scene, const Space& space,
                        const std::function<void(const Cell&, const std::vector<double>&)>& add);

}  // namespace upbead
