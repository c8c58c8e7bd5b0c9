// Tables of DualSPHysics: the force gauge and ComputeForces (forces in N), MeasureTool (pressures at points). Their
// separator is a setting of the user; the decimal point is not. Source: its own example files.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "case/cfd/flow_cells.h"
#include "case/cfd/flow_tables.h"

namespace upbead {

namespace {

constexpr const char* axes_of_forces[] = {"x", "y", "z"};

std::size_t require_column(const CellRows& rows, const std::string& name, const FlowLines& lines) {
  if (const auto found = rows.find(name, lines)) return *found;
  throw InputError({lines.path()}, "there is no column " + in_quotes(name), "give the table whole");
}

/// Compares the length of the vectors, where a column gives it, with their components: a column that is lost or
/// exchanged shows.
void check_length(const CellRows& rows, const std::string& name, const FlowForces& forces, const FlowLines& lines) {
  const auto column = rows.find(name, lines);
  if (!column) return;
  const std::vector<double> length = rows.in_si(*column, "N", false, lines);
  for (std::size_t row = 0; row < length.size(); ++row) {
    const auto& [x, y, z] = forces.force[row];
    const double sum = std::sqrt(x * x + y * y + z * z);
    if (std::abs(sum - std::abs(length[row])) > 1e-3 * std::max(sum, std::abs(length[row])))
      throw InputError({lines.path(), rows.line[row], 1},
                       in_quotes(rows.heading[*column].name) + " = " + significant(length[row], 6) +
                           " is not the length of the force, " + significant(sum, 6),
                       "is a column lost, or has one been exchanged?");
  }
}

/// Forces in the columns STEM + x, y, z.
void read_forces(const CellRows& rows, const std::string& stem, const std::string& length, const FlowLines& lines,
                 FlowRecord& record) {
  FlowRows table{3, rows.in_si(require_column(rows, "time", lines), "s", false, lines), {}};
  std::vector<std::vector<double>> parts;
  for (const char* axis : axes_of_forces)
    parts.push_back(rows.in_si(require_column(rows, stem + axis, lines), "N", false, lines));
  FlowForces& forces = record.forces.emplace();
  for (std::size_t row = 0; row < table.count(); ++row) {
    forces.force.push_back({parts[0][row], parts[1][row], parts[2][row]});
    for (const auto& part : parts) table.value.push_back(part[row]);
  }
  check_length(rows, length, forces, lines);
  settle(table, {lines.path()}, record.notes);
  forces.time = table.time;
  forces.force.clear();
  for (std::size_t row = 0; row < table.count(); ++row)
    forces.force.push_back({table.at(row, 0), table.at(row, 1), table.at(row, 2)});
  for (const CellHeading& heading : rows.heading) {
    const std::string name = lower_case(heading.name), part = lower_case(stem);
    const bool used = name == "time" || name == "part" || name == "np" || name == lower_case(length) ||
                      (starts_with(name, part) && name.size() == part.size() + 1);
    if (!used) record.notes.push_back("column " + in_quotes(heading.name) + " is left out");
  }
}

/// Rows " ;PosX [m]:;0;0.1" above the header of MeasureTool.
std::vector<Triple> read_positions(FlowLines& lines, FlowNotes& notes, char separator) {
  const Dialect dialect = dialect_of_rows(lines, separator);
  std::vector<Triple> at;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis > 0 && !lines.next(notes)) throw InputError({lines.path()}, "the file ends in its head", "give it whole");
    const std::vector<std::string_view> cells = cells_between(lines.line(), separator);
    const CellHeading heading = cell_heading(cells.size() > 1 ? cells[1] : "");
    if (heading.name != std::string("Pos") + "XYZ"[axis] || heading.unit != "m" || cells.size() < 3 ||
        (axis > 0 && cells.size() != at.size() + 2))
      throw InputError(lines.place(),
                       std::string("the head does not tell Pos") + "XYZ"[axis] + " [m] of every point here",
                       "its first three rows are PosX [m]:, PosY [m]: and PosZ [m]:, each with a number a point");
    at.resize(cells.size() - 2);
    for (std::size_t p = 0; p < at.size(); ++p) {
      if (read_cell(cells[p + 2], dialect, at[p][axis]) != CellIs::number)
        throw InputError(lines.place(), in_quotes(cells[p + 2]) + " is no place of a point", "give it in m");
    }
  }
  return at;
}

/// Columns Press_0, Press_1 ... in the order of the points.
void read_measure_tool(FlowLines& lines, FlowRecord& record, char separator) {
  const std::vector<Triple> at = read_positions(lines, record.notes, separator);
  if (!lines.next(record.notes)) throw InputError({lines.path()}, "the file ends in its head", "give it whole");
  std::vector<CellHeading> heading;
  for (const std::string_view cell : cells_between(lines.line(), separator)) heading.push_back(cell_heading(cell));
  const CellRows rows = read_cell_rows(lines, record.notes, heading, separator);
  FlowPoints& points = record.points.emplace();
  points.field = "Press";
  points.unit = "Pa";
  std::vector<std::vector<double>> values;
  for (std::size_t p = 0; p < at.size(); ++p) {
    const std::string name = "Press_" + std::to_string(p);
    std::vector<double> value = rows.in_si(require_column(rows, name, lines), "Pa", true, lines);
    if (std::all_of(value.begin(), value.end(), [](double v) { return std::isnan(v); })) {
      record.notes.push_back(name + " is blank throughout, outside of what was computed: left out");
      continue;
    }
    points.name.push_back(name);
    points.at.push_back(at[p]);
    values.push_back(std::move(value));
  }
  if (rows.find("Press_" + std::to_string(at.size()), lines))
    throw InputError({lines.path()}, "there are more columns of pressures than places of points",
                     "give the table whole");
  if (values.empty()) throw InputError({lines.path()}, "every pressure is blank", "place points where there is water");
  points.rows = {values.size(), rows.in_si(require_column(rows, "time", lines), "s", false, lines), {}};
  for (std::size_t row = 0; row < points.rows.count(); ++row)
    for (const auto& value : values) points.rows.value.push_back(value[row]);
  settle(points.rows, {lines.path()}, record.notes);
  record.layout = "DualSPHysics MeasureTool";
}

}  // namespace

bool is_dualsphysics(std::string_view line) {
  const std::string lower = lower_case(line);
  const auto has = [&lower](const char* part) { return lower.find(part) != std::string::npos; };
  return has("posx [") || has("posx[") || has("forcex") || has("forcefluid.");
}

void read_dualsphysics(const std::string& path, const Place& place, FlowRecord& record) {
  FlowLines lines(path, place);
  if (!lines.next(record.notes)) throw InputError({path}, "an empty file", "give the table whole");
  record.files.push_back(path);
  const char separator = separator_of(lines.line());
  if (lower_case(lines.line()).find("posx") != std::string::npos) {
    read_measure_tool(lines, record, separator);
    return;
  }
  std::vector<CellHeading> heading;
  for (const std::string_view cell : cells_between(lines.line(), separator)) heading.push_back(cell_heading(cell));
  const CellRows rows = read_cell_rows(lines, record.notes, heading, separator);
  const bool gauge = rows.find("forcex", lines).has_value();
  read_forces(rows, gauge ? "force" : "ForceFluid.", gauge ? "force" : "ForceFluid", lines, record);
  record.layout = gauge ? "DualSPHysics force gauge" : "DualSPHysics ComputeForces";
}

}  // namespace upbead
