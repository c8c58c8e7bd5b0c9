// Which runs of a study stay together in one process, and in one part.
#pragma once

#include <vector>

#include "base/parts.h"
#include "study/results.h"

namespace upbead {

/// The runs that have no result yet; those that differ only in [sliding] form a piece, as one solution serves all of
/// them. The pieces are ordered by case and mesh, so that a process can often reuse its mesh.
Pieces schedule(const Study& study, const Results& results);

/// Those of the pieces.
Pieces without_done(const Pieces& pieces, const Results& results);

/// The runs of each part: those that share a basis stay together as far as parts stay balanced. It depends on the study
/// and the number of parts alone, so that parts need no talk.
std::vector<Pieces> deal(const Study& study, int parts);

}  // namespace upbead
