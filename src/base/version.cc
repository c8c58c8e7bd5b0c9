#include "base/version.h"

namespace upbead {

namespace {

std::string compiler() {
#ifdef __clang__
  return __VERSION__;  // "Clang 14.0.6"
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

const char* program_version() {
  return "upbead " UPBEAD_VERSION;
}

Versions base_versions() {
  return {{"upbead", UPBEAD_VERSION}, {"compiler", compiler()}};
}

}  // namespace upbead
