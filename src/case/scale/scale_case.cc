#include <cmath>
#include <filesystem>

#include "../records/measured.h"
#include "../records/record_layout.h"
#include "../records/record_table.h"
#include "base/quoted.h"
#include "base/units.h"
#include "factors.h"
#include "scale_mesh.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

void check_factor(double factor) {
  if (factor > 0. && std::isfinite(factor)) return;
  throw InputError({"--factor " + number_text(factor)}, "the factor is not a positive number",
                   "give the new length over the old one, such as 20, or 0.05 for a model");
}

/// A table at the new size; `units`: SI, of the quantity of each column.
std::string scaled_table(const CsvTable& table, const std::vector<std::string>& units, double factor) {
  std::string text;
  for (std::size_t c = 0; c < table.names.size(); ++c)
    text += (c == 0 ? "" : ",") + table.names[c] + (table.units[c].empty() ? "" : " (" + table.units[c] + ")");
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    text += "\n";
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      text += (c == 0 ? "" : ",") + number_text(table.columns[c][row] * std::pow(factor, froude_exponent(units[c])));
  }
  return text + "\n";
}

/// SI units of a record's columns: those of times, of counters, and of all others.
std::vector<std::string> units_by_column(const CsvTable& table, const std::string& unit) {
  const RecordLayout layout = layout_of(table);
  std::vector<std::string> units(table.names.size(), unit);
  if (layout.time) units[*layout.time] = "s";
  for (const std::size_t c : layout.clocks) units[c] = "s";
  for (const std::size_t c : layout.counters) units[c] = "";
  return units;
}

/// A history with its times and values at the new size.
std::string scaled_history(const std::string& path, const Place& place, double factor, const std::string& unit) {
  const CsvTable table = read_record_table(path, place);
  return scaled_table(table, units_by_column(table, unit), factor);
}

/// The record of transducers at the new size.
std::string scaled_record(const Case& problem, const GaugeSource& source, const std::string& path, double factor) {
  const CsvTable table = read_record_table(problem.resolve(source.gauges), problem.place(path + ".gauges"));
  std::vector<std::string> units = units_by_column(table, "Pa");
  for (std::size_t c = 0; c < units.size(); ++c) {
    if (table.names[c] == source.load_cell) units[c] = "N/m";
    if (source.place.count(table.names[c]) != 0) units[c] = "Pa";
  }
  return scaled_table(table, units, factor);
}

/// A measured history at the new size, alone with its time; of what quantity it is, its unit tells.
std::string scaled_measured(const Case& problem, const std::string& name, const MeasuredSource& source, double factor) {
  const Place place = problem.place(dotted("measured", name) + ".file");
  const CsvTable table = read_record_table(problem.resolve(source.file), place);
  const RecordLayout layout = layout_of(table);
  const std::size_t column = measured_column(source, table, layout, place);
  const std::optional<Unit> unit = unit_of(source.unit.empty() ? table.units[column] : source.unit);
  if (!unit)
    throw InputError(place,
                     "it is not said what unit column " + in_quotes(table.names[column]) + " has: it cannot be scaled",
                     "write the unit into its header, or add unit = \"...\"");
  CsvTable one{table.path, {}, {}, {}, table.lines};
  std::vector<std::string> units;
  const auto keep = [&](std::size_t c, const std::string& si) {
    one.names.push_back(table.names[c]);
    one.units.push_back(table.units[c]);
    one.columns.push_back(table.columns[c]);
    units.push_back(si);
  };
  if (!source.sampling_rate && layout.time) keep(*layout.time, "s");
  keep(column, unit->si);
  return scaled_table(one, units, factor);
}

/// Writes the histories of loads, uplift and what was measured anew, beside the case, under names of their own.
void scale_histories(const Case& problem, double factor, CaseTables& tables, std::vector<NamedText>& histories) {
  for (auto& [name, load] : tables.load_tables) {
    const std::string path = dotted("loads", name);
    if (!load.history_file.empty())
      load.history_file = histories
                              .emplace_back(NamedText{name + ".csv", scaled_history(problem.resolve(load.history_file),
                                                                                    problem.place(path + ".history"),
                                                                                    factor, history_unit(load))})
                              .path;
    if (!load.gauges.empty())
      load.gauges = histories.emplace_back(NamedText{name + ".csv", scaled_record(problem, load, path, factor)}).path;
  }
  for (auto& [name, source] : tables.measured)
    source.file =
        histories.emplace_back(NamedText{"measured-" + name + ".csv", scaled_measured(problem, name, source, factor)})
            .path;
  if (!tables.sliding_table || !tables.sliding_table->uplift_table) return;
  UpliftTable& uplift = *tables.sliding_table->uplift_table;
  const std::string name = tables.load_tables.count("uplift") == 0 ? "uplift.csv" : "sliding-uplift.csv";
  if (!uplift.gauges.empty())
    uplift.gauges =
        histories.emplace_back(NamedText{name, scaled_record(problem, uplift, "sliding.uplift", factor)}).path;
  if (uplift.history_file.empty()) return;
  histories.push_back({name, scaled_history(problem.resolve(uplift.history_file),
                                            problem.place("sliding.uplift.history"), factor, "N/m")});
  uplift.history_file = name;
}

std::string heading(const Case& problem, const ScaleOptions& options) {
  std::string text = "# Made by `upbead scale " + fs::path(problem.document.path()).filename().string() + " --factor " +
                     number_text(options.factor);
  if (options.soil == SoilScaling::same) text += " --soil same";
  for (const std::string& ratio : options.ratios) text += " --ratio " + ratio;
  return text + "`: lengths times " + number_text(options.factor) + ", the rest by Froude's law.\n\n";
}

}  // namespace

ScaledCase scale_case(const Case& problem, const ScaleOptions& options, const std::string& folder) {
  check_factor(options.factor);
  Ratios ratios(options.ratios);
  CaseTables tables;
  InputReport report;  // read_case has found no mistake
  case_schema().read(problem.document.root(), "", tables, report);
  ScaledCase scaled;
  scale_numbers(tables, options, ratios, scaled.kept);
  scale_mesh(problem, options, ratios, tables.mesh);
  ratios.require_all_used();
  if (tables.mesh.file)
    tables.mesh.file = fs::relative(fs::absolute(problem.resolve(*tables.mesh.file)), fs::absolute(folder)).string();
  scale_histories(problem, options.factor, tables, scaled.histories);
  if (!tables.title.empty()) tables.title += ", times " + number_text(options.factor) + " by Froude's law";
  scaled.text = heading(problem, options) + case_schema().echo(tables);
  return scaled;
}

}  // namespace upbead
