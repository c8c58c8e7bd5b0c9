// Checks across the keys of a design.
#pragma once

#include "design.h"

namespace upbead {

void check_section(const DesignTables& tables, const Document& document, InputReport& report);
void check_waves(const DesignTables& tables, const Document& document, InputReport& report);
void check_ground(const DesignTables& tables, const Document& document, InputReport& report);

}  // namespace upbead
