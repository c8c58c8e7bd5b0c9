// Replaces the versions of all libraries: only layers that are not linked here know them.
#include "output/versions.h"

namespace upbead {

std::string versions_line() {
  return "fuzz";
}

}  // namespace upbead
