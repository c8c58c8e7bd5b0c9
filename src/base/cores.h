// Processor cores that a process may use.
#pragma once

namespace upbead {

/// Whether mpirun, or a cluster's launcher, has started this process.
bool is_launched();

/// Cores that this process may use.
int available_cores();

/// Whether a second thread has a core of its own: not where mpirun or a launcher has started other processes too.
bool has_spare_core();

}  // namespace upbead
