#include "base/cores.h"

#include <sched.h>

#include <algorithm>
#include <cstdlib>

namespace upbead {

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

bool has_spare_core() {
  return available_cores() > 1 && !is_launched() && std::getenv(study_worker) == nullptr;
}

}  // namespace upbead
