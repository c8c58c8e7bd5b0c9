// Fields by cell, in one file for ParaView.
#pragma once

#include <string>
#include <vector>

#include "upbead/mesh/mesh.h"

namespace upbead {

/// A value of each cell by active cell index; NaN where there is none.
struct CellField {
  std::string name;  ///< with its unit, as "pressure_(Pa)"
  std::vector<double> values;
};

/// The bytes of a VTU file.
std::string cell_fields_vtu(const Mesh& mesh, const std::vector<CellField>& fields);

}  // namespace upbead
