#include "base/table_head.h"

#include <algorithm>
#include <array>

#include "base/header_words.h"
#include "base/text.h"
#include "base/units.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using Words = std::vector<std::string>;

bool opens(char c) {
  return c == '(' || c == '[';
}

bool in_brackets(std::string_view text) {
  return text.size() > 1 && opens(text.front()) && (text.back() == ')' || text.back() == ']');
}

/// Place of the slash before a unit, as ISO 80000-1 writes it: "t / s", "p1/kPa", "F/kN/m"; npos where there is none.
std::size_t slash_before_unit(std::string_view text) {
  constexpr std::size_t longest_unit = 20;
  // a unit alone, such as "kN/m"
  if (text.size() <= longest_unit && unit_of(std::string(text))) return std::string_view::npos;
  for (std::size_t at = text.find('/', 1); at != std::string_view::npos; at = text.find('/', at + 1)) {
    const std::string_view behind = trimmed(text.substr(at + 1));
    if (behind.size() > longest_unit) continue;
    if (const auto unit = unit_of(std::string(behind)); unit && unit->si != "1") return at;
  }
  return std::string_view::npos;
}

std::string unquoted(std::string_view text) {
  std::string plain(text);
  if (plain.size() > 1 && plain.front() == '"' && plain.back() == '"') plain = plain.substr(1, plain.size() - 2);
  for (std::size_t at = 0; (at = plain.find("\"\"", at)) != std::string::npos; ++at) plain.erase(at, 1);
  return std::string(trimmed(plain));
}

/// Brackets at the end as ASCII has them: those of Japanese keyboards have full width.
std::string with_narrow_brackets(std::string text) {
  for (const auto& [wide_open, wide_close, pair] : {std::array<std::string, 3>{"（", "）", "()"}, {"［", "］", "[]"}}) {
    const std::size_t close = text.rfind(wide_close), open = text.rfind(wide_open);
    if (close == std::string::npos || close + wide_close.size() != text.size() || open == std::string::npos) continue;
    text.replace(close, wide_close.size(), pair.substr(1));
    text.replace(open, wide_open.size(), pair.substr(0, 1));
  }
  return text;
}

/// The name and the unit of "p1 (kPa)", "p1 [kPa]", "p1 / kPa" or "p1".
std::pair<std::string, std::string> heading(const std::string& written) {
  const std::string text = with_narrow_brackets(unquoted(written));
  const std::size_t open = text.find_last_of("([");
  if (open == std::string::npos || open == 0 || !in_brackets(std::string_view(text).substr(open))) {
    const std::size_t slash = slash_before_unit(text);
    const auto end = unit_at_end(text);  // "force_kN/m" is no quotient by m, but "force / MN/m" has the unit MN/m
    if (slash == std::string::npos || (end && slash >= end->name.size())) return {text, ""};
    return {std::string(trimmed(std::string_view(text).substr(0, slash))),
            std::string(trimmed(std::string_view(text).substr(slash + 1)))};
  }
  return {std::string(trimmed(std::string_view(text).substr(0, open))),
          std::string(trimmed(std::string_view(text).substr(open + 1, text.size() - open - 2)))};
}

std::string bare(const std::string& cell) {
  const std::string text = unquoted(cell);
  return in_brackets(text) ? std::string(trimmed(std::string_view(text).substr(1, text.size() - 2))) : text;
}

/// Words between blanks; brackets belong to the word before them, "Time (s)", and so does a unit behind a slash.
Words words_between_blanks(std::string_view line) {
  Words words;
  bool open = false, slash = false;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    const std::string word(line.substr(at, end - at));
    at = end + 1;
    if (word.empty()) continue;
    const bool of_name = !words.empty() && !in_brackets(words.back()) && opens(word.front());
    if (!words.empty() && (open || slash || of_name || word == "/"))
      words.back() += " " + word;
    else
      words.push_back(word);
    slash = word == "/";
    const std::size_t last = words.back().find_last_of("()[]");
    open = last != std::string::npos && opens(words.back()[last]);
  }
  return words;
}

Words words_between_gaps(std::string_view line) {
  Words words;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t gap = std::min({line.find("  ", at), line.find('\t', at), line.size()});
    if (const std::string_view word = trimmed(line.substr(at, gap - at)); !word.empty()) words.emplace_back(word);
    at = gap + 1;
  }
  return words;
}

/// A line as `n` names or units; empty where it is none.
Words cells_of_head(std::string_view line, const Dialect& dialect, std::size_t n) {
  if (dialect.separator == ' ') {
    for (const Words& words : {words_between_blanks(line), words_between_gaps(line)})
      if (words.size() == n) return words;
    return {};
  }
  Dialect quoted = dialect;
  quoted.quotes = true;
  std::vector<Cell> cells;
  split(line, quoted, cells);
  if (cells.size() < n || filled(cells) > n) return {};
  Words words;
  for (std::size_t c = 0; c < n; ++c) words.emplace_back(cells[c].text);
  return words;
}

/// A line above the numbers that may hold names or units.
struct HeadLine {
  std::size_t index = 0;  ///< among the lines
  bool comment = false;
  Words cells;
  std::size_t numbers = 0;  ///< cells that are numbers
  std::size_t units = 0, times = 0;
};

bool is_number(const std::string& cell, const Dialect& dialect) {
  double ignored = 0.;
  const CellIs is = read_cell(cell, dialect, ignored);
  return is == CellIs::number || is == CellIs::grouped || is == CellIs::undecided || is == CellIs::other_decimal;
}

HeadLine judged_line(const TableLine& line, std::size_t index, const TableShape& shape) {
  HeadLine head{index, is_comment(line.text), {}, 0, 0, 0};
  if (is_ruler(line.text)) return head;
  const std::string_view text = trimmed(line.text);
  if (head.comment) head.cells = cells_of_head(text.substr(1), shape.dialect, shape.n);
  if (head.cells.empty()) head.cells = cells_of_head(text, shape.dialect, shape.n);
  for (const std::string& cell : head.cells) {
    const auto [name, unit] = heading(cell);
    head.numbers += is_number(name, shape.dialect) ? 1U : 0U;
    const auto known = unit_of(unit);
    head.units += (!unit.empty() && known) || unit_at_end(name) ? 1U : 0U;
    head.times += header_says(name, unit) > HeaderSays::unit_of_time ? 1U : 0U;
  }
  const bool says =
      std::any_of(head.cells.begin(), head.cells.end(), [](const std::string& c) { return !unquoted(c).empty(); });
  if (!says || head.numbers == head.cells.size()) head.cells.clear();
  return head;
}

/// Whether a line that follows names holds their units: known ones, and beside them blanks, brackets and short words.
bool is_row_of_units(const HeadLine& line) {
  constexpr std::size_t longest_unit = 8;
  std::size_t known = 0;
  for (const std::string& cell : line.cells) {
    const std::string text = bare(cell);
    const auto unit = unit_of(text);
    if (unit && unit->si != "1") {
      ++known;
    } else if (!unit && !text.empty() && !in_brackets(unquoted(cell))) {
      const bool word = text.size() <= longest_unit && text.find_first_of("0123456789") == std::string::npos;
      if (!word || header_says(text, "") > HeaderSays::unit_of_time) return false;
    }
  }
  return known > 0 && line.units == 0;
}

/// Less is better: names are no numbers, and have units or are times.
std::pair<std::size_t, std::size_t> rank_of(const HeadLine& line) {
  return {line.numbers, line.cells.size() * 2 - line.units - line.times};
}

[[noreturn]] void refuse_two(const std::string& path, int first, int second) {
  throw InputError(
      {path, second, 1},
      "lines " + std::to_string(first) + " and " + std::to_string(second) + " both may hold the names of the columns",
      "keep one of them");
}

/// The line with the names, if any.
const HeadLine* names_of(const std::vector<HeadLine>& heads, const std::vector<TableLine>& lines,
                         const std::string& path) {
  const HeadLine* best = nullptr;
  const HeadLine* rival = nullptr;
  for (const HeadLine& head : heads) {
    if (best == nullptr || rank_of(head) < rank_of(*best)) {
      best = &head;
      rival = nullptr;
    } else if (rank_of(head) == rank_of(*best) && head.cells != best->cells) {
      const bool decides = head.comment != best->comment && (head.comment ? head : *best).units == 0;
      if (!decides) rival = &head;
      if (decides && best->comment) best = &head;
    }
  }
  if (rival == nullptr) return best;
  if (best->units + best->times == 0 && !best->comment && !rival->comment)
    return best;  // the other then is a row of no numbers
  refuse_two(path, lines[best->index].number, lines[rival->index].number);
}

/// A line above numbers without names must not say what would be lost: units, or names in another number.
void refuse_lost_names(const std::vector<TableLine>& lines, const TableShape& shape, int first_row,
                       const std::string& path) {
  for (const TableLine& line : lines) {
    if (shape.dialect.separator != ' ') {
      std::vector<Cell> cells;
      split(trimmed(line.text), shape.dialect, cells);
      if (filled(cells) > 1 && !is_comment(line.text))
        throw InputError(
            {path, first_row, 1},
            "cells in this row: " + std::to_string(shape.n) + ", in the header: " + std::to_string(filled(cells)),
            "give every row one number per column, separated by " + separators(shape.dialect) +
                (shape.dialect.separator == ',' ? "; decimal commas need semicolons, tabs or blanks between the columns"
                                                : ""));
    }
    for (const std::string& word : words_between_blanks(line.text)) {
      const auto [name, unit] = heading(word);
      if ((unit.empty() || !unit_of(unit)) && header_says(name, "") <= HeaderSays::capital && !unit_at_end(name))
        continue;
      throw InputError({path, line.number, 1},
                       in_quotes(trimmed(line.text)) + " does not name each of " + std::to_string(shape.n) + " column" +
                           (shape.n > 1 ? "s" : ""),
                       "separate names by commas, semicolons or tabs, or write a name of one word over each column");
    }
  }
}

/// "Unit: kPa" beside the names says which unit, but not of which columns.
void refuse_lost_units(const std::vector<TableLine>& lines, const TableHead& head, const Dialect& dialect,
                       const std::string& path) {
  std::size_t without = 0;
  for (std::size_t c = 0; c < head.names.size(); ++c)
    without +=
        head.units[c].empty() && unit_of_time(head.names[c], "").empty() && !unit_at_end(head.names[c]) ? 1U : 0U;
  const bool all_have =
      without == 0 || (without == 1 && head.names.size() > 1 &&
                       header_says(head.names[0], head.units[0]) > HeaderSays::counter && head.units[0].empty());
  if (all_have) return;
  for (const TableLine& line : lines) {
    if (line.number == head.line || line.number == head.unit_line) continue;
    std::string text(line.text);
    for (char& c : text)
      if (c == dialect.separator && c != ' ')
        c = ':';
      else if (c == '=' || c == ';')
        c = ':';
    const std::size_t colon = text.rfind(':', text.find_last_not_of(": \t\r"));
    if (colon == std::string::npos) continue;
    const std::string_view rest = trimmed(std::string_view(text).substr(colon + 1));
    const std::string word = bare(std::string(rest.substr(0, rest.find(':'))));
    if (const auto unit = unit_of(word);
        unit && word.size() > 1 && unit->si != "1" && unit->si != "s" && unit->si != "Hz" && unit->si != "m")
      throw InputError({path, line.number, 1}, in_quotes(trimmed(line.text)) + " gives a unit, but not by column",
                       "write it behind the names, such as p1 (" + word + ")");
  }
}

void add_units(const HeadLine& line, int number, const std::string& path, TableHead& head) {
  for (std::size_t c = 0; c < line.cells.size(); ++c) {
    const std::string unit = bare(line.cells[c]);
    if (unit.empty() || unit == "-") continue;
    if (head.units[c].empty()) {
      head.units[c] = unit;
      continue;
    }
    const auto above = unit_of(head.units[c]), below = unit_of(unit);
    if (unit != head.units[c] && !(above && below && above->si == below->si && above->factor == below->factor))
      throw InputError({path, number, 1},
                       "column " + in_quotes(head.names[c]) + " has the unit " + in_quotes(head.units[c]) +
                           " behind its name and " + in_quotes(unit) + " below it",
                       "keep the one that holds");
  }
}

}  // namespace

bool is_comment(std::string_view line) {
  const std::string_view text = trimmed(line);
  return !text.empty() && (text.front() == '#' || text.front() == '%');
}

bool is_ruler(std::string_view line) {
  return line.find_first_not_of("-=_+|*~#%:.,; \t\r") == std::string_view::npos &&
         line.find_first_of("-=_") != std::string_view::npos;
}

TableHead head_of(const std::vector<TableLine>& lines, const TableShape& shape, int first_row,
                  const std::string& path) {
  std::vector<HeadLine> heads, units;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    HeadLine head = judged_line(lines[i], i, shape);
    if (head.cells.empty()) continue;
    const bool follows = !heads.empty() && (units.empty() || units.back().index < heads.back().index);
    (follows && is_row_of_units(head) ? units : heads).push_back(std::move(head));
  }
  TableHead head;
  const HeadLine* names = names_of(heads, lines, path);
  if (names == nullptr) {
    refuse_lost_names(lines, shape, first_row, path);
    for (std::size_t c = 0; c < shape.n; ++c) head.names.push_back("column " + std::to_string(c + 1));
    head.units.resize(shape.n);
    return head;
  }
  head.line = lines[names->index].number;
  head.last = names->index + 1;
  head.certain = (!names->comment && names->numbers == 0) || names->units + names->times > 0;
  for (const std::string& cell : names->cells) {
    const auto [name, unit] = heading(cell);
    head.names.push_back(name);
    head.units.push_back(unit);
  }
  const auto next =
      std::find_if(heads.begin(), heads.end(), [names](const HeadLine& h) { return h.index > names->index; });
  for (const HeadLine& line : units) {
    if (line.index < names->index || (next != heads.end() && line.index > next->index)) continue;
    head.unit_line = lines[line.index].number;
    head.last = line.index + 1;
    add_units(line, head.unit_line, path, head);
  }
  while (head.last < lines.size() && judged_line(lines[head.last], head.last, shape).cells == names->cells) ++head.last;
  refuse_lost_units(lines, head, shape.dialect, path);
  return head;
}

}  // namespace upbead
