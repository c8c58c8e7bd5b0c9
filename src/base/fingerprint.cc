#include "base/fingerprint.h"

#include <fstream>
#include <sstream>

namespace upbead {

void Fingerprint::add_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  add(path.filename().string());
  add(text.str());
}

}  // namespace upbead
