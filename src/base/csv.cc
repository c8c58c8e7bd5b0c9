#include "base/csv.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>

#include "base/dialect.h"
#include "base/strong_motion.h"
#include "base/table_head.h"
#include "base/table_text.h"
#include "base/text.h"
#include "base/text_file.h"

namespace upbead {

namespace {

constexpr std::uintmax_t most_bytes = 1'000'000'000;  // some 4e7 samples
constexpr std::size_t most_columns = 10'000;          // channels of one record
constexpr std::size_t most_numbers = 100'000'000;     // 0.8 GB of memory
constexpr std::size_t most_head_lines = 10'000;
constexpr std::size_t n_judged = 100;  // rows by which a dialect is judged

bool is_blank_line(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

/// Takes the first line off a text.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// The last lines of a text that are neither blank nor comments.
std::vector<std::string_view> last_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < n_judged) {
    if (text.back() == '\n') text.remove_suffix(1);
    const std::size_t begin = text.rfind('\n') + 1;  // npos + 1 = 0
    const std::string_view line = text.substr(begin);
    text = text.substr(0, begin);
    if (!is_blank_line(line) && !is_comment(line)) lines.push_back(line);
  }
  return lines;
}

/// The separator of a first line such as `sep=;`, which spreadsheets write and obey; 0 without one.
char separator_line(std::string_view& text) {
  std::string_view rest = text;
  std::string_view line = next_line(rest);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line.size() > 1 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
  const bool says =
      line.size() == 5 && (line.substr(0, 4) == "sep=" || line.substr(0, 4) == "SEP=" || line.substr(0, 4) == "Sep=");
  return says ? line[4] : '\0';
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& path) : text_(text) { table_.path = path; }

  CsvTable read() {
    const char given = separator_line(text_);
    if (given != 0) {
      next_line(text_);
      ++number_;
    }
    const bool quotes = text_.find('"') != std::string_view::npos;
    shape_ = shape_of_table(last_lines(text_), quotes, given);
    const std::vector<TableLine> above = lines_above();
    decide_signs(text_, shape_.dialect);
    const TableHead head = head_of(above, shape_, number_ + 1, table_.path);
    if (!head.certain) require_two_columns();
    if (shape_.two_ways)
      throw InputError({table_.path}, "blanks may separate columns here, or group the thousands of one",
                       "take the separators from the ends of the lines, or the blanks out of the numbers");
    if (!head.certain && has_words())
      throw InputError({table_.path, number_ + 1, 1},
                       "some columns hold words, and no line above them names the columns",
                       "write a header above the rows, such as date,time,force");
    if (shape_.n > most_columns)
      throw InputError({table_.path, head.line == 0 ? number_ + 1 : head.line, 1},
                       std::to_string(shape_.n) + " columns; at most " + std::to_string(most_columns) +
                           " are read, more than any record has",
                       "is it the right file? keep the time and the columns that are needed");
    begin(head);
    for (std::size_t i = head.last; i < above.size(); ++i)
      if (!is_ruler(above[i].text) && (head.line != 0 || is_row(above[i].text)))
        read_line(above[i].text, above[i].number);
    reserve();
    while (!text_.empty()) {
      const std::string_view line = next_line(text_);
      ++number_;
      read_line(line, number_);
    }
    return finish();
  }

 private:
  /// Takes the lines above the first row of numbers off the text.
  std::vector<TableLine> lines_above() {
    std::vector<TableLine> lines;
    bool any = false;
    while (!text_.empty() && lines.size() < most_head_lines) {
      std::string_view rest = text_;
      const std::string_view line = next_line(rest);
      if (!is_blank_line(line)) {
        if (is_row(line) && (!has_words() || is_blank_line(rest) || next_is_row(rest))) return lines;
        lines.push_back({line, number_ + 1});
        any = true;
      }
      ++number_;
      text_ = rest;
    }
    if (!any) throw InputError({table_.path}, "an empty file", "write a header line and rows of numbers");
    throw InputError({table_.path}, "no row of numbers below the header", "write at least one row");
  }

  /// Whether a line has numbers, or nothing, in all columns of numbers.
  bool is_row(std::string_view line) {
    if (is_comment(line)) return false;
    split(line, shape_.dialect, cells_);
    if (shape_.n == 0 || cells_.size() < shape_.n || filled(cells_) > shape_.n) return false;
    std::size_t numbers = 0;
    for (std::size_t c = 0; c < shape_.n; ++c) {
      double ignored = 0.;
      const CellIs is = read_cell(cells_[c].text, shape_.dialect, ignored);
      if (!shape_.numeric[c] || is == CellIs::empty || is == CellIs::missing) continue;
      if (is == CellIs::no_number) return false;
      ++numbers;
    }
    return numbers > 0;
  }

  /// Beside columns of words a title, "Run 7", may look like a row; but not two lines on end.
  bool has_words() const {
    return std::find(shape_.numeric.begin(), shape_.numeric.end(), false) != shape_.numeric.end();
  }
  bool next_is_row(std::string_view rest) {
    std::string_view line = next_line(rest);
    while (is_blank_line(line) && !rest.empty()) line = next_line(rest);
    return is_row(line);
  }

  /// Without a sure header rows such as 0,5 may be two columns, or one with decimal commas; rows such as 1,250 and 1
  /// 250 one with grouped thousands.
  void require_two_columns() {
    const bool commas = shape_.dialect.separator == ',', blanks = shape_.dialect.separator == ' ';
    if (!(commas || blanks) || shape_.dialect.quotes || shape_.n < 2) return;
    bool decimals = commas && shape_.n % 2 == 0;
    std::vector<bool> thousands(shape_.n - 1, true);
    const auto is_one = [this, commas](std::size_t c, char decimal) {
      double ignored = 0.;
      const std::string pair = std::string(cells_[c].text).append(commas ? "," : "'").append(cells_[c + 1].text);
      const CellIs is = read_cell(pair, {';', decimal}, ignored);
      return is == CellIs::number || is == CellIs::grouped;
    };
    std::string_view rows = text_;
    while (!rows.empty()) {
      const std::string_view line = next_line(rows);
      if (is_blank_line(line) || is_comment(line)) continue;
      split(line, shape_.dialect, cells_);
      if (cells_.size() < shape_.n) return;
      for (std::size_t c = 0; c + 1 < shape_.n; ++c) {
        thousands[c] = thousands[c] && is_one(c, shape_.dialect.decimal);
        decimals = decimals && (c % 2 == 1 || is_one(c, ','));
      }
      if (!decimals && std::find(thousands.begin(), thousands.end(), true) == thousands.end()) return;
    }
    throw InputError({table_.path, number_ + 1, 1},
                     in_quotes(trimmed(text_.substr(0, text_.find('\n')))) + " may be columns, or numbers with " +
                         (commas ? "commas" : "blanks") + " in them: no line names columns",
                     "write a header above it, such as time,force");
  }

  void begin(const TableHead& head) {
    table_.names = head.names;
    table_.units = head.units;
    table_.columns.resize(shape_.n);
    table_.faults.resize(shape_.n);
    grouped_.resize(shape_.n);
    row_.resize(shape_.n);
    table_.layout = text_of(shape_.dialect) +
                    (head.line == 0 ? ", no names above the numbers" : ", names in line " + std::to_string(head.line)) +
                    (head.unit_line == 0 ? "" : ", units in line " + std::to_string(head.unit_line));
  }

  /// Reserves memory for the rows, but not for more than the characters can hold.
  void reserve() {
    const std::size_t rows = std::min({static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n')) + 1,
                                       text_.size() / (2 * shape_.n) + 1, most_numbers / shape_.n + 1});
    table_.lines.reserve(table_.lines.size() + rows);
    for (std::vector<double>& column : table_.columns) column.reserve(column.size() + rows);
  }

  void read_line(std::string_view line, int number) {
    if (!read_row(line, shape_.dialect, row_) && !read_cells(line, number)) return;
    for (std::size_t c = 0; c < row_.size(); ++c) table_.columns[c].push_back(row_[c]);
    table_.lines.push_back(number);
    if (table_.lines.size() > most_numbers / row_.size())
      throw InputError({table_.path, number, 1},
                       "more than " + std::to_string(most_numbers) + " numbers: they would fill the memory",
                       "is it the right file? thin the record, or keep the columns that are needed");
  }

  /// Reads a row cell by cell; false for what is no row.
  bool read_cells(std::string_view line, int number) {
    if (is_blank_line(line) || is_comment(line)) return false;
    const Dialect& dialect = shape_.dialect;
    split(line, dialect, cells_);
    if (cells_.size() < shape_.n || filled(cells_) > shape_.n)
      throw InputError(
          {table_.path, number, 1},
          "cells in this row: " + std::to_string(cells_.size()) + ", in the header: " + std::to_string(shape_.n),
          "give every row one number per column, separated by " + separators(dialect));
    for (std::size_t c = 0; c < row_.size(); ++c) {
      const Cell& cell = cells_[c];
      const CellIs is = read_cell(cell.text, dialect, row_[c]);
      if (is == CellIs::number) continue;
      if (is == CellIs::grouped) {
        if (!grouped_[c]) grouped_[c] = Place{table_.path, number, cell.column};
        continue;
      }
      if (is == CellIs::other_decimal) mixed_ = true;
      row_[c] = std::numeric_limits<double>::quiet_NaN();
      add_fault(c, {table_.path, number, cell.column}, is, cell.text);
    }
    return true;
  }

  void add_fault(std::size_t column, const Place& place, CellIs is, std::string_view cell) {
    ColumnFault& fault = table_.faults[column];
    if (++fault.cells > 1) return;
    fault.first = {place, objection(is, cell, shape_.dialect) + " (column " + excerpt(table_.names[column]) + ")",
                   cure_of(is)};
  }

  CsvTable finish() {
    if (table_.lines.empty())
      throw InputError({table_.path}, "no row of numbers below the header", "write at least one row");
    for (std::size_t c = 0; c < grouped_.size(); ++c)
      if (mixed_ && grouped_[c])
        add_fault(c, *grouped_[c], CellIs::undecided, shape_.dialect.decimal == '.' ? "1,250" : "1.250");
    if (std::any_of(grouped_.begin(), grouped_.end(), [](const auto& place) { return place.has_value(); }))
      table_.layout += std::string(", ") + (shape_.dialect.decimal == '.' ? "commas" : "points") + " group thousands";
    return std::move(table_);
  }

  std::string_view text_;  ///< what is not read yet
  int number_ = 0;         ///< of the last line that was read
  CsvTable table_;
  TableShape shape_;
  std::vector<Cell> cells_;
  std::vector<double> row_;
  std::vector<std::optional<Place>> grouped_;  ///< the first number of each column in which a sign groups thousands
  bool mixed_ = false;                         ///< some cell has the other decimal sign
};

}  // namespace

const std::vector<double>& CsvTable::numbers(std::size_t column) const {
  if (column < faults.size() && faults[column].cells > 0) {
    Diagnostic mistake = faults[column].first;
    if (faults[column].cells > 1) mistake.what += ", one of " + std::to_string(faults[column].cells) + " such cells";
    throw InputError(Diagnostics{mistake});
  }
  return columns[column];
}

bool CsvTable::is_text(std::size_t column) const {
  return column < faults.size() && faults[column].cells == n_rows();
}

CsvTable read_csv(const std::string& path, const Place& place) {
  const std::string text = as_utf8(read_text(path, most_bytes, place), path, place);
  if (auto motion = read_strong_motion(text, path)) return std::move(*motion);
  return Reader(text, path).read();
}

}  // namespace upbead
