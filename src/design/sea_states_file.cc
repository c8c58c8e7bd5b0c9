#include "design/expected_laws.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <functional>

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

void check_names(const CsvTable& table, RecordNotes& notes, Diagnostics& mistakes) {
  std::vector<std::string> known;
  for (const Column& column : columns()) {
    known.push_back(column.name);
    const auto n = std::count(table.names.begin(), table.names.end(), column.name);
    if (n > 1)
      mistakes.add({table.path, 1, 1}, "there are " + std::to_string(n) + " columns '" + column.name + "'",
                   "keep one of them");
    if (n == 0 && column.required)
      mistakes.add({table.path, 1, 1}, "there is no column '" + column.name + "'", "add it");
  }
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    if (std::find(known.begin(), known.end(), table.names[c]) != known.end()) continue;
    if (header_says(table.names[c], table.units[c]) == HeaderSays::counter)
      notes.left_out.push_back({column_text(table, c), "a counter"});
    else
      mistakes.add({table.path, 1, 1}, "unknown column " + in_quotes(table.names[c]),
                   suggestion(table.names[c], known, "columns"));
  }
}

/// Values in the unit of the key: degrees for angles, else SI.
std::vector<double> values_of(const CsvTable& table, std::size_t c, const Column& column) {
  std::vector<double> values = in_si(table, c, column.si);
  if (!table.units[c].empty())
    for (double& value : values) value /= column.scale;
  return values;
}

}  // namespace

std::vector<SeaState> read_sea_states(const std::string& path, const Place& place, RecordNotes& notes) {
  const CsvTable table = read_record_table(path, place);
  Diagnostics mistakes;
  check_names(table, notes, mistakes);
  std::vector<SeaState> states(table.n_rows());
  for (const Column& column : columns()) {
    const auto found = std::find(table.names.begin(), table.names.end(), column.name);
    if (found == table.names.end()) continue;
    const std::vector<double> values = values_of(table, static_cast<std::size_t>(found - table.names.begin()), column);
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
