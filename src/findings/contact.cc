// What the bottom does node by node, where the caisson may slip and lift.
#include <algorithm>

#include "base/text.h"
#include "findings/errors.h"
#include "findings/support_warnings.h"
#include "findings/topics.h"
#include "output/contact_outputs.h"
#include "run/contact/contact_run.h"
#include "run/sliding/uplift.h"

namespace upbead {

namespace {

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
  f.keys.object("contact", &Summary::contact, contact_outputs(),
                "[slip and uplift node by node](contact.md); null where the bottom is bonded");
  f.warnings = warnings_of_contact;
  f.skipped = skipped_nodes;
  return f.part(&Summary::contact, find_contact);
}

}  // namespace upbead
