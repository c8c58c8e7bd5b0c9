// Checks across the keys of a design.
#pragma once

#include "design.h"

namespace upbead {

void check_section(const DesignTables& tables, const Document& document, Diagnostics& report);
void check_waves(const DesignTables& tables, const Document& document, Diagnostics& report);
void check_ground(const DesignTables& tables, const Document& document, Diagnostics& report);

}  // namespace upbead
