// Checks across the keys of a study.
#pragma once

#include "sampler.h"
#include "upbead/input/document.h"

namespace upbead {

/// Reports what is wrong with a study by itself, without its cases. `axes`: in the order of the file.
void check_study(const StudyTables& study, const std::vector<Axis>& axes, const Document& document,
                 Diagnostics& report);

/// Throws InputError where a key is written without quotes, [vary.time.end]: what the schema would say of that is no
/// help.
void require_quoted_keys(const Document& document);

}  // namespace upbead
