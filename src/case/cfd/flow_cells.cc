#include "case/cfd/flow_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/text.h"
#include "base/units.h"

namespace upbead {

char separator_of(std::string_view line) {
  for (const char separator : {';', '\t'})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ',';
}

std::vector<std::string_view> cells_between(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

CellHeading cell_heading(std::string_view cell) {
  const std::size_t open = cell.find('['), close = cell.find(']');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open)
    return {std::string(trimmed(cell)), ""};
  return {std::string(trimmed(cell.substr(0, open))), std::string(trimmed(cell.substr(open + 1, close - open - 1)))};
}

std::optional<std::size_t> CellRows::find(const std::string& name, const FlowLines& lines) const {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < heading.size(); ++c) {
    if (lower_case(heading[c].name) != lower_case(name)) continue;
    if (found)
      throw InputError({lines.path()}, "there are two columns " + in_quotes(name), "keep the one that is meant");
    found = c;
  }
  return found;
}

std::vector<double> CellRows::in_si(std::size_t c, const std::string& si, bool may_be_blank,
                                    const FlowLines& lines) const {
  const std::optional<Unit> unit = unit_of(heading[c].unit);
  if (!unit || unit->si != si)
    throw InputError({lines.path()},
                     heading[c].unit.empty()
                         ? "the header does not give the unit of column " + in_quotes(heading[c].name)
                         : "the unit " + in_quotes(heading[c].unit) + " of column " + in_quotes(heading[c].name) +
                               " is none of " + si,
                     "write one of " + units_like(si) + " behind its name, in [ ]");
  std::vector<double> values = column[c];
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!may_be_blank && std::isnan(values[row]))
      throw InputError({lines.path(), line[row], 1}, "the cell of column " + in_quotes(heading[c].name) + " is blank",
                       "give a number in every row");
    values[row] *= unit->factor;
  }
  return values;
}

Dialect dialect_of_rows(const FlowLines& lines, char separator) {
  Dialect dialect;
  dialect.separator = separator;
  decide_signs(lines.rest(), dialect);
  return dialect;
}

CellRows read_cell_rows(FlowLines& lines, FlowNotes& notes, const std::vector<CellHeading>& heading, char separator) {
  constexpr std::size_t most_columns_of_cells = 10'000;
  if (heading.size() > most_columns_of_cells)
    throw InputError(lines.place(), std::to_string(heading.size()) + " columns, more than any record has",
                     "is it the right file?");
  const Dialect dialect = dialect_of_rows(lines, separator);
  CellRows rows;
  rows.heading = heading;
  rows.column.resize(heading.size());
  while (lines.next(notes)) {
    std::size_t begin = 0, c = 0;
    const std::string_view line = lines.line();
    for (; begin <= line.size(); ++c) {
      const std::size_t end = std::min(line.find(separator, begin), line.size());
      const std::string_view cell = trimmed(line.substr(begin, end - begin));
      double number = 0.;
      if (c < heading.size()) {
        const CellIs is = read_cell(cell, dialect, number);
        if (is == CellIs::empty)
          number = std::numeric_limits<double>::quiet_NaN();
        else if (is != CellIs::number && is != CellIs::grouped) {
          const bool again = cell_heading(cell).name == heading[c].name || cell == heading[c].name;
          throw InputError(lines.place(static_cast<int>(begin) + 1),
                           again ? "a second head: " + in_quotes(cell) : objection(is, cell, dialect),
                           again ? "give each run a file of its own" : cure_of(is));
        }
        rows.column[c].push_back(number);
      }
      begin = end + 1;
    }
    if (c != heading.size())
      throw InputError(lines.place(),
                       "cells in this row: " + std::to_string(c) + ", in the header: " + std::to_string(heading.size()),
                       "is a column lost, or the row cut? decimal commas need semicolons between the cells");
    rows.line.push_back(lines.place().line);
  }
  return rows;
}

}  // namespace upbead
