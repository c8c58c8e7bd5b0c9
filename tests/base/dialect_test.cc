// Claim: whatever the dialect that a table is written in, it is read with the same numbers to the last bit, names and
// units, or it is refused; never with another number.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "base/csv.h"

namespace upbead {
namespace dialect_test {

enum class Format { shortest, fixed, scientific, whole };
enum class Head { brackets, slash, row, comment, none };
enum class Encoding { utf8, mark, utf16_little, utf16_big, latin };

/// How a table is written.
struct Style {
  char separator = ',', decimal = '.';
  std::string groups;  ///< of thousands; "" none
  Format format = Format::shortest;
  Head head = Head::brackets;
  Encoding encoding = Encoding::utf8;
  std::string end = "\n", title;
  bool quoted = false, trailing = false, sep_line = false, dates = false, last_end = true;
};

class Writer {
 public:
  explicit Writer(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return random_() % n; }
  bool sometimes(std::size_t in) { return below(in) == 0; }

  Style style() {
    Style s;
    s.separator = ";,\t "[below(4)];
    s.quoted = sometimes(4);
    s.decimal = s.separator == ',' && !s.quoted ? '.' : ".,"[below(2)];
    const std::string other = s.decimal == '.' ? "," : ".";
    if (sometimes(3) && (s.separator != ',' || s.quoted))
      s.groups = std::vector<std::string>{other, "\u00A0", "'", "\u202F", " "}[below(5)];
    if (s.groups == " " && s.separator != ';' && s.separator != '\t') s.groups = "";
    if (s.separator == ',' && !s.quoted && sometimes(4)) s.groups = "'";
    s.format = static_cast<Format>(below(4));
    s.head = static_cast<Head>(below(5));
    s.encoding = static_cast<Encoding>(below(5));
    if (s.encoding == Encoding::latin && s.groups == "\u202F") s.groups = "";
    s.end = std::vector<std::string>{"\n", "\r\n", "\r"}[below(3)];
    s.title = std::vector<std::string>{
        "", "", "Versuch 7", "# filtered at 300 Hz, run 7", "Messung auf der Platte; Lauf 12", "\t\tRun 7"}[below(6)];
    // one column in which blanks group thousands, without any separator, may be two columns
    s.trailing = s.separator != ' ' && (sometimes(4) || s.groups == " ");
    s.sep_line = s.separator != ' ' && sometimes(6);
    s.dates = sometimes(4);
    s.last_end = !sometimes(3);
    return s;
  }

  /// A number with a point and no groups.
  std::string number(Format format) {
    char text[40];
    const double size = std::pow(10., static_cast<double>(below(8)) - 2.);
    const double value = (static_cast<double>(below(2'000'001)) * 1e-6 - (sometimes(3) ? 1. : 0.)) * size;
    const int digits = static_cast<int>(below(5));
    const char* as = format == Format::shortest     ? "%.6g"
                     : format == Format::scientific ? "%.*e"
                     : format == Format::whole      ? "%.0f"
                                                    : "%.*f";
    if (format == Format::shortest || format == Format::whole)
      std::snprintf(text, sizeof text, as, value);
    else
      std::snprintf(text, sizeof text, as, digits, value);
    return text;
  }

  std::mt19937 random_;
};

/// A canonical number in a style.
std::string written(const std::string& number, const Style& style) {
  const std::size_t begin = number[0] == '-' ? 1 : 0, end = std::min(number.find_first_of(".e"), number.size());
  std::string whole = number.substr(begin, end - begin);
  for (std::size_t at = whole.size(); at > 3; at -= 3) whole.insert(at - 3, style.groups);
  std::string rest = number.substr(end);
  if (!rest.empty() && rest[0] == '.') rest[0] = style.decimal;
  const std::string text = number.substr(0, begin) + whole + rest;
  return style.quoted ? "\"" + text + "\"" : text;
}

std::string line_of(const std::vector<std::string>& cells, const Style& style) {
  std::string line;
  for (std::size_t c = 0; c < cells.size(); ++c) line += (c > 0 ? std::string(1, style.separator) : "") + cells[c];
  return line + (style.trailing ? std::string(1, style.separator) : "") + style.end;
}

std::string encoded(const std::string& text, Encoding encoding) {
  if (encoding == Encoding::utf8) return text;
  if (encoding == Encoding::mark) return "\xEF\xBB\xBF" + text;
  std::string bytes = encoding == Encoding::utf16_little ? "\xFF\xFE"
                      : encoding == Encoding::utf16_big  ? "\xFE\xFF"
                                                         : "";
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto code = static_cast<unsigned>(static_cast<unsigned char>(text[i]));
    const auto more = [&] { return static_cast<unsigned>(static_cast<unsigned char>(text[++i])) & 0x3FU; };
    if (code >= 0xE0U) {
      code = (code & 0xFU) << 12U;
      code |= more() << 6U;
      code |= more();
    } else if (code >= 0xC0U) {
      code = (code & 0x1FU) << 6U;
      code |= more();
    }
    const char high = static_cast<char>(code >> 8U), low = static_cast<char>(code & 0xFFU);
    if (encoding == Encoding::latin) bytes += low;
    if (encoding == Encoding::utf16_little) (bytes += low) += high;
    if (encoding == Encoding::utf16_big) (bytes += high) += low;
  }
  return bytes;
}

struct Written {
  std::string bytes;
  std::vector<std::vector<std::string>> numbers;  ///< by row, canonical
  std::size_t first = 0;                          ///< column of the first number
};

Written write(Writer& writer, const Style& style) {
  Written out;
  const std::size_t n = 1 + writer.below(4), rows = 1 + writer.below(12);
  out.first = style.dates ? 1 : 0;
  std::vector<std::string> names, units;
  const std::vector<std::string> name{"t", "p1", "p2", "F"}, unit{"s", "kPa", "kPa", "kN/m"};
  if (style.dates) {
    names.push_back("Datum");
    units.emplace_back("-");
  }
  const bool behind = style.head == Head::brackets || style.head == Head::comment;
  for (std::size_t c = 0; c < n; ++c) {
    const std::string full = name[c] + (behind                      ? " (" + unit[c] + ")"
                                        : style.head == Head::slash ? " / " + unit[c]
                                                                    : "");
    names.push_back(style.quoted ? "\"" + full + "\"" : full);
    units.push_back(unit[c]);
  }
  std::string text = style.sep_line ? std::string("sep=") + style.separator + style.end : "";
  if (!style.title.empty()) text += style.title + style.end;
  if (style.head == Head::comment) text += "# ";
  if (style.head != Head::none) text += line_of(names, style);
  if (style.head == Head::row) text += line_of(units, style);
  for (std::size_t r = 0; r < rows; ++r) {
    std::vector<std::string> cells;
    if (style.dates) cells.emplace_back("05/11/2026");
    out.numbers.emplace_back();
    for (std::size_t c = 0; c < n; ++c) {
      out.numbers.back().push_back(writer.number(style.format));
      cells.push_back(written(out.numbers.back().back(), style));
    }
    text += line_of(cells, style);
  }
  if (!style.last_end) text.resize(text.size() - style.end.size());
  out.bytes = encoded(text, style.encoding);
  return out;
}

class Dialects : public testing::Test {
 protected:
  Dialects()
      : path_((std::filesystem::temp_directory_path() / ("upbead-dialect-" + std::to_string(getpid()) + ".csv"))
                  .string()) {}
  ~Dialects() override { std::filesystem::remove(path_); }

  CsvTable read(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary) << bytes;
    return read_csv(path_, {"case.toml", 3, 1});
  }

  /// Whether the table is read; it must then be read right.
  bool is_read(const Written& one) const {
    try {
      const CsvTable table = read(one.bytes);
      std::vector<std::vector<double>> columns;
      for (std::size_t c = one.first; c < table.columns.size(); ++c) columns.push_back(table.numbers(c));
      EXPECT_EQ(columns.size(), one.numbers.front().size());
      if (columns.size() != one.numbers.front().size()) return true;
      for (std::size_t c = 0; c < columns.size(); ++c) {
        EXPECT_EQ(columns[c].size(), one.numbers.size());
        for (std::size_t r = 0; r < std::min(columns[c].size(), one.numbers.size()); ++r)
          EXPECT_EQ(columns[c][r], std::strtod(one.numbers[r][c].c_str(), nullptr)) << "row " << r << ", column " << c;
      }
      return true;
    } catch (const InputError& error) {
      reason_ = error.what();
      return false;
    }
  }

  /// Reads n tables in random dialects; returns how many.
  std::size_t count_read(unsigned seed, std::size_t n) const {
    Writer writer(seed);
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Style style = writer.style();
      const Written one = write(writer, style);
      count += is_read(one) ? 1U : 0U;
      EXPECT_EQ(reason_.find("not a number"), std::string::npos) << reason_ << "\n"
                                                                 << testing::PrintToString(one.bytes);
      if (HasFailure()) {
        ADD_FAILURE() << "table " << i << ": " << testing::PrintToString(one.bytes);
        return 0;
      }
    }
    return count;
  }

  std::string path_;
  mutable std::string reason_;
};

TEST_F(Dialects, GiveTheSameNumbersOrAreRefused) {
  EXPECT_GT(count_read(1, 1000), 700U);
}

TEST_F(Dialects, GiveTheSameNumbersOrAreRefusedAtLength) {
  EXPECT_GT(count_read(2, 100'000), 70'000U);
}

}  // namespace dialect_test
}  // namespace upbead
