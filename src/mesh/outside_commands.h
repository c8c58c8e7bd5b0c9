// Commands of gmsh scripts that reach out of the script: found by reading, before anything is run.
#pragma once

#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

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
