// Scripts of gmsh (.geo) read as text, before anything is run: their parameters, and their commands that do more than
// draw and mesh.
#pragma once

#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

/// One number of a DefineConstant.
struct GeoParameter {
  std::string name;
  std::string default_value;  ///< as written: a number or an expression
  std::string description;    ///< the comment after it on its line, or its gmsh label; may be empty
};

/// The parameters of a .geo and of the scripts that it includes, in their order. The text is read, nothing is run. An
/// unreadable file has none.
std::vector<GeoParameter> geo_parameters(const std::string& file);

/// The file and all that it reads as far as texts in it name them: scripts that are included or merged, meshes,
/// drawings, each once. Names that a script builds at run time are not known.
std::vector<std::string> files_of_mesh(const std::string& file);

struct OutsideCommand {
  Place place;
  std::string word;   ///< as in the script
  std::string would;  ///< "start a program"
};

/// Such commands of a .geo and of the scripts that it includes or merges by a literal name, in their order, as of
/// gmsh 4.8 (its reference manual, "Scripting language"). Scripts that build names or commands at run time are left
/// to the confined process. An unreadable file has none.
std::vector<OutsideCommand> outside_commands(const std::string& file);

}  // namespace upbead
