// The limits of a case: each has one row with its key and sense. Checks are held to them; those that no check has
// judged stay on the sheet.
#pragma once

#include "output/checks.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Completes a check that is held to a limit, or to `natural` where that is not given. The limit says whether the
/// demand must exceed it.
Check held_to(Check check, const Limits& limits, std::optional<double> Limits::*limit,
              const std::optional<double>& natural = {});

/// For each limit that is given and that no check judges, or says why it does not, a check that was not made.
/// `of_run`: of those alone that a run judges, and no other command.
Checks unjudged_limits(const Limits& limits, const Checks& checks, bool of_run);

}  // namespace upbead
