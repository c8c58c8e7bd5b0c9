// Warnings as people read them.
#pragma once

#include <string>

#include "upbead/base/numbered_warning.h"

namespace upbead {

/// Warnings, one line each: "warning: NAME: text".
std::string describe(const NumberedWarnings& warnings);

}  // namespace upbead
