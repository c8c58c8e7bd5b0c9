#include "output/contact_outputs.h"

#include <cmath>

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
  const auto others = [](const G& g) { return g.tolerance_of_others > 0. ? std::optional(g.others) : std::nullopt; };
  return OutputSchema<G>()
      .key("coordinates", &G::coordinates, "", "coordinates of the ground, besides slip and opening of the nodes")
      .key("solves", &G::solves, "", "solves of all unknowns that it took to make it")
      .key("slip", &G::slip, "m", "error of `slip` by nested models")
      .key("peak_shear", &G::peak_shear, "", "error of peak F_T by nested models, relative")
      .key("history", &G::history, "", "error of F_T at any time by nested models, over its largest magnitude")
      .key("others", others, "", "largest error of another reading by nested models, over its peak; null in `respond`");
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

}  // namespace

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

}  // namespace upbead
