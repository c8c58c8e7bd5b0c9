// What may be wrong with the files of a case.
#pragma once

#include "upbead/base/numbered_warning.h"
#include "upbead/case/case.h"

namespace upbead {

/// Those of all histories that come from files (model/record.h).
NumberedWarnings history_warnings(const Case& input);

/// load_zero: a load or uplift that is zero within the run, as where a wrong column was read.
NumberedWarnings zero_load_warnings(const Case& input);

}  // namespace upbead
