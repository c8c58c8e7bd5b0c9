#include "case/records/measured.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/text.h"
#include "case/case_schema.h"
#include "case/records/record_layout.h"
#include "case/records/record_table.h"
#include "model/record.h"
#include "response/comparison.h"

namespace upbead {

TableSchema<MeasuredKeys> measured_schema() {
  TableSchema<MeasuredKeys> table;
  table.key("file", &MeasuredKeys::file, "", "path of the record; CSV (docs/records.md) or HDF5").required();
  table
      .key("reading", &MeasuredKeys::reading, "",
           "history of the results that it is compared with; \"shear_force\", \"caisson/displacement_x\", "
           "\"probes/A/pressure\"")
      .required();
  table.key("column", &MeasuredKeys::column, "", "name of its column").fallback("the one after the time");
  table.key("unit", &MeasuredKeys::unit, "", "unit of the values").fallback("that of the header, else SI");
  const auto everywhere = [](const auto& entry) { return entry; };
  add_clock_keys(table, everywhere, everywhere);
  return table;
}

namespace {

const Dataset* find(const std::vector<Dataset>& histories, const std::string& name) {
  const auto found =
      std::find_if(histories.begin(), histories.end(), [&](const Dataset& history) { return history.name == name; });
  return found == histories.end() ? nullptr : &*found;
}

MeasuredRecord read(const Case& input, const std::string& name, const MeasuredKeys& source, const Dataset& computed) {
  const std::string path = dotted("measured", name);
  const Place place = input.place(path + ".file");
  const CsvTable table = read_record_table(input.resolve(source.file), place);
  const RecordLayout layout = layout_of(table);
  const RecordTimes times = record_times(table, layout, source);
  const std::size_t column = measured_column(source, table, layout, place);
  MeasuredRecord record{
      name, source.reading, computed.unit, times.time, in_si(table, column, computed.unit, source.unit), {}};
  record.notes.read.push_back(summary_of(table, column, computed.unit, source.unit, times.time, record.value));
  record.notes.read.back().of = path;
  note_layout(table, layout, record.notes);
  append(record.notes.warnings, zero_warnings(path, times, record.value));
  append(record.notes.warnings, lost_samples({path, record.time, record.value}));
  for (NumberedWarning& warning : record.notes.warnings) warning.voids = false;  // no check is made of it
  take_off_rest(times, record.value);
  return record;
}

}  // namespace

std::size_t measured_column(const MeasuredKeys& source, const CsvTable& table, const RecordLayout& layout,
                            const Place& place) {
  if (!source.column.empty()) return column_of(table, source.column, place);
  const bool untimed =
      source.sampling_rate && layout.time == 0 && header_says(table.names[0], table.units[0]) == HeaderSays::nothing;
  if (untimed) return 0;
  if (layout.values.empty())
    throw InputError(place, quoted_path(source.file) + " has no column beside the time",
                     "give a record of two columns");
  for (std::size_t i = 1; i < layout.values.size(); ++i)
    if (table.names[layout.values[i]] == table.names[layout.values.front()])
      return column_of(table, table.names[layout.values.front()], place);  // throws: the name is not one column's
  return layout.values.front();
}

std::vector<MeasuredRecord> read_measured(const Case& input, const std::vector<Dataset>& computed) {
  std::vector<MeasuredRecord> records;
  Diagnostics mistakes;
  for (const auto& [name, source] : input.tables->measured) {
    const Dataset* history = find(computed, source.reading);
    if (history == nullptr || source.reading == "time") {
      std::vector<std::string> known;
      for (const Dataset& one : computed)
        if (one.name != "time") known.push_back(one.name);
      mistakes.add(input.place(dotted("measured", name) + ".reading"),
                   "the run has no history " + in_quotes(source.reading),
                   suggestion(source.reading, known, "histories"));
      continue;
    }
    try {
      records.push_back(read(input, name, source, *history));
    } catch (const InputError& error) {
      mistakes.add(error.diagnostics());
    }
  }
  mistakes.throw_if_any();
  return records;
}

namespace {

/// The samples that have a number: the pressure of an edge has none where the resultant leaves the base.
History known(const std::vector<double>& time, const std::vector<double>& value) {
  History history;
  for (std::size_t i = 0; i < time.size(); ++i)
    if (!std::isnan(value[i])) {
      history.time.push_back(time[i]);
      history.value.push_back(value[i]);
    }
  return history;
}

}  // namespace

std::vector<MeasuredSummary> compare_measured(const Case& input, const std::vector<MeasuredRecord>& records,
                                              const std::vector<Dataset>& computed) {
  std::vector<MeasuredSummary> list;
  for (const MeasuredRecord& record : records) try {
      list.push_back({record.name, record.reading, record.unit,
                      compare({record.time, record.value},
                              known(find(computed, "time")->values, find(computed, record.reading)->values))});
    } catch (const std::invalid_argument& error) {
      throw InputError(input.place(dotted("measured", record.name)), error.what(),
                       "look at record_start, or leave the record out");
    }
  return list;
}

std::vector<Dataset> measured_tables(const std::vector<MeasuredRecord>& records) {
  std::vector<Dataset> tables;
  for (const MeasuredRecord& record : records) {
    const std::string path = "measured/" + record.name + "/";
    tables.push_back({path + "time", "s", "time of the run", record.time, 1, record.reading});
    tables.push_back({path + "value", record.unit, "measured, of " + record.reading, record.value, 1, record.reading});
  }
  return tables;
}

std::string text_of(const std::vector<MeasuredSummary>& measured) {
  std::string text;
  for (const MeasuredSummary& m : measured) {
    const Comparison& c = m.comparison;
    text += "measured    " + m.name + ": " + m.reading + " has its peak at " + significant(c.peak_ratio, 4) +
            " of the measured one, comes " + significant(1e3 * std::abs(c.phase), 3) + " ms " +
            (c.phase < 0. ? "earlier" : "later") + ", and differs by " + significant(100. * c.rms_relative, 3) +
            " % of its root mean square\n";
  }
  return text;
}

}  // namespace upbead
