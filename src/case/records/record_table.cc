#include "case/records/record_table.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <numeric>

#include "base/header_words.h"
#include "base/numbers.h"
#include "base/table_text.h"
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
  table.layout = "datasets of an HDF5 file";
  return table;
}

/// Marks for missing values, as buoys and loggers write them; of magnitudes from 1e20 on all are.
bool is_mark(double value) {
  constexpr double huge = 1e20;
  constexpr double marks[]{99.,    99.9,    99.99,    999.,   999.9,   999.99,  999.999, 9999.,
                           9999.9, 9999.99, 9999.999, 99999., 99999.9, 999999., 9999999.};
  const double size = std::abs(value);
  return size >= huge || value == -999.25 || std::find(std::begin(marks), std::end(marks), size) != std::end(marks);
}

}  // namespace

CsvTable read_record_table(const std::string& path, const Place& place) {
  return is_hdf5(path) ? read_hdf5_table(path) : read_csv(path, place);
}

bool is_hdf5(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".h5" || ending == ".hdf5" || is_hdf5_file(path);
}

void refuse_unread_unit(const std::string& path, const std::string& name, const std::string& si) {
  const std::string unit = unread_unit(name);
  const bool of_force = si == "N/m" || si == "Pa" || si == "N" || si == "N m/m" || si == "Nm/m";
  if (unit.empty() || !of_force) return;
  throw InputError({path, 1, 1},
                   "the name " + in_quotes(name) + " holds " + in_quotes(unit) + ", a unit that is not read there",
                   (is_hdf5(path) ? "give the dataset an attribute unit, one of "
                                  : "write the unit in brackets behind the name, one of ") +
                       units_like(si));
}

ColumnUnit unit_of_column(const CsvTable& table, std::size_t column, const std::string& si, const std::string& given) {
  const std::string& name = table.names[column];
  const std::string& written = given.empty() ? table.units[column] : given;
  const std::string is_none = " is none of " + (si == "s" ? "a time" : "what it should hold, " + si);
  if (written.empty()) {
    const auto end = unit_at_end(name);
    if (!end || (end->known.si != si && may_be_a_name(end->unit))) {
      refuse_unread_unit(table.path, name, si);
      return {si, 1., ColumnUnit::none};
    }
    if (end->known.si == si && end->unit == "G" && end->name.find(' ') == std::string::npos)
      throw InputError({table.path}, "the end of the name " + in_quotes(name) + " may be the unit g or a point G",
                       "write the unit in brackets behind the name");
    if (end->known.si != si)
      throw InputError(
          {table.path},
          "the name " + in_quotes(name) + " ends in the unit " + in_quotes(end->unit) + ", which" + is_none,
          "write one of " + units_like(si) + ", in brackets behind the name");
    return {end->unit, end->known.factor, "by the end of its name"};
  }
  const std::optional<Unit> known = unit_of(written);
  if (!known || known->si != si)
    throw InputError({table.path}, "the unit " + in_quotes(written) + " of column " + in_quotes(name) + is_none,
                     "write one of " + units_like(si));
  const auto end = unit_at_end(name);
  if (given.empty() && end && end->known.si == si && end->known.factor != known->factor)
    throw InputError(
        {table.path},
        "column " + in_quotes(name) + " has the unit " + in_quotes(written) + " and another one at its name's end",
        "keep the one that holds");
  return {written, known->factor, given.empty() ? "" : "as the case says"};
}

std::vector<double> converted(const CsvTable& table, std::size_t column, const ColumnUnit& unit) {
  std::vector<double> values = table.numbers(column);
  if (unit.factor != 1.)
    for (double& value : values) value *= unit.factor;
  return values;
}

void refuse_missing_marks(const CsvTable& table, std::size_t column) {
  constexpr double far = 3.;
  const std::vector<double>& values = table.numbers(column);
  double most[2] = {0., 0.};   // of the other numbers, by sign
  std::vector<double> others;  // two that are neither zero nor alike
  std::size_t n = 0, first = 0;
  for (const double value : values) {
    if (is_mark(value)) continue;
    double& largest = most[value < 0. ? 0 : 1];
    largest = std::max(largest, std::abs(value));
    if (value != 0. && others.size() < 2 && (others.empty() || others[0] != value)) others.push_back(value);
  }
  if (others.size() < 2) return;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!is_mark(values[row]) || std::abs(values[row]) <= far * most[values[row] < 0. ? 0 : 1]) continue;
    if (n++ == 0) first = row;
  }
  if (n == 0) return;
  throw InputError(table.place(first),
                   significant(values[first], 7) + " stands for a missing value (column " +
                       excerpt(table.names[column]) + (n > 1 ? ", one of " + std::to_string(n) + " such cells)" : ")"),
                   "leave such rows out, or put in what was measured");
}

std::vector<double> in_si(const CsvTable& table, std::size_t column, const std::string& si, const std::string& unit) {
  std::vector<double> values = converted(table, column, unit_of_column(table, column, si, unit));
  refuse_missing_marks(table, column);
  return values;
}

RecordSummary summary_of(const CsvTable& table, std::size_t column, const std::string& si, const std::string& given,
                         const std::vector<double>& time, const std::vector<double>& values) {
  const ColumnUnit unit = unit_of_column(table, column, si, given);
  const std::size_t extreme = index_of_largest(values), n = values.size();
  RecordSummary s;
  s.file = std::filesystem::path(table.path).filename().string();
  s.column = table.names[column];
  s.unit = unit.text + (unit.by.empty() ? "" : ", " + unit.by);
  s.si = si;
  s.layout = table.layout;
  s.samples = static_cast<int>(n);
  if (n > 1) s.interval = (time.back() - time.front()) / static_cast<double>(n - 1);
  if (n > 0) s.begin = time.front();
  if (n > 0) s.extreme = values[extreme];
  if (n > 0) s.extreme_time = time[extreme];
  return s;
}

namespace {

/// Whether a column is clearly the time.
bool has_times(const CsvTable& table, const RecordLayout& layout) {
  return layout.time && table.n_rows() > 1 && !table.is_text(*layout.time) &&
         header_says(table.names[*layout.time], table.units[*layout.time]) > HeaderSays::counter;
}

/// The length of the record by its rate and by its own times must agree.
void require_rate(const CsvTable& table, const std::vector<double>& time, std::size_t column, double rate) {
  const double by_rate = static_cast<double>(time.size() - 1) / rate, by_column = time.back() - time.front();
  if (std::abs(by_rate - by_column) > 0.01 * by_rate)
    throw InputError({table.path, 1, 1},
                     "sampling_rate = " + significant(rate) + " Hz makes the record " + significant(by_rate) +
                         " s long, its column " + in_quotes(table.names[column]) + " " + significant(by_column) + " s",
                     "leave out sampling_rate, or mend it");
}

/// A column that is clearly the time holds beside a sampling rate, and must agree with it; where its times repeat, as
/// they are written with few digits, they go on from the first by the rate.
std::vector<double> times_by_rate(const CsvTable& table, const RecordLayout& layout, double rate) {
  std::vector<double> time(table.n_rows());
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = static_cast<double>(i) / rate;
  if (!has_times(table, layout)) return time;
  const std::vector<double> own = times_of(table, layout);
  require_rate(table, own, *layout.time, rate);
  const bool ascend =
      std::adjacent_find(own.begin(), own.end(), [](double a, double b) { return !(b > a); }) == own.end();
  if (ascend) return own;
  for (double& t : time) t += own.front();
  return time;
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
    times.time = times_by_rate(table, layout, *clock.sampling_rate);
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
  const auto with_unit = [&table](std::size_t c, const char* before, const char* behind) {
    return table.names[c] + before + table.units[c] + behind;
  };
  const auto is_exact = [&](std::size_t c) { return table.names[c] == name; };
  const auto is_written = [&](std::size_t c) {
    return with_unit(c, "/", "") == name || with_unit(c, " / ", "") == name || with_unit(c, " (", ")") == name ||
           with_unit(c, " [", "]") == name;
  };
  const auto is_short = [&](std::size_t c) {
    const auto end = unit_at_end(table.names[c]);
    return table.units[c].empty() && end && end->name == name;
  };
  for (const std::function<bool(std::size_t)>& fits :
       {std::function<bool(std::size_t)>(is_exact), {is_written}, {is_short}}) {
    std::vector<std::size_t> found;
    for (std::size_t c = 0; c < table.names.size(); ++c)
      if (fits(c)) found.push_back(c);
    if (found.size() == 1) return found[0];
    if (found.size() > 1)
      throw InputError(place,
                       quoted_path(table.path) + " has " + std::to_string(found.size()) + " columns " + in_quotes(name),
                       "give each column a name of its own");
  }
  throw InputError(place, quoted_path(table.path) + " has no column " + in_quotes(name),
                   suggestion(name, table.names, "columns"));
}

NumberedWarnings zero_warnings(const std::string& name, const RecordTimes& times, const std::vector<double>& values) {
  constexpr double quiet = 0.05;
  const std::size_t third = times.at_rest / 3;
  if (third == 0) return {};
  const auto mean = [&](std::size_t first) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(third), 0.) / static_cast<double>(third);
  };
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const auto [low, high] = std::minmax({mean(0), mean(third), mean(times.at_rest - third)});
  const double change = high - low, range = *most - *least;
  if (!(change > quiet * range)) return {};
  return {{"record_zero", change / range, quiet, "1",
           "record '" + name + "' changes by " + significant(100. * change / range, 2) +
               " % of its range within the time that 'zero' calls its rest, whose mean is taken off",
           "let zero end before the event, or leave it out", true}};
}

void take_off_rest(const RecordTimes& times, std::vector<double>& values) {
  double mean = 0.;
  for (std::size_t i = 0; i < times.at_rest; ++i) mean += values[i] / static_cast<double>(times.at_rest);
  for (double& value : values) value -= mean;
}

}  // namespace upbead
