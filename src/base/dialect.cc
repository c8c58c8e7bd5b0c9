#include "base/dialect.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <tuple>

#include "base/numbers.h"
#include "base/text.h"

namespace upbead {

namespace {

using namespace std::string_view_literals;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Characters of two and three bytes that stand in numbers: groups of thousands and a minus.
constexpr std::pair<std::string_view, char> spelled[]{{"\xC2\xA0"sv, '\''},
                                                      {"\xE2\x80\xAF"sv, '\''},
                                                      {"\xE2\x80\x89"sv, '\''},
                                                      {"\xE2\x80\x99"sv, '\''},
                                                      {"\xE2\x88\x92"sv, '-'}};

constexpr std::size_t longest_number = 60;

/// A cell as sign, digits and exponent, with what its points and commas can mean.
struct NumberShape {
  bool is_number = false;
  char decimal = 0;    ///< the decimal sign, where the cell shows it
  char undecided = 0;  ///< a sign that is a decimal sign or groups thousands
  char groups = 0;     ///< the sign that groups thousands, where the cell shows it
  std::size_t size = 0;
  std::array<char, longest_number + 1> text{};  ///< with one byte a character
};

/// Digits in groups of three behind a first group of one to three, which does not begin with zero.
bool is_grouped(std::string_view digits, char sign) {
  std::size_t first = digits.find(sign);
  if (first == std::string_view::npos || first < 1 || first > 3 || digits[0] == '0') return false;
  for (; first < digits.size(); first += 4)
    if (digits[first] != sign || digits.size() - first < 4 || !is_digit(digits[first + 1]) ||
        !is_digit(digits[first + 2]) || !is_digit(digits[first + 3]))
      return false;
  return true;
}

/// Copies the cell with one byte a character; false where it is too long for a number.
bool spell(std::string_view cell, bool blank_groups, NumberShape& shape) {
  for (std::size_t i = 0; i < cell.size();) {
    if (shape.size == longest_number) return false;
    char c = cell[i];
    std::size_t length = 1;
    for (const auto& [bytes, by] : spelled)
      if (cell.compare(i, bytes.size(), bytes) == 0) {
        c = by;
        length = bytes.size();
      }
    if (blank_groups && c == ' ') c = '\'';
    if (c == 'D' || c == 'd') c = 'e';  // as Fortran writes exponents
    shape.text[shape.size++] = c;
    i += length;
  }
  return true;
}

/// Judges the signs in the digits before the exponent.
void judge(std::string_view digits, bool exponent, NumberShape& shape) {
  const auto count = [&](char sign) { return std::count(digits.begin(), digits.end(), sign); };
  const auto points = count('.'), commas = count(','), marks = count('\'');
  const auto settle = [&](char decimal, char groups) {
    const std::string_view whole = digits.substr(0, digits.find(decimal));
    if (groups != 0 && !is_grouped(whole, groups)) return;
    if (groups == 0 && (points + commas + marks > 1)) return;
    shape.decimal = decimal;
    shape.groups = groups;
    shape.is_number = true;
  };
  if (marks > 0) {
    if (points + commas > 1) return;
    if (points + commas == 1) return settle(points > 0 ? '.' : ',', '\'');
    shape.is_number = is_grouped(digits, '\'');
    shape.groups = '\'';
  } else if (points > 0 && commas > 0) {
    const char last = digits.rfind('.') > digits.rfind(',') ? '.' : ',';
    if (count(last) == 1) settle(last, last == '.' ? ',' : '.');
  } else if (points + commas > 1) {
    shape.groups = points > 0 ? '.' : ',';
    shape.decimal = points > 0 ? ',' : '.';
    shape.is_number = !exponent && is_grouped(digits, shape.groups);
  } else if (points + commas == 1) {
    const char sign = points > 0 ? '.' : ',';
    if (exponent || !is_grouped(digits, sign)) return settle(sign, 0);
    shape.undecided = sign;
    shape.is_number = true;
  } else {
    shape.is_number = true;
  }
}

NumberShape shape_of(std::string_view cell, bool blank_groups) {
  NumberShape shape;
  if (cell.empty() || !spell(cell, blank_groups, shape)) return shape;
  std::string_view text(shape.text.data(), shape.size);
  std::size_t begin = text[0] == '+' || text[0] == '-' ? 1 : 0, end = begin;
  bool digits = false;
  while (end < text.size() && (is_digit(text[end]) || text[end] == '.' || text[end] == ',' || text[end] == '\'')) {
    digits = digits || is_digit(text[end]);
    ++end;
  }
  if (!digits) return shape;
  bool exponent = false;
  if (end < text.size()) {
    if (text[end] != 'e' && text[end] != 'E') return shape;
    std::size_t at = end + 1;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    if (at == text.size() || !std::all_of(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), is_digit))
      return shape;
    exponent = true;
  }
  judge(text.substr(begin, end - begin), exponent, shape);
  return shape;
}

/// Blanks may group thousands between semicolons or tabs; between commas they would hide a lost separator.
bool may_group_blanks(char separator) {
  return separator == ';' || separator == '\t';
}

CellIs judged(double& number, std::errc error) {
  if (error == std::errc::result_out_of_range) return CellIs::out_of_range;
  if (!std::isfinite(number)) return CellIs::infinite;
  if (is_too_large(number)) return CellIs::too_large;
  if (is_too_small(number)) number = 0.;  // programs that write a decaying quantity end with such numbers
  return CellIs::number;
}

bool stands_for_missing(std::string_view cell) {
  constexpr std::size_t longest_word = 8;
  if (cell.size() > longest_word) return false;
  std::string word(cell);
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string_view known :
       {"-", "--", "---", "na", "n/a", "#n/a", "nan", "-nan", "+nan", "null", "none", "mm", "*", "missing", "."})
    if (word == known) return true;
  return false;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto drop = [&text](std::string_view nbsp) {
    bool any = false;
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1), any = true;
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1), any = true;
    if (text.substr(0, nbsp.size()) == nbsp) text.remove_prefix(nbsp.size()), any = true;
    if (text.size() >= nbsp.size() && text.substr(text.size() - nbsp.size()) == nbsp)
      text.remove_suffix(nbsp.size()), any = true;
    return any;
  };
  while (drop("\xC2\xA0")) {
  }
  return text;
}

std::string separators(const Dialect& dialect) {
  switch (dialect.separator) {
    case ';':
      return "semicolons";
    case '\t':
      return "tabs";
    case ',':
      return "commas";
    case ' ':
      return "blanks";
    default:
      return in_quotes(std::string(1, dialect.separator));
  }
}

std::string text_of(const Dialect& dialect) {
  return "columns separated by " + separators(dialect) + ", decimal " + (dialect.decimal == '.' ? "points" : "commas");
}

void split(std::string_view line, const Dialect& dialect, std::vector<Cell>& cells) {
  cells.clear();
  const bool blanks = dialect.separator == ' ';
  for (std::size_t at = 0; at <= line.size();) {
    while (at < line.size() && line[at] != dialect.separator && is_blank(line[at])) ++at;
    if (blanks)
      while (at < line.size() && is_blank(line[at])) ++at;
    if (blanks && at == line.size()) break;
    const int column = static_cast<int>(at) + 1;
    std::size_t end = at;
    std::string_view text;
    const std::size_t closing =
        dialect.quotes && at < line.size() && line[at] == '"' ? line.find('"', at + 1) : line.npos;
    if (closing != line.npos) {
      end = closing;
      while (end + 1 < line.size() && line[end + 1] == '"') {  // a doubled quote stands for one
        const std::size_t next = line.find('"', end + 2);
        if (next == line.npos) break;
        end = next;
      }
      text = trimmed(line.substr(at + 1, end - at - 1));
      const std::size_t behind = end + 1;
      end = behind;
    }
    const std::size_t from = end;
    while (end < line.size() && (blanks ? !is_blank(line[end]) : line[end] != dialect.separator)) ++end;
    if (closing == line.npos || !trimmed(line.substr(from, end - from)).empty())
      text = trimmed(line.substr(at, end - at));
    cells.push_back({text, column});
    at = end + 1;
  }
}

std::size_t filled(const std::vector<Cell>& cells) {
  std::size_t n = cells.size();
  while (n > 0 && cells[n - 1].text.empty()) --n;
  return n;
}

CellIs read_cell(std::string_view cell, const Dialect& dialect, double& number) {
  if (cell.empty()) return CellIs::empty;
  const char *begin = cell.data() + (cell.size() > 1 && cell[0] == '+' ? 1 : 0), *end = cell.data() + cell.size();
  const bool as_it_stands = dialect.decimal == '.' ? !dialect.undecided : cell.find_first_of(".,") == cell.npos;
  if (as_it_stands) {
    const auto [stop, error] = std::from_chars(begin, end, number);
    if (stop == end && error != std::errc::invalid_argument) {
      if (std::isnan(number)) return CellIs::infinite;
      return judged(number, error);
    }
  }
  NumberShape shape = shape_of(cell, dialect.blank_groups);
  if (!shape.is_number) return stands_for_missing(cell) ? CellIs::missing : CellIs::no_number;
  if (shape.decimal != 0 && shape.decimal != dialect.decimal) return CellIs::other_decimal;
  if (shape.undecided != 0 && dialect.undecided) return CellIs::undecided;
  char* to = shape.text.data();
  for (const char* from = to; from < shape.text.data() + shape.size; ++from)
    if (*from == dialect.decimal)
      *to++ = '.';
    else if (*from != '.' && *from != ',' && *from != '\'')
      *to++ = *from;
  const char* text = shape.text.data();
  const auto [stop, error] = std::from_chars(*text == '+' ? text + 1 : text, to, number);
  if (stop != to) return CellIs::no_number;
  const CellIs is = judged(number, error);
  return is == CellIs::number && shape.undecided != 0 && shape.undecided != dialect.decimal ? CellIs::grouped : is;
}

bool read_row(std::string_view line, const Dialect& dialect, std::vector<double>& row) {
  if (dialect.undecided || dialect.quotes) return false;
  const bool blanks = dialect.separator == ' ', commas = dialect.decimal == ',';
  std::array<char, longest_number> copy{};
  std::size_t at = 0;
  const auto skip = [&] {
    while (at < line.size() && is_blank(line[at]) && (blanks || line[at] != dialect.separator)) ++at;
  };
  for (std::size_t c = 0; c < row.size(); ++c) {
    skip();
    const char *begin = line.data() + at, *end = line.data() + line.size();
    std::size_t size = 0;
    if (commas) {
      for (; begin + size < end && begin[size] != dialect.separator && !is_blank(begin[size]); ++size) {
        if (size == longest_number || begin[size] == '.') return false;
        copy[size] = begin[size] == ',' ? '.' : begin[size];
      }
      const auto [stop, error] = std::from_chars(copy.data(), copy.data() + size, row[c]);
      if (error != std::errc() || stop != copy.data() + size) return false;
    } else {
      const auto [stop, error] = std::from_chars(begin, end, row[c]);
      if (error != std::errc()) return false;
      size = static_cast<std::size_t>(stop - begin);
    }
    if (!(std::abs(row[c]) <= largest_magnitude)) return false;
    if (is_too_small(row[c])) row[c] = 0.;
    at += size;
    const std::size_t behind = at;
    skip();
    if (c + 1 == row.size()) {  // separators may follow
      while (at < line.size() && (is_blank(line[at]) || line[at] == dialect.separator)) ++at;
      return at == line.size();
    }
    if (blanks ? at == behind : at >= line.size() || line[at] != dialect.separator) return false;
    if (!blanks) ++at;
  }
  return true;
}

std::string objection(CellIs is, std::string_view cell, const Dialect& dialect) {
  const std::string text = in_quotes(cell);
  const auto sign = [](char c) { return c == '.' ? " point" : " comma"; };
  switch (is) {
    case CellIs::empty:
      return "an empty cell";
    case CellIs::out_of_range:
      return text + " is beyond the range of a number";
    case CellIs::infinite:
      return text + " is not finite";
    case CellIs::too_large:
      return text + " is larger than any quantity in SI units";
    case CellIs::other_decimal:
      return text + " has a decimal" + sign(dialect.decimal == '.' ? ',' : '.') + " in a file of decimal" +
             sign(dialect.decimal) + "s";
    case CellIs::undecided:
      return text + " may be " +
             (cell.find(',') == cell.npos ? "1.250 or 1250: no cell tells whether a point"
                                          : "1,250 or 1250: no cell tells whether a comma") +
             " is the decimal sign or groups thousands";
    default:
      return text + " is not a number";
  }
}

std::string cure_of(CellIs is) {
  if (is == CellIs::other_decimal) return "write the whole file with one decimal sign";
  if (is == CellIs::undecided) return "write whole numbers without a sign, or a number with other than three decimals";
  return "give a finite number such as 1.5e6";
}

namespace {

/// What a separator makes of some lines.
struct Split {
  std::size_t n = 0;        ///< cells of most lines with numbers
  std::size_t written = 0;  ///< the same with separators at the lines' ends
  std::size_t lines = 0;    ///< of that kind
  std::size_t alike = 0;    ///< lines with as many cells, with numbers or not
  std::size_t numbers = 0, words = 0;
  std::vector<bool> numeric;
  std::tuple<std::size_t, std::size_t, double> rank() const { return {lines, alike, merit()}; }
  /// Lines with numbers, times the share of numbers in them.
  double merit() const {
    return static_cast<double>(lines * numbers) / static_cast<double>(std::max<std::size_t>(numbers + words, 1));
  }
};

void add_line(const std::vector<Cell>& cells, const Dialect& dialect, Split& split) {
  std::vector<bool> numeric;
  std::size_t numbers = 0, words = 0;
  const bool blank_groups = may_group_blanks(dialect.separator) && cells.size() > 1;
  for (const Cell& cell : cells) {
    double ignored = 0.;
    numeric.push_back(shape_of(cell.text, blank_groups).is_number);
    numbers += numeric.back() ? 1U : 0U;
    words += !numeric.back() && read_cell(cell.text, dialect, ignored) == CellIs::no_number ? 1U : 0U;
  }
  ++split.alike;
  if (numbers == 0) return;
  split.n = cells.size();
  ++split.lines;
  split.numbers += numbers;
  split.words += words;
  split.numeric.resize(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) split.numeric[c] = split.numeric[c] || numeric[c];
}

Split split_by(const std::vector<std::string_view>& lines, const Dialect& dialect) {
  std::map<std::size_t, Split> by_size;
  std::vector<Cell> cells;
  for (const std::string_view line : lines) {
    split(line, dialect, cells);
    if (filled(cells) > 0) add_line(cells, dialect, by_size[cells.size()]);
  }
  Split best;
  for (const auto& [n, found] : by_size)
    if (found.lines > 0 && found.rank() >= best.rank()) best = found;
  std::size_t used = 0;  // a column that is empty in all these lines comes from separators at their ends
  for (const std::string_view line : lines) {
    split(line, dialect, cells);
    if (cells.size() == best.n) used = std::max(used, filled(cells));
  }
  best.written = best.n;
  best.n = used;
  best.numeric.resize(used);
  return best;
}

/// A later separator must be clearly better: a title such as "Run 7" may look like a row by blanks.
bool is_better(const Split& found, const Split& best) {
  constexpr double round_off = 1e-12, clearly = 1.2;
  const bool more_columns = found.n > 1 && best.n <= 1;
  const bool at_ends = found.n == best.n && found.written > 1 && best.written <= 1;
  if (more_columns || at_ends) return found.merit() > best.merit() * (1. - round_off);
  return (found.n > 1 || best.n <= 1) && found.merit() > best.merit() * clearly;
}

}  // namespace

TableShape shape_of_table(const std::vector<std::string_view>& lines, bool quotes, char given) {
  TableShape shape;
  shape.dialect.quotes = quotes;
  Split best;
  const auto attempt = [&](char separator, bool always) {
    Dialect dialect = shape.dialect;
    dialect.separator = separator;
    Split found = split_by(lines, dialect);
    if (!always && !is_better(found, best)) return;
    shape.dialect = dialect;
    best = std::move(found);
  };
  attempt(given != 0 ? given : ';', true);
  if (given == 0)
    for (const char separator : {'\t', ',', ' '}) {
      const bool one_ends = may_group_blanks(shape.dialect.separator) && best.written > 1 && best.n == 1;
      attempt(separator, false);
      shape.two_ways = one_ends && shape.dialect.separator == ' ' && best.n > 1;
    }
  if (best.written <= 1 && given == 0) {  // rows of one cell: the header tells the separator, if any
    const auto any = [&lines](char c) {
      return std::any_of(lines.begin(), lines.end(), [c](std::string_view line) { return line.find(c) != line.npos; });
    };
    attempt(any(',') ? ',' : any(';') ? ';' : any('\t') ? '\t' : ',', true);
  }
  shape.dialect.blank_groups = may_group_blanks(shape.dialect.separator) && best.written > 1;
  shape.n = best.n;
  shape.numeric = best.numeric;
  return shape;
}

void decide_signs(std::string_view rows, Dialect& dialect) {
  // beside commas between the cells a point is a decimal point
  if (dialect.separator == ',' && !dialect.quotes && rows.find(',') != rows.npos) return;
  char undecided = 0;
  bool both = false;
  std::vector<Cell> cells;
  while (!rows.empty()) {
    const std::size_t end = std::min(rows.find('\n'), rows.size());
    split(rows.substr(0, end), dialect, cells);
    rows.remove_prefix(std::min(end + 1, rows.size()));
    for (const Cell& cell : cells) {
      if (cell.text.find_first_of(".,") == cell.text.npos) continue;
      const NumberShape shape = shape_of(cell.text, dialect.blank_groups);
      if (!shape.is_number) continue;
      if (shape.decimal != 0) {
        dialect.decimal = shape.decimal;
        return;
      }
      both = both || (undecided != 0 && shape.undecided != undecided);
      undecided = shape.undecided;
    }
  }
  dialect.undecided = undecided != 0;
}

}  // namespace upbead
