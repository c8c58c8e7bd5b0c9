// Claims: a uniform pressure in sea, rubble and sand causes neither a horizontal force nor a moment on a wet caisson,
// an uplift of the pressure times its width, and no force on the ground except at its outer sides: on wet faces the
// pressures of sea and pores cancel, whatever the shape of the cells, the degree and the flow.
// Source: Archimedes and Pascal; the system's own C with uniform phi'. Biot's coefficient is 1.
// Limit: round-off, 1e-12 of the pressure times the water's depth.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fem/unknowns.h"
#include "record.h"
#include "unknowns_on.h"

namespace upbead::test {
namespace hydrostatic_test {

/// The shipped section with a sea on both sides, sealed everywhere, so that a uniform pressure can stand.
std::unique_ptr<Mesh> section_with_seas() {
  return breakwater_mesh(0.5, with_sea());
}

Scene submerged(Flow mound, int degree) {
  Scene scene = breakwater(triangle(1e6, 0.1));
  scene.mesh.degree = degree;
  scene.regions["mound"].flow = mound;
  scene.regions["seabed"].flow = Flow::darcy;
  add_sea(scene);
  for (const char* side : {"sea_surface", "bed", "mound_surface"})
    scene.boundaries[side].pressure = PressureCondition::sealed;
  return scene;
}

/// Forces on the unknowns by a pressure of 1 Pa everywhere.
Vector forces_of_unit_pressure(const System& system) {
  Vector pressure = Vector::Zero(system.size());
  for (int i = 0; i < system.size(); ++i)
    if (system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse) pressure[i] = 1.;
  return -(system.C * pressure);
}

/// Largest |force| on an unknown that is not in `others`.
double largest_beside(const Vector& force, const std::set<int>& others) {
  double largest = 0.;
  for (int i = 0; i < force.size(); ++i)
    if (!others.count(i)) largest = std::max(largest, std::abs(force[i]));
  return largest;
}

void check_uniform_pressure(Record& record, const std::string& title, const Scene& scene) {
  const double depth = 15., width = 18., dry_bed = 2. * (120. + 28. - 9. - 3. * depth);
  const auto mesh = section_with_seas();
  const Compiled compiled(scene, *mesh);
  const Vector force = forces_of_unit_pressure(compiled.system);
  const auto on_caisson = [&](int motion) { return force[compiled.unknowns.coordinate(0, motion)]; };
  record.at_most(title + ": horizontal force on the caisson, over p h", std::abs(on_caisson(motion_x)) / depth, 1e-12);
  record.at_most(title + ": moment on it about its centre of gravity, over p h^2",
                 std::abs(on_caisson(motion_rotation)) / (depth * depth), 1e-12);
  record.at_most(title + ": its uplift against p times its width, over p h",
                 std::abs(on_caisson(motion_y) - width) / depth, 1e-12);
  std::set<int> others;
  for (int m = 0; m < n_motions; ++m) others.insert(compiled.unknowns.coordinate(0, m));
  double dry = 0.;
  for (const unsigned component : {0u, 1u})
    for (const int i : unknowns_on(compiled, "bed", component)) {
      others.insert(i);
      dry += std::abs(force[i]);  // zero where the bed is wet
    }
  record.at_most(title + ": largest force on any unknown of the ground that is not on the bed, over p h",
                 largest_beside(force, others) / depth, 1e-12);
  record.at_most(title + ": sum of forces on the bed against p times its length beyond the sea",
                 std::abs(dry / dry_bed - 1.), 1e-12);
}

TEST(UniformPressure, PushesTheCaissonToNoSideAndTheGroundNowhere) {
  Record record("water_hydrostatics");
  for (const int degree : {2, 3}) {
    check_uniform_pressure(record, "degree " + std::to_string(degree) + ", inertial mound",
                           submerged(Flow::inertial, degree));
    check_uniform_pressure(record, "degree " + std::to_string(degree) + ", darcy mound",
                           submerged(Flow::darcy, degree));
  }
}

}  // namespace hydrostatic_test
}  // namespace upbead::test
