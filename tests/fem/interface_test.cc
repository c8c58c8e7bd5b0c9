// Claims: an interface whose unknowns are kept at zero changes nothing; residuals of its rows are the forces at the
// bottom, effective normal forces in the rows of the opening; slip and opening of all nodes do not move the ground;
// the forces at rest balance the caisson's submerged weight. Tolerances: round-off of the largest term.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/static_stage.h"
#include "mesh/refine.h"
#include "scenes.h"
#include "system/interface.h"

namespace upbead::test {
namespace interface_test {

constexpr double round_off = 1e-12;

double difference(const SparseMatrix& a, const SparseMatrix& b) {
  const SparseMatrix d = a - b;
  return d.coeffs().size() == 0 ? 0. : d.coeffs().cwiseAbs().maxCoeff() / a.coeffs().cwiseAbs().maxCoeff();
}

double sum_of(const System& system, const State& state, int first, int n) {
  double sum = 0.;
  for (int i = first; i < first + n; ++i)
    sum += system.M.row(i).dot(state.a) + system.C.row(i).dot(state.v) + system.K.row(i).dot(state.x);
  return sum;
}

/// With `levels` above 0, cells around the toe are smaller, so that there are hanging nodes.
std::unique_ptr<Mesh> mesh_with(int levels) {
  auto mesh = breakwater_mesh(0.35, with_sea());
  for (int level = 0; level < levels; ++level) {
    std::vector<bool> chosen(mesh->triangulation.n_active_cells(), false);
    for (const auto& cell : mesh->triangulation.active_cell_iterators())
      chosen[cell->active_cell_index()] = std::hypot(cell->center()[0] + 9., cell->center()[1] - 6.) < 4.;
    mesh = refined(*mesh, chosen);
  }
  return mesh;
}

class Bottom : public testing::TestWithParam<int> {
 protected:
  Bottom() : scene_(breakwater(triangle(1e6, 0.15))), mesh_(mesh_with(GetParam())) { add_sea(scene_); }

  Scene scene_;
  std::unique_ptr<Mesh> mesh_;
};

TEST_P(Bottom, GluedIsTheSystemWithoutInterface) {
  const Compiled plain(scene_, *mesh_), loose(scene_, *mesh_, true);
  ASSERT_TRUE(loose.system.interface);
  const System system = bonded(loose.system);
  ASSERT_EQ(system.size(), plain.system.size());
  EXPECT_LE(difference(plain.system.M, system.M), round_off);
  EXPECT_LE(difference(plain.system.C, system.C), round_off);
  EXPECT_LE(difference(plain.system.K, system.K), round_off);
  for (std::size_t k = 0; k < system.loads.size(); ++k) EXPECT_EQ(system.loads[k].vector, plain.system.loads[k].vector);
  ASSERT_EQ(system.readings.size(), plain.system.readings.size());
}

TEST_P(Bottom, ResidualsAreTheForcesOfTheReadings) {
  const Compiled loose(scene_, *mesh_, true);
  const System& system = loose.system;
  const int n = system.interface->n_nodes();
  State state = at_rest(system);
  for (Vector* part : {&state.x, &state.v, &state.a}) *part = Vector::Random(system.size());
  const std::vector<double> no_load(system.loads.size(), 0.);
  const auto read = [&](const char* name) {
    return evaluate(system.readings[static_cast<std::size_t>(system.reading(name))], state, no_load);
  };
  const double shear = sum_of(system, state, system.first_slip(), n);
  EXPECT_NEAR(-shear, read("shear_force"), round_off * 1e12);
  const double normal = sum_of(system, state, system.first_opening(), n);
  EXPECT_NEAR(normal, read("normal_force") - read("uplift"), round_off * 1e12);
  EXPECT_GT(std::abs(shear) + std::abs(normal), 1e6);  // of forces up to 1e12
}

/// The same forces node by node: from the rows of the interface unknowns, and from the readings of stress of the
/// system without these.
TEST_P(Bottom, StressesOfNodesAreTheirForces) {
  scene_.base_stress = true;
  const Compiled loose(scene_, *mesh_, true);
  const System& system = loose.system;
  State state = at_rest(system);
  for (Vector* part : {&state.x, &state.v, &state.a}) *part = Vector::Random(system.size());
  const std::vector<double> no_load(system.loads.size(), 0.);
  for (int i = 0; i < system.interface->n_nodes(); ++i) {
    const double length = system.interface->length[static_cast<std::size_t>(i)];
    const auto read = [&](const std::string& name) {
      const int found = system.reading("base/" + std::to_string(i) + "/" + name);
      return evaluate(system.readings[static_cast<std::size_t>(found)], state, no_load);
    };
    const double shear = sum_of(system, state, system.first_slip() + i, 1);
    EXPECT_NEAR(-shear, read("shear_stress") * length, round_off * 1e12) << i;
    const double normal = sum_of(system, state, system.first_opening() + i, 1);
    EXPECT_NEAR(normal, read("normal_stress") * length, round_off * 1e12) << i;
  }
}

/// Loads on the ground beside the caisson act on nodes that it shares with the caisson: they enter the stresses as
/// they enter F_T.
TEST_P(Bottom, StressesSumToTheForcesOfAllLoads) {
  scene_.base_stress = true;
  const Compiled plain(scene_, *mesh_);
  const System& system = plain.system;
  State state = at_rest(system);
  for (Vector* part : {&state.x, &state.v, &state.a}) *part = Vector::Random(system.size());
  const std::vector<double> load(system.loads.size(), 1e9);
  std::map<std::string, double> sum;
  for (const Reading& reading : system.readings) {
    if (reading.name.group != "base") continue;
    const auto node = interface_nodes(plain.space)[static_cast<std::size_t>(reading.name.node)];
    sum[reading.name.quantity] += node.length * evaluate(reading, state, load);
  }
  const auto read = [&](const char* name) {
    return evaluate(system.readings[static_cast<std::size_t>(system.reading(name))], state, load);
  };
  EXPECT_NEAR(sum.at("shear_stress"), read("shear_force"), round_off * 1e12);
  EXPECT_NEAR(sum.at("normal_stress"), read("normal_force") - read("uplift"), round_off * 1e12);
  EXPECT_NEAR(sum.at("pore_pressure"), read("uplift"), round_off * 1e6);
}

TEST_P(Bottom, RigidSlipMovesTheCaissonAndNothingElse) {
  const Compiled loose(scene_, *mesh_, true);
  const System& system = loose.system;
  const int n = system.interface->n_nodes(), b = loose.scene.body_coordinates.front();
  for (const auto& [motion, first] : {std::pair(motion_x, system.first_slip()), {motion_y, system.first_opening()}}) {
    Vector x = Vector::Zero(system.size());
    x[b + motion] = 1.;
    x.segment(first, n).setOnes();
    EXPECT_LE((system.K * x).norm(), round_off * system.K.col(b + motion).norm());
  }
  const System sliding = with_rigid_slip(system);
  ASSERT_EQ(sliding.size(), system.first_slip() + 1);
  EXPECT_EQ(sliding.n_prescribed, 0);
  Vector x = Vector::Zero(sliding.size());
  x[b + motion_x] = x[sliding.n_free() - 1] = 1.;
  EXPECT_LE((sliding.K * x).norm(), round_off * sliding.K.col(b + motion_x).norm());
}

TEST_P(Bottom, MatricesStaySymmetric) {
  const Compiled loose(scene_, *mesh_, true);
  for (const SparseMatrix* A : {&loose.system.M, &loose.system.C, &loose.system.K})
    EXPECT_LE(difference(*A, SparseMatrix(A->transpose())), round_off);
}

TEST_P(Bottom, LengthsOfNodesAreThoseOfTheBottom) {
  const Compiled loose(scene_, *mesh_, true);
  double sum = 0.;
  for (const double length : loose.system.interface->length) {
    EXPECT_GT(length, 0.);
    sum += length;
  }
  EXPECT_NEAR(sum, 18., 1e-9);
}

TEST_P(Bottom, ForcesAtRestCarryTheWeightInWater) {
  const Compiled loose(scene_, *mesh_, true);
  const Vector N = static_normal_forces(loose.resolved, *mesh_, {});
  ASSERT_EQ(N.size(), loose.system.interface->n_nodes());
  EXPECT_GT(N.minCoeff(), 0.);
  // caisson 18 m wide and 16 m high, 9 m of them below water
  const double weight = 9.81 * 18. * (2100. * 16. - 1030. * 9.);
  EXPECT_NEAR(N.sum(), weight, 1e-6 * weight);
  double moment = 0.;
  for (int i = 0; i < N.size(); ++i) moment += N[i] * loose.system.interface->position[static_cast<std::size_t>(i)];
  // not zero where one half is refined, as the meshes of both halves then differ
  EXPECT_NEAR(moment, 0., 1e-3 * weight * 18.);
}

TEST_P(Bottom, ForcesAtRestCarryStillWaterAtTwoLevels) {
  scene_.initial = InitialState{};
  scene_.initial->water_level = 15.;
  scene_.initial->harbour_level = 12.;
  const Compiled loose(scene_, *mesh_, true);
  const Vector N = static_normal_forces(loose.resolved, *mesh_, {});
  // 9 and 6 m of water above the bottom; the pressure under it falls in a straight line, so that W' is larger by
  // rho g B 3/2 on a line B/6 landward of the middle, and the push turns by rho g (9^3 - 6^3)/6
  const double rho_g = 1030. * 9.81, more = rho_g * 18. * 1.5;
  const double weight = 9.81 * 18. * (2100. * 16. - 1030. * 9.) + more;
  EXPECT_NEAR(N.sum(), weight, 1e-6 * weight);
  double moment = 0.;
  for (int i = 0; i < N.size(); ++i) moment += N[i] * loose.system.interface->position[static_cast<std::size_t>(i)];
  EXPECT_NEAR(moment, rho_g * (729. - 216.) / 6. + more * 3., 1e-3 * weight * 18.);
}

INSTANTIATE_TEST_SUITE_P(Levels, Bottom, testing::Values(0, 2));

}  // namespace interface_test
}  // namespace upbead::test
