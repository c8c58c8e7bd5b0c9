#include "case/records/record_table.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "base/numbers.h"
#include "base/text.h"
#include "base/units.h"
#include "case/records/record_layout.h"
#include "input/values.h"
#include "output/hdf5_reader.h"

namespace upbead {

namespace {

constexpr std::size_t most_datasets = 10'000;

CsvTable read_hdf5_table(const std::string& path) {
  const Hdf5Reader file(path, "an HDF5 file of records, one dataset for the time and one for each column");
  CsvTable table;
  table.path = path;
  std::vector<std::string> names = file.names();
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name == "time"; });
  if (names.size() > most_datasets)
    throw InputError({path},
                     std::to_string(names.size()) + " datasets; at most " + std::to_string(most_datasets) +
                         " are read, more than any record has",
                     "is it the right file? keep the time and the records that are needed");
  for (const std::string& name : names) {
    std::optional<NumberArray> data = file.numbers("/" + name);
    if (!data || data->shape.size() != 1) continue;
    if (const std::string objection = objection_to(data->values); !objection.empty())
      throw InputError({path}, "a number of /" + excerpt(name) + " " + objection, "repair the record");
    if (!table.columns.empty() && data->values.size() != table.columns.front().size())
      throw InputError({path}, "/" + excerpt(name) + " is not as long as /" + excerpt(table.names.front()),
                       "let all records of a file have the same length");
    table.names.push_back(name);
    table.units.push_back(file.text_attribute("/" + name, "unit").value_or(""));
    table.columns.push_back(std::move(data->values));
  }
  if (table.columns.empty() || table.columns.front().empty())
    throw InputError({path}, "no one-dimensional dataset of numbers below the root",
                     "write /time and a dataset a record");
  table.lines.resize(table.columns.front().size());
  std::iota(table.lines.begin(), table.lines.end(), 1);
  return table;
}

bool is_hdf5(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".h5" || ending == ".hdf5";
}

}  // namespace

CsvTable read_record_table(const std::string& path, const Place& place) {
  return is_hdf5(path) ? read_hdf5_table(path) : read_csv(path, place);
}

CsvTable read_record_head(const std::string& path) {
  return is_hdf5(path) ? read_hdf5_table(path) : read_csv_head(path, 1'000'000);
}

std::vector<double> in_si(const CsvTable& table, std::size_t column, const std::string& si, const std::string& unit) {
  const std::string written = unit.empty() ? table.units[column] : unit;
  std::vector<double> values = table.columns[column];
  if (written.empty()) return values;
  const std::optional<Unit> known = unit_of(written);
  if (!known || known->si != si)
    throw InputError({table.path},
                     "the unit " + in_quotes(written) + " of column " + in_quotes(table.names[column]) +
                         " is none of " + (si == "s" ? "a time" : "what it should hold, " + si),
                     "write one of " + units_like(si));
  if (known->factor != 1.)
    for (double& value : values) value *= known->factor;
  return values;
}

namespace {

/// Where a sampling rate is given, a column that is clearly the time must agree with it.
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

bool is_jump(const std::vector<double>& time, std::size_t row) {
  if (time.front() == time.back() || time[row] != time[row - 1] || (row > 1 && time[row - 2] == time[row]) ||
      (row + 1 < time.size() && time[row + 1] == time[row]))
    return false;
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < time.size(); ++i) repeated += time[i] == time[i - 1] ? 1 : 0;
  constexpr std::size_t drawn = 4;  // jumps of a history that a person wrote
  return repeated <= drawn || 10 * repeated < time.size();
}

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
    if (!(time[i] > time[i - 1]) && !is_jump(time, i))
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
