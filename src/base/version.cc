#include "upbead/base/version.h"

namespace upbead {

const char* program_version() {
  return "upbead " UPBEAD_VERSION;
}

}  // namespace upbead
