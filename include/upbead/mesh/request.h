// Where a mesh comes from.
#pragma once

#include <map>
#include <string>

#include "upbead/base/error.h"

namespace upbead {

/// Each value has its place in the case, for messages.
struct MeshRequest {
  std::string file;                          ///< .geo (gmsh script) or .msh (2.2 or 4.1)
  Place place;                               ///< of the key that names the file
  std::map<std::string, double> parameters;  ///< overrides of the .geo's DefineConstant
  std::map<std::string, Place> parameter_places;
  int refine = 0;  ///< uniform refinements
};

}  // namespace upbead
