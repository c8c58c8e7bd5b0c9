// How a file writes its table: what separates the columns, and which signs stand for decimals and thousands. One
// dialect holds for the whole file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace upbead {

struct Dialect {
  char separator = ',';       ///< a blank stands for any number of blanks and tabs
  char decimal = '.';         ///< or a comma; the other one of both then groups thousands
  bool undecided = false;     ///< every cell with a point or comma may as well be a grouped whole number: 1.250
  bool quotes = false;        ///< some cells may be in quotes
  bool blank_groups = false;  ///< blanks in a cell group thousands
};

/// "semicolons", for messages.
std::string separators(const Dialect& dialect);

/// "columns separated by semicolons, decimal commas".
std::string text_of(const Dialect& dialect);

struct Cell {
  std::string_view text;  ///< without blanks and quotes around it
  int column = 1;         ///< where it starts
};

/// Splits a line; `cells` is used again.
void split(std::string_view line, const Dialect& dialect, std::vector<Cell>& cells);

/// The number of cells without empty ones at the end.
std::size_t filled(const std::vector<Cell>& cells);

/// `grouped`: a number whose one point or comma groups thousands, as the file has the other decimal sign.
enum class CellIs {
  number,
  grouped,
  empty,
  missing,
  out_of_range,
  no_number,
  infinite,
  too_large,
  other_decimal,
  undecided
};

/// Reads a cell; "missing": a word for a missing value, such as - or n/a. A magnitude below smallest_magnitude becomes
/// zero.
CellIs read_cell(std::string_view cell, const Dialect& dialect, double& number);

/// Fills `row` from a line of valid numbers, quickly; false where the line is anything else.
bool read_row(std::string_view line, const Dialect& dialect, std::vector<double>& row);

/// Why a cell is no number, and the cure.
std::string objection(CellIs is, std::string_view cell, const Dialect& dialect);
std::string cure_of(CellIs is);

/// What most lines of a table have in common.
struct TableShape {
  Dialect dialect;
  std::size_t n = 0;          ///< columns; 0 where no line holds a number
  std::vector<bool> numeric;  ///< whether a column holds numbers
  bool two_ways = false;      ///< blanks separate columns, or group thousands of one that ends with a separator
};

/// Judges the separator by `lines`, some of the last of a file; `given`: the separator that the file names, or 0.
/// The decimal sign is left open.
TableShape shape_of_table(const std::vector<std::string_view>& lines, bool quotes, char given);

/// Looks through the rows for a cell that decides what point and comma mean.
void decide_signs(std::string_view rows, Dialect& dialect);

/// Without blanks around it, those that do not break lines too.
std::string_view trimmed(std::string_view text);

}  // namespace upbead
