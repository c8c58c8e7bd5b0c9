#include "findings/find.h"

#include <algorithm>

#include "findings/topics.h"
#include "output/checks.h"
#include "output/limits.h"

namespace upbead {

// A finding has a file of its own, and a row here.
Finding discretisation_finding();
Finding rest_finding();
Finding construction_finding();
Finding shear_finding();
Finding energy_finding();
Finding reduction_finding();
Finding strain_soil_finding();
Finding yielding_finding();
Finding densification_finding();
Finding periods_finding();
Finding contact_finding();
Finding sliding_finding();
Finding base_finding();
Finding circles_finding();
Finding cycles_finding();
Finding peak_safety_finding();
Finding liquefaction_finding();
Finding harbour_finding();
Finding strength_finding();
Finding cavitation_finding();
Finding plausibility_finding();
Finding mesh_plausibility_finding();
Finding scene_finding();
Finding ways_finding();

namespace {

const std::vector<Finding>& findings() {
  static const std::vector<Finding> rows{
      discretisation_finding(), rest_finding(),       construction_finding(), shear_finding(),
      energy_finding(),         reduction_finding(),  periods_finding(),      sliding_finding(),
      yielding_finding(),       base_finding(),       circles_finding(),      peak_safety_finding(),
      liquefaction_finding(),   cycles_finding(),     contact_finding(),      harbour_finding(),
      strength_finding(),       cavitation_finding(), scene_finding(),        densification_finding(),
      strain_soil_finding(),    ways_finding(),       plausibility_finding(), mesh_plausibility_finding()};
  return rows;
}

/// All of these and the others, which must outlive the list.
std::vector<const Finding*> with(const std::vector<Finding>& also) {
  std::vector<const Finding*> all;
  for (const std::vector<Finding>* list : {&findings(), &also})
    for (const Finding& finding : *list) all.push_back(&finding);
  return all;
}

/// What a slot of all findings gives, in one list.
template <class List, class... Given, class... Args>
List gather(const std::vector<const Finding*>& all, std::function<List(Given...)> Finding::*slot, const Args&... args) {
  List list;
  for (const Finding* finding : all)
    if (finding->*slot) append(list, (finding->*slot)(args...));
  return list;
}

bool is_by_formulas(const Check& check) {
  return check.by == "formulas";
}

/// What dynamics say of that which a check by formulas judges; null where they say nothing.
const Check* rival_of(const Check& formula, const Checks& checks) {
  const auto found = std::find_if(checks.begin(), checks.end(), [&formula](const Check& check) {
    return check.has_rival && !is_by_formulas(check) && check.mode == formula.mode;
  });
  return found != checks.end() && found->holds ? &*found : nullptr;
}

/// The keys of the lists that all findings add to.
void add_lists(OutputSchema<Summary>& keys) {
  using S = Summary;
  keys.list("checks[]", &S::checks, check_outputs(),
            "of the section by all routes: strength at rest, sliding, friction, pressure of heel and toe, overturning; "
            "but for the first empty without a "
            "caisson")
      .list("warnings[]", &S::warnings, warning_outputs(), "[what may be wrong](warnings.md) though nothing failed")
      .list("skipped[]", &S::skipped, skipped_outputs(), "each thing that was left out")
      .versions();
}

}  // namespace

OutputSchema<Skipped> skipped_outputs() {
  return OutputSchema<Skipped>()
      .key("what", &Skipped::what, "", "its name")
      .key("why", &Skipped::why, "", "why it was left out");
}

Checks checks_of(const Scene& scene, const Summary& summary, const std::vector<Finding>& also) {
  Checks all;
  for (const Finding* finding : with(also)) {
    if (!finding->checks) continue;
    Checks list = finding->checks(scene, summary);
    if (!summary.why_void.empty() && !finding->needs_no_march)
      for (Check& check : list) check = not_checked(check, "void: there is no state at rest, see no_rest");
    append(all, list);
  }
  append(all, unjudged_limits(scene.limits, all, true));
  return all;
}

NumberedWarnings route_warnings(const Checks& checks) {
  NumberedWarnings list;
  for (const Check& formula : checks) {
    if (!formula.has_rival || !is_by_formulas(formula) || !formula.holds) continue;
    const Check* dynamic = rival_of(formula, checks);
    if (!dynamic || *dynamic->holds == *formula.holds) continue;
    list.push_back({"routes_differ", formula.margin.value_or(0.), dynamic->margin.value_or(0.), "1",
                    "by formulas: " + text_of(formula) + "; by dynamics: " + text_of(*dynamic) +
                        ". These are two routes to one answer, and neither makes the other void: the worse governs",
                    "look at the peak of the load (peak_gain), its duration, the soils and mu before one of them is "
                    "believed"});
  }
  return list;
}

namespace {

Summary find(const Evidence& evidence, const std::vector<Finding>& also) {
  const std::vector<const Finding*> all = with(also);
  Summary summary;
  for (const Finding* finding : all)
    for (const auto& part : finding->parts) part(evidence, summary);
  std::optional<double> peak_time;
  if (summary.response) peak_time = summary.response->peak_shear_time;
  summary.warnings = gather(all, &Finding::of_scene, evidence.simulation, peak_time);
  append(summary.warnings, gather(all, &Finding::warnings, evidence, summary));
  summary.skipped = gather(all, &Finding::skipped_of_scene, evidence.simulation, summary.reduction.has_value());
  append(summary.skipped, gather(all, &Finding::skipped, evidence, summary));
  summary.checks = checks_of(evidence.scene, summary, also);
  append(summary.warnings, route_warnings(summary.checks));
  if (!summary.checks.empty()) summary.verdict = verdict_of(summary.checks, summary.warnings);
  return summary;
}

}  // namespace

Summary find(const Solution& solution, const std::function<void(double)>& progress, const std::vector<Finding>& also) {
  return find(Evidence(solution, progress), also);
}

Run run_of(Solution solution, const std::function<void(double)>& progress, const std::vector<Finding>& also) {
  Run run{std::move(solution), {}, {}};
  const Evidence evidence(run, progress);
  run.summary = find(evidence, also);
  run.history = evidence.of(find_history);
  return run;
}

Run Simulation::run(const RunOptions& options) const {
  return run_of(solve(*this, options), options.progress);
}

NumberedWarnings warnings(const Simulation& simulation, const std::vector<Finding>& also) {
  return gather(with(also), &Finding::of_scene, simulation, std::optional<double>());
}

std::vector<Skipped> skipped(const Simulation& simulation, bool reduced, const std::vector<Finding>& also) {
  return gather(with(also), &Finding::skipped_of_scene, simulation, reduced);
}

OutputSchema<Summary> keys_of(const std::vector<Finding>& also) {
  OutputSchema<Summary> keys;
  for (const Finding* finding : with(also)) keys.keys_of([](const Summary& s) { return &s; }, finding->keys);
  add_lists(keys);
  return keys;
}

}  // namespace upbead
