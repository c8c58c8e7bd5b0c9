// The table [report] of cases, studies and designs.
#pragma once

#include "input/schema.h"
#include "upbead/input/report_head.h"

namespace upbead {

TableSchema<ReportHead> report_table();
/// The text about [report] in the reference.
extern const char* const report_table_doc;

}  // namespace upbead
