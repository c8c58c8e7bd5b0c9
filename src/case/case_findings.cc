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
#include "findings/effective_base.h"
#include "findings/histories.h"
#include "findings/topics.h"
#include "output/section_outputs.h"

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

/// Warning centroid_differs: W' of [section] acts on another line than the weight of the meshed caisson in water, so
/// that overturning and edge pressures by formulas are those of another caisson than the run's.
NumberedWarnings centroid_warnings(const Case& input, const Simulation& simulation) {
  constexpr double same = 0.02;  // of B: footings and rounded corners
  if (!simulation.compiled()->caisson || acting_waves(input).empty()) return {};
  const Section& section = acting_waves(input).front()->section;
  const double B = section.width, t = section.centroid.value_or(0.5 * B);
  const std::optional<double> e = eccentricity_in_water(simulation);
  if (!e || std::abs(0.5 * B - *e - t) <= same * B) return {};
  return {{"centroid_differs", t, 0.5 * B - *e, "m",
           "by [section] W' acts " + significant(t, 4) + " m from the landward heel" +
               (section.centroid ? "" : ", as centroid is not given") + ", by the meshed caisson in still water " +
               significant(0.5 * B - *e, 4) +
               " m: overturning and edge pressures by formulas and by dynamics are of two caissons",
           "give section.centroid = " + significant(0.5 * B - *e, 4) + ", or mend the caisson's centre of gravity"}};
}

/// What of the meshed ground is seaward of the caisson's wall: height of its surface at the wall, and how far it stays
/// there (m).
struct MeshedBerm {
  double height = 0., width = 0.;
};

std::optional<MeshedBerm> meshed_berm(const Simulation& simulation) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const Mesh& mesh = *simulation.mesh();
  const double B = caisson.bottom_width, wall = caisson.bottom_centre[0] - 0.5 * B, hair = 0.01 * B;
  const auto is_ground = [&](const auto& cell) {
    const std::string& name = mesh.surface_of(cell);
    const RegionKind kind = simulation.scene().regions.at(name).kind;
    return name != caisson.body.region && (kind == RegionKind::porous || kind == RegionKind::solid);
  };
  std::map<double, double> surface;  // y by distance from the wall
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      const auto face = cell->face(f);
      if (!is_ground(cell) || face->center()[1] <= cell->center()[1] || face->center()[0] >= wall) continue;
      if (!cell->at_boundary(f) && is_ground(cell->neighbor(f))) continue;
      for (const unsigned v : {0U, 1U}) surface[wall - face->vertex(v)[0]] = face->vertex(v)[1];
    }
  if (surface.empty() || surface.begin()->first > hair) return std::nullopt;
  MeshedBerm berm{surface.begin()->second, 0.};
  for (const auto& [away, y] : surface) {
    if (std::abs(y - berm.height) > hair) break;
    berm.width = away;
  }
  return berm;
}

/// Warning berm_differs: Goda's formulas are asked about another berm than is meshed. Armour that is not meshed makes
/// the water over it shallower, never deeper.
NumberedWarnings berm_warnings(const Case& input, const Simulation& simulation) {
  constexpr double same = 0.1;  // of the meshed one
  if (!simulation.compiled()->caisson || acting_waves(input).empty()) return {};
  const Section& section = acting_waves(input).front()->section;
  const std::optional<MeshedBerm> berm = meshed_berm(simulation);
  if (!berm) return {};
  const double depth = section.foundation_depth - (berm->height - simulation.compiled()->caisson->bottom_centre[1]);
  NumberedWarnings list;
  const auto add = [&](const char* key, double given, double meshed) {
    list.push_back({"berm_differs", given, meshed, "m",
                    std::string("section.") + key + " = " + significant(given, 4) + " m, of the meshed mound " +
                        significant(meshed, 4) + " m: alpha_2, alpha_I and P are those of another mound",
                    "give one mound in both"});
  };
  if (depth > 0. && section.berm_depth > (1. + same) * depth) add("berm_depth", section.berm_depth, depth);
  if (std::abs(section.berm_width - berm->width) > same * berm->width)
    add("berm_width", section.berm_width, berm->width);
  return list;
}

/// Whether one of these curves meets the foot of a wall of the caisson, so that a pressure on it gets under the base.
bool reaches_foot(const Simulation& simulation, const std::vector<std::string>& curves) {
  const Caisson& caisson = *simulation.compiled()->caisson;
  const Mesh& mesh = *simulation.mesh();
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary()) continue;
      if (std::find(curves.begin(), curves.end(), mesh.curve_of(face)) == curves.end()) continue;
      for (const unsigned v : {0U, 1U}) {
        const auto from = face->vertex(v) - caisson.bottom_centre;
        if (std::hypot(std::abs(from[0]) - 0.5 * caisson.bottom_width, from[1]) < 1e-6 * caisson.bottom_width)
          return true;
      }
    }
  return false;
}

/// Warning uplift_left_out: a wave presses on the wall alone, and nothing lifts the caisson.
NumberedWarnings warnings_of_no_uplift(const Case& input, const Simulation& simulation) {
  const auto& sliding = input.scene.sliding;
  const bool is_given = sliding && sliding->uplift && sliding->uplift->kind != UpliftKind::computed;
  if (!simulation.compiled()->caisson || is_given) return {};
  for (const WaveLoad* wave : acting_waves(input)) {
    if (reaches_foot(simulation, wave->table.mound) || !(wave->pressure.uplift > 0.)) continue;
    const std::string U = with_unit(wave->pressure.uplift, "N/m");
    return {{"uplift_left_out", wave->pressure.uplift, 0., "N/m",
             std::string("the load by a wave presses ") +
                 (wave->table.mound.empty() ? "on the wall alone" : "on no curve of mound or bed at the wall's foot") +
                 ", and " +
                 std::string(sliding && sliding->uplift ? "the computed uplift is that of the caisson's own motion"
                                                        : "no uplift acts") +
                 ": S, N', pressures and margins of the run lack the wave's uplift, by Goda " + U,
             std::string(sliding ? "" : "add [sliding] with friction and submerged_weight; ") +
                 "write sliding.uplift = { kind = \"wave\" }, or, with kind = \"computed\", name the curves of mound "
                 "and bed "
                 "in [loads.NAME.wave] mound"}};
  }
  return {};
}

/// Largest U (N/m) of the loads by waves by their own formulas.
double uplift_of_waves(const Case& input) {
  double largest = 0.;
  const std::vector<const WaveLoad*> waves = acting_waves(input);
  for (const auto& [name, source] : input.sources)
    for (const WaveLoad* wave : waves)
      if (wave == source.get()) largest = std::max(largest, input.scene.loads.at(name).factor * wave->pressure.uplift);
  return largest;
}

/// Least T (s) of the loads by waves.
double period_of_waves(const Case& input) {
  double least = infinity;
  for (const WaveLoad* wave : acting_waves(input)) least = std::min(least, wave->wave.period);
  return least;
}

/// Warning uplift_differs: beside a load by a wave the case prescribes an uplift that is smaller than the wave's own,
/// or comes after its force.
NumberedWarnings warnings_of_other_uplift(const Case& input) {
  constexpr double as_large = 0.8, at_once = 0.02;  // of a period
  const auto& sliding = input.scene.sliding;
  const Node* kind = input.document.find("sliding.uplift.kind");
  const std::string* word = kind ? std::get_if<std::string>(&kind->value) : nullptr;
  if (!sliding || !sliding->uplift || sliding->uplift->kind != UpliftKind::prescribed || (word && *word == "wave"))
    return {};
  const UpliftChoice& uplift = *sliding->uplift;
  const double of_waves = uplift_of_waves(input), end = input.scene.time.end,
               given = uplift.peak ? *uplift.peak : extremum(uplift.history, 0., end, 1).value;
  const bool is_small = given < as_large * of_waves;
  const bool is_late = uplift.lag > at_once * period_of_waves(input);
  if (!(of_waves > 0.) || !uplift.parts.empty() || !(is_small || is_late)) return {};
  return {{"uplift_differs", given, of_waves, "N/m",
           "the prescribed uplift " +
               (is_small ? "has a peak of " + with_unit(given, "N/m") + ", the wave by its own formula " +
                               with_unit(of_waves, "N/m")
                         : "comes " + significant(uplift.lag, 3) +
                               " s after the wave's force, and by its own formula with it") +
               ": S, N' and margins of the run are those of less uplift than the checks by formulas have",
           "write sliding.uplift = { kind = \"wave\" }, unless this uplift was measured"}};
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
  append(list, centroid_warnings(input, simulation));
  append(list, berm_warnings(input, simulation));
  append(list, warnings_of_no_uplift(input, simulation));
  append(list, warnings_of_other_uplift(input));
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
  f.keys = [](OutputSchema<Summary>& s) {
    s.named("flows.NAME", &Summary::flows, &FlowSummary::name, flow_outputs(),
            "of a load [from a CFD program](cfd.md)");
  };
  f.parts.emplace_back([input](const Evidence&, Summary& s) { s.flows = flow_summaries(*input); });
  return f;
}

Finding gauges_finding(const Case* input) {
  Finding f;
  f.keys = [](OutputSchema<Summary>& s) {
    s.named("gauges.NAME", &Summary::gauges, &GaugeSummary::name, gauge_outputs(),
            "of a load by [transducers](records.md), or `sliding.uplift`");
  };
  f.parts.emplace_back([input](const Evidence& e, Summary& s) { s.gauges = gauge_summaries(*input, e.simulation); });
  return f;
}

/// The loads by waves, and their checks by formulas.
Finding waves_finding(const Case* input) {
  Finding f;
  f.keys = [](OutputSchema<Summary>& s) {
    s.named("wave_loads.NAME", &Summary::waves, &WaveLoadSummary::name, wave_load_outputs(),
            "of a load by a [wave](waves.md#a-wave-as-a-load-of-a-run)");
  };
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
  f.keys = [](OutputSchema<Summary>& s) {
    s.named("measured.NAME", &Summary::measured, &MeasuredSummary::name, measured_outputs(),
            "of a [record](records.md#the-response) of `[measured]`");
  };
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

OutputSchema<GaugeSummary> gauge_outputs() {
  using G = GaugeSummary;
  return OutputSchema<G>()
      .key("gauges", &G::gauges, "", "how many")
      .key("samples", &G::samples, "", "how many")
      .key("interval", &G::interval, "s", "between samples, mean")
      .key("peak_gauge", &G::peak_gauge, "", "transducer with the largest pressure")
      .key("peak_pressure", &G::peak_pressure, "Pa", "largest pressure")
      .key("peak_pressure_time", &G::peak_pressure_time, "s", "when")
      .key("peak_pressure_at", &G::peak_at, "m", "where")
      .key("peak_force", &G::peak_force, "N/m", "largest force")
      .key("peak_force_time", &G::peak_force_time, "s", "when")
      .key("arm", &G::arm, "m",
           "height of the largest force above the bottom; for an uplift its distance landward of the bottom's middle")
      .key("force_error", &G::force_error, "", "relative error of the force by interpolation")
      .key("arm_error", &G::arm_error, "", "error of the arm by interpolation, over the row's length")
      .key("load_cell", &G::load_cell, "N/m", "largest force by the load cell; null without");
}

OutputSchema<FlowSummary> flow_outputs() {
  using F = FlowSummary;
  return OutputSchema<F>()
      .key("layout", &F::layout, "", "what was read")
      .key("files", &F::files, "", "how many")
      .key("samples", &F::samples, "", "how many")
      .key("begin", &F::begin, "s", "of the record, in the run's time")
      .key("end", &F::end, "s", "of the record, in the run's time")
      .key("thickness", &F::thickness, "m",
           "length of breakwater that its forces belong to; null where it holds pressures")
      .key("peak_force", &F::peak_force, "N/m",
           "largest force over still water, landward; of pressures their sum along the line of points")
      .key("peak_force_time", &F::peak_force_time, "s", "when")
      .key("arm", &F::arm, "m",
           "height of the largest force above the centre of moments, or above the lowest end of the points; null "
           "without either")
      .key("still_force", &F::still_force, "N/m", "force of still water, which was subtracted")
      .key("difference", &F::difference, "",
           "largest difference of the sum of the pressures and the forces of `against`, over the largest force; null "
           "without `against`")
      .key("told", &F::told, "", "how the files were understood, in sentences");
}

OutputSchema<WaveLoadSummary> wave_load_outputs() {
  using W = WaveLoadSummary;
  return OutputSchema<W>()
      .key("course", &W::course, "", "`church_roof`, `triangle`, `sine`, `combined` or `standing`")
      .key("height", &W::height, "m", "H")
      .key("significant_height", &W::significant_height, "m", "H_1/3")
      .key("period", &W::period, "s", "T")
      .key("angle", &W::angle, "degrees", "beta")
      .key("wavelength", &W::wavelength, "m", "L")
      .key("alpha_1", &W::alpha_1, "", "of Goda's formula")
      .key("alpha_2", &W::alpha_2, "", "of Goda's formula")
      .key("alpha_I", &W::alpha_I, "", "as its formula says, negative or not")
      .key("alpha_star", &W::alpha_star, "", "alpha*")
      .key("eta_star", &W::eta_star, "m", "eta*")
      .key("p1", &W::p1, "Pa", "p_1, with alpha*")
      .key("p3", &W::p3, "Pa", "p_3, with alpha*")
      .key("p4", &W::p4, "Pa", "p_4, with alpha*")
      .key("pu", &W::pu, "Pa", "p_u")
      .key("force", &W::force, "N/m", "P, with alpha*, as `waves` gives it")
      .key("force_moment", &W::force_moment, "N m/m", "of P about the bottom's level")
      .key("uplift", &W::uplift, "N/m", "U, as `waves` gives it")
      .key("peak", &W::peak, "N/m", "largest P of the load, with its factor")
      .key("trough_force", &W::trough_force, "N/m", "least P of a standing wave, seaward; null of other courses")
      .key("peak_uplift", &W::peak_uplift, "N/m",
           "largest U of `[sliding.uplift]` of kind wave, with the load's factor")
      .key("rise", &W::rise, "s", "of the impulsive part; of a sine that of the whole")
      .key("duration", &W::duration, "s", "of the impulsive part; of a sine that of the whole")
      .key("standing_force", &W::standing_force, "N/m", "peak of the slow part, gamma P_1; 0 where there is none")
      .key("impulse", &W::impulse, "N s/m", "integral of P over the course")
      .key("end", &W::end, "s", "when the course is over")
      .key("peak_over_goda", &W::peak_over_goda, "",
           "`peak` over P by Goda's formulas with alpha*; a load below 1 is milder than what `waves` has; null where "
           "that "
           "P is 0")
      .keys_of(&W::stability, stability_outputs())
      .key("sliding_exact", &W::sliding, "m",
           "S of Goda's P with alpha* by eqs. (4), (6), tau_0 = k(alpha*) tau_0F: by formulas, without the ground")
      .key("sliding_combined", &W::sliding_combined, "m",
           "the same with the standing wave besides the pulse, by `[combined]`, as `waves` has it")
      .object("standing", inner(&W::standing, &StandingResult::answer), standing_outputs(),
              "the standing wave of finite height before the wall; null where there is none")
      .key("why_no_standing", inner(&W::standing, &StandingResult::why_not), "", "why; empty where there is one")
      .object("trough_bound", inner(&W::standing, &StandingResult::bound), trough_bound_outputs(),
              "a bound of the trough, after Sainflou (1928), where there is none; null where there is one")
      .object("impact", &W::impact, impact_outputs(),
              "by PROVERBS, without the load's factor; null unless `force = \"proverbs\"`")
      .key("direction", &W::direction, "degrees", "from which it comes, from north; null where `angle` is given")
      .key("assumptions[]", &W::assumptions, "", "what the load rests on, in words");
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
