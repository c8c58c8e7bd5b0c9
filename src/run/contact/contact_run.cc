#include "run/contact/contact_run.h"

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "base/numbers.h"
#include "base/text.h"
#include "dynamics/contact.h"
#include "dynamics/gap_water.h"
#include "fem/compile.h"
#include "fem/static_stage.h"
#include "run/contact/contact_demand.h"
#include "run/contact/contact_recorder.h"
#include "run/contact/contact_room.h"
#include "run/contact/reduced_ground.h"
#include "run/derived.h"
#include "run/sliding/uplift.h"
#include "run/yielding_run.h"
#include "system/interface.h"
#include "system/part.h"
#include "upbead/base/error.h"
#include "upbead/dynamics/march.h"

namespace upbead {

namespace {

/// Linear stresses a + b x in equilibrium with the weight: sum l (a + b x) = W', sum l (a + b x) x = 0, x from the
/// point where the weight acts.
Vector linear_forces(const Interface& interface, const WeightInWater& caisson) {
  const auto n = static_cast<Eigen::Index>(interface.position.size());
  const Eigen::Map<const Eigen::ArrayXd> l(interface.length.data(), n);
  const Eigen::ArrayXd x = Eigen::Map<const Eigen::ArrayXd>(interface.position.data(), n) - caisson.x;
  const double s_0 = l.sum(), s_1 = (l * x).sum(), s_2 = (l * x * x).sum();
  return l * (s_2 - s_1 * x) * (caisson.weight / (s_0 * s_2 - s_1 * s_1));
}

/// Throws NumericsError where a node is not in compression.
void require_pressing(const Interface& interface, const Vector& N) {
  Eigen::Index least = 0;
  if (N.minCoeff(&least) > 0.) return;
  throw NumericsError("at rest the caisson pulls on its ground at x = " +
                      significant(interface.position[static_cast<std::size_t>(least)]) + " m: its weight in water, " +
                      significant(N.sum()) + " N/m, does not press the whole bottom down");
}

/// A state at rest and its name.
using RestWay = std::pair<std::string, std::function<Vector()>>;

/// As the stages of construction tell. Else it is not known how a caisson was set down: the static state of caisson and
/// soils under their weight; the caisson set down on soils that have settled under their own weight. After both,
/// stresses that are linear over the bottom.
std::vector<RestWay> rest_ways(const Simulation& simulation, const Interface& interface) {
  const auto by_ground = [&](bool has_settled) {
    return [&simulation, has_settled] {
      return static_normal_forces(simulation.scene(), *simulation.mesh(), simulation.soil_state(), has_settled);
    };
  };
  std::vector<RestWay> ways;
  if (simulation.scene().construction.empty())
    ways = {{"at rest: caisson and soils under their weight", by_ground(false)},
            {"at rest: the caisson set down on soils that have settled", by_ground(true)}};
  else
    ways = {{"at rest: as it was built in stages", by_ground(false)}};
  ways.emplace_back("at rest: stresses linear over the bottom",
                    [&] { return linear_forces(interface, caisson_in_water(simulation.scene(), *simulation.mesh())); });
  return ways;
}

/// The first of rest_ways with compression at every node. Throws NumericsError where none has it: see check_at_rest.
RestForces rest_forces(const Simulation& simulation, const Interface& interface) {
  RestForces rest;
  for (const auto& [way, forces] : rest_ways(simulation, interface)) {
    rest.ladder.push_back({way, ""});
    try {
      rest.normal_force = forces();
      require_pressing(interface, rest.normal_force);
      return rest;
    } catch (const NumericsError& error) {
      rest.ladder.back().refused = error.what();
    }
  }
  throw NumericsError(rest.ladder.back().refused);
}

/// The same, from the room where it has them.
RestForces rest_forces(const Simulation& simulation, const Interface& interface, ContactRoom& room) {
  if (!simulation.scene().construction.empty()) return rest_forces(simulation, interface);
  const double level = water_level(simulation.scene(), *simulation.mesh());
  if (!room.rest || level != room.rest_level) room.rest = rest_forces(simulation, interface);
  room.rest_level = level;
  return *room.rest;
}

/// The prescribed pressure pushes both bodies apart: it does work on the openings alone, and reduces N'.
void add_loads(const std::vector<UpliftLoad>& uplift, System& system) {
  for (const UpliftLoad& load : uplift) {
    SystemLoad apart{"sliding.uplift", Vector::Zero(system.size()), load.pressure};
    if (counts_for_prescribed(system))
      apart.vector.segment(system.first_opening(), system.interface->n_nodes()) = load.node;
    system.loads.push_back(std::move(apart));
  }
}

/// The water of an interface whose gaps are open to the sea; null where they are not.
std::shared_ptr<const GapWater> gap_water(const Simulation& simulation, const std::vector<UpliftLoad>& uplift) {
  if (simulation.scene().regions.at(caisson_name).interface->gap != GapSource::sea) return nullptr;
  auto water = std::make_shared<GapWater>();
  water->foot = pressures_at_feet(simulation);
  for (const UpliftLoad& load : uplift) water->closed.push_back({load.node, load.pressure});
  return water;
}

Ladder joined(Ladder ladder, const Ladder& more) {
  ladder.insert(ladder.end(), more.begin(), more.end());
  return ladder;
}

/// Sets friction and the forces at rest, with the sum W' of [sliding] where that is given. Returns the ways tried, if
/// several.
Ladder set_at_rest(const Simulation& simulation, Interface& interface, ContactRoom& room) {
  interface.friction = contact_friction(simulation.scene());
  RestForces rest = rest_forces(simulation, interface, room);
  interface.normal_force = std::move(rest.normal_force);
  if (simulation.scene().sliding)
    interface.normal_force *= simulation.scene().sliding->submerged_weight / interface.normal_force.sum();
  return rest.ladder.size() > 1 ? std::move(rest.ladder) : Ladder();
}

/// Removes the forces at the nodes from the readings that are reported.
Solution without_node_forces(Solution solution, int n_nodes, System& system) {
  const auto n = static_cast<Eigen::Index>(system.readings.size()) - 2 * n_nodes;
  system.readings.resize(static_cast<std::size_t>(n));
  for (Series* series : {&solution.response.ends, &solution.response.balanced, &solution.response.inside})
    series->reading.conservativeResize(n, Eigen::NoChange);
  return solution;
}

/// Adds the forces of yielding soil to the forces at bonded nodes, which are residuals of the rows of their slips and
/// openings.
void add_soil_to_node_forces(const Simulation& simulation, const System& system, System& tied) {
  const int n_nodes = system.interface->n_nodes(), n_unknowns = whole_size(system);
  const int first = n_unknowns - 2 * n_nodes, first_opening = n_unknowns - n_nodes;  // as the space numbers them
  const std::size_t first_reading = tied.readings.size() - 2 * static_cast<std::size_t>(n_nodes);
  const Unknowns& unknowns = *simulation.unknowns();
  for (unsigned dof = 0; dof < simulation.space()->dofs().n_dofs(); ++dof)
    for (const auto& [unknown, weight] : unknowns.expansion(dof)) {
      if (unknown < first) continue;
      const bool is_slip = unknown < first_opening;
      const auto node = static_cast<std::size_t>(unknown - (is_slip ? first : first_opening));
      Reading& reading = tied.readings[first_reading + 2 * node + (is_slip ? 0 : 1)];
      reading.nodal_forces.emplace_back(static_cast<int>(dof), is_slip ? -weight : weight);
    }
}

/// Marches yielding soil with contact, from all starts.
Solution march_yielding_contact(const Simulation& simulation, const Marching& marching) {
  std::optional<ContactRecorder> recorder;
  NodeFollower nodes;
  nodes.begin = [&](const Scheme& scheme) { return &recorder.emplace(simulation.system(), scheme); };
  nodes.end = [&] { return followed_by(*recorder); };
  return run_yielding(simulation, marching, nodes);
}

Solution march_contact(const Simulation& simulation, const Marching& marching, const Way& way) {
  const std::unique_ptr<Scheme> scheme = make_contact_scheme(simulation.system(), true, way.refined);
  ContactRecorder recorder(simulation.system(), *scheme);
  Marching options = marching;
  options.observers.insert(options.observers.begin(), &recorder);
  const std::string reason = "bonded, the caisson would slip or lift at some node";
  try {
    Solution solution = march_by(*scheme, simulation, reason, options, way.part);
    solution.contact = followed_by(recorder);
    solution.contact->found.solved->dissipated = solution.response.energy.back().friction;  // of all processes
    return solution;
  } catch (const NumericsError& error) {
    if (simulation.scene().time.inertia) throw;
    throw NumericsError(std::string(error.what()) +
                        "; without inertia (time.inertia = false) nothing stops a caisson whose friction is exceeded");
  }
}

}  // namespace

namespace {

/// On a reduced ground where the case asks for it and it can be had, then as marches go.
std::vector<Way> contact_ways(const Simulation& simulation) {
  std::vector<Way> ways = ways_to_march(simulation.scene(), "contact");
  if (reduces_ground(simulation)) ways.insert(ways.begin(), {"contact on a reduced ground", false, 1., true});
  return ways;
}

}  // namespace

void check_at_rest(const Simulation& simulation) {
  if (!has_frictional_contact(simulation.scene()) || !simulation.compiled()->caisson) return;
  const Caisson& caisson = *simulation.compiled()->caisson;
  const WeightInWater at_rest = caisson_in_water(simulation.scene(), *simulation.mesh());
  const double eccentricity = at_rest.x - caisson.bottom_centre[0];
  if (!(at_rest.weight > 0.))
    throw InputError(at_key("regions.caisson"),
                     "the caisson floats: its weight in water is " + significant(at_rest.weight) + " N/m",
                     "give it more density or mass, or lower the water");
  if (!(std::abs(eccentricity) < caisson.bottom_width / 6.))
    throw InputError(at_key("regions.caisson"),
                     "the caisson does not stand on its whole bottom: its weight in water acts " +
                         significant(eccentricity) + " m beside the middle, more than a sixth of the width of " +
                         significant(caisson.bottom_width) + " m",
                     "move its centre of gravity, or bond it: interface = { kind = \"bonded\" }");
}

namespace {

/// Room for what a run of contact makes: of the simulation, where it keeps what it is made of, for runs that come
/// after.
std::shared_ptr<ContactRoom> contact_room(const Simulation& simulation) {
  const std::shared_ptr<BasisRoom>& room = simulation.room();
  if (!room) return std::make_shared<ContactRoom>();
  if (!room->contact()) room->contact() = std::make_shared<ContactRoom>();
  return room->contact();
}

/// A reduced ground has errors of its own: where the bonded caisson has none of few modes, it is marched. Its basis is
/// about the shift of the ground.
Simulation with_tied(const Simulation& simulation, const std::shared_ptr<CompiledScene>& tied, ContactRoom& room) {
  const Simulation bonded = with_system(simulation, tied);
  if (!reduces_ground(simulation))
    return simulation.scene().time.scheme != TimeScheme::reduced
               ? bonded
               : bonded.with([](auto& parts) { parts.scene.time.scheme = TimeScheme::automatic; });
  const double shift = shift_of_ground(simulation.scene());
  if (!room.bonded || room.bonded->shift() != shift) room.bonded = std::make_shared<BasisRoom>(shift);
  return bonded.with([&](auto& parts) {
    parts.scene.time.scheme = TimeScheme::automatic;
    parts.room = room.bonded;
  });
}

}  // namespace

BondedContact solve_bonded(const Simulation& simulation, const Marching& marching) {
  BondedContact out;
  out.sliding = std::make_shared<CompiledScene>(*simulation.compiled());
  out.room = contact_room(simulation);
  const System& system = out.sliding->system;
  out.at_rest = set_at_rest(simulation, *out.sliding->system.interface, *out.room);
  out.uplift = uplift_loads(simulation, system.interface->position, system.interface->length);
  const auto tied = std::make_shared<CompiledScene>(*simulation.compiled());
  tied->system = bonded(system, true);
  const Simulation bonded = with_tied(simulation, tied, *out.room);
  ObserverFunction reported = progress_observer(marching.beside);
  Marching silent;
  silent.observers = {&reported};
  silent.beside = marching.beside;
  const bool soil_yields = yields(simulation.scene());
  silent.monitored = marching.monitored && !soil_yields;  // where nothing slips it is the answer
  if (soil_yields) add_soil_to_node_forces(simulation, system, tied->system);
  out.solution = soil_yields ? run_yielding(bonded, silent, {}, false) : run_bonded(bonded, silent);
  out.margin = out.solution.reduction ? out.solution.reduction->error_of_others : 0.;
  out.tied = tied;
  out.solution.simulation = std::make_shared<const Simulation>(bonded);
  return out;
}

Solution run_contact(const Simulation& simulation, const Marching& marching) {
  BondedContact at_first = solve_bonded(simulation, marching);
  const std::shared_ptr<CompiledScene>& sliding = at_first.sliding;
  const std::shared_ptr<ContactRoom>& room = at_first.room;
  const std::vector<UpliftLoad>& uplift = at_first.uplift;
  System& system = sliding->system;
  const int n_nodes = system.interface->n_nodes();
  const bool soil_yields = yields(simulation.scene());
  Solution before = std::move(at_first.solution);
  ContactSummary found{system.interface->friction,
                       system.interface->normal_force.sum(),
                       n_nodes,
                       contact_demand(*system.interface, uplift, before.response, at_first.margin),
                       {}};
  before = without_node_forces(std::move(before), n_nodes, at_first.tied->system);
  const bool bonded_reduced = before.reduction.has_value();
  before.ladder = joined(at_first.at_rest, before.ladder);
  add_loads(uplift, system);
  system.interface->gap = gap_water(simulation, uplift);
  // with other starts of yielding soil nodes may slip, though they do not with this one
  if (!found.demand.reached && !simulation.scene().fields_every && !soil_yields) {
    before.contact = {found, {}, nullptr};
    return before;
  }
  const auto moving = std::make_shared<const Simulation>(with_system(simulation, sliding));
  Marching unkept = marching;
  unkept.checkpoints = {};
  const auto solve = [&](const Way& way, const Marching& options) {
    return way.reduced ? contact_on_reduced_ground(*moving, options, *room, bonded_reduced)
                       : march_contact(*moving, options, way);
  };
  Solution solved =
      soil_yields ? march_yielding_contact(*moving, unkept) : climb(*moving, contact_ways(*moving), unkept, solve);
  solved.simulation = moving;
  solved.ladder = joined(before.ladder, solved.ladder);
  solved.timing.factorise += before.timing.factorise;
  solved.timing.march += before.timing.march;
  found.solved = solved.contact->found.solved;
  solved.contact->found = found;
  solved.contact->bonded = std::make_shared<const Solution>(std::move(before));
  return solved;
}

}  // namespace upbead
