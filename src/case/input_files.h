// The files that a case reads.
#pragma once

#include <vector>

#include "base/files.h"
#include "upbead/case/case.h"

namespace upbead {

/// The case itself, its mesh, histories, records of transducers and measured records, each with the key that names
/// it.
std::vector<InputFile> input_files(const Case& problem);

}  // namespace upbead
