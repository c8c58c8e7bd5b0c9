#include "upbead/fem/caisson_readings.h"

namespace upbead {

namespace {

Row scaled(Row row, double factor) {
  for (auto& entry : row) entry.second *= factor;
  return row;
}

/// One entry per load.
std::vector<double> feedthrough(const SceneLoads& loads, double LoadOnCaisson::*part, double factor) {
  std::vector<double> values;
  for (const LoadOnCaisson& load : loads.on_caisson) values.push_back(factor * load.*part);
  return values;
}

/// Force that the caisson exerts on the ground in one unit motion: the ground's own balance at the caisson's nodes.
Reading ground_force(const GroundReaction& reaction, const SceneLoads& loads, int motion, double sign) {
  Reading r;
  r.position = scaled(reaction.position(motion), sign);
  r.velocity = scaled(reaction.velocity(motion), sign);
  r.acceleration = scaled(reaction.acceleration(motion), sign);
  for (const auto& work : loads.on_shared_nodes) r.feedthrough.push_back(-sign * work[motion]);
  return r;
}

Reading named(Reading r, std::string name, std::string unit, std::string description) {
  r.name = std::move(name);
  r.unit = std::move(unit);
  r.description = std::move(description);
  return r;
}

void add_forces(std::vector<Reading>& list, const GroundReaction& reaction, const SceneLoads& loads,
                const Row& momentum_x, bool inertia) {
  const auto P = feedthrough(loads, &LoadOnCaisson::force_x, 1.);
  list.push_back({reading::force, "N/m", "P, horizontal load on the caisson, landward", {}, {}, {}, P});
  list.push_back({"force_vertical",
                  "N/m",
                  "vertical load on the caisson, upward",
                  {},
                  {},
                  {},
                  feedthrough(loads, &LoadOnCaisson::force_y, 1.)});
  list.push_back(named(ground_force(reaction, loads, motion_x, 1.), reading::shear_force, "N/m",
                       "F_T, shear force at the caisson's bottom, landward on the ground"));
  list.push_back(named(ground_force(reaction, loads, motion_y, -1.), reading::normal_force, "N/m",
                       "change of the normal force at the caisson's bottom, total, compression positive"));
  list.push_back(named(ground_force(reaction, loads, motion_rotation, 1.), reading::base_moment, "N m/m",
                       "moment at the caisson's bottom about its middle, overturning landward positive"));

  Reading inertia_force = ground_force(reaction, loads, motion_x, -1.);
  for (std::size_t k = 0; k < P.size(); ++k) inertia_force.feedthrough[k] += P[k];
  list.push_back(named(inertia_force, reading::inertia_force, "N/m",
                       "m x_G'', inertia force of the caisson, as P - F_T from the balance of forces"));
  list.push_back({reading::shear_by_inertia,
                  "N/m",
                  "F_T as P - m x_G'', from the acceleration of the scheme",
                  {},
                  {},
                  inertia ? scaled(momentum_x, -1.) : Row{},
                  P});
}

void add_motion(std::vector<Reading>& list, const Body& body, const std::array<Row, n_motions>& momentum) {
  const std::string axes[] = {"x", "y"}, directions[] = {"landward", "upward"};
  for (int m = 0; m < dim; ++m) {
    const Row row = scaled(momentum[m], 1. / body.mass);
    const std::string text = " of the centre of gravity, " + directions[m];
    list.push_back({"caisson/displacement_" + axes[m], "m", "displacement" + text, row, {}, {}, {}});
    list.push_back({"caisson/velocity_" + axes[m], "m/s", "velocity" + text, {}, row, {}, {}});
    list.push_back({"caisson/acceleration_" + axes[m], "m/s2", "acceleration" + text, {}, {}, row, {}});
  }
  const Row rotation = scaled(momentum[motion_rotation], 1. / body.moment_of_inertia);
  list.push_back({reading::rotation, "rad", "rotation, positive when the top moves landward", rotation, {}, {}, {}});
  list.push_back({"caisson/angular_velocity", "rad/s", "rate of rotation", {}, rotation, {}, {}});
}

}  // namespace

std::vector<Reading> caisson_readings(const Caisson& caisson, const GroundReaction& reaction,
                                      const std::array<Row, n_motions>& momentum, const SceneLoads& loads,
                                      bool inertia) {
  std::vector<Reading> list;
  add_forces(list, reaction, loads, momentum[motion_x], inertia);
  add_motion(list, caisson.body, momentum);
  return list;
}

}  // namespace upbead
