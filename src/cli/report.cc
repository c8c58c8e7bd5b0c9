#include "cli/report.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "base/text.h"
#include "case/case_findings.h"
#include "case/case_run.h"
#include "case/cfd/flow_scene.h"
#include "case/wave_load.h"
#include "fem/compile.h"
#include "findings/find.h"
#include "findings/topics.h"
#include "model/words.h"
#include "output/checks.h"
#include "output/output_text.h"
#include "response/time_choice.h"
#include "run/contact/reduced_ground.h"
#include "run/yielding_extent.h"

namespace upbead {

namespace {

/// "a, b and 3 others"
std::string first_of(const std::vector<std::string>& list, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, list.size()); ++i) text += (i > 0 ? ", " : "") + list[i];
  return text + (list.size() > most ? " and " + std::to_string(list.size() - most) + " others" : "");
}

std::string regions_text(const Case& input, const Simulation& simulation) {
  std::string text;
  for (const Decision& decision : simulation.decisions()) {
    const std::string& name = decision.region;
    if (name.empty()) continue;
    const std::string kind = word_of(input.scene.regions.at(name).kind, region_kind_words);
    std::string line = kind + (decision.value == kind ? "" : ", " + decision.value) +
                       (decision.key == "flow" ? " flow: " : ": ") + decision.why;
    for (const Body& body : simulation.compiled()->bodies)
      if (body.region == name)
        line += format(", %.5g kg/m, centre of gravity (%.4g, %.4g) m, inertia %.4g kg m2/m", body.mass, body.centre[0],
                       body.centre[1], body.moment_of_inertia);
    text += format("  %-12s ", name.c_str()) + line + "\n";
  }
  return text;
}

/// Largest velocity of a motion, and whether the boundary itself moves so or waves arrive from below through it.
std::string motion_text(const Load& load, const Scene& scene) {
  const bool arrives = scene.boundaries.at(load.boundary).displacement == DisplacementCondition::absorbing;
  const double up = extremum(load.history, 0., scene.time.end, 1).value;
  const double down = extremum(load.history, 0., scene.time.end, -1).value;
  const std::string what = arrives ? "waves from below '" + load.boundary + "', by the motion of its outcrop"
                                   : "moves '" + load.boundary + "'";
  return format("%s: at most %.4g m/s", what.c_str(),
                std::max(up, -down) * std::hypot(load.direction[0], load.direction[1]));
}

std::string loads_text(const Simulation& simulation) {
  std::string text;
  for (const LoadOnCaisson& load : simulation.compiled()->loads_on_caisson) {
    std::string line = format("  %-12s ", load.name.c_str());
    const auto written = simulation.given().loads.find(load.name);
    if (written != simulation.given().loads.end() && is_motion(written->second.kind)) {
      text += line + motion_text(written->second, simulation.given()) + "\n";
      continue;
    }
    const double largest = std::max(std::abs(load.force_x), std::abs(load.force_y));
    if (const auto arm = load.arm())
      line += format("arm %.4g m above the caisson's bottom, F_x = %.4g per unit, F_y = %.4g", *arm,
                     without_round_off(load.force_x, largest), without_round_off(load.force_y, largest));
    else
      line += simulation.compiled()->caisson ? "no horizontal force on the caisson" : "no caisson to act on";
    text += line + "\n";
  }
  return text;
}

std::string text_of(const MeshAccuracy& accuracy) {
  std::string text = "adapted     unknowns (error of the history of F_T, of its peak):";
  for (const auto& [unknowns, error] : accuracy.levels)
    text += format(" %d (%.2g, %.2g)", unknowns, error.history, error.peak);
  return text + "\n";
}

constexpr std::size_t most_checks = 8, most_regions = 8, most_loads = 3;

/// "caisson rigid, mound porous drained, seabed porous inertial"
std::string list_of_regions(const Case& input, const Simulation& simulation) {
  std::vector<std::string> list;
  for (const Decision& decision : simulation.decisions()) {
    if (decision.region.empty() || decision.key == "damping") continue;
    const std::string kind = word_of(input.scene.regions.at(decision.region).kind, region_kind_words);
    list.push_back(decision.region + " " + kind + (decision.value == kind ? "" : " " + decision.value));
  }
  return first_of(list, most_regions);
}

/// "impulse (arm 0.4 m), tail (no horizontal force)"
std::string list_of_loads(const Simulation& simulation) {
  std::vector<std::string> list;
  for (const LoadOnCaisson& load : simulation.compiled()->loads_on_caisson) {
    const auto arm = load.arm();
    list.push_back(load.name + (arm ? " (arm " + significant(*arm, 3) + " m)" : ""));
  }
  return list.empty() ? "none" : first_of(list, most_loads);
}

/// Those with a limit; the others are in the summary.
Checks with_a_limit(const Checks& checks) {
  Checks list;
  for (const Check& check : checks)
    if (check.holds) list.push_back(check);
  return list;
}

/// What the ground under contact node by node is, where the case asks for a reduced model.
std::string ground_text(const Simulation& simulation) {
  if (simulation.scene().time.scheme != TimeScheme::reduced) return "";
  const std::string why = why_ground_is_whole(simulation);
  return why.empty() ? ", on a reduced ground if nested models of it agree" : "; the ground is marched whole: " + why;
}

std::string error_of(const std::optional<double>& error) {
  return error ? " (wrong by up to " + with_unit(*error, "m") + ")" : "";
}

/// P, F_T, their ratio, x_G and the error of F_T.
std::string forces_of(const Summary& s) {
  const ShearResponse& r = *s.response;
  const bool seaward = -r.peak_force_seaward > r.peak_force;  // as the ratio
  const double shear = seaward ? r.peak_shear_seaward : r.peak_shear;
  const double shear_time = seaward ? r.peak_shear_seaward_time : r.peak_shear_time;
  const double force = seaward ? r.peak_force_seaward : r.peak_force;
  const double force_time = seaward ? r.peak_force_seaward_time : r.peak_force_time;
  std::string text = "F_T / P     " +
                     (r.shear_to_force_ratio ? significant(*r.shear_to_force_ratio, 4)
                                             : std::string("none: no horizontal force acts")) +
                     (is_solved_with_friction(s) ? ", with friction node by node" : "") + ": F_T " +
                     with_unit(shear, "N/m", std::abs(force)) + " at " + significant(shear_time, 4) + " s, P " +
                     with_unit(force, "N/m") + " at " + significant(force_time, 4) + " s\n";
  text += "x_G         " + with_unit(r.largest_displacement, "m") + " at " +
          significant(r.largest_displacement_time, 4) + " s, " +
          (seaward ? "landward F_T " + with_unit(r.peak_shear, "N/m", std::abs(force))
                   : "seaward F_T " + with_unit(r.peak_shear_seaward, "N/m", force)) +
          "\n";
  if (s.error)
    text += "error       up to " + percent(s.error->total()) + " of peak F_T, " + percent(s.history_error->total()) +
            " of it at any time\n";
  return text;
}

/// "moves 78 mm landward"
std::string moved(double landward) {
  return "moves " + with_unit(std::abs(landward), "m") + (landward < 0. ? " seaward" : " landward");
}

/// "settles 78 mm, tilts 1:157 landward", as surveyors write a tilt; less than 1:100,000 is none that they see.
std::string settled(double down, double rotation) {
  constexpr double seen = 1e-5;
  const std::string tilt = std::abs(rotation) < seen
                               ? std::string("does not tilt")
                               : "tilts 1:" + std::to_string(std::lround(1. / std::abs(rotation))) +
                                     (rotation < 0. ? " seaward" : " landward");
  return (down < 0. ? "rises " : "settles ") + with_unit(std::abs(down), "m") + ", " + tilt;
}

std::string periods_of(const std::vector<NaturalPeriod>& periods) {
  std::vector<std::string> list;
  for (const NaturalPeriod& p : periods)
    list.push_back(significant(p.period) + " s (" + percent(p.share) + " of F_T, damping " + percent(p.damping_ratio) +
                   ")");
  return "periods     " + first_of(list, 2) + "\n";
}

/// All that `explain` says.
struct Explained {
  const Case* input;
  const Simulation* simulation;
  NumberedWarnings told;
  std::vector<RecordSummary> records;
  std::vector<GaugeSummary> gauges;
  std::vector<FlowSummary> flows;
  std::vector<WaveLoadSummary> waves;
  std::vector<Skipped> skipped;
  YieldingExtent yielding;
};

/// What was chosen for each region, and why.
Json regions(const Explained& e) {
  Json json = Json::object();
  for (const Decision& decision : e.simulation->decisions())
    if (!decision.region.empty()) json[decision.region] = {{decision.key, decision.value}, {"why", decision.why}};
  return json;
}

OutputSchema<RecordSummary> record_outputs() {
  using R = RecordSummary;
  return OutputSchema<R>()
      .key("of", &R::of, "", "key of the case that it belongs to")
      .key("file", &R::file, "", "its file")
      .key("column", &R::column, "", "its column")
      .key("unit", &R::unit, "", "unit that was taken, and how it is known where not by the header")
      .key("layout", &R::layout, "", "separator, decimal sign and header of the file")
      .key("samples", &R::samples, "", "how many")
      .key("begin", &R::begin, "s", "first time, in the run's time")
      .key("interval", &R::interval, "s", "between samples, mean")
      .key("extreme", &R::extreme, "", "largest value by magnitude, as the file has it")
      .key("extreme_time", &R::extreme_time, "s", "when, in the run's time")
      .key("extreme_unit", &R::si, "", "SI unit of `extreme`");
}

const OutputSchema<Explained>& explained_outputs() {
  using E = Explained;
  const auto size =
      OutputSchema<Simulation>()
          .key(
              "cells", [](const Simulation& s) { return s.mesh()->triangulation.n_active_cells(); }, "", "cells")
          .key(
              "unknowns", [](const Simulation& s) { return s.system().n_free(); }, "", "unknowns")
          .key("degree", inner(&Simulation::space, &Space::degree), "", "degree of the displacement");
  const auto yielding =
      OutputSchema<YieldingExtent>()
          .key("cells", &YieldingExtent::cells, "", "cells that may yield")
          .key("area", &YieldingExtent::area, "m2", "of them")
          .key("cells_that_deform", &YieldingExtent::of, "", "all of them, whether they may yield or not")
          .list("linear[]", &YieldingExtent::linear, skipped_outputs(), "each region that is linear, and why");
  static const auto schema =
      OutputSchema<E>()
          .key("title", inner(&E::input, &Case::scene, &Scene::title), "", "that of the case")
          .object("discretisation", &E::simulation, size, "how the scene would be solved")
          .key("regions.NAME", regions, "", "`flow` or `kind` as chosen, and `why`")
          .named(
              "loads.NAME", [](const E& e) -> auto& { return e.simulation->compiled()->loads_on_caisson; },
              &LoadOnCaisson::name, load_outputs(), "resultant on the caisson per unit of the history")
          .named("flows.NAME", &E::flows, &FlowSummary::name, flow_outputs(), "of a load [from a CFD program](cfd.md)")
          .list("records[]", &E::records, record_outputs(), "how each column of the [files](records.md) was read")
          .named("gauges.NAME", &E::gauges, &GaugeSummary::name, gauge_outputs(),
                 "of a load by [transducers](records.md), or `sliding.uplift`")
          .named("wave_loads.NAME", &E::waves, &WaveLoadSummary::name, wave_load_outputs(),
                 "of a load by a [wave](waves.md#a-wave-as-a-load-of-a-run)")
          .object("yielding", &E::yielding, yielding, "[soil that yields](yielding.md)")
          .list("skipped[]", &E::skipped, skipped_outputs(), "what would be left out")
          .list("warnings[]", &E::told, warning_outputs(), "[what may be wrong](warnings.md) and needs no solution");
  return schema;
}

}  // namespace

std::vector<OutputRow> rows_of_explain() {
  return explained_outputs().rows();
}

Json explanation(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& measured,
                 const NumberedWarnings& told) {
  const bool is_reduced = choose_scheme(simulation.scene(), *simulation.compiled()).scheme == TimeScheme::reduced;
  return explained_outputs().to_json({&input, &simulation, told, record_summaries(input, measured),
                                      gauge_summaries(input, simulation), flow_summaries(input), wave_summaries(input),
                                      skipped(input, simulation, is_reduced), yielding_extent(simulation)});
}

std::string details(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& measured) {
  std::string text = input.scene.title + "\n";
  text += format("mesh        %d cells of degree %d, %d unknowns (%d of them relative fluid displacements)\n",
                 static_cast<int>(simulation.mesh()->triangulation.n_active_cells()), simulation.space()->degree(),
                 simulation.unknowns()->n_free(), [&] {
                   int n = 0;
                   for (const IndexRange& block : simulation.unknowns()->blocks()) n += block.size();
                   return n;
                 }());
  if (const int n = simulation.mesh()->n_high_order; n > 0)
    text += format("            %d cells of second or higher order, read by their corners\n", n);
  if (simulation.processes())
    text += format("            divided among %d processes\n", simulation.processes()->count());
  if (simulation.accuracy()) text += text_of(*simulation.accuracy());
  text += "regions\n" + regions_text(input, simulation);
  text += "loads\n" + loads_text(simulation);
  const SchemeChoice choice = choose_scheme(simulation.scene(), *simulation.compiled());
  text += "in time     " + word_of(choice.scheme, time_scheme_words) + ": " + choice.reason +
          (choice.solves.empty() ? "" : "; " + choice.solves) + "\n";
  if (!input.why_end.empty())
    text += "            until " + significant(simulation.given().time.end) + " s, " + input.why_end + "\n";
  if (!simulation.scene().construction.empty())
    text += "built       " + join(stages_in_order(simulation.scene()), ", then ") + "; each stage drained\n";
  if (simulation.system().interface)
    text += "contact     friction " + significant(contact_friction(simulation.scene())) + " at " +
            std::to_string(simulation.system().interface->n_nodes()) +
            " nodes; followed where the bonded caisson would slip or lift at one of them" + ground_text(simulation) +
            "\n";
  return text + text_of(explanation(input, simulation, measured), rows_of_explain(),
                        {"records", "flows", "gauges", "wave_loads", "yielding", "skipped"});
}

std::string brief(const Case& input, const Simulation& simulation) {
  std::string text = input.scene.title + "\n" +
                     format("mesh        %d cells of degree %d, %d unknowns: ",
                            static_cast<int>(simulation.mesh()->triangulation.n_active_cells()),
                            simulation.space()->degree(), simulation.unknowns()->n_free()) +
                     list_of_regions(input, simulation) + "\n";
  text += "loads       " + list_of_loads(simulation) + "; until " + significant(simulation.given().time.end) + " s\n";
  const SchemeChoice choice = choose_scheme(simulation.scene(), *simulation.compiled());
  return text + "in time     " + word_of(choice.scheme, time_scheme_words) + ": " + choice.reason + "\n";
}

/// S, and where the caisson has not come to rest that this is not all of it.
std::string how_far(const DesignSliding& design) {
  const std::string S = with_unit(design.value, "m");
  if (!design.rests) return "without bound, " + S + " till the end";
  return design.why_not_all.empty() ? S : "at least " + S + ", it still slides at the end,";
}

std::string brief(const Summary& s) {
  std::string text;
  if (s.verdict) text += verdict_text(*s.verdict, with_a_limit(s.checks), most_checks);
  if (!s.why_void.empty()) text += "VOID        " + s.why_void + "\n";
  if (const int refused = static_cast<int>(s.ladder.size()) - 1; refused > 0)
    text += "solved by   " + s.ladder.back().way + ", after " + std::to_string(refused) +
            (refused == 1 ? " way was" : " ways were") + " refused\n";
  if (s.response) text += forces_of(s);
  if (s.sliding || is_solved_with_friction(s)) {
    const DesignSliding design = s.sliding ? s.sliding->design : design_by_nodes(*s.contact);
    text += "S           " + how_far(design) + error_of(design.error_estimate) + " by " + design.measure + "\n";
  }
  if (s.residual)
    text += "at rest     " + moved(s.residual->displacement_x) + ", " +
            settled(-s.residual->displacement_y, s.residual->rotation) + "\n";
  if (s.construction && s.construction->caisson)
    text += "before      " + settled(s.construction->caisson->settlement, s.construction->caisson->rotation) +
            ", since it was set down and in no number above\n";
  if (!s.periods.empty()) text += periods_of(s.periods);
  return text + format("time        %.2f s; --details prints all else, summary.json has it\n", s.timing.total);
}

std::string details(const Summary& summary) {
  return text_of(summary_outputs().to_json(summary), summary_outputs().rows());
}

}  // namespace upbead
