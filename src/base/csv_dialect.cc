#include "csv_dialect.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/magnitude.h"
#include "base/quoted.h"
#include "base/units.h"

namespace upbead::detail {

namespace {

constexpr std::string_view blanks = " \t\r";

bool is_blank(char c) {
  return blanks.find(c) != std::string_view::npos;
}

/// As from_chars, which knows neither a leading plus nor decimal commas.
std::from_chars_result parse(std::string_view text, Dialect dialect, double& number) {
  const char *begin = text.data(), *end = begin + text.size();
  if (text.size() > 1 && *begin == '+') ++begin;
  if (!dialect.decimal_comma() || text.find(',') == std::string_view::npos) return std::from_chars(begin, end, number);
  std::string with_point(begin, end);
  if (with_point.find('.') == std::string::npos) with_point.replace(with_point.find(','), 1, ".");
  const auto [stop, error] = std::from_chars(with_point.data(), with_point.data() + with_point.size(), number);
  return {begin + (stop - with_point.data()), error};
}

/// Where the slash is behind which a unit follows, as ISO 80000-1 has it: "t / s", "p1/kPa", "F/kN/m"; npos without.
std::size_t slash_before_unit(std::string_view text) {
  constexpr std::size_t longest_unit = 20;
  if (text.size() <= longest_unit && unit_of(std::string(text))) return std::string_view::npos;  // "kN/m" alone
  for (std::size_t at = text.find('/', 1); at != std::string_view::npos; at = text.find('/', at + 1)) {
    const std::string_view behind = trimmed(text.substr(at + 1));
    if (behind.size() > longest_unit) continue;
    if (const auto unit = unit_of(std::string(behind)); unit && unit->si != "1") return at;
  }
  return std::string_view::npos;
}

}  // namespace

Dialect dialect_of(std::string_view header) {
  for (const char separator : {';', '\t'})
    if (header.find(separator) != std::string_view::npos &&
        (separator == ';' || header.find(',') == std::string_view::npos))
      return {separator};
  return {};
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks), last = text.find_last_not_of(blanks);
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

std::vector<Cell> cells_of(std::string_view line, Dialect dialect) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(dialect.separator, begin), line.size());
    std::size_t text = begin;
    while (text < end && is_blank(line[text])) ++text;
    cells.push_back({trimmed(line.substr(begin, end - begin)), static_cast<int>(text) + 1});
    begin = end + 1;
  }
  return cells;
}

std::string read_number(std::string_view cell, Dialect dialect, double& number) {
  const std::string text(cell);
  const auto [stop, error] = parse(text, dialect, number);
  if (text.empty()) return "an empty cell";
  if (error == std::errc::result_out_of_range) return in_quotes(text) + " is beyond the range of a number";
  if (error != std::errc() || stop != text.data() + text.size()) return in_quotes(text) + " is not a number";
  if (!std::isfinite(number)) return in_quotes(text) + " is not finite";
  if (is_too_large(number)) return in_quotes(text) + " is larger than any quantity in SI units";
  if (is_too_small(number)) number = 0.;  // what is left of a number that decays in some program
  return "";
}

bool read_row(std::string_view line, Dialect dialect, std::vector<double>& row) {
  std::size_t at = 0;
  for (std::size_t c = 0; c < row.size(); ++c) {
    while (at < line.size() && line[at] != dialect.separator && is_blank(line[at])) ++at;
    const auto [stop, error] = parse(line.substr(at), dialect, row[c]);
    if (error != std::errc() || !(std::abs(row[c]) <= largest_magnitude)) return false;
    if (is_too_small(row[c])) row[c] = 0.;
    at = static_cast<std::size_t>(stop - line.data());
    while (at < line.size() && line[at] != dialect.separator && is_blank(line[at])) ++at;
    const bool last = c + 1 == row.size();
    if (last ? at != line.size() : at >= line.size() || line[at] != dialect.separator) return false;
    ++at;
  }
  return true;
}

Heading heading(std::string_view cell) {
  std::string_view text = trimmed(cell);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = trimmed(text.substr(1, text.size() - 2));
  const std::size_t open = text.find_last_of("([");
  if (open == std::string_view::npos || open == 0 || (text.back() != ')' && text.back() != ']')) {
    const std::size_t slash = slash_before_unit(text);
    if (slash == std::string_view::npos) return {std::string(text), ""};
    return {std::string(trimmed(text.substr(0, slash))), std::string(trimmed(text.substr(slash + 1)))};
  }
  return {std::string(trimmed(text.substr(0, open))),
          std::string(trimmed(text.substr(open + 1, text.size() - open - 2)))};
}

}  // namespace upbead::detail
