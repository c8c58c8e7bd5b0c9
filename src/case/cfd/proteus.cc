// Point gauges of Proteus: `time, p [ x y z], p [ x y z], ...`, with places in the names of the columns. Source: the
// code that writes them, proteus/Gauges.py.
#include <cmath>

#include "base/text.h"
#include "case/cfd/flow_cells.h"
#include "case/cfd/flow_tables.h"

namespace upbead {

namespace {

/// Reads "p [ 0.5 0.2 0]"; false where the cell is no such name.
bool read_gauge_name(std::string_view cell, std::string& field, Triple& at) {
  const std::size_t open = cell.find('['), close = cell.find(']');
  if (open == std::string_view::npos || close != cell.size() - 1 || close < open) return false;
  const std::vector<std::string> name = words_of(cell.substr(0, open)),
                                 place = words_of(cell.substr(open + 1, close - open - 1));
  if (name.size() != 1 || place.size() != 3) return false;
  field = name[0];
  for (std::size_t i = 0; i < 3; ++i)
    if (!read_number(place[i], at[i]) || !(std::abs(at[i]) < 1e50)) return false;
  return true;
}

}  // namespace

bool is_proteus(std::string_view line) {
  const std::vector<std::string_view> cells = cells_between(line, ',');
  std::string field;
  Triple at{};
  return cells.size() > 1 && cells[0] == "time" && read_gauge_name(cells[1], field, at);
}

void read_proteus(const std::string& path, const Place& place, FlowRecord& record) {
  FlowLines lines(path, place);
  lines.next(record.notes);
  record.files.push_back(path);
  FlowPoints& points = record.points.emplace();
  points.field = "p";
  const std::vector<std::string_view> cells = cells_between(lines.line(), ',');
  std::vector<CellHeading> heading;
  std::vector<std::size_t> used;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    heading.push_back({std::string(cells[c]), c == 0 ? "s" : ""});
    if (c == 0) continue;
    std::string field;
    Triple at{};
    if (!read_gauge_name(cells[c], field, at))
      throw InputError(lines.place(), "the column " + in_quotes(cells[c]) + " does not tell a field and its place",
                       "a column is called 'p [ x y z]'");
    if (field != "p") {
      record.notes.push_back("column " + in_quotes(cells[c]) + " is no pressure: left out");
      continue;
    }
    used.push_back(c);
    points.name.push_back("p" + std::to_string(points.name.size()));
    points.at.push_back(at);
  }
  if (used.empty()) throw InputError({path}, "no column is a pressure, 'p [ x y z]'", "give the file of the pressures");
  const CellRows rows = read_cell_rows(lines, record.notes, heading, ',');
  points.rows = {used.size(), rows.in_si(0, "s", false, lines), {}};
  for (std::size_t row = 0; row < points.rows.count(); ++row)
    for (const std::size_t c : used) {
      if (std::isnan(rows.column[c][row]))
        throw InputError({path, rows.line[row], 1}, "the cell of " + in_quotes(heading[c].name) + " is blank",
                         "give a number in every row");
      points.rows.value.push_back(rows.column[c][row]);
    }
  settle(points.rows, {path}, record.notes);
  record.layout = "Proteus point gauges";
}

}  // namespace upbead
