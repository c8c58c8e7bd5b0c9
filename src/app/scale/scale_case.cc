#include <cmath>
#include <filesystem>

#include "factors.h"
#include "scale_mesh.h"
#include "upbead/base/csv.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

void check_factor(double factor) {
  if (factor > 0. && std::isfinite(factor)) return;
  throw InputError({"--factor " + number_text(factor)}, "the factor is not a positive number",
                   "give the new length over the old one, such as 20, or 0.05 for a model");
}

/// A history with its times and values at the new size.
std::string scaled_history(const std::string& path, const Place& place, double factor, const std::string& unit) {
  const CsvTable table = read_csv(path, place);
  std::string text;
  for (std::size_t c = 0; c < table.names.size(); ++c) text += (c == 0 ? "" : ",") + table.names[c];
  const double time = std::pow(factor, froude_exponent("s")), value = std::pow(factor, froude_exponent(unit));
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    text += "\n";
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      text += (c == 0 ? "" : ",") + number_text(table.columns[c][row] * (c == 0 ? time : value));
  }
  return text + "\n";
}

/// Writes the histories of loads and uplift anew, beside the case, under names of their own.
void scale_histories(const Case& problem, double factor, CaseTables& tables, std::vector<NamedText>& histories) {
  for (auto& [name, load] : tables.load_tables) {
    if (load.history_file.empty()) continue;
    const Place place = problem.place(dotted("loads", name) + ".history");
    histories.push_back(
        {name + ".csv", scaled_history(problem.resolve(load.history_file), place, factor, history_unit(load))});
    load.history_file = histories.back().path;
  }
  if (!tables.sliding_table || !tables.sliding_table->uplift_table) return;
  std::string& file = tables.sliding_table->uplift_table->history_file;
  if (file.empty()) return;
  const std::string name = tables.load_tables.count("uplift") == 0 ? "uplift.csv" : "sliding-uplift.csv";
  histories.push_back(
      {name, scaled_history(problem.resolve(file), problem.place("sliding.uplift.history"), factor, "N/m")});
  file = name;
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
