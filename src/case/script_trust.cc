#include "script_trust.h"

#include <filesystem>

#include "base/confined_work.h"
#include "upbead/base/error.h"

namespace upbead {

void require_trust(const Case& problem, bool trusted) {
  const auto& file = problem.scene.mesh.file;
  if (trusted || !file || std::filesystem::path(*file).extension() != ".geo" || can_confine()) return;
  throw InputError(
      problem.place("mesh.file"),
      "nothing on this machine (seccomp, Landlock) can keep '" + *file + "' from starting programs and writing files",
      "read it through, and if you trust it add --trust; or mesh it (gmsh -2) and give the .msh");
}

}  // namespace upbead
