#include "case/records/history_load.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/text.h"
#include "case/case_checks.h"
#include "case/case_schema.h"
#include "case/records/record_table.h"
#include "model/motion.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// A history in SI units.
struct Columns {
  CsvTable table;  ///< kept for the places of mistakes
  std::vector<double> time, value;
  RecordNotes notes;
};

void check_times(const CsvTable& table, const std::vector<double>& time, double start, Diagnostics& mistakes) {
  if (time.front() < 0. && start == 0.)
    mistakes.add(table.place(0), "the history starts at t = " + number_text(time.front()) + " s, before the run",
                 "let it start at 0 or later, or give record_start");
  for (std::size_t row = 1; row < time.size(); ++row)
    if (!(time[row] > time[row - 1]) && !is_jump(time, row)) {
      mistakes.add(table.place(row),
                   "t = " + number_text(time[row]) + " s does not follow t = " + number_text(time[row - 1]) + " s",
                   "let the times ascend strictly");
      return;  // a shuffled file would repeat this on every line
    }
}

/// The columns of values whose unit may be that of the history; all of them where none is.
std::vector<std::size_t> fitting_values(const CsvTable& table, const RecordLayout& layout, const std::string& si) {
  std::vector<std::size_t> list;
  for (const std::size_t c : layout.values) try {
      unit_of_column(table, c, si);
      list.push_back(c);
    } catch (const InputError&) {
      continue;  // of another quantity
    }
  return list.empty() ? layout.values : list;
}

/// A history has one value: that of the column which is named, else the one whose unit fits. Of several that fit the
/// first is taken, though another one would be as good, so that this is a guess.
std::size_t only_value(const CsvTable& table, const RecordLayout& layout, const std::string& si,
                       const std::string& name, const Place& place, RecordNotes& notes) {
  const std::vector<std::size_t> fit = fitting_values(table, layout, si);
  const std::size_t value = name.empty() ? fit.front() : column_of(table, name, place);
  std::vector<std::size_t> others;
  std::copy_if(layout.values.begin(), layout.values.end(), std::back_inserter(others),
               [value](std::size_t c) { return c != value; });
  if (!others.empty())
    notes.left_out.push_back({column_text(table, others.front()) +
                                  (others.size() > 1 ? " and " + std::to_string(others.size() - 1) + " more" : ""),
                              "a history has one value, here " + in_quotes(table.names[value])});
  if (!name.empty() || fit.size() == 1) return value;
  for (std::size_t i = 1; i < fit.size(); ++i)
    if (table.names[fit[i]] == table.names[value])
      throw InputError({table.path, 1, 1}, "two columns are called " + in_quotes(table.names[value]),
                       "keep the one that is meant, or give each a name of its own");
  notes.warnings.push_back({"column_chosen", static_cast<double>(fit.size()), 1., "1",
                            std::filesystem::path(table.path).filename().string() + " has " +
                                std::to_string(fit.size()) + " columns of values that fit, and the first, " +
                                in_quotes(table.names[value]) + ", is taken",
                            "name the one that is meant by column = \"...\", or keep it alone beside the time", true});
  return value;
}

/// Lets t = 0 of the run be `start` of the record: leaves out what comes before, up to a value there.
void begin_at(double start, const Place& place, std::vector<double>& time, std::vector<double>& value) {
  if (start == 0.) return;
  for (double& t : time) t -= start;
  const auto first = std::lower_bound(time.begin(), time.end(), 0.) - time.begin();
  if (time.end() - time.begin() - first < 2)
    throw InputError(place, "the record is over before the run begins", "give an earlier record_start");
  if (first == 0) return;
  const auto i = static_cast<std::size_t>(first);
  const double share = time[i - 1] / (time[i - 1] - time[i]),
               at_zero = value[i - 1] + share * (value[i] - value[i - 1]);
  const bool has_zero = time[i] == 0.;
  time.erase(time.begin(), time.begin() + first - (has_zero ? 0 : 1));
  value.erase(value.begin(), value.begin() + first - (has_zero ? 0 : 1));
  if (has_zero) return;
  time.front() = 0.;
  value.front() = at_zero;
}

/// Takes off what the record reads in its first `zero` seconds.
void take_off_zero(const std::string& name, double zero, Columns& columns) {
  const std::vector<double>& time = columns.time;
  const RecordTimes times{time, static_cast<std::size_t>(std::count_if(
                                    time.begin(), time.end(), [&](double t) { return t - time.front() < zero; }))};
  append(columns.notes.warnings, zero_warnings(name, times, columns.value));
  take_off_rest(times, columns.value);
}

/// Reads and checks what all histories have in common; `si`: unit of the value.
Columns read_columns(const std::string& path, const Place& place, const std::string& si, const HistoryChoice& choice) {
  const double start = choice.start;
  Columns columns{read_record_table(path, place), {}, {}, {}};
  Diagnostics mistakes;
  if (columns.table.columns.size() < 2)
    mistakes.add({path, 1, 1}, "a history of one column", "give two columns, time (s) and value");
  if (columns.table.n_rows() < 2) mistakes.add({path}, "a history of one row", "give two rows or more");
  mistakes.throw_if_any();
  const RecordLayout layout = layout_of(columns.table);
  columns.time = times_of(columns.table, layout);
  if (layout.values.empty() && !layout.words.empty()) static_cast<void>(columns.table.numbers(layout.words.back()));
  if (layout.values.empty())
    throw InputError({path, 1, 1}, "beside the time no column holds values, but counters or other times",
                     "give two columns, time (s) and value");
  note_layout(columns.table, layout, columns.notes);
  const std::size_t value = only_value(columns.table, layout, si, choice.column, place, columns.notes);
  columns.value = in_si(columns.table, value, si);
  take_off_zero(columns.table.names[value], choice.zero, columns);
  check_times(columns.table, columns.time, start, mistakes);
  mistakes.throw_if_any();
  begin_at(start, place, columns.time, columns.value);
  columns.notes.read.push_back(summary_of(columns.table, value, si, "", columns.time, columns.value));
  return columns;
}

/// A displacement must not jump; a jump of an acceleration at its end moves nothing.
void require_motion(LoadKind kind, const std::string& path, std::vector<double>& time, std::vector<double>& value) {
  const auto jump = std::adjacent_find(time.begin(), time.end());
  if (jump == time.end()) return;
  if (kind == LoadKind::displacement)
    throw InputError({path}, "the displacement jumps at t = " + number_text(*jump) + " s, at an infinite velocity",
                     "let it pass from one value to the other within some time");
  while (kind == LoadKind::acceleration && time.size() > 2 && time[time.size() - 2] == time.back()) {
    time.pop_back();
    value.pop_back();
  }
}

}  // namespace

FileHistory read_history(const std::string& path, const Place& place, LoadKind kind, double end,
                         const HistoryChoice& choice) {
  Columns columns = read_columns(path, place, unit_of(kind), choice);
  FileHistory history{{path, columns.time, columns.value}, {}, {}, std::move(columns.notes)};
  std::vector<double>&time = columns.time, &value = columns.value;
  if (std::all_of(value.begin(), value.end(), [](double v) { return v == 0.; }))
    throw InputError({path}, "every value of the history is zero", "give a history with a load");
  if (is_motion(kind)) require_motion(kind, path, time, value);
  if (kind == LoadKind::displacement) {
    constexpr std::size_t fewest = 4;  // of a cubic
    if (time.size() < fewest)
      throw InputError({path}, "a displacement of " + std::to_string(time.size()) + " rows has no smooth velocity",
                       "give four rows or more");
    history.function = rate_of_samples(time, value);
    const double first = value.front();
    for (double& v : value) v -= first;
    history.record.value = value;
    history.duration = sampled_duration(time, value, time.back());
    return history;
  }
  history.function = kind == LoadKind::acceleration ? integral_of_samples(time, value) : piecewise_linear(time, value);
  history.duration = sampled_duration(time, value, end);
  return history;
}

FileHistory read_uplift(const std::string& path, const Place& place, const HistoryChoice& choice) {
  constexpr double noise = 0.05;  // of the largest value
  Columns columns = read_columns(path, place, "N/m", choice);
  std::vector<double>& value = columns.value;
  const double largest = *std::max_element(value.begin(), value.end());
  if (choice.zero > 0.)
    for (double& v : value)
      if (v > -noise * largest) v = std::max(v, 0.);
  const auto negative = std::find_if(value.begin(), value.end(), [](double v) { return v < 0.; });
  if (negative != value.end())
    throw InputError(
        choice.start == 0. ? columns.table.place(static_cast<std::size_t>(negative - value.begin())) : Place{path},
        "the uplift is " + number_text(*negative) + " N/m, below zero", "give U upward, what it takes off the weight");
  return {{path, columns.time, value}, piecewise_linear(columns.time, value), {}, columns.notes};
}

namespace {

/// Warning implausible: an acceleration without a unit whose peak is that of a motion in g. A factor below 1, by which
/// a study weakens a motion, is left out.
NumberedWarnings warnings_of_no_unit(const GivenLoad& given, const RecordNotes& notes) {
  constexpr double largest_in_g = 1.;
  const RecordSummary& column = notes.read.front();
  const double peak = std::abs(column.extreme) * std::max(std::abs(given.table.factor), 1.);
  if (given.table.kind != LoadKind::acceleration || peak >= largest_in_g ||
      column.unit.find(ColumnUnit::none) == std::string::npos)
    return {};
  return {{"implausible", peak, largest_in_g, "m/s2",
           "loads." + given.name + ": the column '" + column.column + "' has no unit, and its peak, " +
               significant(peak, 4) + ", is taken in m/s2: in g it would be " + significant(9.81 * peak, 4) + " m/s2",
           "write the unit in brackets behind the name of the column, as " + column.column + " (g)", true}};
}

/// Adds the file, and warnings of its record where it acts. `end`: of the run, where the load is zero after the record.
void add_file(const std::string& path, const Place& place, FileHistory& history, const std::optional<double>& end,
              LoadSource& source) {
  source.files = {{path, place}};
  source.notes = std::move(history.notes);
  history.record.name = source.title;
  history.record.end = end;
  if (!source.acts()) return;
  append(source.warnings, record_warnings(history.record));
  append(source.warnings, drop_warnings(history.record, source.warnings));
}

HistoryChoice choice_of(const HistoryKeys& keys, const RecordClock& clock) {
  return {keys.column, clock.zero, clock.record_start};
}

std::shared_ptr<LoadSource> read_one(const GivenLoad& given) {
  const auto source = begun(given);
  Load load = given.table;
  const std::string path = given.problem.resolve(given.table.history_file);
  const Place place = given.place("history");
  FileHistory history = read_history(path, place, load.kind, given.end(), choice_of(given.table, given.table));
  load.history = history.function;
  load.duration = history.duration;
  if (!is_motion(load.kind))
    for (double& value : history.record.value) value *= load.factor;
  if (source->acts()) source->warnings = warnings_of_no_unit(given, history.notes);
  add_file(path, place, history, is_motion(load.kind) ? std::nullopt : std::optional(given.end()), *source);
  const Load& made = source->made[given.name] = with_factor(load);
  if (source->acts()) source->action = action_of(source->title, "load_cut", "record_start", made.history);
  return source;
}

}  // namespace

LoadWay by_history() {
  return {[](const LoadTable& table) { return !table.pulse; },
          [](TableSchema<LoadTable>& table) {
            table.key("history", &LoadTable::history_file, "",
                      "path of a CSV file with a header line, then time (s) and value; linear in between; or pulse");
            add_column_key(table);
          },
          [](const LoadCheck& check) { check.exactly_one("pulse", "history"); },
          read_one,
          {&LoadTable::history_file}};
}

std::shared_ptr<LoadSource> read_uplift_history(const UpliftTable& uplift, const Case& problem) {
  const auto source = std::make_shared<LoadSource>();
  source->name = source->title = "sliding.uplift";
  const std::string path = problem.resolve(uplift.history_file);
  const Place place = problem.place("sliding.uplift.history");
  FileHistory history = read_uplift(path, place, choice_of(uplift, uplift));
  source->load.history = history.function;
  add_file(path, place, history, problem.scene.time.end, *source);
  source->action = action_of(source->title, "load_cut", "record_start", history.function);
  return source;
}

}  // namespace upbead
