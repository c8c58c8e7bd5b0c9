#include "study/shared_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

void write_together(const std::vector<std::pair<std::string, std::string>>& files) {
  std::vector<std::string> own;
  std::string path;
  try {
    for (const auto& [name, text] : files) {
      path = name;
      own.push_back(name + ".XXXXXX");
      if (const int descriptor = mkstemp(own.back().data()); descriptor >= 0) close(descriptor);
      write_whole(own.back(), text);
    }
    for (std::size_t i = 0; i < files.size(); ++i) fs::rename(own[i], path = files[i].first);
  } catch (const std::exception&) {
    std::error_code ignored;
    for (const std::string& name : own) fs::remove(name, ignored);
    throw InputError({path}, "cannot be written", "make room on the disk, or choose another folder with --out DIR");
  }
}

bool is_first(const std::string& path) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor >= 0) close(descriptor);
  return descriptor >= 0;
}

}  // namespace upbead
