// Processor cores that a process may use.
#pragma once

namespace upbead {

/// Whether mpirun, or a cluster's launcher with PMI or PMIx, has started this process, and MPI can ask it for the
/// others. Not srun --mpi=none, whose processes MPI takes for lone ones.
bool is_launched();

/// Cores that this process may use.
int available_cores();

/// Variable of the environment in processes that share the runs of a study.
constexpr const char* study_worker = "UPBEAD_STUDY_WORKER";

/// Whether a second thread has a core of its own: not where mpirun, a launcher or a study has started other processes
/// too.
bool has_spare_core();

}  // namespace upbead
