// The versions of all libraries, which only their layers know, and those are not linked.
#include "output/versions.h"

namespace upbead {

std::string versions_line() {
  return "fuzz";
}

}  // namespace upbead
