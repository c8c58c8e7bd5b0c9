// The keys of a table [measured.NAME].
#pragma once

#include "input/schema.h"
#include "upbead/case/case.h"

namespace upbead {

TableSchema<MeasuredSource> measured_schema();

}  // namespace upbead
