#include "rest_forces.h"

#include <cmath>
#include <functional>
#include <utility>

#include "base/text.h"
#include "fem/static_stage.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Stresses a + b x in balance with the weight: sum l (a + b x) = W', sum l (a + b x) x = 0, x from where it acts.
Vector linear_forces(const Interface& interface, const WeightInWater& caisson) {
  const auto n = static_cast<Eigen::Index>(interface.position.size());
  const Eigen::Map<const Eigen::ArrayXd> l(interface.length.data(), n);
  const Eigen::ArrayXd x = Eigen::Map<const Eigen::ArrayXd>(interface.position.data(), n) - caisson.x;
  const double s_0 = l.sum(), s_1 = (l * x).sum(), s_2 = (l * x * x).sum();
  return l * (s_2 - s_1 * x) * (caisson.weight / (s_0 * s_2 - s_1 * s_1));
}

/// Throws NumericsError where a node does not press.
void require_pressing(const Interface& interface, const Vector& N) {
  Eigen::Index least = 0;
  if (N.minCoeff(&least) > 0.) return;
  throw NumericsError("at rest the caisson pulls on its ground at x = " +
                      significant(interface.position[static_cast<std::size_t>(least)]) + " m: its weight in water, " +
                      significant(N.sum()) + " N/m, does not press the whole bottom down");
}

}  // namespace

RestForces rest_forces(const Simulation& simulation, const Interface& interface) {
  const auto by_ground = [&](bool has_settled) {
    return static_normal_forces(simulation.scene, *simulation.mesh, simulation.soil_state, has_settled);
  };
  const std::vector<std::pair<std::string, std::function<Vector()>>> ways = {
      {"at rest: caisson and soils under their weight", [&] { return by_ground(false); }},
      {"at rest: the caisson set down on soils that have settled", [&] { return by_ground(true); }},
      {"at rest: stresses linear over the bottom",
       [&] { return linear_forces(interface, caisson_in_water(simulation.scene, *simulation.mesh)); }}};
  RestForces rest;
  for (const auto& [way, forces] : ways) {
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

void check_at_rest(const Simulation& simulation) {
  if (!has_frictional_contact(simulation.scene) || !simulation.compiled->caisson) return;
  const Caisson& caisson = *simulation.compiled->caisson;
  const WeightInWater at_rest = caisson_in_water(simulation.scene, *simulation.mesh);
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
                     "move its centre of gravity, or tie it: interface = { kind = \"tied\" }");
}

}  // namespace upbead
