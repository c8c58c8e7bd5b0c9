// Starting a study on several cores.
#pragma once

namespace upbead {

/// Whether mpirun, or a cluster's launcher, has started this process.
bool is_launched();

/// Cores that this process may use.
int available_cores();

/// Becomes `mpirun -n processes` of this very command line. Returns only where there is no mpirun.
void launch(int processes);

/// Whether a person sees what goes to stderr, be it through mpirun.
bool has_terminal();

}  // namespace upbead
