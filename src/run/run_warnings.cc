#include "run_warnings.h"

#include "base/text.h"
#include "contact/contact_demand.h"
#include "fem/compile.h"
#include "ladder.h"
#include "sliding/read_sliding.h"

namespace upbead {

namespace {

NumberedWarnings balance_warnings(const Run& run) {
  const std::optional<Mismatch> off = imbalance(*run.simulation, run);
  if (!off) return {};
  return {
      {"balance_loose", off->value, off->tolerable, "1",
       off->what + " by " + significant(off->value) + ", where " + significant(off->tolerable) +
           " is usual: large forces cancel in this scene and leave their round-off; F_T may err by up to " +
           significant(off->error, 2) + " of its largest value, motions by that part of what the loads would do " +
           "alone; look for stiffnesses or permeabilities far from all others, or give the water its bulk modulus"}};
}

NumberedWarnings loose_warnings(const Summary& summary) {
  NumberedWarnings list;
  if (!summary.reduction || summary.reduction->loose.empty()) return list;
  std::string names;
  for (const LooseReading& reading : summary.reduction->loose) names += (names.empty() ? "" : ", ") + reading.name;
  list.push_back({"reading_not_converged", summary.reduction->error_of_others, summary.reduction->tolerance_of_others,
                  "1",
                  "the reduced model that was asked for has F_T within its tolerance, but " + names +
                      " move by up to " + significant(summary.reduction->error_of_others) +
                      " of their peaks between nested models; write time.scheme = \"sdirk4\" where they matter"});
  return list;
}

}  // namespace

void tell(SceneWatch& watch, Run& run) {
  const Simulation& simulation = *run.simulation;
  Summary& summary = run.summary;
  summary.title = simulation.given.title;
  summary.soil = simulation.soil;
  summary.loads = simulation.compiled->loads_on_caisson;
  summary.skipped = skipped(simulation, summary.reduction.has_value());
  watch.tell(run);
  append(summary.warnings, loose_warnings(summary));
  append(summary.warnings, balance_warnings(run));
  if (summary.sliding) append(summary.skipped, skipped(*summary.sliding));
  if (summary.contact && !summary.contact->solved)
    summary.skipped.push_back({"contact node by node", why_glued(*summary.contact)});
}

std::vector<Skipped> skipped(const Simulation& simulation, bool reduced) {
  std::vector<Skipped> list;
  for (const Decision& decision : simulation.decisions)
    if (!decision.left_out.empty()) list.push_back({decision.left_out, decision.why});
  for (const auto& [name, load] : simulation.given.loads)
    if (load.factor == 0.) {
      list.push_back({"load " + name, "its factor is 0"});
    } else if (const auto& samples = load.history.samples(); !reduced && is_rough(load.history)) {
      list.push_back({"steps that meet the corners of load " + name,
                      "a rough record of " + std::to_string(samples.size()) +
                          " samples: F_T errs by some of its roughness (8 % for noise of 1 % measured); use "
                          "time.scheme = \"reduced\", smooth it, or give time.step = its sampling interval, " +
                          significant(samples[1] - samples[0]) + " s"});
    }
  if (!simulation.given.fields_every) list.push_back({"fields", "the case asks for none ([output] fields)"});
  if (!simulation.compiled->caisson) list.push_back({"shear force", "the mesh has no surface 'caisson'"});
  if (simulation.compiled->caisson && !has_strength(simulation.given))
    list.push_back({"strength of the soil", "no region has a table strength"});
  if (!simulation.given.time.inertia) list.push_back({"inertia", "[time] inertia = false: consolidation"});
  return list;
}

}  // namespace upbead
