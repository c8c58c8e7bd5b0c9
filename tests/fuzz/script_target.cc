// A script is scanned to its end, whatever its content; parameters have names, commands places.
#include "mesh/geo_script.h"
#include "target.h"

namespace upbead::fuzz {

void try_script(std::string_view bytes) {
  const std::string path = memory_file("script.geo", bytes);
  for (const GeoParameter& parameter : geo_parameters(path)) require(!parameter.name.empty(), "a parameter has a name");
  for (const OutsideCommand& command : outside_commands(path))
    require(command.place.line > 0 && command.place.column > 0 && !command.word.empty(), "a command has a place");
}

}  // namespace upbead::fuzz
