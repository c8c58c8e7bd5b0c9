// Tables whose cells are separated by semicolons, commas or tabs, with units in their names, as DualSPHysics and
// Proteus write them. Unlike in base/csv.h, a cell may be blank.
#pragma once

#include <optional>

#include "base/dialect.h"
#include "case/cfd/flow_text.h"

namespace upbead {

struct CellHeading {
  std::string name, unit;
};

/// The separator of a line: the first of semicolon, tab and comma that the line contains.
char separator_of(std::string_view line);

std::vector<std::string_view> cells_between(std::string_view line, char separator);

/// Splits a heading such as "Time [s]" or "PosX [m]:" into name and unit.
CellHeading cell_heading(std::string_view cell);

/// Rows of numbers below a header; column 0 of a row is its cell 0. A blank cell is not a number (NaN).
struct CellRows {
  std::vector<CellHeading> heading;
  std::vector<std::vector<double>> column;
  std::vector<int> line;  ///< of each row in the file

  /// The column of that name, whether in capitals or not; none where there is none. Throws InputError where two have
  /// it.
  std::optional<std::size_t> find(const std::string& name, const FlowLines& lines) const;
  /// In SI units. Throws InputError where the header gives no unit or the unit of another quantity, and where a cell
  /// is blank that must not be.
  std::vector<double> in_si(std::size_t c, const std::string& si, bool may_be_blank, const FlowLines& lines) const;
};

/// Decimal sign and thousands sign of what is left of a file, told from all its rows.
Dialect dialect_of_rows(const FlowLines& lines, char separator);

/// Reads the rows below the header, where `lines` stands.
CellRows read_cell_rows(FlowLines& lines, FlowNotes& notes, const std::vector<CellHeading>& heading, char separator);

}  // namespace upbead
