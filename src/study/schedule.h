// Which runs follow one another in one process.
#pragma once

#include <vector>

#include "journal.h"
#include "study/study.h"

namespace upbead {

/// The runs that have no result yet, in pieces that stay in one process: runs that differ in [sliding] alone, as one
/// solution does for all of them. The pieces are ordered by case and mesh, so that a process finds its mesh made.
std::vector<std::vector<int>> schedule(const Study& study, const Results& results);

}  // namespace upbead
