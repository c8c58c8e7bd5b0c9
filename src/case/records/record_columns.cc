#include "record_columns.h"

#include <algorithm>
#include <cmath>

#include "base/quoted.h"
#include "base/suggest.h"
#include "base/text.h"
#include "header_words.h"
#include "input/values.h"

namespace upbead {

namespace {

/// A column that says that it is the time must agree with the rate that is given.
void require_rate(const CsvTable& table, const RecordLayout& layout, double rate) {
  const bool says_so =
      layout.time && header_says(table.names[*layout.time], table.units[*layout.time]) > HeaderSays::counter;
  if (!says_so || table.n_rows() < 2) return;
  const std::vector<double> time = times_of(table, layout);
  const double by_rate = static_cast<double>(time.size() - 1) / rate, by_column = time.back() - time.front();
  if (std::abs(by_rate - by_column) > 0.01 * by_rate)
    throw InputError({table.path, 1, 1},
                     "sampling_rate = " + significant(rate) + " Hz makes the record " + significant(by_rate) +
                         " s long, its column " + in_quotes(table.names[*layout.time]) + " " + significant(by_column) +
                         " s",
                     "leave out sampling_rate, or mend it");
}

}  // namespace

RecordTimes record_times(const CsvTable& table, const RecordLayout& layout, const RecordClock& clock) {
  RecordTimes times;
  if (clock.sampling_rate) {
    require_rate(table, layout, *clock.sampling_rate);
    times.time.resize(table.n_rows());
    for (std::size_t i = 0; i < times.time.size(); ++i) times.time[i] = static_cast<double>(i) / *clock.sampling_rate;
  } else {
    times.time = times_of(table, layout);
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
  if (found != table.names.end()) return static_cast<std::size_t>(found - table.names.begin());
  for (std::size_t c = 0; c < table.names.size(); ++c)
    for (const char* slash : {"/", " / "})
      if (table.names[c] + slash + table.units[c] == name) return c;
  throw InputError(place, quoted_path(table.path) + " has no column " + in_quotes(name),
                   suggestion(name, table.names, "columns"));
}

void take_off_rest(const RecordTimes& times, std::vector<double>& values) {
  double mean = 0.;
  for (std::size_t i = 0; i < times.at_rest; ++i) mean += values[i] / static_cast<double>(times.at_rest);
  for (double& value : values) value -= mean;
}

}  // namespace upbead
