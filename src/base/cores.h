// Cores that a process has for itself.
#pragma once

namespace upbead {

/// Whether mpirun, or a cluster's launcher, has started this process.
bool is_launched();

/// Cores that this process may use.
int available_cores();

/// Whether a second thread has a core for itself: not beside other processes of the same work.
bool has_spare_core();

}  // namespace upbead
