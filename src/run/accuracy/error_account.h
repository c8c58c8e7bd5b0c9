// How wrong F_T and S are, added up by source.
#pragma once

#include "upbead/run/simulation.h"

namespace upbead {

/// Fills in what a run's F_T and S are wrong by, where its mesh was made for the tolerance (`simulation.accuracy`) or
/// the case asks for it (accuracy.estimate); else why that is not told. From
/// - the cells: F_T and S on cells half as large (finer.h);
/// - the steps of a march: F_T moves by so much with steps half as long, on the coarse mesh that the refinement started
///   from; of contact node by node on the mesh itself;
/// - the vectors of a reduced model: its F_T against that of the last smaller one;
/// - the far sides, of the peak alone, on the coarse mesh: sides that hold what comes (roller, sealed) and sides that
///   give way (free, open) send back waves of opposite signs, so that the mean of both is without (Smith 1974); F_T of
///   the case differs from it by so much at the time of its peak. Far sides may be meant as they are, and the truth
///   that the other parts are about has them, too.
void estimate_errors(Run& run);

}  // namespace upbead
