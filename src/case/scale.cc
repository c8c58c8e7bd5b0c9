#include "case/scale.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "base/text.h"
#include "base/units.h"
#include "case/case_schema.h"
#include "case/cfd/flow_text.h"
#include "case/records/measured.h"
#include "case/records/record_layout.h"
#include "case/records/record_table.h"
#include "mesh/geo_script.h"
#include "upbead/mesh/request.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// Exponents of the length's factor L, where accelerations and densities stay: s = L^(1/2), kg = L^3, N = kg m/s2, Pa
/// = N/m2.
const std::map<std::string, double> exponents{{"m", 1.},    {"s", 0.5},  {"kg", 3.},      {"N", 3.},   {"Pa", 1.},
                                              {"Hz", -0.5}, {"rad", 0.}, {"degrees", 0.}, {"deg", 0.}, {"1", 0.}};

/// "m2" has twice the exponent of "m".
double exponent_of(const std::string& symbol, const std::string& unit) {
  std::size_t letters = symbol.size();
  while (letters > 1 && std::isdigit(static_cast<unsigned char>(symbol[letters - 1])) != 0) --letters;
  const auto found = exponents.find(symbol.substr(0, letters));
  if (found == exponents.end()) throw std::invalid_argument("no scale is known for the unit '" + unit + "'");
  return found->second * (letters < symbol.size() ? std::stoi(symbol.substr(letters)) : 1);
}

}  // namespace

double froude_exponent(const std::string& unit) {
  if (unit.empty() || unit == "-") return 0.;
  double sum = 0., sign = 1.;
  std::string spaced;
  for (const char c : unit) spaced += c == '/' ? std::string(" / ") : std::string(1, c);
  std::istringstream symbols(spaced);
  for (std::string symbol; symbols >> symbol;) {
    if (symbol == "/")
      sign = -1.;
    else
      sum += sign * exponent_of(symbol, unit);
  }
  return sum;
}

namespace {

/// Ratios that a person gives by key.
class Ratios {
 public:
  /// Throws InputError for a text that is not KEY=VALUE with a finite VALUE.
  explicit Ratios(const std::vector<std::string>& texts);
  /// The ratio of the key at a dotted path; nullptr where none is given.
  const double* find(const std::string& path);
  /// The ratio of a path as a person wrote it, as a place for messages.
  Place place(const std::string& path) const;
  /// Throws InputError where a ratio names none of the keys that were looked up by find().
  void require_all_used() const;

 private:
  std::map<std::string, double> ratio_;
  std::map<std::string, std::string> text_;
  std::set<std::string> asked_, used_;
};

Ratios::Ratios(const std::vector<std::string>& texts) {
  Diagnostics mistakes;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string key = text.substr(0, equals), value = equals == std::string::npos ? "" : text.substr(equals + 1);
    char* end = nullptr;
    const double ratio = std::strtod(value.c_str(), &end);
    if (key.empty() || value.empty() || *end != '\0' || !std::isfinite(ratio))
      mistakes.add({"--ratio " + text}, "it is not a key and a number",
                   "write --ratio KEY=VALUE, such as --ratio regions.seabed.shear_modulus=4.47");
    else if (!text_.emplace(key, text).second)
      mistakes.add({"--ratio " + text}, "the key has a ratio already", "keep one of them");
    else
      ratio_[key] = ratio;
  }
  mistakes.throw_if_any();
}

const double* Ratios::find(const std::string& path) {
  asked_.insert(path);
  const auto found = ratio_.find(path);
  if (found == ratio_.end()) return nullptr;
  used_.insert(path);
  return &found->second;
}

Place Ratios::place(const std::string& path) const {
  return {"--ratio " + text_.at(path)};
}

void Ratios::require_all_used() const {
  Diagnostics mistakes;
  for (const auto& [path, ratio] : ratio_)
    if (used_.count(path) == 0)
      mistakes.add(place(path), "the case has no number '" + path + "'",
                   suggestion(path, {asked_.begin(), asked_.end()}, "numbers"));
  mistakes.throw_if_any();
}

/// Whether a key is a constant of the soil or its water, which stays where the soil is the same: moduli,
/// conductivity, permeability, viscosity.
bool is_of_the_soil(const std::string& path, const std::string& unit) {
  return (starts_with(path, "regions.") || starts_with(path, "fluid.")) &&
         (unit == "Pa" || unit == "m/s" || unit == "m2" || unit == "Pa s" || unit == "s2/m2");
}

/// The exponent of the factor for what stands for soil that stays the same, G and rho: springs under a caisson are G,
/// that of rotation times a length squared; dashpots are rho V_s times a length, and its square again.
std::optional<double> exponent_on_same_soil(const std::string& path, const std::string& unit) {
  const bool spring = path.find(".springs.") != std::string::npos,
             dashpot = path.find(".dashpots.") != std::string::npos;
  if (!starts_with(path, "regions.") || (!spring && !dashpot)) return std::nullopt;
  const bool turns = unit == "N" || unit == "N s";
  return (dashpot ? 1. : 0.) + (turns ? 2. : 0.);
}

/// Whether any region uses this number of the water.
bool counts(const std::string& path, const CaseTables& tables) {
  const auto any = [&](const auto& asks) {
    return std::any_of(tables.regions.begin(), tables.regions.end(), [&](const auto& r) { return asks(r.second); });
  };
  if (path == "fluid.viscosity") return any([](const Region& region) { return region.permeability.has_value(); });
  if (path == "fluid.atmospheric_pressure") return any([](const Region& region) { return region.saturation < 1.; });
  return true;
}

/// The unit of a number; the unit of a pulse's peak depends on the kind of its load.
std::string dimension_of(const KeyInfo& key, const std::string& path, const CaseTables& tables) {
  if (key.unit != "N/m or Pa") return key.unit;
  return unit_of(tables.load_tables.at(split_dotted(path).at(1)).kind);
}

/// In a list of pairs the second number has no dimension; a ratio does not apply to it.
bool is_second_of_pair(const KeyInfo& key) {
  return !key.unit_of_first.empty() && key.unit != key.unit_of_first;
}

/// Multiplies every number of the tables by its factor or ratio; keys that keep a number with a dimension are added
/// to `kept`. The mesh's parameters are left alone, as their units stand in the .geo. Throws InputError.
void scale_numbers(CaseTables& tables, const ScaleOptions& options, Ratios& ratios, std::vector<std::string>& kept) {
  Diagnostics mistakes;
  const auto scale = [&](const KeyInfo& key, const std::string& path, double& number) {
    if (starts_with(path, "mesh.parameters.") || is_second_of_pair(key)) return;
    const double before = number;
    const std::string unit = dimension_of(key, path, tables);
    const double exponent = froude_exponent(unit);
    if (const double* ratio = ratios.find(path)) {
      number *= *ratio;
      if (!key.range.contains(number) && std::isfinite(before))
        mistakes.add(ratios.place(path), path + " = " + number_text(number) + " is outside " + key.range.text(),
                     "give another ratio");
    } else if (const auto of_soil = exponent_on_same_soil(path, unit); options.soil == SoilScaling::same && of_soil) {
      number *= std::pow(options.factor, *of_soil);
    } else if (options.soil == SoilScaling::same && is_of_the_soil(path, unit)) {
      if (std::isfinite(number) && counts(path, tables)) kept.push_back(path);
    } else {
      number *= std::pow(options.factor, exponent);
    }
  };
  case_schema().visit_numbers(tables, "", scale);
  mistakes.throw_if_any();
}

/// "m" of "m: height of the mound".
std::string unit_of_parameter(const GeoParameter& parameter) {
  const std::size_t colon = parameter.description.find(':');
  if (colon == std::string::npos) throw std::invalid_argument("its comment names no unit");
  return parameter.description.substr(0, colon);
}

/// The default value in the geometry.
double value_of(const GeoParameter& parameter) {
  char* end = nullptr;
  const double value = std::strtod(parameter.default_value.c_str(), &end);
  if (parameter.default_value.empty() || *end != '\0')
    throw std::invalid_argument("its default '" + parameter.default_value + "' is no number");
  return value;
}

/// Gives every parameter of the case's .geo that has a dimension its new value, including those for which the case
/// keeps the geometry's default. The comment behind a parameter begins with its unit: "// m: height of the mound", or
/// "// -: ..." without one. Throws InputError where the mesh is finished (.msh), where no parameter is a length, and
/// where a unit or a value cannot be read.
void scale_mesh(const Case& problem, const ScaleOptions& options, Ratios& ratios, MeshChoice& mesh) {
  const MeshRequest request = mesh_request(problem);
  if (std::filesystem::path(request.file).extension() == ".msh")
    throw InputError(request.place, "a finished mesh (.msh) cannot be scaled", "name the .geo that made it");
  Diagnostics mistakes;
  bool has_length = false;
  for (const GeoParameter& parameter : geo_parameters(request.file)) try {
      const double exponent = froude_exponent(unit_of_parameter(parameter));
      const double* ratio = ratios.find(dotted("mesh.parameters", parameter.name));
      has_length = has_length || exponent != 0.;
      if (exponent == 0. && ratio == nullptr) continue;
      const auto given = mesh.parameters.find(parameter.name);
      const double value = given == mesh.parameters.end() ? value_of(parameter) : given->second;
      mesh.parameters[parameter.name] = value * (ratio != nullptr ? *ratio : std::pow(options.factor, exponent));
    } catch (const std::invalid_argument& error) {
      mistakes.add(request.place,
                   "the parameter '" + parameter.name + "' of " + request.file + " cannot be scaled: " + error.what(),
                   "begin the comment behind its number with its unit, such as // m: height of the mound, or // -: for "
                   "a number without one");
    }
  if (mistakes.empty() && !has_length)
    mistakes.add(request.place, request.file + " cannot be scaled: no parameter of it is a length",
                 "make its lengths parameters (DefineConstant) with // m: comments");
  mistakes.throw_if_any();
}

void check_factor(double factor) {
  if (factor > 0. && std::isfinite(factor)) return;
  throw InputError({"--factor " + number_text(factor)}, "the factor is not a positive number",
                   "give the new length over the old one, such as 20, or 0.05 for a model");
}

/// A table at the new size, without columns in which a cell is no number; `units`: the SI unit of each column.
std::string scaled_table(const CsvTable& table, const std::vector<std::string>& units, double factor) {
  std::vector<std::size_t> kept;
  for (std::size_t c = 0; c < table.names.size(); ++c)
    if (c >= table.faults.size() || table.faults[c].cells == 0) kept.push_back(c);
  std::vector<std::string> heads;
  for (const std::size_t c : kept) {
    const std::string head = table.names[c] + (table.units[c].empty() ? "" : " (" + table.units[c] + ")");
    heads.push_back(head.find(',') == std::string::npos ? head : "\"" + head + "\"");
  }
  std::string text = join(heads, ",");
  for (std::size_t row = 0; row < table.n_rows(); ++row) {
    text += "\n";
    for (const std::size_t c : kept)
      text +=
          (c == kept[0] ? "" : ",") + number_text(table.columns[c][row] * std::pow(factor, froude_exponent(units[c])));
  }
  return text + "\n";
}

/// SI units of a record's columns: times in s, counters without unit, all others in `unit`.
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

/// A record of transducers at the new size.
std::string scaled_record(const Case& problem, const GaugeKeys& source, const std::string& path, double factor) {
  const CsvTable table = read_record_table(problem.resolve(source.gauges), problem.place(path + ".gauges"));
  std::vector<std::string> units = units_by_column(table, "Pa");
  const Place place = problem.place(path + ".gauges");
  if (!source.load_cell.empty()) units[column_of(table, source.load_cell, place)] = "N/m";
  for (const auto& [name, at] : source.place) units[column_of(table, name, place)] = "Pa";
  return scaled_table(table, units, factor);
}

/// A measured history at the new size, only its column and the time; its unit shows which quantity it is.
std::string scaled_measured(const Case& problem, const std::string& name, const MeasuredKeys& source, double factor) {
  const Place place = problem.place(dotted("measured", name) + ".file");
  const CsvTable table = read_record_table(problem.resolve(source.file), place);
  const RecordLayout layout = layout_of(table);
  const std::size_t column = measured_column(source, table, layout, place);
  const auto end = unit_at_end(table.names[column]);
  const std::string by_name = end && !may_be_a_name(end->unit) ? end->unit : "";
  const std::string& by_header = table.units[column].empty() ? by_name : table.units[column];
  const std::optional<Unit> unit = unit_of(source.unit.empty() ? by_header : source.unit);
  if (!unit)
    throw InputError(place,
                     "it is not said what unit column " + in_quotes(table.names[column]) + " has: it cannot be scaled",
                     "write the unit into its header, or add unit = \"...\"");
  CsvTable one{table.path, {}, {}, {}, table.lines, {}, {}};
  std::vector<std::string> units;
  const auto keep = [&](std::size_t c, const std::string& si) {
    one.names.push_back(table.names[c]);
    one.units.push_back(table.units[c]);
    one.columns.push_back(table.numbers(c));
    units.push_back(si);
  };
  if (!source.sampling_rate && layout.time) keep(*layout.time, "s");
  keep(column, unit->si);
  return scaled_table(one, units, factor);
}

/// Writes scaled histories of loads, uplift and measurements beside the case, under new names.
void scale_histories(const Case& problem, double factor, CaseTables& tables, std::vector<NamedText>& histories) {
  const auto keep = [&histories](const std::string& name, std::string text) {
    return histories.emplace_back(NamedText{name, std::move(text)}).path;
  };
  const auto history = [&](const std::string& file, const std::string& key, const std::string& unit) {
    return scaled_history(problem.resolve(file), problem.place(key + ".history"), factor, unit);
  };
  for (auto& [name, load] : tables.load_tables) {
    if (!load.from.empty())
      throw InputError(problem.place(dotted("loads", name) + ".from"), "a record of CFD is not scaled",
                       "write it as a table by `upbead read` and load that by history or gauges");
    const std::string path = dotted("loads", name), file = name + ".csv";
    if (!load.history_file.empty())
      load.history_file = keep(file, history(load.history_file, path, unit_of(load.kind)));
    if (!load.gauges.empty()) load.gauges = keep(file, scaled_record(problem, load, path, factor));
  }
  for (auto& [name, source] : tables.measured)
    source.file = keep("measured-" + name + ".csv", scaled_measured(problem, name, source, factor));
  if (!tables.sliding_table || !tables.sliding_table->uplift_table) return;
  UpliftTable& uplift = *tables.sliding_table->uplift_table;
  const std::string key = "sliding.uplift";
  const std::string file = tables.load_tables.count("uplift") == 0 ? "uplift.csv" : "sliding-uplift.csv";
  if (!uplift.gauges.empty()) uplift.gauges = keep(file, scaled_record(problem, uplift, key, factor));
  if (!uplift.history_file.empty()) uplift.history_file = keep(file, history(uplift.history_file, key, "N/m"));
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
  CaseTables tables = *problem.tables;
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
