// What presses on the base: edges, eccentricity, overturning, lift.
#include <algorithm>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/caisson/bottom.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "findings/effective_base.h"
#include "findings/load_places.h"
#include "findings/topics.h"
#include "output/limits.h"

namespace upbead {

namespace {

/// Finds the largest effective stress of a node of the base: its change, added to linear stresses at rest.
void look_at_nodes(const Simulation& simulation, const EffectiveBase& base, const Series& series,
                   BaseSummary& summary) {
  const System& system = simulation.system();
  if (!simulation.scene().base_stress) return;
  const std::vector<InterfaceNode> nodes = interface_nodes(*simulation.space());
  for (std::size_t r = 0; r < system.readings.size(); ++r) {
    const ReadingName& name = system.readings[r].name;
    if (name.group != base_group || name.quantity != "normal_stress") continue;
    Eigen::Index t = 0;
    const double x = nodes[static_cast<std::size_t>(name.node)].position, B = base.width;
    const double rest = base.weight / B +
                        12. * base.weight_moment * (x - simulation.compiled()->caisson->bottom_centre[0]) / (B * B * B);
    const double stress = rest + series.reading.row(static_cast<Eigen::Index>(r)).maxCoeff(&t);
    if (summary.peak_computed_pressure && stress <= *summary.peak_computed_pressure) continue;
    summary.peak_computed_pressure = stress;
    summary.peak_computed_pressure_at = x;
    summary.peak_computed_pressure_time = series.time[static_cast<std::size_t>(t)];
  }
}

void look_at_nodes(const ContactHistory& contact, BaseSummary& summary) {
  const std::size_t n = contact.position.size();
  for (std::size_t i = 0; i < contact.normal_force.size(); ++i) {
    const double stress = contact.normal_force[i] / contact.length[i % n];
    if (summary.peak_computed_pressure && stress <= *summary.peak_computed_pressure) continue;
    summary.peak_computed_pressure = stress;
    summary.peak_computed_pressure_at = contact.position[i % n];
    summary.peak_computed_pressure_time = contact.time[i / n];
  }
}

/// Where friction was followed, an edge parts from the mound where its node opens, not where a straight line of stress
/// ends.
void set_lifting(const NodeContact& contact, BaseSummary& base) {
  base.lifts_time = contact.first_open;
  base.lifts = !contact.first_open                                   ? ""
               : contact.least_contact <= 0.                         ? "all"
               : contact.opening_seaward >= contact.opening_landward ? "seaward"
                                                                     : "landward";
}

/// A base that is followed node by node turns about its edge where a bonded one would pull: its reaction stays on the
/// base, so that the margin by it is never below 1. The loads without motion tell whether it overturns: at the times
/// when one edge bears all, and when the run ends, as these stay.
void look_at_loads_on_edge(const EffectiveBase& base, const EffectiveBase& still, const std::vector<double>& time,
                           BaseSummary& summary) {
  EffectiveBase on_edge = still;
  std::vector<double> when = time;
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const EdgePressures edges = edge_pressures(base.force[i], base.moment[i], base.width);
    if (!edges.landward || !edges.seaward || i + 1 == time.size()) asked.push_back(i);
  }
  const auto keep = [&asked](std::vector<double>& values) {
    if (values.empty()) return;
    for (std::size_t n = 0; n < asked.size(); ++n) values[n] = values[asked[n]];
    values.resize(asked.size());
  };
  for (auto* of : {&on_edge.force, &on_edge.moment, &on_edge.uplift, &on_edge.uplift_moment, &on_edge.vertical,
                   &on_edge.vertical_moment, &when})
    keep(*of);
  const BaseExtremes loads = base_extremes(on_edge, when);
  std::optional<double> margin = loads.least_overturning_margin;
  const bool leaves = !loads.peak_heel_pressure || !loads.peak_toe_pressure;
  const bool by_uplift = leaves && !(margin && *margin < 1.);  // without a wave that overturns
  if (by_uplift) margin = 0.;
  if (!margin || *margin >= above_all(summary.least_overturning_margin)) return;
  summary.least_overturning_margin = margin;
  summary.least_overturning_margin_time = by_uplift ? when.front() : loads.least_overturning_margin_time;
}

std::optional<BaseSummary> find_base(const Evidence& e) {
  const std::optional<EffectiveBase>& base = e.of(find_effective_base);
  if (!base) return std::nullopt;
  const Series& series = e.of(find_history).series;
  BaseSummary s{base_extremes(*base, series.time), {}, {}, {}, {}, 0., 0., e.scene.limits.dynamic_base_pressure};
  const EffectiveBase still = loads_alone(e.simulation, *base, series);
  const BaseExtremes at_rest = base_extremes(still, series.time);
  s.static_heel_pressure = at_rest.peak_heel_pressure;
  s.static_toe_pressure = at_rest.peak_toe_pressure;
  s.static_overturning_margin = at_rest.least_overturning_margin;
  const auto& contact = e.solution.contact;
  if (contact && contact->history)
    look_at_nodes(*contact->history, s);
  else
    look_at_nodes(e.simulation, *base, series, s);
  if (contact && contact->found.solved) {
    set_lifting(*contact->found.solved, s);
    look_at_loads_on_edge(*base, still, series.time, s);
  }
  return s;
}

/// Warning would_lift: an edge of a bonded caisson is in tension, by its effective stress N'/B - 6 |M'|/(1.26 B^2).
/// N' = W' + change of the normal force - U, M' = W' e + base moment + moment of U, where U is that of the modelled
/// pore pressure and e is how far W' acts landward of the bottom's middle. W' is that of [sliding] minus a prescribed
/// uplift, or the mass minus the water that the caisson displaces below still water; without either there is no
/// warning.
NumberedWarnings lift_warnings(const Evidence& e) {
  const std::optional<EffectiveBase>& base = e.of(find_effective_base);
  if (e.solution.contact || !base) return {};
  const EdgeStress least = least_edge_stress(*base, e.of(find_history).series.time);
  if (least.stress >= 0.) return {};
  return {{"would_lift", least.stress, 0., "Pa", lifts_text(least),
           e.scene.regions.at(caisson_name).springs
               ? "believe the springs only up to then, or mesh the ground with [regions.caisson.interface] kind = "
                 "\"friction\""
               : "write [regions.caisson.interface] kind = \"friction\""}};
}

/// Warning base_pressure: an edge has a larger pressure in motion than the case allows.
NumberedWarnings pressure_warnings(const std::optional<BaseSummary>& base) {
  if (!base || !base->limit) return {};
  const bool heel = above_all(base->peak_heel_pressure) >= above_all(base->peak_toe_pressure);
  const std::optional<double>& largest = heel ? base->peak_heel_pressure : base->peak_toe_pressure;
  if (largest && *largest <= *base->limit) return {};
  return {{"base_pressure", largest.value_or(0.), *base->limit, largest ? "Pa" : "",
           std::string("the ") + (heel ? "heel" : "toe") + " presses with " +
               (largest ? with_unit(*largest, "Pa") : "more than can be computed, as the resultant leaves the base,") +
               " at " + significant(heel ? base->peak_heel_pressure_time : base->peak_toe_pressure_time) +
               " s, more than limits.dynamic_base_pressure",
           "widen the caisson, or spread its weight seaward"}};
}

/// Warning rocks_on_edge where the reaction stays on ground that gives way, though the loads overturn the caisson.
NumberedWarnings overturning_warnings(const BaseSummary& base, const NodeContact& contact) {
  if (!contact.first_open || !(base.static_overturning_margin.value_or(1.) < 1.)) return {};
  const double opening = std::max(contact.opening_seaward, contact.opening_landward);
  return {{"rocks_on_edge", opening, 0., "m",
           "the loads without motion overturn the caisson, by a margin of " +
               significant(*base.static_overturning_margin, 4) + ", and an edge lifts by up to " +
               with_unit(opening, "m") +
               ": the reaction of ground that gives way stays on the base, so that the margin "
               "against overturning in motion, " +
               significant(base.least_overturning_margin.value_or(0.), 4) +
               ", tells only that these loads are too short to turn it over",
           "judge by base.static_overturning_margin where the loads may last; widen the caisson, or make it heavier"}};
}

/// Warning rocks_on_edge: a caisson that is followed node by node stands on one edge of its base alone, or on none.
NumberedWarnings rocking_warnings(const Summary& summary) {
  if (!summary.base || !is_solved_with_friction(summary)) return {};
  const BaseSummary& base = *summary.base;
  const NodeContact& contact = *summary.contact->solved;
  if (base.peak_heel_pressure && base.peak_toe_pressure) return overturning_warnings(base, contact);
  const bool heel = !base.peak_heel_pressure;
  const double opening = heel ? contact.opening_seaward : contact.opening_landward;
  if (contact.least_contact == 0.)
    return {{"rocks_on_edge", std::max(contact.opening_seaward, contact.opening_landward), 0., "m",
             "the whole bottom lifts from the ground, from " + significant(*contact.first_open) +
                 " s on at one end: what presses on the ground when it comes down is not known, and neither is S",
             "make the caisson heavier, or let less uplift act", true}};
  return {{"rocks_on_edge", opening, 0., "m",
           std::string("at ") + significant(heel ? base.peak_heel_pressure_time : base.peak_toe_pressure_time) +
               " s the caisson stands on its " + (heel ? "landward" : "seaward") +
               " edge alone and turns about it; the other edge lifts by up to " + with_unit(opening, "m") +
               ", and rotations are taken as small",
           "look at the margin against overturning; widen the caisson, or make it heavier"}};
}

NumberedWarnings base_warnings(const Evidence& e, const Summary& summary) {
  NumberedWarnings list = lift_warnings(e);
  append(list, rocking_warnings(summary));
  append(list, pressure_warnings(summary.base));
  return list;
}

/// p_e without motion, for which the limit of practice was made: by Goda's formulas of loads by waves, else of the
/// loads as they act on the caisson.
Checks bearing_checks(const Scene& scene, const BaseSummary& base, bool elsewhere) {
  Checks list;
  const auto add = [&](FailureMode mode, const std::string& edge, const std::optional<double>& pressure) {
    Check check =
        check_of(mode, edge + " pressure p_e of the loads", "Pa", pressure, "base.static_" + edge + "_pressure",
                 about_uplift(scene) +
                     "; the loads without motion: Goda's p_e where the load is Goda's, more "
                     "than that where it is the peak of an impact");
    check.by = "statics";
    check = held_to(check, scene.limits, &Limits::base_pressure);
    if (is_shaken(scene))
      check = not_checked(check, "a motion shakes the ground, and nothing of it acts at rest");
    else if (elsewhere)
      check = not_checked(check,
                          "a load acts on the sea or the ground: what of it comes to the caisson is known in motion "
                          "alone, see limits.dynamic_base_pressure");
    list.push_back(check);
  };
  add(FailureMode::heel_pressure, "heel", base.static_heel_pressure);
  add(FailureMode::toe_pressure, "toe", base.static_toe_pressure);
  return list;
}

/// Whether checks by formulas know all loads that act: each is of one wave.
bool formulas_know_all(const Scene& scene, const Summary& summary) {
  return std::all_of(scene.loads.begin(), scene.loads.end(), [&](const auto& entry) {
    const auto is_of_it = [&](const Check& check) { return check.wave == entry.first; };
    return entry.second.factor == 0. ||
           std::any_of(summary.formula_checks.begin(), summary.formula_checks.end(), is_of_it);
  });
}

Checks base_checks(const Scene& scene, const Summary& summary) {
  if (!summary.base) return {};
  Checks list;
  const BaseSummary& base = *summary.base;
  const std::string linear = about_uplift(scene) +
                             "; of a moment in motion, effective stress linear over the width in contact: not the p_e "
                             "for which limits of bearing pressure are made";
  const auto limit = &Limits::dynamic_base_pressure;
  list.push_back(held_to(check_of(FailureMode::heel_pressure, "heel pressure in motion", "Pa", base.peak_heel_pressure,
                                  "base.peak_heel_pressure", linear),
                         scene.limits, limit));
  list.push_back(held_to(check_of(FailureMode::toe_pressure, "toe pressure in motion", "Pa", base.peak_toe_pressure,
                                  "base.peak_toe_pressure", linear),
                         scene.limits, limit));
  if (base.least_overturning_margin) {
    Check margin = check_of(FailureMode::overturning, "margin against overturning", "", base.least_overturning_margin,
                            "base.least_overturning_margin", about_uplift(scene) + "; a rigid base");
    margin.has_rival = true;
    margin = held_to(margin, scene.limits, &Limits::overturning);
    const auto& still = base.static_overturning_margin;
    if (is_solved_with_friction(summary) && margin.capacity && still && *still < *margin.capacity)
      margin = in_doubt(margin, "the loads without motion have " + significant(*still, 4) +
                                    " at their worst, below the limit: the reaction of a base that opens stays on it, "
                                    "so that " +
                                    significant(*margin.demand, 4) + " of the motion does not tell");
    list.push_back(margin);
  }
  if (summary.formula_checks.empty() || !formulas_know_all(scene, summary))
    append(list, bearing_checks(scene, base, summary.loads_elsewhere));
  return list;
}

OutputSchema<BaseSummary> base_outputs() {
  using B = BaseSummary;
  return OutputSchema<B>()
      .key("heel_pressure_at_rest", &B::heel_pressure_at_rest, "Pa", "of the landward edge, before the wave")
      .key("toe_pressure_at_rest", &B::toe_pressure_at_rest, "Pa", "of the seaward edge, before the wave")
      .key("eccentricity_at_rest", &B::eccentricity_at_rest, "m", "of W', landward of the middle")
      .key(
          "peak_heel_pressure", &B::peak_heel_pressure, "Pa",
          "largest pressure of the landward edge in motion; null where the resultant leaves the base there: a bonded "
          "base pulls, a real one overturns or rocks. It is not the p_e for which limits of bearing pressure are made: "
          "that is in `checks`, by formulas")
      .key("peak_heel_pressure_time", &B::peak_heel_pressure_time, "s", "when, or when the resultant first leaves")
      .key("peak_toe_pressure", &B::peak_toe_pressure, "Pa", "the same of the seaward edge")
      .key("static_heel_pressure", &B::static_heel_pressure, "Pa",
           "largest pressure of the landward edge under the loads without motion: Goda's p_e where the load is Goda's; "
           "null where their resultant leaves the base")
      .key("static_toe_pressure", &B::static_toe_pressure, "Pa", "the same of the seaward edge")
      .key("static_overturning_margin", &B::static_overturning_margin, "",
           "least margin against overturning under the loads without motion; null where nothing overturns")
      .key("peak_toe_pressure_time", &B::peak_toe_pressure_time, "s", "when")
      .key("largest_eccentricity", &B::largest_eccentricity, "m", "e = M'/N' of largest magnitude, landward positive")
      .key("largest_eccentricity_time", &B::largest_eccentricity_time, "s", "when")
      .key("least_normal_force", &B::least_normal_force, "N/m", "least N'")
      .key("least_normal_force_time", &B::least_normal_force_time, "s", "when")
      .key("least_overturning_margin", &B::least_overturning_margin, "",
           "least of (moment of W' and of loads that act up or down alone - U)/(moment of all that the wave does), "
           "about the heel or the toe: Goda's safety "
           "factor against overturning where nothing moves, and with friction node by node while one edge bears all; "
           "null where nothing overturns")
      .key("least_overturning_margin_time", &B::least_overturning_margin_time, "s", "when")
      .key("lifts_time", &B::lifts_time, "s",
           "when an edge first has no pressure: from then on a base that cannot pull parts from its mound there, and "
           "one that is bonded pulls; with friction node by node when a node opens; null where both edges always press")
      .reason("lifts", &B::lifts, "which edge that is: `seaward`, `landward`, or `all`; null with it")
      .key("peak_computed_pressure", &B::peak_computed_pressure, "Pa",
           "largest effective stress under a node of the base, as solved; **no pressure to judge by**: at the edges of "
           "a "
           "rigid base it is singular and grows with finer cells; without friction node by node on stresses at "
           "rest that are linear, and without a prescribed uplift; null unless `output.base = true` or contact was "
           "solved")
      .key("peak_computed_pressure_at", &B::peak_computed_pressure_at, "m", "x of that node")
      .key("peak_computed_pressure_time", &B::peak_computed_pressure_time, "s", "when")
      .key("limit", &B::limit, "Pa",
           "of heel and toe pressure in motion, `limits.dynamic_base_pressure`; null where none is given");
}

}  // namespace

std::optional<EffectiveBase> find_effective_base(const Evidence& e) {
  return effective_base(e.simulation, e.of(find_history).series, e.solution.contact);
}

Finding base_finding() {
  Finding f;
  f.keys.object(
      "base", &Summary::base, base_outputs(),
      "[what presses on the base](contact.md#base-pressure): effective, stress varying linearly over the width "
      "in contact, in the rows of `/history`; null where neither `[sliding]` nor the water level gives W'");
  f.parts.emplace_back([](const Evidence& e, Summary& s) {
    const std::optional<ShearResponse>& response = e.of(find_shear);
    s.loads_elsewhere = response && acts_elsewhere(e.simulation, *response);
  });
  f.warnings = base_warnings;
  f.checks = base_checks;
  return f.part(&Summary::base, find_base);
}

}  // namespace upbead
