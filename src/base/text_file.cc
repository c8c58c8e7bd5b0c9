#include "upbead/base/text_file.h"

#include <zlib.h>

#include <filesystem>
#include <memory>

#include "upbead/base/input_file.h"

namespace upbead {

std::string read_text(const std::string& path, std::uintmax_t most, const Place& place) {
  require_readable(path, most, place);
  // what is not packed comes out as it is
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) throw InputError(place, "cannot read '" + path + "'", "check the path and the rights");
  constexpr unsigned piece = 1U << 20U;
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
      throw InputError(place, "'" + path + "' is damaged where it is packed by gzip", "pack it again");
    if (text.size() > most)
      throw InputError(place, "'" + path + "' holds more than " + std::to_string(most / 1'000'000) + " MB unpacked",
                       "is it the right file? a record may be thinned");
    if (n == 0) return text;
  }
}

}  // namespace upbead
