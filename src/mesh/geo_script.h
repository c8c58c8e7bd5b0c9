// Scripts of gmsh (.geo) read as text, before anything is run: the parameters that they offer, and the commands that
// reach out of them.
#pragma once

#include <string>
#include <vector>

#include "upbead/base/error.h"

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

struct OutsideCommand {
  Place place;
  std::string word;   ///< as in the script
  std::string would;  ///< "start a program"
};

/// Those of a .geo and of the scripts that it includes or merges by a name that stands there as it is, in their order,
/// of gmsh 4.8 (its reference manual, "Scripting language"). Others, which build their own words, are for the confined
/// process. An unreadable file has none.
std::vector<OutsideCommand> outside_commands(const std::string& file);

}  // namespace upbead
