#include "fem/caisson/base_readings.h"

#include "fem/bottom_faces.h"

namespace upbead {

using namespace dealii;

namespace {

/// Integrals of the pore pressure times the shape function of a node: of its amount, and of its push upward.
struct PorePush {
  std::map<int, double> amount, upward;
};

/// By the degree of freedom u_y of the node.
std::map<types::global_dof_index, PorePush> pore_pushes(const Space& space, const Unknowns& unknowns) {
  std::map<types::global_dof_index, PorePush> of_node;
  std::vector<types::global_dof_index> dofs;
  for_each_bottom_face(space, [&](const Cell& ground, unsigned f) {
    if (!space.has_pores(ground)) return;
    const FaceValues fe(space, ground, f);
    dofs.resize(fe.dofs_per_cell);
    ground->get_dof_indices(dofs);
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
        unknowns.add_to(push.amount, static_cast<unsigned>(dofs[j]), amount);
        unknowns.add_to(push.upward, static_cast<unsigned>(dofs[j]), upward);
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

/// A sum of the nodal forces on the ground, times a factor.
Reading stress(const ReadingName& name, const char* description, const NodalReaction& bottom, const SceneLoads& loads,
               int sum, double factor) {
  Reading reading{name,
                  "Pa",
                  description,
                  scaled(bottom.position(sum), factor),
                  scaled(bottom.velocity(sum), factor),
                  scaled(bottom.acceleration(sum), factor),
                  {}};
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
      list.push_back({{base_group, at, "pore_pressure"},
                      "Pa",
                      "excess pore pressure",
                      {},
                      scaled(to_row(found->second.amount), 1. / node.length),
                      {},
                      {}});
    }
    const char* directions[] = {"landward", "upward"};
    for (unsigned d = 0; d < dim; ++d)
      list.push_back({{base_group, at, d == 0 ? "displacement_x" : "displacement_y"},
                      "m",
                      std::string("displacement of the ground, ") + directions[d],
                      unknowns.expansion(static_cast<unsigned>(d == 0 ? node.ux : node.uy)),
                      {},
                      {},
                      {}});
  }
  return list;
}

}  // namespace upbead
