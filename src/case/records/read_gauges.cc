#include <algorithm>

#include "gauge_keys.h"
#include "record_columns.h"

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

/// Columns in the order of their places; mistakes of any of them together.
void read_columns(const GaugeSource& source, const CsvTable& table, const RecordTimes& times, const Place& place,
                  Gauges& gauges) {
  Mistakes mistakes;
  const auto column = [&](const std::string& name, const std::string& si, const std::string& unit) {
    std::vector<double> values;
    try {
      values = in_si(table, column_of(table, name, place), si, unit);
      take_off_rest(times, values);
    } catch (const InputError& error) {
      mistakes.add(error);
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
                   const Document& document) {
  const Place place = document.place(path + ".gauges");
  const CsvTable table = read_record_table(file, place);
  const RecordLayout layout = layout_of(table);
  const RecordTimes times = record_times(table, layout, source);
  Gauges gauges;
  gauges.beyond = {source.to_first, source.to_last};
  if (source.ends) gauges.zero_at = *source.ends;
  gauges.time = times.time;
  read_columns(source, table, times, place, gauges);
  const auto first = std::lower_bound(gauges.time.begin(), gauges.time.end(), 0.) - gauges.time.begin();
  if (gauges.time.end() - gauges.time.begin() - first < 2)
    throw InputError(document.place(path + ".record_start"), "the record is over before the run begins",
                     "give an earlier record_start");
  cut(first, gauges);
  return gauges;
}

}  // namespace upbead
