// What is doubtful in a section whatever the wave: the part of warnings() of goda.h for commands that have many waves.
#pragma once

#include "upbead/waves/goda.h"

namespace upbead {

/// bed_slope, berm_below_bed, foundation_below_bed, buoyancy.
NumberedWarnings section_warnings(const Section& section, const Water& water);

}  // namespace upbead
