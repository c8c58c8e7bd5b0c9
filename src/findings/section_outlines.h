// The outlines of a section's regions, for pictures of it that need no mesher.
#pragma once

#include <vector>

#include "output/result_file.h"
#include "upbead/mesh/mesh.h"

namespace upbead {

/// A table /section/REGION for each region: its outer sides, x and y of their two ends, a row for each side of a cell.
std::vector<Dataset> section_outlines(const Mesh& mesh);

}  // namespace upbead
