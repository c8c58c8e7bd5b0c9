#include "fem/caisson/readings.h"

#include <map>

namespace upbead {

namespace {

/// One entry per load.
std::vector<double> feedthrough(const SceneLoads& loads, double LoadOnCaisson::*part, double factor) {
  std::vector<double> values;
  for (const LoadOnCaisson& load : loads.on_caisson) values.push_back(factor * load.*part);
  return values;
}

/// Force that the caisson exerts on the ground in one unit motion: the ground's own balance at the caisson's nodes.
Reading ground_force(const NodalReaction& ground, const SceneLoads& loads, int motion, double sign) {
  Reading r;
  r.position = scaled(ground.position(motion), sign);
  r.velocity = scaled(ground.velocity(motion), sign);
  r.acceleration = scaled(ground.acceleration(motion), sign);
  for (const NodalForces& forces : loads.on_ground) r.feedthrough.push_back(-sign * ground.sum(motion, forces));
  return r;
}

Reading named(Reading r, std::string name, std::string unit, std::string description) {
  r.name = std::move(name);
  r.unit = std::move(unit);
  r.description = std::move(description);
  return r;
}

/// Force of the modelled water on the caisson, landward; `water` is what its surroundings exert on the water.
Row water_row(const NodalReaction& water) {
  return scaled(water.velocity(motion_x), -1.);
}

Row sum(const Row& a, const Row& b) {
  std::map<int, double> entries;
  for (const Row* row : {&a, &b})
    for (const auto& [i, weight] : *row) entries[i] += weight;
  return to_row(entries);
}

void add_loads(std::vector<Reading>& list, const CaissonForces& forces, const SceneLoads& loads) {
  list.push_back({reading::force,
                  "N/m",
                  "P, horizontal load on the caisson, landward",
                  {},
                  {},
                  {},
                  feedthrough(loads, &LoadOnCaisson::force_x, 1.)});
  list.push_back({"force_vertical",
                  "N/m",
                  "vertical load on the caisson, upward",
                  {},
                  {},
                  {},
                  feedthrough(loads, &LoadOnCaisson::force_y, 1.)});
  const Row front = water_row(forces.water_front), back = water_row(forces.water_back);
  list.push_back({reading::water_force,
                  "N/m",
                  "P_water, force of the modelled water on the caisson, landward",
                  {},
                  sum(front, back),
                  {},
                  {}});
  list.push_back(
      {reading::water_force_front, "N/m", "P_water on the faces that look seaward, landward", {}, front, {}, {}});
}

void add_base_forces(std::vector<Reading>& list, const NodalReaction& ground, const SceneLoads& loads) {
  list.push_back(named(ground_force(ground, loads, motion_x, 1.), reading::shear_force, "N/m",
                       "F_T, shear force at the caisson's bottom, landward on the ground"));
  list.push_back(named(ground_force(ground, loads, motion_y, -1.), reading::normal_force, "N/m",
                       "change of the normal force at the caisson's bottom, total, compression positive"));
  list.push_back(named(ground_force(ground, loads, motion_rotation, 1.), reading::base_moment, "N m/m",
                       "moment at the caisson's bottom about its middle, overturning landward positive"));
}

/// m x_G'' from the balance of forces, and F_T by route (i).
void add_inertia(std::vector<Reading>& list, const CaissonForces& forces, const SceneLoads& loads,
                 const Row& momentum_x, bool inertia) {
  const auto P = feedthrough(loads, &LoadOnCaisson::force_x, 1.);
  const Row water = sum(water_row(forces.water_front), water_row(forces.water_back));
  Reading inertia_force = ground_force(forces.ground, loads, motion_x, -1.);
  inertia_force.velocity = sum(inertia_force.velocity, water);
  for (std::size_t k = 0; k < P.size(); ++k) inertia_force.feedthrough[k] += P[k];
  list.push_back(named(inertia_force, reading::inertia_force, "N/m",
                       "m x_G'', inertia force of the caisson, as P + P_water - F_T from the balance of forces"));
  list.push_back({reading::shear_by_inertia,
                  "N/m",
                  "F_T as P + P_water - m x_G'', from the acceleration of the scheme",
                  {},
                  water,
                  inertia ? scaled(momentum_x, -1.) : Row{},
                  P});
}

void add_motion(std::vector<Reading>& list, const Body& body, const std::array<Row, n_motions>& momentum) {
  const std::string axes[] = {"x", "y"}, directions[] = {"landward", "upward"};
  for (int m = 0; m < dim; ++m) {
    const Row row = scaled(momentum[m], 1. / body.mass);
    const std::string text = " of the centre of gravity, " + directions[m];
    list.push_back({{"caisson", "displacement_" + axes[m]}, "m", "displacement" + text, row, {}, {}, {}});
    list.push_back({{"caisson", "velocity_" + axes[m]}, "m/s", "velocity" + text, {}, row, {}, {}});
    list.push_back({{"caisson", "acceleration_" + axes[m]}, "m/s2", "acceleration" + text, {}, {}, row, {}});
  }
  const Row rotation = scaled(momentum[motion_rotation], 1. / body.moment_of_inertia);
  list.push_back(
      {{"caisson", "rotation"}, "rad", "rotation, positive when the top moves landward", rotation, {}, {}, {}});
  list.push_back({{"caisson", "angular_velocity"}, "rad/s", "rate of rotation", {}, rotation, {}, {}});
}

}  // namespace

std::vector<Reading> caisson_readings(const Caisson& caisson, const CaissonForces& forces,
                                      const std::array<Row, n_motions>& momentum,
                                      const std::array<Row, n_motions>& uplift, const SceneLoads& loads, bool inertia) {
  std::vector<Reading> list;
  add_loads(list, forces, loads);
  add_base_forces(list, forces.ground, loads);
  list.push_back({reading::uplift,
                  "N/m",
                  "U, integral of the excess pore pressure over the bottom, upward",
                  {},
                  uplift[motion_y],
                  {},
                  {}});
  list.push_back({"uplift_moment",
                  "N m/m",
                  "moment of the uplift about the bottom's middle, overturning landward positive",
                  {},
                  uplift[motion_rotation],
                  {},
                  {}});
  add_inertia(list, forces, loads, momentum[motion_x], inertia);
  add_motion(list, caisson.body, momentum);
  return list;
}

}  // namespace upbead
