#include "case/records/gauge_load.h"

#include <algorithm>
#include <set>

#include "case/case_checks.h"
#include "case/case_schema.h"
#include "case/records/record_table.h"
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
void read_columns(const GaugeKeys& source, const CsvTable& table, const RecordTimes& times, const Place& place,
                  GaugeRecord& record) {
  Gauges& gauges = record.gauges;
  Diagnostics mistakes;
  NumberedWarnings zero;  // the first one stands for all
  const auto column = [&](const std::string& name, const std::string& si, const std::string& unit) {
    std::vector<double> values;
    try {
      const std::size_t c = column_of(table, name, place);
      values = in_si(table, c, si, unit);
      record.notes.read.push_back(summary_of(table, c, si, unit, times.time, values));
      if (zero.empty()) zero = zero_warnings(name, times, values);
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
  append(record.notes.warnings, zero);
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

GaugeRecord read_gauges(const GaugeKeys& keys, const std::string& file, const std::string& path,
                        const Document& document) {
  const Place place = document.place(path + ".gauges");
  const CsvTable table = read_record_table(file, place);
  const RecordLayout layout = layout_of(table);
  const RecordTimes times = record_times(table, layout, keys);
  GaugeRecord record;
  Gauges& gauges = record.gauges;
  gauges.beyond = {keys.to_first, keys.to_last};
  if (keys.ends) gauges.zero_at = *keys.ends;
  gauges.time = times.time;
  note_layout(table, layout, record.notes);
  read_columns(keys, table, times, place, record);
  const auto first = std::lower_bound(gauges.time.begin(), gauges.time.end(), 0.) - gauges.time.begin();
  if (gauges.time.end() - gauges.time.begin() - first < 2)
    throw InputError(document.place(path + ".record_start"), "the record is over before the run begins",
                     "give an earlier record_start");
  cut(first, gauges);
  return record;
}

void check_gauges(const GaugeKeys& keys, const GaugeWords& words, const std::string& path, const Document& document,
                  Diagnostics& report) {
  const TableDiagnostics wrong(path, document, report);
  if (keys.gauges.empty())
    wrong.add("gauges", "there is no record of the pressures", "add gauges = the path of their record");
  if (keys.place.empty())
    wrong.add(words.places, std::string("it is not said where the transducers are"),
              std::string("add ") + words.places + " = { COLUMN = ..., ... } (m)");
  for (const char* key : {words.to_first, words.to_last})
    if (!wrong.given(key))
      wrong.add(key, std::string("it is not said how the pressure goes on beyond the transducers: no '") + key + "'",
                std::string("add ") + key + " = \"constant\", \"none\" or \"to_zero\"");
  std::set<double> seen;
  for (const auto& [name, at] : keys.place)
    if (!seen.insert(at).second)
      wrong.add(words.places, "two transducers are at " + number_text(at) + " m", "give each a place of its own");
  if ((keys.to_first == Beyond::to_zero || keys.to_last == Beyond::to_zero) && !keys.ends)
    wrong.add("ends", "'to_zero' needs the places where the pressure is zero", "add ends = [..., ...] (m)");
  if (!keys.ends || seen.empty()) return;
  if (!((*keys.ends)[0] < *seen.begin() && *seen.rbegin() < (*keys.ends)[1]))
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

std::map<std::string, Load> gauge_loads(const std::string& name, const Load& load, const Gauges& gauges, double end) {
  std::map<std::string, Load> loads;
  const std::ptrdiff_t n = needed(gauges.time, end);
  const std::vector<double> time(gauges.time.begin(), gauges.time.begin() + n);
  for (std::size_t i = 0; i < gauges.count(); ++i) {
    if (n < 2 || !sees_any(gauges.pressure[i])) continue;
    Load& one = loads[name + "." + gauges.name[i]] = load;
    one.kind = LoadKind::pressure;
    one.shape = share(gauges, i);
    one.over_x = gauges.over_x;
    one.transducer = gauges.name[i];
    if (load.factor == 0.) continue;
    const std::vector<double> pressure(gauges.pressure[i].begin(), gauges.pressure[i].begin() + n);
    one.history = scaled(piecewise_linear(time, pressure), load.factor);
    one.duration = sampled_duration(time, pressure, end);
  }
  return loads;
}

TimeFunction uplift_of(const LoadSource& by_gauges) {
  const auto [from, to] = by_gauges.gauges->zero_at;
  std::vector<double> uplift = resultant(*by_gauges.gauges, from, to).force;
  for (double& force : uplift) force = std::max(force, 0.);
  if (!sees_any(uplift))
    throw InputError({by_gauges.files.front().path}, "the transducers see no uplift",
                     "give pressures upward as positive");
  return piecewise_linear(by_gauges.gauges->time, uplift);
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

namespace {

bool is_along_points(const LoadTable& load) {
  return load.kind == LoadKind::pressures;
}

bool is_by_gauges(const LoadTable& load) {
  return is_along_points(load) && load.from.empty();
}

/// Adds what transducers measured, by the keys of the table at `path`.
void add_record(const GaugeKeys& keys, const std::string& path, const Case& problem, LoadSource& source) {
  source.files = {{problem.resolve(keys.gauges), problem.place(path + ".gauges")}};
  GaugeRecord record = read_gauges(keys, source.files.front().path, path, problem.document);
  source.gauges = std::move(record.gauges);
  source.notes = std::move(record.notes);
}

void check_row(const LoadCheck& check) {
  check.refuse({"pulse", "history", "shape"}, "pressures by transducers", "write kind = \"pressure\"");
  check_gauges(check.load, wall_words, check.path, check.document, check.report);
}

std::shared_ptr<LoadSource> read_row(const GivenLoad& given) {
  const auto source = begun(given);
  add_record(given.table, given.path, given.problem, *source);
  source->gauges->over_x = given.table.over_x;
  source->made = gauge_loads(given.name, source->load, *source->gauges, given.end());
  if (source->acts())
    source->action = action_of(source->title, "record_start", source->gauges->time, source->gauges->pressure);
  return source;
}

}  // namespace

LoadWay by_gauges() {
  return {is_by_gauges,
          [](TableSchema<LoadTable>& table) {
            add_gauge_keys<LoadTable>(table, wall_words, is_by_gauges, "where kind = \"pressures\"", is_along_points);
          },
          check_row,
          read_row,
          {&LoadTable::gauges}};
}

std::shared_ptr<LoadSource> read_uplift_gauges(const GaugeKeys& keys, const Case& problem) {
  const auto source = std::make_shared<LoadSource>();
  source->name = source->title = "sliding.uplift";
  add_record(keys, source->name, problem, *source);
  source->action = action_of(source->title, "record_start", source->gauges->time, source->gauges->pressure);
  return source;
}

}  // namespace upbead
