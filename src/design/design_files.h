// The files that a design reads.
#pragma once

#include <vector>

#include "base/files.h"
#include "design.h"

namespace upbead {

/// The design itself and the files that it names, each with the key.
std::vector<InputFile> input_files(const Design& design);

}  // namespace upbead
