#include "upbead/base/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "upbead/base/input_file.h"

#include "upbead/base/magnitude.h"

namespace upbead {

namespace {

constexpr std::uintmax_t most_bytes = 1'000'000'000;  // some 4e7 samples
constexpr std::size_t n_listed = 10;                  // mistakes of one file that help; a thousand do not

struct Cell {
  std::string text;
  int column = 1;  ///< where it starts
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<Cell> cells_of(const std::string& line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::size_t text = std::min(line.find_first_not_of(" \t", begin), end);
    cells.push_back({trimmed(line.substr(begin, end - begin)), static_cast<int>(text) + 1});
    begin = end + 1;
  }
  return cells;
}

/// What is wrong with a cell as a number, "" if nothing.
std::string read_number(const std::string& text, double& number) {
  const char* begin = text.data() + (text.size() > 1 && text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (text.empty()) return "an empty cell";
  if (error == std::errc::result_out_of_range) return "'" + text + "' is beyond the range of a number";
  if (error != std::errc() || stop != end) return "'" + text + "' is not a number";
  if (!std::isfinite(number)) return "'" + text + "' is not finite";
  if (is_too_large(number)) return "'" + text + "' is larger than any quantity in SI units";
  if (is_too_small(number)) number = 0.;  // what is left of a number that decays in some program
  return "";
}

bool is_number(const Cell& cell) {
  double number = 0.;
  return read_number(cell.text, number).empty();
}

class Reader {
 public:
  explicit Reader(const std::string& path) { table_.path = path; }

  void read_header(const std::string& line, int line_number) {
    refuse_other_dialects(line, line_number);
    const std::vector<Cell> cells = cells_of(line);
    if (std::all_of(cells.begin(), cells.end(), is_number)) {
      mistakes_.add({table_.path, line_number, 1}, "the first line holds numbers, not the names of the columns",
                    "put a header line above them, such as time,force");
      mistakes_.throw_if_any();
    }
    for (const Cell& cell : cells) table_.names.push_back(cell.text);
    table_.columns.resize(cells.size());
  }

  void read_row(const std::string& line, int line_number) {
    const std::vector<Cell> cells = cells_of(line);
    if (cells.size() != table_.names.size()) {
      add({line, 1}, line_number,
          "cells in this row: " + std::to_string(cells.size()) +
              ", in the header: " + std::to_string(table_.names.size()),
          "give every row one number per column, separated by commas");
      return;
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      double number = 0.;
      const std::string objection = read_number(cells[c].text, number);
      if (!objection.empty())
        add(cells[c], line_number, objection + " (column " + table_.names[c] + ")",
            "give a finite number such as 1.5e6");
      table_.columns[c].push_back(number);
    }
    table_.lines.push_back(line_number);
  }

  bool full() const { return n_mistakes_ >= n_listed; }

  CsvTable finish() {
    mistakes_.throw_if_any();
    if (table_.names.empty()) mistakes_.add({table_.path}, "an empty file", "write a header line and rows of numbers");
    if (!table_.names.empty() && table_.lines.empty())
      mistakes_.add({table_.path}, "no row of numbers below the header", "write at least one row");
    mistakes_.throw_if_any();
    return std::move(table_);
  }

 private:
  /// Names the two ways in which a table is often written otherwise; its rows would tell of neither.
  void refuse_other_dialects(const std::string& line, int line_number) {
    const Place place{table_.path, line_number, 1};
    if (trimmed(line)[0] == '#')
      throw InputError(place, "a comment ('#') stands where the names of the columns belong",
                       "remove the '#' line, and begin with the names of the columns, such as time,force");
    const bool comma = line.find(',') != std::string::npos;
    const bool semicolon = line.find(';') != std::string::npos;  // beside commas these are decimal commas
    if (semicolon || (!comma && trimmed(line).find('\t') != std::string::npos))
      throw InputError(place, std::string("the columns are separated by ") + (semicolon ? "semicolons" : "tabs"),
                       "separate them by commas, and write decimals with a point");
  }

  void add(const Cell& cell, int line_number, const std::string& what, const std::string& cure) {
    ++n_mistakes_;
    mistakes_.add({table_.path, line_number, cell.column}, what, full() ? cure + "; further rows were not read" : cure);
  }

  CsvTable table_;
  Mistakes mistakes_;
  std::size_t n_mistakes_ = 0;
};

}  // namespace

CsvTable read_csv(const std::string& path, const Place& place) {
  require_readable(path, most_bytes, place);
  std::ifstream file(path);
  std::string line;
  Reader reader(path);
  bool header = true;
  for (int number = 1; !reader.full() && std::getline(file, line); ++number) {
    if (number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);  // byte order mark of spreadsheets
    if (trimmed(line).empty()) continue;
    if (header)
      reader.read_header(line, number);
    else
      reader.read_row(line, number);
    header = false;
  }
  return reader.finish();
}

}  // namespace upbead
