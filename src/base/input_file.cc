#include "base/input_file.h"

#include <filesystem>
#include <fstream>

#include "base/quoted.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// What is no file, and how to mend that; nothing of a file, or of what is not there.
Mistake not_a_file(fs::file_type type) {
  switch (type) {
    case fs::file_type::directory:
      return {{}, "is a folder", "name a file in it"};
    case fs::file_type::character:
    case fs::file_type::block:
      return {{}, "is a device", "name a file"};
    case fs::file_type::socket:
      return {{}, "is a socket", "name a file"};
    case fs::file_type::fifo:
      return {{},
              "is a pipe, which may never end and can be read only once",
              "write it into a file first and name that: COMMAND > FILE, in place of <(COMMAND)"};
    default:
      return {};
  }
}

}  // namespace

void require_readable(const std::string& path, std::uintmax_t most, const Place& place) {
  std::error_code ignored;  // what may not be looked at cannot be opened either
  const fs::file_type type = fs::status(path, ignored).type();
  if (const Mistake found = not_a_file(type); !found.what.empty())
    throw InputError(place, quoted_path(path) + " " + found.what, found.cure);
  if (type == fs::file_type::regular) {
    const std::uintmax_t size = fs::file_size(path, ignored);
    if (size > most)
      throw InputError(place,
                       quoted_path(path) + " holds " + std::to_string(size / 1'000'000) + " MB; at most " +
                           std::to_string(most / 1'000'000) + " MB are read",
                       "is it the right file? a record may be thinned");
  }
  if (type != fs::file_type::regular || !std::ifstream(path, std::ios::binary).good())
    throw InputError(place, "cannot read " + quoted_path(path), "check the path and the rights");
}

}  // namespace upbead
