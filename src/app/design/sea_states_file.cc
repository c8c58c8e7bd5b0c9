#include "sea_states_file.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <functional>

#include "upbead/base/csv.h"
#include "upbead/base/suggest.h"
#include "upbead/base/text.h"

namespace upbead {

namespace {

struct Column {
  std::string name;
  bool required;
  std::string cure;
  std::function<bool(double)> allowed;
  double SeaState::*member;
  double scale = 1.;
};

const std::vector<Column>& columns() {
  const auto within = [](double low, double high) { return [=](double x) { return x >= low && x <= high; }; };
  static const std::vector<Column> list{
      {"significant_height", true, "give H_1/3 from 0.001 to 1000 (m)", within(1e-3, 1e3),
       &SeaState::significant_height},
      {"period", true, "give T from 0.01 to 10000 (s)", within(0.01, 1e4), &SeaState::period},
      {"waves", true, "give a number from 0 to 4e9", [](double x) { return x >= 0. && x < 4e9; }, &SeaState::waves},
      {"angle", false, "give the angle to the wall's normal, from 0 to below 90 (degrees)",
       [](double x) { return x >= 0. && x < 90.; }, &SeaState::angle, boost::math::constants::degree<double>()},
      {"water_level", false, "", [](double) { return true; }, &SeaState::water_level}};
  return list;
}

void check_names(const CsvTable& table, Mistakes& mistakes) {
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
  for (const std::string& name : table.names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      mistakes.add({table.path, 1, 1}, "unknown column '" + name + "'", suggestion(name, known, "columns"));
}

}  // namespace

std::vector<SeaState> read_sea_states(const std::string& path, const Place& place) {
  const CsvTable table = read_csv(path, place);
  Mistakes mistakes;
  check_names(table, mistakes);
  std::vector<SeaState> states(table.n_rows());
  for (const Column& column : columns()) {
    const auto found = std::find(table.names.begin(), table.names.end(), column.name);
    if (found == table.names.end()) continue;
    const std::vector<double>& values = table.columns[static_cast<std::size_t>(found - table.names.begin())];
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
