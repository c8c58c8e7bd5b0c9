#include "case/case_findings.h"

#include <cmath>
#include <map>

#include "base/numbers.h"
#include "base/text.h"
#include "case/case_run.h"
#include "case/case_schema.h"
#include "case/cfd/flow_scene.h"
#include "case/key_units.h"
#include "case/load_source.h"
#include "case/records/record_layout.h"
#include "case/time_end.h"
#include "case/wave_load.h"
#include "fem/compile.h"
#include "findings/histories.h"
#include "findings/plausibility.h"
#include "findings/topics.h"

namespace upbead {

namespace {

/// How the files of loads and uplift were read.
RecordNotes record_notes(const Case& input) {
  RecordNotes all;
  const auto add = [&all](const std::string& path, const LoadSource& source) {
    append(all, source.notes);
    for (std::size_t i = all.read.size() - source.notes.read.size(); i < all.read.size(); ++i) all.read[i].of = path;
  };
  for (const auto& [name, source] : input.sources) add(dotted("loads", name), *source);
  if (input.uplift) add(input.uplift->name, *input.uplift);
  return all;
}

/// Numbers whose unit was mistaken, as far as their key tells.
NumberedWarnings unit_warnings(const Case& input) {
  CaseTables tables = *input.tables;
  NumberedWarnings list = implausible_keys(
      input.document, [&](const NumberVisitor& visitor) { case_schema().visit_numbers(tables, "", visitor); });
  if (tables.section)
    append(list, implausible_section(*tables.section, {input.scene.fluid.density, input.scene.gravity}));
  return list;
}

/// Warning load_zero where all loads of a case are switched off: checks that hold are then of the rest alone.
NumberedWarnings warnings_of_no_load(const Case& input) {
  if (input.sources.empty()) return {};
  for (const auto& [name, source] : input.sources)
    if (source->acts()) return {};
  const std::optional<UpliftChoice> uplift = input.scene.sliding ? input.scene.sliding->uplift : std::nullopt;
  const std::string what = !uplift || uplift->kind == UpliftKind::computed ? "nothing acts"
                           : uplift->peak ? "nothing acts, nor does the uplift, which follows P"
                                          : "nothing acts but the uplift";
  return {{"load_zero", 0., input.scene.time.end, "s",
           "every load is switched off (factor = 0): " + what +
               ", and what is told of motion, S and pressures is of the section at rest",
           "give a load a factor that is not 0", true}};
}

/// Levels of still water that the file gives for `waves`, beside the section's own.
std::size_t n_levels(const Case& input) {
  const Node* levels = input.document.find("levels");
  return levels && levels->table() ? levels->table()->size() : 0;
}

NumberedWarnings warnings_of_levels(const Case& input) {
  const std::size_t n = acting_waves(input).empty() ? 0 : n_levels(input);
  return levels_not_used(n,
                         "the run and its checks by formulas are at the section's own level of still water, and the "
                         "file has " +
                             std::to_string(n) + (n == 1 ? " more" : " others") +
                             " in [levels]: one of them may be worse",
                         "judge the formulas at each level by 'upbead waves' or 'upbead sheet'");
}

/// What acts; where it presses on the caisson with less than a hundredth of the largest force it is trifling.
std::vector<Action> actions_on(const Case& input, const Simulation& simulation) {
  constexpr double share = 0.01;
  const CompiledScene& compiled = *simulation.compiled();
  std::vector<Action> list = actions_of(input);
  double end = simulation.given().time.end, largest = 0.;
  for (const Action& action : list)
    if (!action.time.empty()) end = std::max(end, action.time.back());
  std::map<std::string, double> force;
  for (std::size_t k = 0; k < compiled.loads_on_caisson.size(); ++k) {
    const SystemLoad& load = compiled.system.loads[k];
    const double most = std::max(extremum(load.history, 0., end, 1).value, -extremum(load.history, 0., end, -1).value);
    const double of_load =
        most * std::hypot(compiled.loads_on_caisson[k].force_x, compiled.loads_on_caisson[k].force_y);
    largest = std::max(largest, of_load);
    for (const auto& [name, source] : input.sources)
      if (load.name == name || load.name.rfind(name + ".", 0) == 0) force[source->title] += of_load;
  }
  for (Action& action : list)
    if (const double own = force[action.name]; own > 0. && own < share * largest) action.trifling = true;
  return list;
}

NumberedWarnings warnings_of_files(const Case& input, const Simulation& simulation, const RecordNotes& notes) {
  NumberedWarnings list = warnings_of_no_load(input);
  for (const LoadSource* source : sources_of(input)) append(list, source->warnings);
  append(list, warnings_of_levels(input));
  append(list, wave_mesh_warnings(input, simulation));
  append(list, transducer_warnings(input, simulation));
  const std::vector<Action> actions = actions_on(input, simulation);
  append(list, end_warnings(actions, simulation.given().time.end));
  if (!end_is_open(input) && simulation.given().time.inertia)
    append(list,
           answer_warnings(actions, simulation.given().time.end, swing_period(simulation.given(), *simulation.mesh())));
  append(list, unit_warnings(input));
  if (const auto& section = input.tables->section;
      section && !input.scene.sliding && !acting_waves(input).empty() && simulation.compiled()->caisson)
    judge_weight("section.submerged_weight", section->submerged_weight, simulation, list);
  append(list, flow_arm_warnings(input, *simulation.mesh()));
  append(list, notes.warnings);
  return list;
}

OutputSchema<MeasuredSummary> measured_outputs() {
  using M = MeasuredSummary;
  using C = Comparison;
  return OutputSchema<M>()
      .key("reading", &M::reading, "", "the history that it is compared with")
      .keys_of(&M::comparison,
               OutputSchema<C>()
                   .key("peak_measured", &C::peak_measured, "", "of largest magnitude, in the unit of the record")
                   .key("peak_computed", &C::peak_computed, "", "in the direction of the measured one, in that unit")
                   .key("peak_ratio", &C::peak_ratio, "", "computed over measured")
                   .key("rms", &C::rms, "", "root of the mean square of the difference, in that unit")
                   .key("rms_relative", &C::rms_relative, "", "that over the root of the mean square of the record")
                   .key("phase", &C::phase, "s", "time by which the computed history lags the record"));
}

Finding flows_finding(const Case* input) {
  Finding f;
  f.keys.named("flows.NAME", &Summary::flows, &FlowSummary::name, flow_outputs(),
               "of a load [from a CFD program](cfd.md)");
  f.parts.emplace_back([input](const Evidence&, Summary& s) { s.flows = flow_summaries(*input); });
  return f;
}

Finding gauges_finding(const Case* input) {
  Finding f;
  f.keys.named("gauges.NAME", &Summary::gauges, &GaugeSummary::name, gauge_outputs(),
               "of a load by [transducers](records.md), or `sliding.uplift`");
  f.parts.emplace_back([input](const Evidence& e, Summary& s) { s.gauges = gauge_summaries(*input, e.simulation); });
  return f;
}

/// The loads by waves, and their checks by formulas.
Finding waves_finding(const Case* input) {
  Finding f;
  f.keys.named("wave_loads.NAME", &Summary::waves, &WaveLoadSummary::name, wave_load_outputs(),
               "of a load by a [wave](waves.md#a-wave-as-a-load-of-a-run)");
  f.parts.emplace_back([input](const Evidence& e, Summary& s) {
    s.waves = wave_summaries(*input);
    s.formula_checks = formula_checks(s.waves, e.scene.limits);
    for (Check& check : s.formula_checks) check.level = n_levels(*input) > 0 ? "section" : "";
  });
  f.checks = [](const Scene&, const Summary& s) { return s.formula_checks; };
  f.warnings = [](const Evidence& e, const Summary& s) { return factor_warnings(s.formula_checks, e.scene.limits); };
  f.needs_no_march = true;
  return f;
}

Finding files_finding(const Case* input) {
  Finding f;
  f.of_scene = [input](const Simulation& simulation, const std::optional<double>&) {
    return warnings_of_files(*input, simulation, record_notes(*input));
  };
  f.skipped_of_scene = [input](const Simulation&, bool) { return record_notes(*input).left_out; };
  return f;
}

/// Warning implausible: a record and its reading that differ a hundredfold have two units.
NumberedWarnings peaks_far_apart(const std::vector<MeasuredSummary>& measured) {
  constexpr double most = 100.;
  NumberedWarnings list;
  for (const MeasuredSummary& m : measured)
    if (const double ratio = std::abs(m.comparison.peak_ratio); ratio > 0. && (ratio > most || ratio < 1. / most))
      list.push_back(
          {"implausible", ratio, ratio > most ? most : 1. / most, "1",
           "measured." + m.name + ": the peak of " + m.reading + " is " + significant(ratio, 4) +
               " times the measured one",
           "look at the reading, the scale and the unit of its column, which is SI where its header has none"});
  return list;
}

Finding measured_finding(const Case* input, const std::vector<MeasuredRecord>* records) {
  Finding f;
  f.keys.named("measured.NAME", &Summary::measured, &MeasuredSummary::name, measured_outputs(),
               "of a [record](records.md#the-response) of `[measured]`");
  f.parts.emplace_back([input, records](const Evidence& e, Summary& s) {
    if (!records->empty())
      s.measured =
          compare_measured(*input, *records, histories(e.simulation, e.of(find_history).series, e.solution.contact));
  });
  f.warnings = [records](const Evidence&, const Summary& s) {
    NumberedWarnings list;
    for (const MeasuredRecord& record : *records) append(list, record.notes.warnings);
    append(list, peaks_far_apart(s.measured));
    return list;
  };
  f.skipped = [records](const Evidence&, const Summary&) {
    SkippedList list;
    for (const MeasuredRecord& record : *records) append(list, record.notes.left_out);
    return list;
  };
  return f;
}

}  // namespace

std::vector<Finding> case_findings(const Case* input, const std::vector<MeasuredRecord>* records) {
  return {flows_finding(input), gauges_finding(input), waves_finding(input), files_finding(input),
          measured_finding(input, records)};
}

const OutputSchema<Summary>& summary_outputs() {
  static const OutputSchema<Summary> schema = keys_of(case_findings(nullptr, nullptr));
  return schema;
}

std::string to_json(const Summary& summary) {
  return summary_outputs().text(summary);
}

std::vector<RecordSummary> record_summaries(const Case& input, const std::vector<MeasuredRecord>& records) {
  std::vector<RecordSummary> list = record_notes(input).read;
  for (const MeasuredRecord& record : records) append(list, record.notes.read);
  return list;
}

}  // namespace upbead
