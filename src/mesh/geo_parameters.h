// The parameters that a gmsh script offers.
#pragma once

#include <string>
#include <vector>

namespace upbead {

/// One number of a DefineConstant.
struct GeoParameter {
  std::string name;
  std::string default_value;  ///< as written: a number or an expression
  std::string description;    ///< the comment behind it on its line, or its gmsh label; may be empty
};

/// The parameters of a .geo and of the scripts that it includes, in their order, by reading the text: nothing is run.
/// An unreadable file has none.
std::vector<GeoParameter> geo_parameters(const std::string& file);

}  // namespace upbead
