// The geometries that come with the program.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "upbead/case/case.h"

namespace fs = std::filesystem;

namespace upbead {

std::string geometry_folder() {
  if (const char* folder = std::getenv("UPBEAD_MESHES")) {
    if (fs::is_directory(folder)) return folder;
    throw InputError(Place(), "UPBEAD_MESHES = '" + std::string(folder) + "' is no folder", "unset or mend it");
  }
  std::error_code code;
  const fs::path program = fs::read_symlink("/proc/self/exe", code);
  const fs::path installed = program.parent_path().parent_path() / "share" / "upbead" / "meshes";
  if (fs::is_directory(installed, code)) return installed.string();
  if (fs::is_directory(UPBEAD_MESH_DIR)) return UPBEAD_MESH_DIR;
  throw InputError(Place(), "no folder of shipped geometries", "set UPBEAD_MESHES to the folder of the .geo files");
}

std::vector<std::string> geometries() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(geometry_folder()))
    if (entry.path().extension() == ".geo") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace upbead
