// Checks across the keys of a design, and of the models that it names, for `calibrate`.
#pragma once

#include "../design.h"

namespace upbead {

void check_calibration(const DesignTables& tables, const Document& document, Diagnostics& report);

}  // namespace upbead
