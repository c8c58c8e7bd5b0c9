// Tables whose cells stand between semicolons, commas or tabs, with units in their names, as DualSPHysics and Proteus
// write them. Other than in base/csv.h a cell may be blank.
#pragma once

#include <optional>

#include "case/cfd/flow_text.h"

namespace upbead {

struct CellHeading {
  std::string name, unit;
};

/// The separator of a line: semicolon, tab, comma, whichever it has first of these.
char separator_of(std::string_view line);

std::vector<std::string_view> cells_between(std::string_view line, char separator);

/// "Time [s]" and "PosX [m]:".
CellHeading cell_heading(std::string_view cell);

/// Rows of numbers below a header; column 0 of a row is its cell 0. A blank cell is not a number (NaN).
struct CellRows {
  std::vector<CellHeading> heading;
  std::vector<std::vector<double>> column;
  std::vector<int> line;  ///< of each row in the file

  /// By name, capitals set aside; none where there is none. Throws InputError where it is there twice.
  std::optional<std::size_t> find(const std::string& name, const FlowLines& lines) const;
  /// In SI units. Throws InputError where the header does not tell the unit, or one of another quantity; where a cell
  /// is blank that must not be.
  std::vector<double> in_si(std::size_t c, const std::string& si, bool may_be_blank, const FlowLines& lines) const;
};

/// `lines` stands at the header. With semicolons decimal commas are understood.
CellRows read_cell_rows(FlowLines& lines, FlowNotes& notes, const std::vector<CellHeading>& heading, char separator);

}  // namespace upbead
