#include "upbead/case/case.h"

#include <filesystem>

#include "base/numbers.h"
#include "case/cfd/flow_keys.h"
#include "case/cfd/flow_record.h"
#include "case/cfd/flow_scene.h"
#include "case/records/load_records.h"
#include "case/time_end.h"
#include "case_checks.h"
#include "case_schema.h"
#include "model/motion.h"
#include "wave_load.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// Polynomial degree where the tolerance decides which cells are split: for tolerances of 1 % and less degree 3 needs
/// fewer unknowns than degree 2 (docs/performance.md).
constexpr int adapted_degree = 3;

/// Adds a landward force to the scene; its shape over the wall is set once the mesh is known.
void make_wave(Case& problem, const std::string& name, const CaseTables& tables, LoadTable& table) {
  const Place place = problem.place(dotted("loads", name) + ".wave.height");
  const auto wave = [&] {
    try {
      return wave_load(table, *table.wave, *tables.section, {tables.fluid.density, tables.gravity});
    } catch (const NumericsError& error) {
      throw InputError(place, error.what(),
                       "give a lower wave, or course = \"church_roof\", which is of waves that break");
    }
  }();
  problem.waves[name] = wave;
  table.kind = LoadKind::force;
  table.history = wave->history;
  table.duration = wave->duration;
}

/// Where to note how the file of a key is read.
RecordNotes& notes_of(Case& problem, const std::string& path) {
  const auto notes = std::make_shared<RecordNotes>();
  problem.records[path] = notes;
  return *notes;
}

/// Reads a record of CFD and turns it into a load as the keys say.
void make_flow(Case& problem, const std::string& name, const CaseTables& tables, LoadTable& table) {
  const std::string path = dotted("loads", name);
  FlowContext context{path, &problem.document, tables.gravity};
  context.on_region = !table.region.empty();
  context.beyond = {table.to_first, table.to_last};
  context.beyond_given = {problem.document.find(path + ".to_base") != nullptr,
                          problem.document.find(path + ".to_crest") != nullptr};
  context.base = fs::path(problem.document.path()).parent_path().string();
  const FlowRecord record = read_flow(problem.resolve(table.from), table.file, problem.place(path + ".from"));
  const bool points = record.points.has_value(), says_points = table.kind == LoadKind::pressures;
  if (points != says_points)
    throw InputError(problem.place(path + ".kind"),
                     std::string("the record holds ") + (points ? "pressures" : "forces") + ": " + record.layout,
                     std::string("write kind = ") + (points ? "\"pressures\"" : "\"force\""));
  const auto flow = std::make_shared<FlowLoad>(understand(record, table, context));
  if (flow->force && !flow->force->moment.empty() && !table.shape.empty())
    throw InputError(problem.place(path + ".shape"), "the record's moments tell where its force acts", "remove shape");
  problem.flows[name] = {table, table, flow};
  if (flow->pressure) problem.gauges[name] = {table, GaugeSource(), *flow->pressure};
}

/// Reads what gives the load its course in time: a pulse, a history, a wave, a wave train or transducers.
void make_history(Case& problem, const std::string& name, const CaseTables& tables, LoadTable& table) {
  const std::string path = dotted("loads", name);
  if (!table.from.empty()) {
    make_flow(problem, name, tables, table);
    return;
  }
  if (table.kind == LoadKind::train) {
    problem.trains[name] = std::make_shared<const TrainLoad>(TrainLoad{table, *table.train});
    return;
  }
  if (table.kind == LoadKind::pressures) {
    // first, as GCC 12 destroys the members before it twice where one in braces throws
    Gauges gauges = read_gauges(table, problem.resolve(table.gauges), path, problem.document, notes_of(problem, path));
    problem.gauges[name] = {table, table, std::move(gauges)};
    problem.gauges[name].gauges.over_x = table.over_x;
  } else if (table.kind == LoadKind::wave) {
    make_wave(problem, name, tables, table);
  } else if (table.pulse && is_motion(table.kind)) {
    table.history = velocity(table.kind, *table.pulse);
    table.duration = motion_duration(table.kind, *table.pulse);
  } else if (table.pulse) {
    table.history = time_function(*table.pulse);
    table.duration = duration(*table.pulse);
  } else {
    read_history(problem.resolve(table.history_file), problem.place(path + ".history"), tables.time.end, table,
                 table.record_start, notes_of(problem, path));
  }
  if (table.factor == 0.) {
    table.history = TimeFunction();
    table.duration.reset();
  } else {
    table.history = scaled(table.history, table.factor);
  }
}

/// Makes the histories of all loads whose tables have no mistakes.
void make_histories(Case& problem, CaseTables& tables, Diagnostics& report) {
  for (auto& [name, table] : tables.load_tables) {
    if (!report.sound(dotted("loads", name))) continue;
    if (table.kind == LoadKind::wave && !report.sound("section")) continue;
    try {
      make_history(problem, name, tables, table);
    } catch (const InputError& error) {
      report.add_at(dotted("loads", name), error.diagnostics());
    }
  }
}

/// Fills the values that [sliding] takes from the one load by a wave.
void add_wave_sliding(Case& problem, SlidingChoice& sliding) {
  const auto waves = acting_waves(problem);
  if (waves.size() != 1) return;
  const WaveLoad& wave = *waves.front().second;
  if (!sliding.wave) {
    problem.sliding_by_wave = true;
    sliding.wave = {wave.wave.height, wave.section.water_depth, wave.wave.period, wave.pressure.alpha_star};
  }
  if (!sliding.uplift || sliding.uplift->kind != UpliftKind::wave) return;
  problem.uplift_by_wave = true;
  sliding.uplift->kind = UpliftKind::prescribed;
  if (wave.standing)
    sliding.uplift->history = scaled(wave.standing->uplift, wave.load.factor);
  else
    sliding.uplift->peak = wave.load.factor * wave.pressure.uplift;
}

/// Gives a frictional contact the section's coefficient where neither the contact nor [sliding] gives one.
void add_section_friction(CaseTables& tables) {
  if (!tables.section || tables.sliding_table || !has_frictional_contact(tables)) return;
  std::optional<double>& mu = tables.regions.at(caisson_name).interface->coefficient;
  if (!mu) mu = tables.section->friction;
}

/// Makes the sliding of a scene, with the history of its uplift.
void make_sliding(Case& problem, CaseTables& tables, Diagnostics& report) {
  if (!tables.sliding_table || !report.sound("sliding")) return;
  tables.sliding = *tables.sliding_table;
  const SlidingTable& written = *tables.sliding_table;
  tables.sliding->friction =
      written.own_friction.value_or(tables.section ? tables.section->friction : contact_friction(tables));
  tables.sliding->submerged_weight =
      written.own_submerged_weight.value_or(tables.section ? tables.section->submerged_weight : 0.);
  if (tables.sliding_table->uplift_table) tables.sliding->uplift = *tables.sliding_table->uplift_table;
  add_wave_sliding(problem, *tables.sliding);
  if (!tables.sliding_table->uplift_table) return;
  const UpliftTable& table = *tables.sliding_table->uplift_table;
  try {
    if (!table.history_file.empty())
      tables.sliding->uplift->history =
          read_uplift(problem.resolve(table.history_file), problem.place("sliding.uplift.history"), table.record_start,
                      notes_of(problem, "sliding.uplift"));
    if (table.gauges.empty()) return;
    // first, as above
    Gauges gauges = read_gauges(table, problem.resolve(table.gauges), "sliding.uplift", problem.document,
                                notes_of(problem, "sliding.uplift"));
    problem.uplift_gauges = {{}, table, std::move(gauges)};
    tables.sliding->uplift->history = uplift_of(*problem.uplift_gauges);
    tables.sliding->uplift->parts = uplift_parts_of(problem.uplift_gauges->gauges);
  } catch (const InputError& error) {
    report.add_at("sliding.uplift", error.diagnostics());
  }
}

/// Adds the tables of loads by records of CFD, as written.
template <class PathText>
void add_flow_tables(const Case& problem, PathText path_text, CaseTables& tables) {
  for (const auto& [name, by_flow] : problem.flows) {
    LoadTable& table = tables.load_tables[name];
    static_cast<Load&>(table) = by_flow.load;
    static_cast<GaugeSource&>(table) = by_flow.beyond;
    static_cast<FlowSource&>(table) = by_flow.flow->source;
    table.from = path_text(table.from);
    if (!table.against.empty()) table.against = path_text(table.against);
  }
}

/// Adds the table [sliding], as written.
template <class PathText>
void add_sliding_table(const Case& problem, PathText path_text, CaseTables& tables) {
  const auto& sliding = problem.scene.sliding;
  if (!sliding) return;
  static_cast<SlidingChoice&>(tables.sliding_table.emplace()) = *sliding;
  tables.sliding_table->own_friction = sliding->friction;
  tables.sliding_table->own_submerged_weight = sliding->submerged_weight;
  if (problem.sliding_by_wave) tables.sliding_table->wave.reset();
  if (sliding->uplift) {
    UpliftTable& uplift = tables.sliding_table->uplift_table.emplace();
    static_cast<UpliftChoice&>(uplift) = *sliding->uplift;
    if (problem.uplift_by_wave) {
      uplift.kind = UpliftKind::wave;
      uplift.peak.reset();
    }
    if (!problem.uplift_history.empty()) uplift.history_file = path_text(problem.uplift_history);
    uplift.record_start = problem.uplift_start;
    if (problem.uplift_gauges) {
      static_cast<GaugeSource&>(uplift) = problem.uplift_gauges->source;
      uplift.gauges = path_text(uplift.gauges);
    }
  }
}

/// The tables as written, with each path of a file as `path_text` writes it.
template <class PathText>
CaseTables tables_of(const Case& problem, PathText path_text) {
  CaseTables tables;
  static_cast<Scene&>(tables) = problem.scene;
  if (tables.mesh.file) tables.mesh.file = path_text(*tables.mesh.file);
  for (const auto& [name, source] : problem.sources) {
    LoadTable& table = tables.load_tables[name];
    static_cast<Load&>(table) = problem.scene.loads.at(name);
    table.pulse = source.pulse;
    if (!source.history.empty()) table.history_file = path_text(source.history);
    table.record_start = source.record_start;
  }
  tables.accuracy_of = problem.scene.accuracy.of;
  tables.accuracy_estimate = problem.scene.accuracy.estimate;
  tables.measured = problem.measured;
  tables.report = problem.report;
  if (!tables.report.logo.empty()) tables.report.logo = path_text(tables.report.logo);
  for (auto& [name, source] : tables.measured) source.file = path_text(source.file);
  add_flow_tables(problem, path_text, tables);
  for (const auto& [name, by_gauges] : problem.gauges) {
    if (problem.flows.count(name) > 0) continue;
    LoadTable& table = tables.load_tables[name];
    static_cast<Load&>(table) = by_gauges.load;
    static_cast<GaugeSource&>(table) = by_gauges.source;
    table.gauges = path_text(by_gauges.source.gauges);
  }
  for (const auto& [name, by_train] : problem.trains) {
    LoadTable& table = tables.load_tables[name];
    static_cast<Load&>(table) = by_train->load;
    table.train = by_train->train;
  }
  for (const auto& [name, wave] : problem.waves) {
    LoadTable& table = tables.load_tables[name];
    static_cast<Load&>(table) = wave->load;
    table.wave = wave->table;
  }
  tables.section = problem.section;
  add_sliding_table(problem, path_text, tables);
  return tables;
}

/// The tables as they are written, with the mistakes that can be found without another file.
CaseTables read_tables(const Document& document, Diagnostics& report) {
  CaseTables tables;
  case_schema().read(document.root(), "", tables, report);
  for (const auto check :
       {check_mesh, check_regions, check_section, check_loads, check_time, check_probes, check_output, check_sliding})
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
  CaseTables tables = read_tables(problem.document, report);
  if (end_is_open(problem)) tables.time.end = infinity;  // until the loads are known
  make_histories(problem, tables, report);
  make_sliding(problem, tables, report);
  add_section_friction(tables);
  report.throw_if_any(path);
  problem.notes = report.notes();
  problem.scene = tables;
  problem.scene.accuracy = {tables.accuracy_of, tables.accuracy_estimate};
  problem.measured = tables.measured;
  problem.report = tables.report;
  problem.section = tables.section;
  if (!problem.scene.mesh.refine && !problem.document.find("mesh.degree")) problem.scene.mesh.degree = adapted_degree;
  if (tables.sliding_table && tables.sliding_table->uplift_table) {
    problem.uplift_history = tables.sliding_table->uplift_table->history_file;
    problem.uplift_start = tables.sliding_table->uplift_table->record_start;
  }
  for (const auto& [name, table] : tables.load_tables) {
    if (table.kind == LoadKind::pressures) {
      add_gauge_loads(name, problem.gauges.at(name), tables.time.end, problem.scene);
      continue;
    }
    if (table.kind == LoadKind::train) {
      add_train_loads(name, *problem.trains.at(name), problem.scene.fluid.density, problem.scene.gravity,
                      problem.scene);
      continue;
    }
    if (const auto wave = problem.waves.find(name); wave != problem.waves.end() && wave->second->standing) {
      add_gauge_loads(name, {table, {}, wave->second->standing->gauges}, tables.time.end, problem.scene);
      continue;
    }
    if (!table.from.empty()) {
      add_flow_force(name, table, *problem.flows.at(name).flow, problem.scene);
      continue;
    }
    problem.scene.loads[name] = table;
    if (table.wave) continue;
    problem.sources[name] = {table.pulse, table.history_file, table.record_start};
  }
  if (end_is_open(problem)) problem.scene.time.end = end_of_actions(problem) + TimeChoice().end;
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

std::string effective_case(const Case& problem, const std::string& output_folder) {
  const fs::path folder = fs::absolute(output_folder);
  const auto seen_from_folder = [&](const std::string& path) {
    return fs::relative(fs::absolute(problem.resolve(path)), folder).string();
  };
  return case_schema().echo(tables_of(problem, seen_from_folder));
}

std::string case_reference() {
  return reference(case_schema());
}

std::string case_json_schema() {
  return case_schema().json_schema("a case of upbead");
}

}  // namespace upbead
