#include "case/records/sea_states.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <functional>

#include "base/header_words.h"
#include "base/text.h"
#include "case/records/record_layout.h"
#include "case/records/record_table.h"

namespace upbead {

namespace {

struct Column {
  std::string name;
  bool required;
  std::string cure;
  std::function<bool(double)> allowed;
  double SeaState::*member;
  std::string si;  ///< SI unit of the quantity, for a unit in its header
  double scale = 1.;
};

const std::vector<Column>& columns() {
  const auto within = [](double low, double high) { return [=](double x) { return x >= low && x <= high; }; };
  static const std::vector<Column> list{
      {"significant_height", true, "give H_1/3 from 0.001 to 1000 (m)", within(1e-3, 1e3),
       &SeaState::significant_height, "m"},
      {"period", true, "give T from 0.01 to 10000 (s)", within(0.01, 1e4), &SeaState::period, "s"},
      {"waves", true, "give a number from 0 to 4e9", [](double x) { return x >= 0. && x < 4e9; }, &SeaState::waves,
       "1"},
      {"angle", false, "give the angle to the wall's normal, from 0 to below 90 (degrees)",
       [](double x) { return x >= 0. && x < 90.; }, &SeaState::angle, "rad", boost::math::constants::degree<double>()},
      {"water_level", false, "", [](double) { return true; }, &SeaState::water_level, "m"}};
  return list;
}

/// Name of a column among the known ones, without a unit at its end; as written elsewhere.
std::string known_name(const CsvTable& table, std::size_t c) {
  const auto is = [](const std::string& name) {
    return std::any_of(columns().begin(), columns().end(),
                       [&name](const Column& column) { return column.name == name; });
  };
  const auto end = unit_at_end(table.names[c]);
  return end && table.units[c].empty() && is(end->name) ? end->name : table.names[c];
}

std::vector<std::string> known_names(const CsvTable& table) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < table.names.size(); ++c) names.push_back(known_name(table, c));
  return names;
}

/// Columns of numbers that have no known name: a mistyped one is told by itself, others together.
void check_others(const CsvTable& table, const std::vector<std::string>& names, const std::vector<std::string>& known,
                  RecordNotes& notes, Diagnostics& mistakes) {
  std::vector<std::string> others;
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (std::find(known.begin(), known.end(), names[c]) != known.end()) continue;
    if (header_says(names[c], table.units[c]) == HeaderSays::counter)
      notes.left_out.push_back({column_text(table, c), "a counter"});
    else if (table.is_text(c))
      notes.left_out.push_back({column_text(table, c), "it holds no numbers"});
    else
      others.push_back(names[c]);
  }
  if (others.size() == 1)
    mistakes.add({table.path, 1, 1}, "unknown column " + in_quotes(others[0]), suggestion(others[0], known, "columns"));
  if (others.size() > 1)
    mistakes.add({table.path, 1, 1}, std::to_string(others.size()) + " unknown columns, " + excerpt(join(others)),
                 "leave them out, or call them as what they hold: " + join(known));
}

/// Refuses in one sentence a table of other names, as a buoy's or that of another program.
void check_names(const CsvTable& table, RecordNotes& notes, Diagnostics& mistakes) {
  std::vector<std::string> known, missing;
  const std::vector<std::string> names = known_names(table);
  const auto count = [&names](const Column& column) { return std::count(names.begin(), names.end(), column.name); };
  for (const Column& column : columns()) {
    known.push_back(column.name);
    if (column.required && count(column) == 0) missing.push_back(column.name);
  }
  if (missing.size() == 3) {
    mistakes.add({table.path, 1, 1},
                 "a table with the columns " + excerpt(join(table.names)) + " does not tell which are " + join(missing),
                 "call H_1/3 (m; WVHT, Hs, Hm0 elsewhere) significant_height and T_1/3 (s) period, and add waves, the "
                 "number of waves that each row stands for");
    return;
  }
  for (const Column& column : columns()) {
    if (count(column) > 1)
      mistakes.add({table.path, 1, 1}, "there are " + std::to_string(count(column)) + " columns '" + column.name + "'",
                   "keep one of them");
    if (column.required && count(column) == 0)
      mistakes.add({table.path, 1, 1}, "there is no column '" + column.name + "'", "add it");
  }
  check_others(table, names, known, notes, mistakes);
}

/// Values in the unit of the key: degrees for angles, else SI.
std::vector<double> values_of(const CsvTable& table, std::size_t c, const Column& column) {
  const ColumnUnit unit = unit_of_column(table, c, column.si);
  if (column.name == "waves" && unit.factor != 1.)
    throw InputError(
        {table.path}, "the unit " + in_quotes(table.units[c]) + " of column 'waves' is no number of waves",
        "give how many waves each row stands for: its share of the time, times years over the mean period");
  std::vector<double> values = converted(table, c, unit);
  if (column.name != "waves") refuse_missing_marks(table, c);  // any number of waves may be
  if (unit.given())
    for (double& value : values) value /= column.scale;
  return values;
}

}  // namespace

std::vector<SeaState> read_sea_states(const std::string& path, const Place& place, RecordNotes& notes) {
  const CsvTable table = read_record_table(path, place);
  Diagnostics mistakes;
  check_names(table, notes, mistakes);
  mistakes.throw_if_any();
  const std::vector<std::string> names = known_names(table);
  std::vector<SeaState> states(table.n_rows());
  for (const Column& column : columns()) {
    const auto found = std::find(names.begin(), names.end(), column.name);
    if (found == names.end()) continue;
    const auto c = static_cast<std::size_t>(found - names.begin());
    const std::vector<double> values = values_of(table, c, column);
    if (column.required) notes.read.push_back(summary_of(table, c, column.si, "", values, values));
    for (std::size_t row = 0; row < states.size(); ++row) {
      if (!column.allowed(values[row]))
        mistakes.add(table.place(row), column.name + " = " + significant(values[row], 6) + " is not possible",
                     column.cure);
      states[row].*column.member = column.scale * values[row];
    }
  }
  mistakes.throw_if_any();
  return states;
}

}  // namespace upbead
