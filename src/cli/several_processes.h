// One run on several processes.
#pragma once

#include <functional>

#include "upbead/algebra/processes.h"
#include "upbead/case/case.h"

namespace upbead {

/// Throws InputError at the keys of a case that ask for what is not done on several processes; checkpoints are not.
void check_processes(const Case& input, bool with_checkpoints);

/// Calls work(); where it fails on one of the processes, says so once and ends them all, as the others would wait for
/// that one for ever. Alone (null), exceptions pass.
void run_together(const Processes* processes, const std::function<void()>& work);

}  // namespace upbead
