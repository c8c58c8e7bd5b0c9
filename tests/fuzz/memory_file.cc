#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "target.h"

namespace upbead::fuzz {

namespace fs = std::filesystem;

namespace {

/// Removed when the process ends normally.
class Folder {
 public:
  Folder() {
    const fs::path memory = "/dev/shm";
    path =
        (fs::is_directory(memory) ? memory : fs::temp_directory_path()) / ("upbead-fuzz-" + std::to_string(getpid()));
    fs::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path path;
};

}  // namespace

std::string memory_file(const std::string& name, std::string_view bytes) {
  static const Folder folder;
  const fs::path path = folder.path / name;
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  require(!file.fail(), "there is room for the file of an input");
  return path.string();
}

}  // namespace upbead::fuzz
