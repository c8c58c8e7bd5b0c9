#include "upbead/base/input_file.h"

#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace upbead {

void require_readable(const std::string& path, std::uintmax_t most, const Place& place) {
  std::error_code ignored;  // what may not be looked at cannot be opened either
  const fs::file_type type = fs::status(path, ignored).type();
  if (type == fs::file_type::character || type == fs::file_type::block)
    throw InputError(place, "'" + path + "' is a device", "name a file");
  if (type == fs::file_type::regular) {
    const std::uintmax_t size = fs::file_size(path, ignored);
    if (size > most)
      throw InputError(place,
                       "'" + path + "' holds " + std::to_string(size / 1'000'000) + " MB; at most " +
                           std::to_string(most / 1'000'000) + " MB are read",
                       "is it the right file? a record may be thinned");
  } else if (type == fs::file_type::fifo) {
    return;  // looking at it would wait for its writer
  }
  std::ifstream file(path, std::ios::binary);
  // a folder opens like a file and fails at the first character
  if (!file.good() || (file.peek(), file.bad()))
    throw InputError(place, "cannot read '" + path + "'", "check the path and the rights");
}

}  // namespace upbead
