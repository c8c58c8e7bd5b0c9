#include "wave_checks.h"

#include <algorithm>

#include "base/text.h"
#include "base/units.h"

namespace upbead::detail {

std::size_t find(const Names& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

void add_unknown_load(const Place& place, const std::string& what, const std::string& name, const Names& loads,
                      Diagnostics& mistakes) {
  const std::string near = nearest(name, loads), all = "the model's loads are: " + join(loads);
  mistakes.add(place, what + " " + in_quotes(name) + " is no load of the model",
               near.empty() ? all : "did you mean " + in_quotes(near) + "? " + all);
}

void check_times(const std::vector<double>& time, const std::function<Place(std::size_t)>& place,
                 Diagnostics& mistakes) {
  if (time.size() < 2) return mistakes.add(place(0), "a wave of one time", "give two times or more");
  if (time.front() < 0.)
    mistakes.add(place(0), "the wave starts at t = " + significant(time.front(), 6) + " s, before the response",
                 "let it start at 0 or later");
  for (std::size_t n = 1; n < time.size(); ++n)
    if (!(time[n] > time[n - 1]))
      return mistakes.add(
          place(n), "t = " + significant(time[n], 6) + " s does not follow t = " + significant(time[n - 1], 6) + " s",
          "let the times ascend strictly");
}

double factor_to_load(const std::string& unit, std::size_t k, const Names& units, const Place& place,
                      const std::string& who) {
  if (unit.empty()) return 1.;
  const std::string wanted = k < units.size() ? units[k] : "";
  const std::optional<Unit> known = unit_of(unit);
  if (known && (wanted.empty() ? known->si == "N/m" || known->si == "Pa" : known->si == wanted)) return known->factor;
  throw InputError(
      place,
      "the unit " + in_quotes(unit) + " of " + who + " is none of the load, " + (wanted.empty() ? "N/m or Pa" : wanted),
      "write one of " + units_like(wanted.empty() ? "N/m" : wanted));
}

std::vector<double> in_unit_of_load(const CsvTable& table, std::size_t column, std::size_t k, const Names& units) {
  const double factor =
      factor_to_load(table.units[column], k, units, {table.path, 1, 1}, "column " + in_quotes(table.names[column]));
  std::vector<double> values = table.columns[column];
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace upbead::detail
