#include "case/records/load_records.h"

#include <algorithm>
#include <set>

#include "base/text.h"
#include "case/case_checks.h"
#include "case/records/record_table.h"
#include "model/motion.h"
#include "upbead/base/error.h"

namespace upbead {

const std::vector<std::pair<std::string, Beyond>> beyond_words{
    {"constant", Beyond::constant}, {"none", Beyond::none}, {"to_zero", Beyond::to_zero}};

const GaugeWords wall_words{"heights",
                            "heights y of the transducers; by the names of their columns",
                            "to_base",
                            "to_crest",
                            "heights y of the wall's base and crest; where the pressure falls to zero",
                            "lowest",
                            "highest"};
const GaugeWords bottom_words{
    "positions",    "positions x of the transducers; by the names of their columns", "to_seaward",
    "to_landward",  "positions x of the bottom's seaward and landward end",          "most seaward",
    "most landward"};

namespace {

/// Reads the columns in the order of their places; reports the mistakes of all columns together.
void read_columns(const GaugeSource& source, const CsvTable& table, const RecordTimes& times, const Place& place,
                  Gauges& gauges, RecordNotes& notes) {
  Diagnostics mistakes;
  const auto column = [&](const std::string& name, const std::string& si, const std::string& unit) {
    std::vector<double> values;
    try {
      const std::size_t c = column_of(table, name, place);
      values = in_si(table, c, si, unit);
      notes.read.push_back(summary_of(table, c, si, unit, times.time, values));
      take_off_rest(times, values);
    } catch (const InputError& error) {
      mistakes.add(error.diagnostics());
    }
    return values;
  };
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, at] : source.place) order.emplace_back(at, name);
  std::sort(order.begin(), order.end());
  for (const auto& [at, name] : order) {
    gauges.name.push_back(name);
    gauges.place.push_back(at);
    gauges.pressure.push_back(column(name, "Pa", source.gauge_unit));
  }
  if (!source.load_cell.empty()) gauges.load_cell = column(source.load_cell, "N/m", "");
  mistakes.throw_if_any();
}

/// Leaves out what comes before t = 0.
void cut(std::ptrdiff_t first, Gauges& gauges) {
  const auto cut_one = [first](std::vector<double>& values) {
    if (!values.empty()) values.erase(values.begin(), values.begin() + first);
  };
  for (std::vector<double>& pressure : gauges.pressure) cut_one(pressure);
  cut_one(gauges.load_cell);
  cut_one(gauges.time);
}

}  // namespace

Gauges read_gauges(const GaugeSource& source, const std::string& file, const std::string& path,
                   const Document& document, RecordNotes& notes) {
  const Place place = document.place(path + ".gauges");
  const CsvTable table = read_record_table(file, place);
  const RecordLayout layout = layout_of(table);
  const RecordTimes times = record_times(table, layout, source);
  Gauges gauges;
  gauges.beyond = {source.to_first, source.to_last};
  if (source.ends) gauges.zero_at = *source.ends;
  gauges.time = times.time;
  note_layout(table, layout, notes);
  read_columns(source, table, times, place, gauges, notes);
  const auto first = std::lower_bound(gauges.time.begin(), gauges.time.end(), 0.) - gauges.time.begin();
  if (gauges.time.end() - gauges.time.begin() - first < 2)
    throw InputError(document.place(path + ".record_start"), "the record is over before the run begins",
                     "give an earlier record_start");
  cut(first, gauges);
  return gauges;
}

void check_gauges(const GaugeSource& source, const GaugeWords& words, const std::string& path, const Document& document,
                  Diagnostics& report) {
  const TableDiagnostics wrong(path, document, report);
  const auto given = [&](const std::string& key) { return document.find(path + "." + key) != nullptr; };
  if (source.gauges.empty())
    wrong.add("gauges", "there is no record of the pressures", "add gauges = the path of their record");
  if (source.place.empty())
    wrong.add(words.places, std::string("it is not said where the transducers are"),
              std::string("add ") + words.places + " = { COLUMN = ..., ... } (m)");
  for (const char* key : {words.to_first, words.to_last})
    if (!given(key))
      wrong.add(key, std::string("it is not said how the pressure goes on beyond the transducers: no '") + key + "'",
                std::string("add ") + key + " = \"constant\", \"none\" or \"to_zero\"");
  std::set<double> seen;
  for (const auto& [name, at] : source.place)
    if (!seen.insert(at).second)
      wrong.add(words.places, "two transducers are at " + number_text(at) + " m", "give each a place of its own");
  if ((source.to_first == Beyond::to_zero || source.to_last == Beyond::to_zero) && !source.ends)
    wrong.add("ends", "'to_zero' needs the places where the pressure is zero", "add ends = [..., ...] (m)");
  if (!source.ends || seen.empty()) return;
  if (!((*source.ends)[0] < *seen.begin() && *seen.rbegin() < (*source.ends)[1]))
    wrong.add("ends", "a transducer is not between the ends", "give the ends of the whole row, the lower one first");
}

namespace {

bool sees_any(const std::vector<double>& pressure) {
  return std::any_of(pressure.begin(), pressure.end(), [](double p) { return p != 0.; });
}

/// How many samples a run until `end` needs: those until then and one later.
std::ptrdiff_t needed(const std::vector<double>& time, double end) {
  const auto beyond = std::upper_bound(time.begin(), time.end(), end);
  return beyond - time.begin() + (beyond == time.end() ? 0 : 1);
}

}  // namespace

void add_gauge_loads(const std::string& name, const GaugeLoad& by_gauges, double end, Scene& scene) {
  const Gauges& gauges = by_gauges.gauges;
  const std::ptrdiff_t n = needed(gauges.time, end);
  const std::vector<double> time(gauges.time.begin(), gauges.time.begin() + n);
  for (std::size_t i = 0; i < gauges.count(); ++i) {
    if (n < 2 || !sees_any(gauges.pressure[i])) continue;
    Load load = by_gauges.load;
    load.kind = LoadKind::pressure;
    load.shape = share(gauges, i);
    load.over_x = gauges.over_x;
    load.transducer = gauges.name[i];
    if (load.factor != 0.) {
      const std::vector<double> pressure(gauges.pressure[i].begin(), gauges.pressure[i].begin() + n);
      load.history = scaled(piecewise_linear(time, pressure), load.factor);
      load.duration = sampled_duration(time, pressure, end);
    }
    scene.loads[name + "." + load.transducer] = load;
  }
}

TimeFunction uplift_of(const GaugeLoad& by_gauges) {
  const auto [from, to] = *by_gauges.source.ends;
  std::vector<double> uplift = resultant(by_gauges.gauges, from, to).force;
  for (double& force : uplift) force = std::max(force, 0.);
  if (!sees_any(uplift))
    throw InputError({by_gauges.source.gauges}, "the transducers see no uplift", "give pressures upward as positive");
  return piecewise_linear(by_gauges.gauges.time, uplift);
}

std::vector<UpliftPart> uplift_parts_of(const Gauges& gauges) {
  std::vector<UpliftPart> parts;
  for (std::size_t i = 0; i < gauges.count(); ++i) {
    std::vector<double> pressure = gauges.pressure[i];
    for (double& p : pressure) p = std::max(p, 0.);
    if (sees_any(pressure)) parts.push_back({share(gauges, i), piecewise_linear(gauges.time, pressure)});
  }
  return parts;
}

TableSchema<MeasuredSource> measured_schema() {
  TableSchema<MeasuredSource> table;
  table.key("file", &MeasuredSource::file).required().doc("path of the record; CSV (docs/records.md) or HDF5");
  table.key("reading", &MeasuredSource::reading)
      .required()
      .doc(
          "history of the results that it is compared with; \"shear_force\", \"caisson/displacement_x\", "
          "\"probes/A/pressure\"");
  table.key("column", &MeasuredSource::column).fallback("the one after the time").doc("name of its column");
  table.key("unit", &MeasuredSource::unit).fallback("that of the header, else SI").doc("unit of the values");
  const auto everywhere = [](const auto& entry) { return entry; };
  add_clock_keys(table, everywhere, everywhere);
  return table;
}

namespace {

/// A history in SI units.
struct Columns {
  CsvTable table;  ///< kept for the places of mistakes
  std::vector<double> time, value;
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

/// A history has one value: the first column of values. Another one of that name would be as good.
std::size_t only_value(const CsvTable& table, const RecordLayout& layout, RecordNotes& notes) {
  const std::size_t value = layout.values.front();
  if (layout.values.size() == 1) return value;
  for (std::size_t i = 1; i < layout.values.size(); ++i)
    if (table.names[layout.values[i]] == table.names[value])
      throw InputError({table.path, 1, 1}, "two columns are called " + in_quotes(table.names[value]),
                       "keep the one that is meant, or give each a name of its own");
  std::string what = column_text(table, layout.values[1]);
  if (layout.values.size() > 2) what += " and " + std::to_string(layout.values.size() - 2) + " more";
  notes.left_out.push_back({what, "a history has one value, here " + in_quotes(table.names[value])});
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

/// Reads and checks what all histories have in common; `si`: unit of the value; `start`: its time at t = 0 (s).
Columns read_columns(const std::string& path, const Place& place, const std::string& si, double start,
                     RecordNotes& notes) {
  Columns columns{read_record_table(path, place), {}, {}};
  Diagnostics mistakes;
  if (columns.table.columns.size() < 2)
    mistakes.add({path, 1, 1}, "a history of one column", "give two columns, time (s) and value");
  if (columns.table.n_rows() < 2) mistakes.add({path}, "a history of one row", "give two rows or more");
  mistakes.throw_if_any();
  const RecordLayout layout = layout_of(columns.table);
  columns.time = times_of(columns.table, layout);
  if (layout.values.empty())
    throw InputError({path, 1, 1}, "beside the time no column holds values, but counters or other times",
                     "give two columns, time (s) and value");
  note_layout(columns.table, layout, notes);
  const std::size_t value = only_value(columns.table, layout, notes);
  columns.value = in_si(columns.table, value, si);
  check_times(columns.table, columns.time, start, mistakes);
  mistakes.throw_if_any();
  begin_at(start, place, columns.time, columns.value);
  notes.read.push_back(summary_of(columns.table, value, si, "", columns.time, columns.value));
  return columns;
}

}  // namespace

namespace {

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

void read_history(const std::string& path, const Place& place, double end, Load& load, double start,
                  RecordNotes& notes) {
  auto [table, time, value] = read_columns(path, place, unit_of(load.kind), start, notes);
  if (std::all_of(value.begin(), value.end(), [](double v) { return v == 0.; }))
    throw InputError({path}, "every value of the history is zero", "give a history with a load");
  if (is_motion(load.kind)) require_motion(load.kind, path, time, value);
  if (load.kind == LoadKind::displacement) {
    constexpr std::size_t fewest = 4;  // of a cubic
    if (time.size() < fewest)
      throw InputError({path}, "a displacement of " + std::to_string(time.size()) + " rows has no smooth velocity",
                       "give four rows or more");
    load.history = rate_of_samples(time, value);
    std::vector<double> moved = value;
    for (double& v : moved) v -= value.front();
    load.duration = sampled_duration(time, moved, time.back());
    return;
  }
  load.history = load.kind == LoadKind::acceleration ? integral_of_samples(time, value) : piecewise_linear(time, value);
  load.duration = sampled_duration(time, value, end);
}

Record written_history(const std::string& name, const std::string& path, const Place& place, LoadKind kind,
                       double start) {
  RecordNotes told_elsewhere;
  Columns columns = read_columns(path, place, unit_of(kind), start, told_elsewhere);
  return {name, std::move(columns.time), std::move(columns.value)};
}

TimeFunction read_uplift(const std::string& path, const Place& place, double start, RecordNotes& notes) {
  const auto [table, time, value] = read_columns(path, place, "N/m", start, notes);
  const auto negative = std::find_if(value.begin(), value.end(), [](double v) { return v < 0.; });
  if (negative != value.end())
    throw InputError(start == 0. ? table.place(static_cast<std::size_t>(negative - value.begin())) : Place{path},
                     "the uplift is " + number_text(*negative) + " N/m, below zero",
                     "give U upward, what it takes off the weight");
  return piecewise_linear(time, value);
}

}  // namespace upbead
