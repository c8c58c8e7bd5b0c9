#include "upbead/case/case.h"

#include <filesystem>

#include "base/numbers.h"
#include "case/load_source.h"
#include "case/records/gauge_load.h"
#include "case/records/history_load.h"
#include "case_checks.h"
#include "case_schema.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// Polynomial degree where the tolerance decides which cells are split: for tolerances of 1 % and less degree 3 needs
/// fewer unknowns than degree 2 (docs/performance.md).
constexpr int adapted_degree = 3;

/// Makes the loads of all tables without mistakes.
void make_loads(Case& problem, Diagnostics& report) {
  for (const auto& [name, table] : problem.tables->load_tables) {
    const std::string path = dotted("loads", name);
    const LoadWay& way = way_of(table);
    if (!report.sound(path) || (!way.needs.empty() && !report.sound(way.needs))) continue;
    try {
      const std::shared_ptr<LoadSource> source = way.read({problem, name, path, table});
      problem.scene.loads.merge(source->made);
      problem.sources[name] = source;
    } catch (const InputError& error) {
      report.add_at(path, error.diagnostics());
    }
  }
}

/// Fills the values that [sliding] takes from the one load by a wave.
void add_wave_sliding(const Case& problem, SlidingChoice& sliding) {
  const DurationFactor k = problem.tables->duration.value_or(DurationFactor());
  if (sliding.wave) sliding.wave->factor = k(sliding.wave->alpha_star);
  const auto waves = acting_waves(problem);
  if (waves.size() != 1) return;
  const WaveLoad& wave = *waves.front();
  if (!sliding.wave)
    sliding.wave = {wave.wave.height, wave.section.water_depth, wave.wave.period, wave.pressure.alpha_star,
                    k(wave.pressure.alpha_star)};
  if (!sliding.uplift || sliding.uplift->kind != UpliftKind::wave) return;
  sliding.uplift->kind = UpliftKind::prescribed;
  if (wave.standing)
    sliding.uplift->history = scaled(wave.standing->uplift, wave.load.factor);
  else
    sliding.uplift->peak = wave.load.factor * wave.pressure.uplift;
}

/// Gives a frictional contact the section's coefficient where neither the contact nor [sliding] gives one.
void add_section_friction(Case& problem) {
  const CaseTables& tables = *problem.tables;
  if (!tables.section || tables.sliding_table || !has_frictional_contact(problem.scene)) return;
  std::optional<double>& mu = problem.scene.regions.at(caisson_name).interface->coefficient;
  if (!mu) mu = tables.section->friction;
}

/// Reads the file of a prescribed uplift, if any.
void add_uplift_file(const UpliftTable& table, Case& problem, UpliftChoice& uplift) {
  if (!table.history_file.empty()) {
    problem.uplift = read_uplift_history(table, problem);
    uplift.history = problem.uplift->load.history;
  }
  if (table.gauges.empty()) return;
  problem.uplift = read_uplift_gauges(table, problem);
  uplift.history = uplift_of(*problem.uplift);
  uplift.parts = uplift_parts_of(*problem.uplift->gauges);
}

void make_sliding(Case& problem, Diagnostics& report) {
  const CaseTables& tables = *problem.tables;
  if (!tables.sliding_table || !report.sound("sliding")) return;
  const SlidingTable& written = *tables.sliding_table;
  const auto& section = tables.section;
  SlidingChoice& sliding = problem.scene.sliding.emplace(written);
  sliding.friction = written.own_friction.value_or(section ? section->friction : contact_friction(problem.scene));
  sliding.submerged_weight = written.own_submerged_weight.value_or(section ? section->submerged_weight : 0.);
  if (written.uplift_table) sliding.uplift = *written.uplift_table;
  add_wave_sliding(problem, sliding);
  if (written.uplift_table) try {
      add_uplift_file(*written.uplift_table, problem, *sliding.uplift);
    } catch (const InputError& error) {
      report.add_at("sliding.uplift", error.diagnostics());
    }
}

/// The tables as they are written, with the mistakes that can be found without another file.
CaseTables read_tables(const Document& document, Diagnostics& report) {
  CaseTables tables;
  case_schema().read(document.root(), "", tables, report);
  for (const auto check : {check_mesh, check_regions, check_section, check_loads, check_time, check_probes,
                           check_output, check_cycles, check_sliding})
    check(tables, document, report);
  return tables;
}

}  // namespace

std::string Case::resolve(const std::string& path) const {
  return (fs::path(document.path()).parent_path() / path).lexically_normal().string();
}

InputError Case::placed(const InputError& error) const {
  Diagnostics placed;
  for (const auto& [at, what, cure] : error.diagnostics())
    placed.add(at.file.empty() && !at.key.empty() ? place(at.key) : at, what, cure);
  return InputError(std::move(placed));
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  Case problem;
  problem.document = Document(path, overrides);
  problem.stem = fs::path(path).stem().string();
  Diagnostics report;
  problem.tables = std::make_shared<const CaseTables>(read_tables(problem.document, report));
  problem.scene = *problem.tables;
  problem.scene.accuracy = {problem.tables->accuracy_of, problem.tables->accuracy_estimate};
  if (!problem.scene.mesh.refine && !problem.document.find("mesh.degree")) problem.scene.mesh.degree = adapted_degree;
  const bool open = end_is_open(problem);
  if (open) problem.scene.time.end = infinity;  // until the loads are known
  make_loads(problem, report);
  make_sliding(problem, report);
  if (report.sound("loads")) make_cycles(problem, report);
  add_section_friction(problem);
  report.throw_if_any(path);
  problem.notes = report.notes();
  if (open) problem.scene.time.end = end_of_actions(problem) + TimeChoice().end;
  return problem;
}

void check_case(const std::string& path, const std::vector<std::string>& overrides) {
  Diagnostics report;
  read_tables(Document(path, overrides), report);
  if (!report.empty()) read_case(path, overrides);
}

std::string notes_on(const Case& problem) {
  std::string text;
  for (const Diagnostic& note : problem.notes) text += "note: " + to_string(note) + "\n";
  return text;
}

void require_loads(const Case& problem) {
  if (problem.scene.loads.empty())
    throw InputError(problem.place("loads"), "the case has no load, so nothing would move",
                     "add a table [loads.NAME] with boundary and pulse");
}

CaseTables effective_tables(const Case& problem, const std::string& output_folder) {
  const fs::path folder = fs::absolute(output_folder);
  const auto look_from_folder = [&](std::string& path) {
    if (!path.empty()) path = fs::relative(fs::absolute(problem.resolve(path)), folder).string();
  };
  CaseTables tables = *problem.tables;
  static_cast<Scene&>(tables) = problem.scene;
  if (tables.mesh.file) look_from_folder(*tables.mesh.file);
  look_from_folder(tables.report.logo);
  for (auto& [name, table] : tables.load_tables)
    for (const LoadWay& way : load_ways())
      for (const auto path : way.paths) look_from_folder(table.*path);
  for (auto& [name, record] : tables.measured) look_from_folder(record.file);
  if (tables.cycles_table) static_cast<Cycles&>(tables.cycles_table.emplace()) = *problem.scene.cycles;
  if (!tables.sliding_table) return tables;
  tables.sliding_table->own_friction = problem.scene.sliding->friction;
  tables.sliding_table->own_submerged_weight = problem.scene.sliding->submerged_weight;
  if (auto& uplift = tables.sliding_table->uplift_table)
    for (std::string* path : {&uplift->history_file, &uplift->gauges}) look_from_folder(*path);
  return tables;
}

std::string effective_case(const Case& problem, const std::string& output_folder) {
  return case_schema().echo(effective_tables(problem, output_folder));
}

std::string case_reference() {
  return reference(case_schema());
}

std::string case_json_schema() {
  return case_schema().json_schema("a case of upbead");
}

}  // namespace upbead
