// What the bottom does node by node, where the caisson may slip and lift.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "findings/errors.h"
#include "findings/support_warnings.h"
#include "findings/topics.h"
#include "run/contact/contact_run.h"
#include "run/sliding/uplift.h"

namespace upbead {

namespace {

OutputSchema<BondedDemand> demand_outputs() {
  using D = BondedDemand;
  const auto slip = [](const D& d) { return std::isfinite(d.slip) ? std::optional(d.slip) : std::nullopt; };
  return OutputSchema<D>()
      .key("slip", slip, "", "largest abs(T) / (mu N); null where a node pulls")
      .key("least_normal", &D::least_normal, "", "least N over that at rest")
      .key("margin", &D::margin, "", "margin of both, for errors of a reduced model")
      .key("reached", &D::reached, "", "whether one of them comes to its limit within the margin");
}

OutputSchema<ContactGround> ground_outputs() {
  using G = ContactGround;
  return OutputSchema<G>()
      .key("coordinates", &G::coordinates, "", "coordinates of the ground, besides slip and opening of the nodes")
      .key("solves", &G::solves, "", "solves of all unknowns that it took to make it")
      .key("slip", &G::slip, "m", "error of `slip` by nested models")
      .key("peak_shear", &G::peak_shear, "", "error of peak F_T by nested models, relative")
      .key("history", &G::history, "", "error of F_T at any time by nested models, over its largest magnitude")
      .key("others", &G::others, "", "largest error of another reading by nested models, over its peak");
}

OutputSchema<NodeContact> solved_outputs() {
  using C = NodeContact;
  return OutputSchema<C>()
      .key("slip", &C::slip, "m", "mean over the bottom in the end, landward: S")
      .key("error_estimate", &C::error_estimate, "m",
           "upper bound of the error of `slip` by cells and steps; null where `response.error_estimate` is")
      .key("largest_slip", &C::largest_slip, "m", "largest slip on the way: mean over the bottom")
      .key(
          "least_slip", &C::least_slip, "m",
          "final slip of the node that slipped least: the bottom as a whole slid this far; slip beyond it is local, at "
          "edges that lift")
      .key("opening_seaward", &C::opening_seaward, "m", "largest opening of the seaward end")
      .key("opening_landward", &C::opening_landward, "m", "largest opening of the landward end")
      .key("least_contact", &C::least_contact, "", "least share of the bottom that touches: of its width")
      .key("least_normal_force", &C::least_normal_force, "N/m", "least normal force: sum of N")
      .key("first_slip", &C::first_slip, "s", "when a node first slips; null: never")
      .key("first_open", &C::first_open, "s", "when a node first opens; null: never")
      .key("lift_energy", &C::lift_energy, "J/m",
           "largest that the weight has gained by openings: what comes down again")
      .key("closing_speed", &C::closing_speed, "m/s", "largest speed at which an end of the bottom comes down; 0: none")
      .key("closing_time", &C::closing_time, "s", "when it does; null: neither end has opened and closed")
      .key("last_closing", &C::last_closing, "s",
           "since when the whole bottom touches again; null where no node opened, or one is open in the end")
      .key("open_in_end", &C::open_in_end, "", "share of the bottom that is open in the end: of its width")
      .key("gap_force", &C::gap_force, "N/m",
           "largest uplift that the sea in gaps adds to a prescribed one; null where gaps take water from the pores "
           "alone")
      .key("dissipated", &C::dissipated, "J/m", "energy taken by friction")
      .key("end_velocity", &C::end_velocity, "m/s",
           "slip velocity in the last step of the node that slips least; 0 where one rests")
      .key("slip_steps", &C::slip_steps, "", "steps in which a node slipped")
      .key("open_steps", &C::open_steps, "", "steps in which a node was open")
      .key("impacts", &C::impacts, "", "how often a node closed")
      .key("fallbacks", &C::fallbacks, "", "contact problems that were solved by the slower method")
      .object("ground", &C::ground, ground_outputs(),
              "the reduced ground on which contact was solved; null where all unknowns were marched");
}

OutputSchema<ContactSummary> contact_outputs() {
  using C = ContactSummary;
  return OutputSchema<C>()
      .key("friction", &C::friction, "", "mu")
      .key("weight", &C::weight, "N/m", "sum of N at rest")
      .key("nodes", &C::nodes, "", "nodes of the bottom")
      .object("glued", &C::demand, demand_outputs(), "how near the bonded caisson comes to slip or opening at any node")
      .object("solved", &C::solved, solved_outputs(),
              "slip and opening of the bottom; null where the bonded caisson slips and opens at no node");
}

/// Why the bonded solution obeys the law of contact, with the numbers.
std::string why_bonded(const ContactSummary& contact) {
  const std::string margin =
      contact.demand.margin > 0. ? ", which may err by " + percent(contact.demand.margin) : std::string();
  return "no node pulls or slips: |T| reaches " + percent(contact.demand.slip) + " of mu N, and N falls to " +
         percent(contact.demand.least_normal) + " of that at rest" + margin;
}

SkippedList skipped_nodes(const Evidence&, const Summary& summary) {
  if (!summary.contact || summary.contact->solved) return {};
  return {{"contact node by node", why_bonded(*summary.contact)}};
}

/// Warning reading_not_converged, of a reduced ground.
NumberedWarnings warnings_of_ground(const Summary& summary) {
  if (!summary.contact || !summary.contact->solved || !summary.contact->solved->ground) return {};
  const ContactGround& ground = *summary.contact->solved->ground;
  if (ground.inexact.empty()) return {};
  constexpr std::size_t most = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(most, ground.inexact.size()); ++i)
    names += (i > 0 ? ", " : "") + ground.inexact[i].name;
  if (ground.inexact.size() > most) names += " and " + std::to_string(ground.inexact.size() - most) + " more";
  return {{"reading_not_converged", ground.others, ground.tolerance_of_others, "1",
           "on the reduced ground S and F_T are within their tolerance, but " + names + " err by up to " +
               percent(ground.others) + " of their peaks",
           "write time.scheme = \"auto\" where these readings matter"}};
}

/// Warning no_settlement: a base lifts and comes down on ground that does not yield.
NumberedWarnings warnings_of_lift(const Evidence& e, const Summary& summary) {
  if (!is_solved_with_friction(summary) || !summary.contact->solved->first_open || yields(e.scene)) return {};
  const NodeContact& solved = *summary.contact->solved;
  const double lift = std::max(solved.opening_seaward, solved.opening_landward);
  const std::string down = solved.open_in_end > 0.
                               ? ", and is open over " + percent(solved.open_in_end) + " of its width when the run ends"
                               : ", with " + with_unit(solved.lift_energy, "J/m") + ", and comes down at up to " +
                                     with_unit(solved.closing_speed, "m/s");
  return {{"no_settlement", lift, 0., "m",
           "an edge of the base lifts by up to " + with_unit(lift, "m") + down +
               ": ground that is elastic keeps no settlement and no tilt of that, and stones do",
           "give the mound a law that yields, [regions.mound] law, or take settlement and tilt from tests"}};
}

/// Warning gap_without_pressure: the sea is to enter gaps, and no pressure of it is known.
NumberedWarnings warnings_of_gap(const Evidence& e, const Summary& summary) {
  if (!is_solved_with_friction(summary)) return {};
  const NodeContact& solved = *summary.contact->solved;
  if (!solved.first_open || solved.gap_force.value_or(1.) > 0.) return {};
  if (!uplift_loads(e.simulation, {}, {}).empty()) return {};  // gaps have its pressure
  for (const TimeFunction& foot : pressures_at_feet(e.simulation))
    if (extremum(foot, 0., e.scene.time.end, 1).value > 0.) return {};
  return {{"gap_without_pressure", std::max(solved.opening_seaward, solved.opening_landward), 0., "m",
           "the base lifts, but no load presses on a wall of the caisson at its foot: the sea enters the gap without "
           "pressure, and all is as with gap = \"pores\", which may be on the unsafe side",
           "let the load press on the wall (boundary, with a shape from the foot on) or prescribe the uplift "
           "([sliding.uplift])"}};
}

NumberedWarnings warnings_of_contact(const Evidence& e, const Summary& summary) {
  NumberedWarnings list = impact_warnings(e.solution);
  append(list, warnings_of_lift(e, summary));
  append(list, warnings_of_gap(e, summary));
  append(list, warnings_of_ground(summary));
  return list;
}

}  // namespace

std::optional<ContactSummary> find_contact(const Evidence& e) {
  if (!e.solution.contact) return std::nullopt;
  ContactSummary contact = e.solution.contact->found;
  if (contact.solved) contact.solved->error_estimate = e.of(find_errors).slip_of_nodes;
  return contact;
}

bool is_solved_with_friction(const Summary& summary) {
  return summary.contact && summary.contact->solved;
}

Finding contact_finding() {
  Finding f;
  f.keys = [](OutputSchema<Summary>& s) {
    s.object("contact", &Summary::contact, contact_outputs(),
             "[slip and uplift node by node](contact.md); null where the bottom is bonded");
  };
  f.warnings = warnings_of_contact;
  f.skipped = skipped_nodes;
  return f.part(&Summary::contact, find_contact);
}

}  // namespace upbead
