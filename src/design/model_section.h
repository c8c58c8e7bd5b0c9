// Whether a reduced model is of the section of a design.
#pragma once

#include "upbead/base/numbered_warning.h"
#include "upbead/output/model_file.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// Warning model_of_other_section of each that differs by more than 2 %, of water's density 1 %: depth of water and h',
/// where the model's case has [section] or a shipped section with a sea, and W'. Voids the verdict.
NumberedWarnings warnings_of_other_section(const ReducedModelFile& file, const Section& section, const Water& water);

}  // namespace upbead
