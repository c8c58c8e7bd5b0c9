// Limits that no check has judged: they stay on the sheet.
#pragma once

#include "output/checks.h"
#include "upbead/model/scene.h"

namespace upbead {

/// For each limit that is given and that no check judges, or says why it does not, a check that was not made.
/// `of_run`: of those alone that a run judges, and no other command.
Checks unjudged_limits(const Limits& limits, const Checks& checks, bool of_run);

}  // namespace upbead
