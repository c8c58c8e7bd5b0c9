#include "fem/caisson/readings.h"

#include <map>

#include "fem/caisson/bottom.h"

namespace upbead {

using namespace dealii;

namespace {

/// `factor` times a component of each load on the caisson; one entry per load.
std::vector<double> feedthrough(const SceneLoads& loads, double LoadOnCaisson::*part, double factor) {
  std::vector<double> values;
  for (const LoadOnCaisson& load : loads.on_caisson) values.push_back(factor * load.*part);
  return values;
}

/// Force of the caisson on the ground in one unit motion: from the balance of the ground at the caisson's nodes.
Reading ground_force(const NodalReaction& ground, const SceneLoads& loads, int motion, double sign) {
  Reading r;
  r.position = scaled(ground.position(motion), sign);
  r.velocity = scaled(ground.velocity(motion), sign);
  r.acceleration = scaled(ground.acceleration(motion), sign);
  r.nodal_forces = scaled(ground.nodal_forces(motion), sign);
  for (const NodalForces& forces : loads.on_ground) r.feedthrough.push_back(-sign * ground.sum(motion, forces));
  return r;
}

Reading named(Reading r, ReadingName name, std::string unit, std::string description) {
  r.name = std::move(name);
  r.unit = std::move(unit);
  r.description = std::move(description);
  return r;
}

Row sum(const Row& a, const Row& b) {
  std::map<int, double> entries;
  for (const Row* row : {&a, &b})
    for (const auto& [i, weight] : *row) entries[i] += weight;
  return to_row(entries);
}

/// Landward force of the modelled water on the caisson: of the mesh's by its velocity potential, of a mass beside the
/// walls by their acceleration.
Reading water_force(const NodalReaction& water) {
  Reading force;
  force.velocity = scaled(water.velocity(motion_x), -1.);
  force.acceleration = scaled(water.acceleration(motion_x), -1.);
  return force;
}

Reading water_force(const CaissonForces& forces) {
  Reading force = water_force(forces.water_front);
  const Reading back = water_force(forces.water_back);
  force.velocity = sum(force.velocity, back.velocity);
  force.acceleration = sum(force.acceleration, back.acceleration);
  return force;
}

void add_loads(std::vector<Reading>& list, const CaissonForces& forces, const SceneLoads& loads) {
  list.push_back({reading::force,
                  "N/m",
                  "P, horizontal load on the caisson, landward",
                  {},
                  {},
                  {},
                  feedthrough(loads, &LoadOnCaisson::force_x, 1.)});
  list.push_back({reading::force_vertical,
                  "N/m",
                  "vertical load on the caisson, upward",
                  {},
                  {},
                  {},
                  feedthrough(loads, &LoadOnCaisson::force_y, 1.)});
  list.push_back(named(water_force(forces), reading::water_force, "N/m",
                       "P_water, force of the modelled water on the caisson, landward"));
  list.push_back(named(water_force(forces.water_front), reading::water_force_front, "N/m",
                       "P_water on the faces that look seaward, landward"));
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
  const Reading water = water_force(forces);
  Reading inertia_force = ground_force(forces.ground, loads, motion_x, -1.);
  inertia_force.velocity = sum(inertia_force.velocity, water.velocity);
  inertia_force.acceleration = sum(inertia_force.acceleration, water.acceleration);
  for (std::size_t k = 0; k < P.size(); ++k) inertia_force.feedthrough[k] += P[k];
  list.push_back(named(inertia_force, reading::inertia_force, "N/m",
                       "m x_G'', inertia force of the caisson, as P + P_water - F_T from the balance of forces"));
  list.push_back({reading::shear_by_inertia,
                  "N/m",
                  "F_T as P + P_water - m x_G'', from the acceleration of the scheme",
                  {},
                  water.velocity,
                  inertia ? sum(scaled(momentum_x, -1.), water.acceleration) : Row{},
                  P});
}

void add_motion(std::vector<Reading>& list, const Body& body, const std::array<Row, n_motions>& momentum) {
  const std::string axes[] = {"x", "y"}, directions[] = {"landward", "upward"};
  for (int m = 0; m < dim; ++m) {
    const Row row = scaled(momentum[m], 1. / body.mass);
    const std::string text = " of the centre of gravity, " + directions[m];
    list.push_back(position_reading({"caisson", "displacement_" + axes[m]}, "m", "displacement" + text, row));
    list.push_back(velocity_reading({"caisson", "velocity_" + axes[m]}, "m/s", "velocity" + text, row));
    list.push_back(acceleration_reading({"caisson", "acceleration_" + axes[m]}, "m/s2", "acceleration" + text, row));
  }
  const Row rotation = scaled(momentum[motion_rotation], 1. / body.moment_of_inertia);
  list.push_back(
      position_reading({"caisson", "rotation"}, "rad", "rotation, positive when the top moves landward", rotation));
  list.push_back(velocity_reading({"caisson", "angular_velocity"}, "rad/s", "rate of rotation", rotation));
}

}  // namespace

std::vector<Reading> caisson_readings(const Caisson& caisson, const CaissonForces& forces,
                                      const std::array<Row, n_motions>& momentum,
                                      const std::array<Row, n_motions>& uplift, const SceneLoads& loads, bool inertia) {
  std::vector<Reading> list;
  add_loads(list, forces, loads);
  add_base_forces(list, forces.ground, loads);
  list.push_back(velocity_reading(reading::uplift, "N/m",
                                  "U, integral of the excess pore pressure over the bottom, upward", uplift[motion_y]));
  list.push_back(velocity_reading("uplift_moment", "N m/m",
                                  "moment of the uplift about the bottom's middle, overturning landward positive",
                                  uplift[motion_rotation]));
  add_inertia(list, forces, loads, momentum[motion_x], inertia);
  add_motion(list, caisson.body, momentum);
  return list;
}

namespace {

using Entries = std::array<std::map<int, double>, n_motions>;

void add_uplift(const FaceValues& fe, const Dofs& dofs, const Unknowns& unknowns, const Point<dim>& about,
                Entries& entries) {
  for (unsigned i = 0; i < dofs.size(); ++i)
    for (int m = 0; m < n_motions; ++m) {
      double work = 0.;  // the ground's outward normal points into the caisson
      for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
        work += fe[phi_part].value(i, q) * (fe.normal_vector(q) * unit_motion(m, fe.quadrature_point(q), about)) *
                fe.JxW(q);
      if (work != 0.) unknowns.add_to(entries[m], dofs[i], work);
    }
}

}  // namespace

std::array<Row, n_motions> uplift_rows(const Space& space, const Unknowns& unknowns, const Caisson& caisson) {
  Entries entries;
  for_each_bottom_face(space, [&](const Cell& ground, unsigned f) {
    if (space.has_pores(ground))
      add_uplift(FaceValues(space, ground, f), dofs_of(ground), unknowns, caisson.bottom_centre, entries);
  });
  std::array<Row, n_motions> rows;
  for (int m = 0; m < n_motions; ++m) rows[m] = to_row(entries[m]);
  return rows;
}

namespace {

/// Integrals of the pore pressure times the shape function of a node: of the pressure itself, and of its upward
/// component on the caisson.
struct PorePush {
  std::map<int, double> amount, upward;
};

/// By the degree of freedom u_y of the node on the ground.
std::map<types::global_dof_index, PorePush> pore_pushes(const Space& space, const Unknowns& unknowns) {
  std::map<types::global_dof_index, PorePush> of_node;
  for_each_bottom_face(space, [&](const Cell& ground, unsigned f) {
    if (!space.has_pores(ground)) return;
    const FaceValues fe(space, ground, f);
    const Dofs dofs = dofs_of(ground);
    for_each_displacement(space, ground, f, [&](unsigned node, unsigned component, const Point<dim>&) {
      if (component != 1) return;
      PorePush& push = of_node[dofs[node]];
      for (unsigned j = 0; j < dofs.size(); ++j) {
        double amount = 0., upward = 0.;  // the ground's outward normal points into the caisson
        for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
          const double part = fe[u_part].value(node, q)[1] * fe[phi_part].value(j, q) * fe.JxW(q);
          amount += part;
          upward += part * fe.normal_vector(q)[1];
        }
        if (amount == 0. && upward == 0.) continue;
        unknowns.add_to(push.amount, dofs[j], amount);
        unknowns.add_to(push.upward, dofs[j], upward);
      }
    });
  });
  return of_node;
}

Row sum(Row row, const std::map<int, double>& more, double factor) {
  std::map<int, double> entries(row.begin(), row.end());
  for (const auto& [unknown, weight] : more) entries[unknown] += factor * weight;
  return to_row(entries);
}

/// A stress: a sum of the nodal forces on the ground, times a factor.
Reading stress(const ReadingName& name, const char* description, const NodalReaction& bottom, const SceneLoads& loads,
               int sum, double factor) {
  Reading reading{name,
                  "Pa",
                  description,
                  scaled(bottom.position(sum), factor),
                  scaled(bottom.velocity(sum), factor),
                  scaled(bottom.acceleration(sum), factor),
                  {},
                  scaled(bottom.nodal_forces(sum), factor)};
  for (const NodalForces& forces : loads.on_ground) reading.feedthrough.push_back(-factor * bottom.sum(sum, forces));
  return reading;
}

}  // namespace

std::vector<Reading> base_readings(const Space& space, const Unknowns& unknowns,
                                   const std::vector<InterfaceNode>& nodes, const NodalReaction& bottom,
                                   const SceneLoads& loads) {
  const auto pushes = pore_pushes(space, unknowns);
  std::vector<Reading> list;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const InterfaceNode& node = nodes[i];
    const int at = static_cast<int>(i), x = dim * at, y = x + 1;
    list.push_back(stress({base_group, at, "shear_stress"}, "shear stress on the ground, landward", bottom, loads, x,
                          1. / node.length));
    list.push_back(stress({base_group, at, "normal_stress"},
                          "change of the effective normal stress, compression positive", bottom, loads, y,
                          -1. / node.length));
    if (const auto found = pushes.find(node.uy); found != pushes.end()) {
      Row& velocity = list.back().velocity;
      velocity = sum(velocity, found->second.upward, -1. / node.length);
      list.push_back(velocity_reading({base_group, at, "pore_pressure"}, "Pa", "excess pore pressure",
                                      scaled(to_row(found->second.amount), 1. / node.length)));
    }
    const char* directions[] = {"landward", "upward"};
    for (unsigned d = 0; d < dim; ++d)
      list.push_back(position_reading({base_group, at, d == 0 ? "displacement_x" : "displacement_y"}, "m",
                                      std::string("displacement of the ground, ") + directions[d],
                                      unknowns.expansion(d == 0 ? node.ux : node.uy)));
  }
  return list;
}

}  // namespace upbead
