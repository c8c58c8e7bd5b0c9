// Claims: the row of a caisson's slip that is made of the cells at its bottom is that of the whole scene with its
// interface, on meshes with hanging nodes and with water; the bonded scene with that row answers as the whole one does,
// solved by the bonded scene's factors; the residual of the row is the shear force; the space of the bonded scene with
// the slip's own vectors is the space that the whole scene has, so that both models answer alike, and is the same
// whether the bonded scene has been reduced further or not.
#include "dynamics/slip_basis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algebra/factorisation.h"
#include "fem/caisson/reading_names.h"
#include "fem/compile.h"
#include "mesh/refine.h"
#include "response/reduction.h"
#include "response/slip_reduction.h"
#include "scenes.h"
#include "system/interface.h"

namespace upbead::test {
namespace slip_basis_test {

constexpr double round_off = 1e-12;

std::unique_ptr<Mesh> refined_at_toe(std::unique_ptr<Mesh> mesh) {
  std::vector<bool> chosen(mesh->triangulation.n_active_cells(), false);
  for (const auto& cell : mesh->triangulation.active_cell_iterators())
    chosen[cell->active_cell_index()] = std::hypot(cell->center()[0] + 9., cell->center()[1] - 6.) < 4.;
  return refined(*mesh, chosen);
}

/// A breakwater between two seas, bonded and loose; `levels`: with smaller cells at its toe.
class SlipRowOf : public testing::TestWithParam<int> {
 protected:
  SlipRowOf() : scene_(breakwater(triangle(1.6e6, 0.15))), mesh_(breakwater_mesh(0.35, with_sea())) {
    add_sea(scene_);
    for (int level = 0; level < GetParam(); ++level) mesh_ = refined_at_toe(std::move(mesh_));
  }

  Scene scene_;
  std::unique_ptr<Mesh> mesh_;
};

Vector dense(const Row& row, int n) {
  Vector out = Vector::Zero(n);
  for (const auto& [i, value] : row) out[i] += value;
  return out;
}

void expect_same(const Row& a, const Row& b, int n) {
  const Vector x = dense(a, n), y = dense(b, n);
  ASSERT_GT(x.norm(), 0.);
  EXPECT_LE((x - y).norm(), round_off * x.norm());
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  double largest = 0.;
  for (const double value : a) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], round_off * largest) << i;
}

TEST_P(SlipRowOf, CellsAtTheBottomIsThatOfTheWholeScene) {
  const Compiled plain(scene_, *mesh_), loose(scene_, *mesh_, true);
  const SlipRow whole = slip_row(slip_system(loose.scene).system);
  const SlipRow made = slip_row(slip_system(compile_bottom(plain.resolved, plain.space)).system);
  const int n = plain.system.size();
  expect_same(whole.M, made.M, n);
  expect_same(whole.C, made.C, n);
  expect_same(whole.K, made.K, n);
  EXPECT_NEAR(made.m, whole.m, round_off * whole.m);
  EXPECT_NEAR(made.c, whole.c, round_off * whole.c);
  EXPECT_NEAR(made.k, whole.k, round_off * whole.k);
  expect_same(whole.load, made.load);
  expect_same(whole.position, made.position);
  expect_same(whole.velocity, made.velocity);
  expect_same(whole.acceleration, made.acceleration);
  EXPECT_EQ(made.unit, 1.);
}

/// The residual of the row is -F_T, whose reading is made of forces at nodes of the ground.
TEST_P(SlipRowOf, TheSlipIsMinusTheShearForce) {
  const Compiled plain(scene_, *mesh_);
  const SlipRow row = slip_row(slip_system(compile_bottom(plain.resolved, plain.space)).system);
  const Reading& shear = plain.system.readings[static_cast<std::size_t>(plain.system.reading(reading::shear_force))];
  const int n = plain.system.size();
  const auto minus = [](Row part) {
    for (auto& entry : part) entry.second = -entry.second;
    return part;
  };
  expect_same(row.M, minus(shear.acceleration), n);
  expect_same(row.C, minus(shear.velocity), n);
  expect_same(row.K, minus(shear.position), n);
}

/// x = T^-1 (b f - t s), and s by the Schur complement of one row: F_T may be any.
TEST_P(SlipRowOf, TheBondedFactorsSolveTheSceneThatSlips) {
  const Compiled plain(scene_, *mesh_), loose(scene_, *mesh_, true);
  const System whole = slip_system(loose.scene).system;
  const SlipRow row = slip_row(slip_system(compile_bottom(plain.resolved, plain.space)).system);
  const int n = plain.system.size();
  ASSERT_EQ(plain.system.n_prescribed, 0);
  for (const double z : {3., 50., 400.}) {
    const auto at = [z](const System& system) -> SparseMatrix { return z * z * system.M + z * system.C + system.K; };
    for (const double friction : {0., 1e5}) {
      Vector b = whole.loads.front().vector;
      b += friction * whole.loads.back().vector;
      const Vector exact = Factorisation(at(whole), whole.blocks).solve(b);
      const Factorisation bonded_factors(at(plain.system), plain.system.blocks);
      const Vector t = z * z * dense(row.M, n) + z * dense(row.C, n) + dense(row.K, n);
      const Vector stuck = bonded_factors.solve(plain.system.loads.front().vector), answer = bonded_factors.solve(t);
      const double own = z * z * row.m + z * row.c + row.k;
      const double s = (row.load.front() - friction - t.dot(stuck)) / (own - t.dot(answer));
      const Vector x = stuck - s * answer;
      EXPECT_NEAR(s, exact[whole.n_free() - 1], 1e-10 * std::abs(s)) << z;
      EXPECT_LE((x - exact.head(n)).norm(), 1e-10 * x.norm()) << z;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, SlipRowOf, testing::Values(0, 2));

struct Both {
  Both()
      : scene(breakwater(triangle(1.6e6, 0.15))),
        mesh(breakwater_mesh(0.35, with_sea())),
        plain((add_sea(scene), scene.time.end = 0.6, scene), *mesh),
        loose(scene, *mesh, true),
        slips(slip_system(loose.scene)) {
    options.shift = krylov_shift(plain.resolved);
    options.exact = plain.scene.body_coordinates;
  }

  Scene scene;
  std::unique_ptr<Mesh> mesh;
  Compiled plain, loose;
  SlipSystem slips;
  ReduceOptions options;
};

/// Largest difference of any reading of both models, over its largest value, under the load and under friction.
double difference(const ReducedSystem& a, const ReducedSystem& b, const Both& both) {
  const SampledLoads loads = sampled_loads(both.plain.resolved, both.plain.system);
  const SampledLoads all = with_load(loads, 0.1 * loads.begin.row(0));
  const auto answer = [&](const ReducedSystem& system) {
    return respond(stuck_and_free(system, slip_law(system, 1., UpliftKind::computed)), all).reading;
  };
  const Eigen::MatrixXd x = answer(a), y = answer(b);
  const Eigen::VectorXd largest = y.cwiseAbs().rowwise().maxCoeff();
  return (x - y).cwiseAbs().rowwise().maxCoeff().cwiseQuotient(largest).maxCoeff();
}

TEST(SlipBasis, IsTheSpaceOfTheWholeScene) {
  const Both both;
  ReduceOptions whole = both.options;
  whole.exact = both.slips.exact;
  GrowingBasis alone(both.slips.system, whole);
  const auto basis = slip_basis(both.plain.resolved, both.plain.scene, both.slips);
  for (const std::size_t number : {0u, 1u}) {
    const Look &of_whole = alone.look(number), &look = basis->look(number);
    EXPECT_EQ(look.n_vectors, of_whole.n_vectors);
    EXPECT_EQ(look.system.size(), of_whole.system.size());
    EXPECT_EQ(look.system.load_name, of_whole.system.load_name);
    // what one model differs from the next by is a thousand times as much
    EXPECT_LE(difference(look.system, of_whole.system, both), 1e-7) << number;
  }
}

TEST(SlipBasis, IsTheSameBesideAnyLookOfTheBondedScene) {
  const Both both;
  const auto grown = std::make_shared<GrowingBasis>(both.plain.system, both.options);
  grown->look(3);
  const auto fresh = slip_basis(both.plain.resolved, both.plain.scene, both.slips);
  fresh->prepare();
  const auto beside = slip_basis(both.plain.resolved, both.plain.scene, both.slips, grown);
  for (const std::size_t number : {0u, 1u}) {
    const ReducedSystem &a = fresh->look(number).system, &b = beside->look(number).system;
    EXPECT_EQ(a.M, b.M);
    EXPECT_EQ(a.C, b.C);
    EXPECT_EQ(a.K, b.K);
    EXPECT_EQ(a.load, b.load);
    EXPECT_EQ(a.velocity, b.velocity);
  }
}

}  // namespace slip_basis_test
}  // namespace upbead::test
