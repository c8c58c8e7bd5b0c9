// How wrong the peak of F_T is, added up by source.
#pragma once

#include "upbead/app/pipeline.h"

namespace upbead {

/// Of a run on a mesh that was made for the tolerance (`scene.accuracy`), from
/// - the cells (mesh_error of the last mesh);
/// - the steps of a march: the peak moves by so much from steps twice as long, over 3, as its order is 2 at least, on
/// the
///   coarse mesh that the refinement started from;
/// - the vectors of a reduced model: its peak against that of the last smaller one;
/// - the far sides, again on the coarse mesh: sides that hold what comes (roller, sealed) and sides that give way
/// (free,
///   open) send back waves of opposite signs, so that the mean of both is without (Smith 1974); F_T of the case differs
///   from it by so much at the time of its peak.
ErrorEstimate estimate_error(const Case& input, const CompiledCase& scene, const Run& run);

}  // namespace upbead
