#include "base/launch.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <vector>

#include "base/text.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

std::string variable(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? "" : text;
}

/// A whole number of at least 0; none where the variable is none.
std::optional<int> number_in(const char* name) {
  const std::string text = variable(name);
  char* end = nullptr;
  const long number = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || number < 0 || number > 1000000000) return std::nullopt;
  return static_cast<int>(number);
}

/// Variables of a launcher. Those inside others come first: mpirun starts its daemons by srun, which leaves its own.
struct Launcher {
  const char *rank, *size;
  std::array<const char*, 2> id;  ///< together they name the launch
};

constexpr std::array launchers{
    Launcher{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", {"OMPI_MCA_ess_base_jobid", ""}},
    Launcher{"PMI_RANK", "PMI_SIZE", {"PMI_JOBID", ""}},
    // srun alone sets this number: that of a job, SLURM_NTASKS, is also there in a script that sbatch starts once
    Launcher{"SLURM_PROCID", "SLURM_STEP_NUM_TASKS", {"SLURM_JOB_ID", "SLURM_STEP_ID"}}};

}  // namespace

std::optional<Launch> told_launch() {
  for (const Launcher& launcher : launchers) {
    const auto rank = number_in(launcher.rank), size = number_in(launcher.size);
    if (!rank || !size || *rank >= *size) continue;
    Launch launch{*rank, *size, launcher.rank, variable(launcher.id[0])};
    if (launcher.id[1][0] != '\0') launch.id += "." + variable(launcher.id[1]);
    return launch;
  }
  return std::nullopt;
}

std::optional<Launch> launch_of_environment() {
  if (auto launch = told_launch()) return launch;
  if (!variable("PMIX_RANK").empty())
    throw InputError({}, "a launcher has set PMIX_RANK, but no variable tells how many processes it has started",
                     "say --part K/N, or start by mpirun or srun");
  return std::nullopt;
}

Launch launch_of_array() {
  const auto id = number_in("SLURM_ARRAY_TASK_ID"), count = number_in("SLURM_ARRAY_TASK_COUNT"),
             first = number_in("SLURM_ARRAY_TASK_MIN"), last = number_in("SLURM_ARRAY_TASK_MAX");
  if (!id || !count || !first || !last)
    throw InputError({}, "--part auto: neither mpirun, srun nor a Slurm array has started this process",
                     "say which part of how many: --part K/N");
  // tasks that are submitted again, --array=3,7, are fewer than the parts
  if (*first > 1 || *last - *first + 1 != *count || *count == 1 || *id < *first || *id > *last)
    throw InputError({},
                     "--part auto: this array of " + std::to_string(*count) + " tasks from " + std::to_string(*first) +
                         " to " + std::to_string(*last) + " does not tell how many parts the study has",
                     "say so: --part $SLURM_ARRAY_TASK_ID/N");
  return {*id - *first, *count, "SLURM_ARRAY_TASK_ID", variable("SLURM_ARRAY_JOB_ID")};
}

void leave_launcher() {
  std::vector<std::string> names;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    for (const char* of_mpi : {"OMPI_", "PMIX_", "PMI_"})
      if (starts_with(text, of_mpi)) names.push_back(text.substr(0, text.find('=')));
  }
  for (const std::string& name : names) unsetenv(name.c_str());
  unsetenv("SLURM_NODELIST");
}

}  // namespace upbead
