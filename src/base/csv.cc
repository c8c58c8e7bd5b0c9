#include "base/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/numbers.h"
#include "base/text.h"
#include "base/text_file.h"
#include "base/units.h"

namespace upbead {

namespace {

/// Numbers separated by semicolons or tabs may have decimal commas.
struct Dialect {
  char separator = ',';
  bool decimal_comma() const { return separator != ','; }
  std::string separators() const { return separator == ',' ? "commas" : separator == ';' ? "semicolons" : "tabs"; }
};

struct Cell {
  std::string_view text;  ///< without blanks around it
  int column = 1;         ///< where it starts
};

constexpr std::string_view blanks = " \t\r";

bool is_blank(char c) {
  return blanks.find(c) != std::string_view::npos;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks), last = text.find_last_not_of(blanks);
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

/// Like from_chars, which reads neither a leading plus nor decimal commas.
std::from_chars_result parse(std::string_view text, Dialect dialect, double& number) {
  const char *begin = text.data(), *end = begin + text.size();
  if (text.size() > 1 && *begin == '+') ++begin;
  if (!dialect.decimal_comma() || text.find(',') == std::string_view::npos) return std::from_chars(begin, end, number);
  std::string with_point(begin, end);
  if (with_point.find('.') == std::string::npos) with_point.replace(with_point.find(','), 1, ".");
  const auto [stop, error] = std::from_chars(with_point.data(), with_point.data() + with_point.size(), number);
  return {begin + (stop - with_point.data()), error};
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

/// Separator: a semicolon where the line has one, else a tab, else a comma.
Dialect dialect_of(std::string_view header) {
  for (const char separator : {';', '\t'})
    if (header.find(separator) != std::string_view::npos &&
        (separator == ';' || header.find(',') == std::string_view::npos))
      return {separator};
  return {};
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

/// Why a cell is not a number, "" if it is one. A magnitude below smallest_magnitude becomes zero.
std::string read_number(std::string_view cell, Dialect dialect, double& number) {
  const std::string text(cell);
  const auto [stop, error] = parse(text, dialect, number);
  if (text.empty()) return "an empty cell";
  if (error == std::errc::result_out_of_range) return in_quotes(text) + " is beyond the range of a number";
  if (error != std::errc() || stop != text.data() + text.size()) return in_quotes(text) + " is not a number";
  if (!std::isfinite(number)) return in_quotes(text) + " is not finite";
  if (is_too_large(number)) return in_quotes(text) + " is larger than any quantity in SI units";
  if (is_too_small(number)) number = 0.;  // programs that write a decaying quantity end with such numbers
  return "";
}

/// Fills `row` from a line of row.size() valid numbers; false where the line is anything else.
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

/// The name and the unit of "p1 (kPa)", "p1 [kPa]", "p1 / kPa" or "p1", with or without quotes.
struct Heading {
  std::string name, unit;
};
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

constexpr std::uintmax_t most_bytes = 1'000'000'000;  // some 4e7 samples
constexpr std::size_t most_columns = 10'000;          // channels of one record
constexpr std::size_t most_numbers = 100'000'000;     // 0.8 GB of memory
constexpr std::size_t n_listed = 10;                  // number of mistakes listed for one file

class Reader {
 public:
  explicit Reader(const std::string& path) { table_.path = path; }

  bool has_header() const { return !table_.names.empty(); }
  bool full() const { return n_mistakes_ >= n_listed; }

  /// A comment above the numbers; some programs write the names of the columns there.
  void read_comment(std::string_view line) { comment_ = trimmed(trimmed(line).substr(1)); }

  void read_header(std::string_view line, int line_number) {
    dialect_ = dialect_of(line);
    if (const std::size_t n = n_cells(line, dialect_); n > most_columns)
      throw InputError({table_.path, line_number, 1},
                       std::to_string(n) + " columns; at most " + std::to_string(most_columns) +
                           " are read, more than any record has",
                       "is it the right file? keep the time and the columns that are needed");
    std::vector<Cell> cells = cells_of(line, dialect_);
    const bool begins_with_numbers = are_numbers(cells);
    if (begins_with_numbers) {
      const Dialect of_names = dialect_of(comment_);
      if (n_cells(comment_, of_names) == cells.size()) cells = cells_of(comment_, of_names);
      if (are_numbers(cells))
        throw InputError({table_.path, line_number, 1}, "the first line holds numbers, not the names of the columns",
                         "put a header line above them, such as time,force");
    }
    for (const Cell& cell : cells) {
      const Heading head = heading(cell.text);
      table_.names.push_back(head.name);
      table_.units.push_back(head.unit);
    }
    table_.columns.resize(cells.size());
    row_.resize(cells.size());
    if (begins_with_numbers) read_line(line, line_number);
  }

  /// Reserves memory for `rows`, but not for more rows than that many characters can hold.
  void reserve(std::size_t rows, std::size_t characters) {
    rows = std::min({rows, characters / (2 * table_.columns.size()) + 1, most_numbers / table_.columns.size() + 1});
    table_.lines.reserve(rows);
    for (std::vector<double>& column : table_.columns) column.reserve(rows);
  }

  void read_line(std::string_view line, int line_number) {
    if (!read_row(line, dialect_, row_) && !read_cells(line, line_number)) return;
    for (std::size_t c = 0; c < row_.size(); ++c) table_.columns[c].push_back(row_[c]);
    table_.lines.push_back(line_number);
    if (table_.lines.size() > most_numbers / row_.size())
      throw InputError({table_.path, line_number, 1},
                       "more than " + std::to_string(most_numbers) + " numbers: they would fill the memory",
                       "is it the right file? thin the record, or keep the columns that are needed");
  }

  CsvTable finish() {
    mistakes_.throw_if_any();
    if (!has_header()) mistakes_.add({table_.path}, "an empty file", "write a header line and rows of numbers");
    if (has_header() && table_.lines.empty())
      mistakes_.add({table_.path}, "no row of numbers below the header", "write at least one row");
    mistakes_.throw_if_any();
    return std::move(table_);
  }

 private:
  static std::size_t n_cells(std::string_view line, Dialect dialect) {
    return static_cast<std::size_t>(std::count(line.begin(), line.end(), dialect.separator)) + 1;
  }

  bool are_numbers(const std::vector<Cell>& cells) const {
    return std::all_of(cells.begin(), cells.end(), [this](const Cell& cell) {
      double number = 0.;
      return read_number(cell.text, dialect_, number).empty();
    });
  }

  /// Reads the row cell by cell and reports what is wrong with it; false where it gives no numbers.
  bool read_cells(std::string_view line, int line_number) {
    if (const std::size_t n = n_cells(line, dialect_); n != table_.names.size()) {
      add(1, line_number,
          "cells in this row: " + std::to_string(n) + ", in the header: " + std::to_string(table_.names.size()),
          "give every row one number per column, separated by " + dialect_.separators());
      return false;
    }
    const std::vector<Cell> cells = cells_of(line, dialect_);
    if (is_row_of_units(cells)) {
      for (std::size_t c = 0; c < cells.size(); ++c) table_.units[c] = bare(cells[c].text);
      return false;
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::string objection = read_number(cells[c].text, dialect_, row_[c]);
      if (!objection.empty())
        add(cells[c].column, line_number, objection + " (column " + excerpt(table_.names[c]) + ")",
            "give a finite number such as 1.5e6");
    }
    return true;
  }

  /// Whether this is a row of units: right below the names, where the names have none.
  bool is_row_of_units(const std::vector<Cell>& cells) const {
    const auto is_unit = [](const Cell& cell) {
      return unit_of(bare(cell.text)).has_value() && bare(cell.text) != "1";
    };
    return table_.lines.empty() && mistakes_.empty() && cells.size() == table_.names.size() &&
           std::all_of(table_.units.begin(), table_.units.end(),
                       [](const std::string& unit) { return unit.empty(); }) &&
           std::all_of(cells.begin(), cells.end(), is_unit);
  }
  static std::string bare(std::string_view text) {
    const bool bracketed = text.size() > 2 && (text.front() == '[' || text.front() == '(');
    return std::string(bracketed ? text.substr(1, text.size() - 2) : text);
  }

  void add(int column, int line_number, const std::string& what, const std::string& cure) {
    ++n_mistakes_;
    mistakes_.add({table_.path, line_number, column}, what, full() ? cure + "; further rows were not read" : cure);
  }

  CsvTable table_;
  Dialect dialect_;
  std::string comment_;
  std::vector<double> row_;
  Diagnostics mistakes_;
  std::size_t n_mistakes_ = 0;
};

bool is_comment(std::string_view line) {
  const char first = trimmed(line).front();
  return first == '#' || first == '%';
}

CsvTable read_table(std::string_view text, const std::string& path) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);  // byte order mark of spreadsheets
  Reader reader(path);
  for (int number = 1; !reader.full() && !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (trimmed(line).empty()) continue;
    if (reader.has_header()) {
      reader.read_line(line, number);
    } else if (is_comment(line)) {
      reader.read_comment(line);
    } else {
      reader.read_header(line, number);
      reader.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1, text.size());
    }
  }
  return reader.finish();
}

}  // namespace

CsvTable read_csv(const std::string& path, const Place& place) {
  return read_table(read_text(path, most_bytes, place), path);
}

CsvTable read_csv_head(const std::string& path, std::size_t bytes) {
  std::string text = read_text(path, most_bytes, {}, bytes);
  const std::size_t last = text.rfind('\n');
  if (text.size() >= bytes && last != std::string::npos) text.resize(last);
  try {
    return read_table(text, path);
  } catch (const InputError&) {
    return read_csv(path, {});  // the header is longer than `bytes`
  }
}

}  // namespace upbead
