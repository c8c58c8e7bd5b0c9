#include "case_history.h"

#include <algorithm>

#include "upbead/base/csv.h"

namespace upbead {

namespace {

void check_times(const CsvTable& table, Mistakes& mistakes) {
  const std::vector<double>& time = table.columns[0];
  if (time.front() < 0.)
    mistakes.add(table.place(0), "the history starts at t = " + number_text(time.front()) + " s, before the run",
                 "let it start at 0 or later");
  for (std::size_t row = 1; row < time.size(); ++row)
    if (!(time[row] > time[row - 1])) {
      mistakes.add(table.place(row),
                   "t = " + number_text(time[row]) + " s does not follow t = " + number_text(time[row - 1]) + " s",
                   "let the times ascend strictly");
      return;  // a shuffled file would repeat this on every line
    }
}

/// Reads and checks what all histories have in common.
CsvTable read_columns(const std::string& path, const Place& place) {
  CsvTable table = read_csv(path, place);
  Mistakes mistakes;
  if (table.columns.size() < 2)
    mistakes.add({path, 1, 1}, "a history of one column", "give two columns, time (s) and value");
  if (table.n_rows() < 2) mistakes.add({path}, "a history of one row", "give two rows or more");
  check_times(table, mistakes);
  mistakes.throw_if_any();
  return table;
}

}  // namespace

void read_history(const std::string& path, const Place& place, double end, Load& load) {
  const CsvTable table = read_columns(path, place);
  const std::vector<double>&time = table.columns[0], &value = table.columns[1];
  if (std::all_of(value.begin(), value.end(), [](double v) { return v == 0.; }))
    throw InputError({path}, "every value of the history is zero", "give a history with a load");
  load.history = piecewise_linear(time, value);
  load.duration = sampled_duration(time, value, end);
}

TimeFunction read_uplift(const std::string& path, const Place& place) {
  const CsvTable table = read_columns(path, place);
  const std::vector<double>& value = table.columns[1];
  const auto negative = std::find_if(value.begin(), value.end(), [](double v) { return v < 0.; });
  if (negative != value.end())
    throw InputError(table.place(static_cast<std::size_t>(negative - value.begin())),
                     "the uplift is " + number_text(*negative) + " N/m, below zero",
                     "give U upward, what it takes off the weight");
  return piecewise_linear(table.columns[0], value);
}

}  // namespace upbead
