// Claims: where a cell meets two smaller ones u and phi are continuous for every x; both routes to F_T and the balance
// of energy agree on such meshes as on others; linear fields are exact there. Tolerances: round-off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/faces.h"
#include "mesh/refine.h"
#include "scenes.h"

namespace upbead::test {
namespace hanging_nodes_test {

/// Splits the cells within `distance` of the caisson's bottom corners, `levels` times.
std::unique_ptr<Mesh> refined_breakwater(int levels, double distance, std::map<std::string, double> parameters = {}) {
  auto mesh = breakwater_mesh(0.35, std::move(parameters));
  for (int level = 0; level < levels; ++level) {
    std::vector<bool> chosen(mesh->triangulation.n_active_cells(), false);
    for (const auto& cell : mesh->triangulation.active_cell_iterators())
      chosen[cell->active_cell_index()] =
          std::hypot(std::abs(cell->center()[0]) - 9., cell->center()[1] - 6.) < distance;
    mesh = refined(*mesh, chosen);
  }
  return mesh;
}

double value(const Cell& cell, unsigned component, const dealii::Point<dim>& at, const Space& space, const Vector& x) {
  const auto& fe = cell->get_fe();
  std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  const dealii::Point<dim> unit = space.mapping().transform_real_to_unit_cell(cell, at);
  double sum = 0.;
  for (unsigned i = 0; i < dofs.size(); ++i)
    if (fe.system_to_component_index(i).first == component)
      sum += x[static_cast<Eigen::Index>(dofs[i])] * fe.shape_value(i, unit);
  return sum;
}

struct Jumps {
  int n_sides = 0;
  double largest = 0.;
};

/// Jumps of u and phi over all sides where a cell meets a larger one.
Jumps jumps_of(const Compiled& compiled) {
  const Space& space = compiled.space;
  const Vector x = compiled.unknowns.expand(Vector::Random(compiled.unknowns.size()));
  Jumps jumps;
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f) || !cell->neighbor_is_coarser(f)) continue;
      ++jumps.n_sides;
      EXPECT_EQ(space.kind(cell), space.kind(cell->neighbor(f)));
      for (const unsigned component : {0U, 1U, static_cast<unsigned>(phi_component)})
        for (const double t : {0.1, 0.37, 0.8}) {
          const auto at = cell->face(f)->vertex(0) + t * (cell->face(f)->vertex(1) - cell->face(f)->vertex(0));
          const double jump = value(cell, component, at, space, x) - value(cell->neighbor(f), component, at, space, x);
          jumps.largest = std::max(jumps.largest, std::abs(jump));
        }
    }
  return jumps;
}

TEST(HangingNodes, FieldsAreContinuous) {
  for (const int degree : {2, 3}) {
    const auto mesh = refined_breakwater(2, 4., with_sea());
    Scene scene = breakwater(triangle(1e6, 0.15));
    add_sea(scene);
    scene.mesh.degree = degree;
    const Jumps jumps = jumps_of(Compiled(scene, *mesh));
    EXPECT_GE(jumps.n_sides, 20);
    EXPECT_LE(jumps.largest, 1e-11);
  }
}

TEST(HangingNodes, BothRoutesToTheShearForceAndTheEnergyAgree) {
  const auto mesh = refined_breakwater(2, 4., with_sea());
  Scene scene = breakwater(triangle(1e6, 0.15));
  add_sea(scene);
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, 0.3, 0.01);
  EXPECT_LE(shear_of(compiled, response).reaction_mismatch, 1e-10);
  EXPECT_LE(response.energy.back().mismatch(), 1e-10);
}

TEST(HangingNodes, AColumnSettlesEvenly) {
  auto mesh = column_mesh(10., 4);
  std::vector<bool> chosen(mesh->triangulation.n_active_cells(), false);
  chosen[1] = true;
  mesh = refined(*mesh, chosen);
  Region soil = sand();
  soil.flow = Flow::drained;
  Scene scene = column(soil, piecewise_linear({0., 1., 1000.}, {0., 1e5, 1e5}));
  scene.time.inertia = false;
  scene.probes["in_small_cell"].at = {0.3, 3.1};
  scene.probes["above"].at = {0.3, 8.};
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, 999., 50.);
  for (const char* probe : {"in_small_cell", "above"})
    EXPECT_NEAR(history(compiled, response, std::string("probes/") + probe + "/effective_stress_yy").tail<1>()[0], -1e5,
                1e-3)
        << probe;
}

}  // namespace hanging_nodes_test
}  // namespace upbead::test
