// A case on cells half as large: what the cells that it has make wrong.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// The scene on its mesh with every cell split into four, undivided. Soil that has followed the strain keeps what it
/// came to in each cell; an interface stays.
Simulation with_halved_cells(const Simulation& simulation);

/// The same on the same cells.
Simulation assembled_again(const Simulation& simulation);

/// How wrong the cells of a scene make F_T: by so much it moves on those of `finer`, times what is measured in
/// docs/accuracy.md. Both are solved alike, by a reduced model, or marched where one of them has not converged. Glued.
/// Throws NumericsError as a march does.
ShearError error_of_cells(const Simulation& simulation, const Simulation& finer);

/// A bound of the error, of what an answer moved by on cells half as large.
ShearError with_margin(const ShearError& moved);

}  // namespace upbead
