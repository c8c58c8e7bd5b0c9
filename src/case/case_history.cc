#include "case_history.h"

#include <algorithm>

#include "records/record_layout.h"
#include "records/record_table.h"

namespace upbead {

namespace {

/// A history in SI units.
struct Columns {
  CsvTable table;  ///< for places
  std::vector<double> time, value;
};

void check_times(const CsvTable& table, const std::vector<double>& time, Mistakes& mistakes) {
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

/// Reads and checks what all histories have in common; `si`: unit of the value.
Columns read_columns(const std::string& path, const Place& place, const std::string& si) {
  Columns columns{read_record_table(path, place), {}, {}};
  Mistakes mistakes;
  if (columns.table.columns.size() < 2)
    mistakes.add({path, 1, 1}, "a history of one column", "give two columns, time (s) and value");
  if (columns.table.n_rows() < 2) mistakes.add({path}, "a history of one row", "give two rows or more");
  mistakes.throw_if_any();
  const RecordLayout layout = layout_of(columns.table);
  columns.time = times_of(columns.table, layout);
  if (layout.values.empty())
    throw InputError({path, 1, 1}, "beside the time no column holds values, but counters or other times",
                     "give two columns, time (s) and value");
  columns.value = in_si(columns.table, layout.values.front(), si);
  check_times(columns.table, columns.time, mistakes);
  mistakes.throw_if_any();
  return columns;
}

}  // namespace

void read_history(const std::string& path, const Place& place, double end, Load& load) {
  const auto [table, time, value] = read_columns(path, place, load.kind == LoadKind::force ? "N/m" : "Pa");
  if (std::all_of(value.begin(), value.end(), [](double v) { return v == 0.; }))
    throw InputError({path}, "every value of the history is zero", "give a history with a load");
  load.history = piecewise_linear(time, value);
  load.duration = sampled_duration(time, value, end);
}

TimeFunction read_uplift(const std::string& path, const Place& place) {
  const auto [table, time, value] = read_columns(path, place, "N/m");
  const auto negative = std::find_if(value.begin(), value.end(), [](double v) { return v < 0.; });
  if (negative != value.end())
    throw InputError(table.place(static_cast<std::size_t>(negative - value.begin())),
                     "the uplift is " + number_text(*negative) + " N/m, below zero",
                     "give U upward, what it takes off the weight");
  return piecewise_linear(time, value);
}

}  // namespace upbead
