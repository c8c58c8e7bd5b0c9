// The keys of a table [measured.NAME].
#pragma once

#include "upbead/case/measured_source.h"
#include "upbead/input/schema.h"

namespace upbead {

TableSchema<MeasuredSource> measured_schema();

}  // namespace upbead
