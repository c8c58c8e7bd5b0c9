// Several processes of one command, which mpirun, srun or an array of jobs has started.
#pragma once

#include <optional>
#include <string>

namespace upbead {

/// Which of them this one is.
struct Launch {
  int rank = 0, size = 1;
  std::string by;  ///< the variable of the environment that tells the rank
  std::string id;  ///< equal in all of them, and in no other launch; "" where that is unknown
};

/// By Open MPI's mpirun, a launcher with PMI, or Slurm's srun; none where this process was started alone, or where a
/// launcher tells no number of processes.
std::optional<Launch> told_launch();
/// The same. Throws InputError where a launcher tells no number of processes.
std::optional<Launch> launch_of_environment();

/// By a Slurm array whose tasks are numbered from 0 or 1 without gaps. Throws InputError where it is none.
Launch launch_of_array();

/// Forgets the launcher, as this process and those that it starts take no part in its MPI: what MPI needs of the
/// environment is removed, so that it starts as for a lone process, and waits for no other.
void leave_launcher();

}  // namespace upbead
