#include "design/design.h"

#include <algorithm>
#include <filesystem>

#include "case/case_schema.h"
#include "case/key_units.h"
#include "design/water_levels.h"
#include "model/quantities.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// Why shear_to_force_ratio needs a measured force: it may reduce only that.
Diagnostic ratio_without_force() {
  return {at_key("shear_to_force_ratio"),
          "shear_to_force_ratio needs a measured or computed 'force': alpha_I was fitted to sliding tests, so the P of "
          "Goda's formula with it already is an effective sliding force, and the ratio would count twice",
          "add force, the peak of P (N/m), or remove shear_to_force_ratio"};
}

Diagnostics diagnose(const WaveTable& wave, const Section* section) {
  Diagnostics list = upbead::diagnose(static_cast<const WaveGiven&>(wave), section);
  if (wave.shear_to_force_ratio && !wave.force) list.add(ratio_without_force());
  if (wave.uplift && !wave.force)
    list.add(at_key("uplift"), "'uplift' is that beside a measured or computed 'force', which is not given",
             "add force, the peak of P (N/m), or remove uplift");
  return list;
}

/// Reports what is contradictory in a table, unless one of the keys that it depends on has been refused already.
void report_unless_refused(const std::string& path, const Diagnostics& found, const std::vector<std::string>& keys,
                           const Document& document, Diagnostics& report) {
  const auto sound = [&](const std::string& key) { return report.sound(dotted(path, key)); };
  if (!std::all_of(keys.begin(), keys.end(), sound)) return;
  for (const auto& [at, what, cure] : found)
    report.add(document.place(dotted(path, at.key)), "[" + path + "]: " + what, cure);
}

void check_section(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (document.find("section"))
    report_unless_refused("section", diagnose(tables.section),
                          {"weight", "submerged_weight", "width", "centroid", "harbour_level", "crest"}, document,
                          report);
}

void check_ground(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (tables.ground && tables.ground->damping > 0. && tables.ground->mass == 0.)
    report_unless_refused(
        "ground", {{at_key("damping"), "'damping' without a 'mass' that it could slow down", "add mass (kg/m)"}},
        {"damping", "mass"}, document, report);
  for (const auto& [name, wave] : tables.waves) {
    if (!wave.pulse_duration || (wave.force && tables.ground)) continue;
    report_unless_refused(dotted("waves", name),
                          {{at_key("pulse_duration"),
                            std::string("'pulse_duration' is that of a measured or computed 'force' on [ground], ") +
                                (wave.force ? "and there is no [ground]" : "which is not given"),
                            wave.force ? "add [ground] with stiffness (N/m2)" : "add force, the peak of P (N/m)"}},
                          {"pulse_duration", "force"}, document, report);
  }
}

void check_waves(const DesignTables& tables, const Document& document, Diagnostics& report) {
  for (const auto& [name, wave] : tables.waves)
    report_unless_refused(dotted("waves", name), diagnose(wave, report.sound("section") ? &tables.section : nullptr),
                          {"height", "significant_height", "deep_water_height", "force", "shear_to_force_ratio",
                           "uplift", "angle", "direction"},
                          document, report);
}

void check_impact_table(const DesignTables& tables, const Document& document, Diagnostics& report) {
  report_unless_refused("impact", diagnose(tables.impact, tables.impact.force), {"proverbs", "peak_gain", "force"},
                        document, report);
}

/// A copy of the tables is visited, as a visitor may change them.
NumberedWarnings implausible_numbers(const Design& design) {
  DesignTables tables = design.tables;
  NumberedWarnings list;
  judge("fluid.density", tables.water.density, quantities::water_density, list);
  append(list, implausible_keys(design.document, [&](const NumberVisitor& visitor) {
           design_schema().visit_numbers(tables, "", visitor);
         }));
  append(list, implausible_section(tables.section, tables.water));
  append(list, implausible_distributions(tables));
  const double h = tables.section.water_depth;
  Quantity height = quantities::wave_height;  // a wave of three times the depth has broken long before
  height.high = 3. * h;
  height.common_low = 0.01 * h;
  height.common_high = 1.5 * h;
  const Quantity force = of(quantities::load_on_weight, tables.section.weight, "N/m", "beside the caisson's weight");
  for (const auto& [name, wave] : tables.waves) {
    const std::string at = dotted("waves", name);
    if (wave.height && *wave.height <= quantities::wave_height.high) judge(at + ".height", wave.height, height, list);
    judge(at + ".force", wave.force, force, list);
    judge(at + ".uplift", wave.uplift, force, list);
  }
  if (tables.ground)
    judge("ground.mass", tables.ground->mass,
          of(quantities::load_on_weight, tables.section.weight / tables.water.gravity, "kg/m",
             "beside the caisson's mass", {{"t/m", 1e3}}),
          list);
  return list;
}

}  // namespace

std::string Design::resolve(const std::string& path) const {
  return (fs::path(document.path()).parent_path() / path).lexically_normal().string();
}

Design read_design(const std::string& path, const std::vector<std::string>& overrides,
                   const std::vector<DesignCheck>& further) {
  Design design;
  design.document = Document(path, overrides);
  design.stem = fs::path(path).stem().string();
  Diagnostics report;
  design_schema().read(design.document.root(), "", design.tables, report);
  design.tables.water.gravity = design.tables.gravity;
  for (const DesignCheck check :
       {check_section, check_waves, check_ground, check_water_levels, check_what_acts, check_impact_table})
    check(design.tables, design.document, report);
  for (const DesignCheck check : further) check(design.tables, design.document, report);
  report.throw_if_any(path);
  static_cast<ImpactAssumptions&>(design.tables.impact) = with_force(design.tables.impact, design.tables.impact.force);
  design.implausible = implausible_numbers(design);
  return design;
}

std::string effective_design(const Design& design, const std::string& output_folder,
                             const std::vector<std::string>& without) {
  const fs::path folder = fs::absolute(output_folder);
  DesignTables tables = design.tables;
  const auto look_from_folder = [&](std::string& path) {
    if (!path.empty()) path = fs::relative(fs::absolute(design.resolve(path)), folder).string();
  };
  look_from_folder(tables.report.logo);
  if (tables.sea) look_from_folder(tables.sea->states);
  if (tables.dynamics) look_from_folder(tables.dynamics->model);
  if (tables.calibration)
    for (auto& [name, model] : tables.calibration->models) look_from_folder(model.model);
  return design_schema().echo(tables, without);
}

std::string effective_file(const Case& problem, const Design& design, const std::string& output_folder) {
  const std::string text = effective_design(design, output_folder, case_schema().names());
  const std::size_t tables =
      std::min(text.find("\n["), text.size());  // keys of the file itself stand before all tables
  return text.substr(0, tables) + effective_case(problem, output_folder) + text.substr(tables);
}

std::string design_reference() {
  return reference(design_schema());
}

std::string design_json_schema() {
  return design_schema().json_schema("a design of upbead");
}

std::vector<InputFile> input_files(const Design& design) {
  std::vector<InputFile> files{{design.document.path(), {design.document.path()}}};
  const auto add = [&](const std::string& file, const std::string& key) {
    if (!file.empty()) files.push_back({design.resolve(file), design.document.place(key)});
  };
  const DesignTables& tables = design.tables;
  if (tables.sea) add(tables.sea->states, "sea.states");
  if (tables.dynamics) add(tables.dynamics->model, "dynamics.model");
  if (tables.calibration)
    for (const auto& [name, model] : tables.calibration->models)
      add(model.model, dotted("calibration.models", name) + ".model");
  return files;
}

}  // namespace upbead
