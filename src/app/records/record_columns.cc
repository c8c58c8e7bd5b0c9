#include "record_columns.h"

#include <algorithm>

#include "upbead/base/suggest.h"
#include "upbead/input/values.h"

namespace upbead {

RecordTimes record_times(const CsvTable& table, const RecordClock& clock) {
  RecordTimes times;
  if (clock.sampling_rate) {
    times.time.resize(table.n_rows());
    for (std::size_t i = 0; i < times.time.size(); ++i) times.time[i] = static_cast<double>(i) / *clock.sampling_rate;
  } else {
    times.time = in_si(table, 0, "s");
  }
  std::vector<double>& time = times.time;
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      throw InputError(table.place(i),
                       "t = " + number_text(time[i]) + " s does not follow t = " + number_text(time[i - 1]) + " s",
                       "let the times ascend strictly, or give sampling_rate where there is no column of times");
  times.at_rest = static_cast<std::size_t>(
      std::count_if(time.begin(), time.end(), [&](double t) { return t - time.front() < clock.zero; }));
  for (double& t : time) t -= clock.record_start;
  return times;
}

std::size_t column_of(const CsvTable& table, const std::string& name, const Place& place) {
  const auto found = std::find(table.names.begin(), table.names.end(), name);
  if (found == table.names.end())
    throw InputError(place, "'" + table.path + "' has no column '" + name + "'",
                     suggestion(name, table.names, "columns"));
  return static_cast<std::size_t>(found - table.names.begin());
}

void take_off_rest(const RecordTimes& times, std::vector<double>& values) {
  double mean = 0.;
  for (std::size_t i = 0; i < times.at_rest; ++i) mean += values[i] / static_cast<double>(times.at_rest);
  for (double& value : values) value -= mean;
}

}  // namespace upbead
