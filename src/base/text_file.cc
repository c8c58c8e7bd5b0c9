#include "base/text_file.h"

#include <zlib.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "base/text.h"

namespace fs = std::filesystem;

namespace upbead {

std::string read_text(const std::string& path, std::uintmax_t most, const Place& place) {
  require_readable(path, most, place);
  // gzread passes on the bytes of a file that is not packed
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) throw InputError(place, "cannot read " + quoted_path(path), "check the path and the rights");
  constexpr unsigned piece = 1U << 20U;
  // tables of numbers shrink 2 to 20 times, a zip bomb 1000 times
  constexpr std::size_t harmless = 64'000'000, most_unpacked = 100;
  gzbuffer(file.get(), piece);
  std::string text;
  std::error_code ignored;
  if (const std::uintmax_t size = std::filesystem::file_size(path, ignored); !ignored) text.reserve(size + piece);
  while (true) {
    const std::size_t before = text.size();
    text.resize(before + piece);
    const int n = gzread(file.get(), text.data() + before, piece);
    text.resize(before + static_cast<std::size_t>(std::max(n, 0)));
    int code = Z_OK;
    if (n < 0 || (gzerror(file.get(), &code), code == Z_BUF_ERROR || code == Z_DATA_ERROR))
      throw InputError(place, quoted_path(path) + " is damaged where it is packed by gzip", "pack it again");
    if (text.size() > most)
      throw InputError(place,
                       quoted_path(path) + " holds more than " + std::to_string(most / 1'000'000) + " MB unpacked",
                       "is it the right file? a record may be thinned");
    if (const std::uintmax_t packed = static_cast<std::uintmax_t>(std::max<z_off_t>(gzoffset(file.get()), 0));
        text.size() > harmless && text.size() > most_unpacked * packed)
      throw InputError(place,
                       quoted_path(path) + " unpacks to more than " + std::to_string(most_unpacked) +
                           " times its size: so much alike is no record",
                       "is it the right file? else unpack it before");
    if (n == 0) return text;
  }
}

namespace {

/// Names what is no file, and the cure; empty for a file, or where nothing is there.
Diagnostic not_a_file(fs::file_type type) {
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
  std::error_code ignored;  // what cannot be looked at cannot be opened either, which is checked later
  const fs::file_type type = fs::status(path, ignored).type();
  if (const Diagnostic found = not_a_file(type); !found.what.empty())
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
