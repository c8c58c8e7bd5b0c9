#include "base/table_text.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/text.h"

namespace upbead {

namespace {

struct BinaryKind {
  std::string_view beginning;
  const char *what, *cure;
};

using namespace std::string_view_literals;

constexpr std::string_view hdf5_beginning = "\x89HDF\r\n\x1a\n"sv;

/// First bytes of files that are no text, by their formats' own documents.
constexpr BinaryKind kinds[]{
    {"PK\3\4"sv, "is a workbook of a spreadsheet (.xlsx, .ods) or a zip archive, not a text",
     "open it and save the sheet as CSV"},
    {"\xD0\xCF\x11\xE0"sv, "is a workbook of a spreadsheet (.xls), not a text", "open it and save the sheet as CSV"},
    {hdf5_beginning, "is an HDF5 file, not a text", "where a text is read, write its columns as CSV"},
    {"CDF\1"sv, "is a NetCDF file, not a text", "write its columns as CSV or HDF5"},
    {"CDF\2"sv, "is a NetCDF file, not a text", "write its columns as CSV or HDF5"},
    {"MATLAB 5.0 MAT-file"sv, "is a file of MATLAB, not a text", "write its columns as CSV, or save it with '-v7.3'"},
    {"PAR1"sv, "is a Parquet file, not a text", "write its columns as CSV or HDF5"},
    {"TDSm"sv, "is a file of LabVIEW (.tdms), not a text", "export it as CSV"},
    {"%PDF"sv, "is a PDF document, not a text", "write its table as CSV"},
    {"7z\xBC\xAF"sv, "is a packed archive, not a text", "unpack it"},
    {"BZh"sv, "is packed by bzip2", "unpack it, or pack it by gzip"},
    {"\xFD"
     "7zXZ"sv,
     "is packed by xz", "unpack it, or pack it by gzip"}};

void append_utf8(std::uint32_t code, std::string& text) {
  const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80U) return add(code);
  if (code < 0x800U) {
    add(0xC0U | code >> 6U);
  } else {
    if (code < 0x10000U) {
      add(0xE0U | code >> 12U);
    } else {
      add(0xF0U | code >> 18U);
      add(0x80U | (code >> 12U & 0x3FU));
    }
    add(0x80U | (code >> 6U & 0x3FU));
  }
  add(0x80U | (code & 0x3FU));
}

/// `high`: which of the two bytes of a unit comes first in its value, 0 (big-endian) or 1 (little-endian).
std::string from_utf16(std::string_view bytes, std::size_t high) {
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    return static_cast<unsigned char>(bytes[i + high]) * 256U + static_cast<unsigned char>(bytes[i + 1 - high]);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  constexpr std::uint32_t replacement = 0xFFFD;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xD800U && code < 0xE000U) {  // a pair of units is one character
      const std::uint32_t second = i + 3 < bytes.size() ? unit(i + 2) : 0U;
      const bool pair = code < 0xDC00U && second >= 0xDC00U && second < 0xE000U;
      code = pair ? 0x10000U + ((code - 0xD800U) << 10U) + (second - 0xDC00U) : replacement;
      if (pair) i += 2;
    }
    append_utf8(code, text);
  }
  return text;
}

/// UTF-16 without a byte order mark: of Latin text every other byte is zero. Which byte is the high one, or 2 for none.
std::size_t high_byte(std::string_view bytes) {
  constexpr std::size_t looked_at = 1000;
  std::size_t zeros[2] = {0, 0};
  const std::size_t n = std::min(bytes.size(), looked_at) / 2 * 2;
  for (std::size_t i = 0; i < n; ++i) zeros[i % 2] += bytes[i] == '\0' ? 1U : 0U;
  for (const std::size_t high : {0U, 1U})
    if (n > 0 && zeros[1 - high] == 0 && 10 * zeros[high] > 9 * (n / 2)) return high;
  return 2;
}

/// Characters 0x80 to 0x9F of Windows-1252; the others are those of Latin-1.
std::string from_windows_1252(std::string_view bytes) {
  constexpr std::uint16_t special[]{0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                    0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                    0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                    0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    append_utf8(byte >= 0x80U && byte < 0xA0U ? special[byte - 0x80U] : byte, text);
  }
  return text;
}

void end_lines(std::string& text) {
  if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
}

}  // namespace

std::size_t end_of_utf8(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    for (std::uint64_t eight = 0; i + sizeof eight <= text.size(); i += sizeof eight) {
      std::memcpy(&eight, text.data() + i, sizeof eight);
      if ((eight & 0x8080808080808080U) != 0) break;
    }
    if (i == text.size()) break;
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80U ? 1 : first < 0xC2U ? 0 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
    if (length == 0 || first > 0xF4U || i + length > text.size()) return i;
    for (std::size_t k = 1; k < length; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U) return i;
    i += length;
  }
  return text.size();
}

std::string as_utf8(std::string bytes, const std::string& path, const Place& place) {
  const auto begins = [&bytes](std::string_view with) { return bytes.compare(0, with.size(), with) == 0; };
  for (const BinaryKind& kind : kinds)
    if (begins(kind.beginning)) throw InputError(place, quoted_path(path) + " " + kind.what, kind.cure);
  if (begins("\xEF\xBB\xBF")) bytes.erase(0, 3);
  if (begins("\xFF\xFE") || begins("\xFE\xFF"))
    bytes = from_utf16(std::string_view(bytes).substr(2), bytes[0] == '\xFF' ? 1 : 0);
  else if (const std::size_t high = high_byte(bytes); high < 2)
    bytes = from_utf16(bytes, high);
  if (bytes.find('\0') != std::string::npos)
    throw InputError(place, quoted_path(path) + " holds zero bytes: it is no text", "name a table written as text");
  if (end_of_utf8(bytes) < bytes.size()) bytes = from_windows_1252(bytes);
  end_lines(bytes);
  return bytes;
}

bool is_hdf5_file(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;  // to open a pipe may never end
  std::string beginning(hdf5_beginning.size(), ' ');
  std::ifstream(path, std::ios::binary).read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning == hdf5_beginning;
}

}  // namespace upbead
