// How a table of numbers is written as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace upbead::detail {

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

/// Semicolons where the line has one, else tabs, else commas.
Dialect dialect_of(std::string_view header);

std::string_view trimmed(std::string_view text);
std::vector<Cell> cells_of(std::string_view line, Dialect dialect);

/// What is wrong with a cell as a number, "" if nothing. A magnitude below smallest_magnitude becomes zero.
std::string read_number(std::string_view text, Dialect dialect, double& number);

/// Fills `row` from a line that holds as many sound numbers; false where it does not.
bool read_row(std::string_view line, Dialect dialect, std::vector<double>& row);

/// The name and the unit of "p1 (kPa)", "p1 [kPa]", "p1 / kPa" or "p1", with or without quotes.
struct Heading {
  std::string name, unit;
};
Heading heading(std::string_view cell);

}  // namespace upbead::detail
