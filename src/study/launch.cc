#include "launch.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace upbead {

namespace {

constexpr const char* terminal = "UPBEAD_TERMINAL";

/// Texts that end with a null character each, as /proc has them.
std::vector<std::string> texts_in(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<std::string> list;
  for (std::string text; std::getline(stream, text, '\0');) list.push_back(text);
  return list;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

/// The environment as this process was started with: PetscSession has told Open MPI since that it is alone.
std::vector<std::string> environment() {
  std::vector<std::string> list = texts_in("/proc/self/environ");
  for (const char* more : {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "OMP_NUM_THREADS=1",
                           "OPENBLAS_NUM_THREADS=1"}) {
    const std::string name = std::string(more).substr(0, std::string(more).find('=') + 1);
    list.erase(std::remove_if(list.begin(), list.end(), [&](const auto& text) { return text.rfind(name, 0) == 0; }),
               list.end());
    list.emplace_back(more);
  }
  if (has_terminal()) list.push_back(std::string(terminal) + "=1");
  return list;
}

std::string own_path() {
  std::string path(4096, '\0');
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size());
  path.resize(static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
  return path;
}

}  // namespace

bool is_launched() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

int available_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

void launch(int processes) {
  // quiet: the program itself says what went wrong; a container may forbid to bind and to copy between processes
  std::vector<std::string> command{
      "mpirun",    "--quiet", "-n",    std::to_string(processes),         "--oversubscribe",
      "--bind-to", "none",    "--mca", "btl_vader_single_copy_mechanism", "none",
      own_path()};
  const std::vector<std::string> own = texts_in("/proc/self/cmdline");
  command.insert(command.end(), own.begin() + 1, own.end());
  std::vector<std::string> variables = environment();
  execvpe("mpirun", pointers(command).data(), pointers(variables).data());
}

bool has_terminal() {
  return isatty(STDERR_FILENO) == 1 || std::getenv(terminal) != nullptr;
}

}  // namespace upbead
