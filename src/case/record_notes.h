// What a person is told of how a record was read.
#pragma once

#include <string>
#include <vector>

#include "upbead/base/numbered_warning.h"

namespace upbead {

/// A part of a file that is not used, and why.
struct LeftOut {
  std::string what, why;
};

struct RecordNotes {
  std::vector<LeftOut> left_out;
  NumberedWarnings warnings;
};

}  // namespace upbead
