// Claims: the estimate of the error of F_T by the mesh falls as cells are split, the largest shares are at the
// corners of the caisson's bottom, mirrored cells have equal shares, and no frequency depends on the unit of time; the
// spectrum is that of a direct solve, and those of two scenes give the difference of their responses.
#include "response/spectrum.h"

#include <gtest/gtest.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace mesh_error_test {

MeshError error_of(const Compiled& compiled) {
  return mesh_error(compiled.resolved, compiled.space, compiled.unknowns, compiled.scene);
}

TEST(MeshError, FallsWithSmallerCells) {
  const Scene scene = breakwater(triangle(1e6, 0.15));
  const double coarse = error_of(Compiled(scene, *breakwater_mesh(0.35))).sum,
               middle = error_of(Compiled(scene, *breakwater_mesh(0.7))).sum,
               fine = error_of(Compiled(scene, *breakwater_mesh(1.4))).sum;
  EXPECT_LT(middle, 0.6 * coarse);
  EXPECT_LT(fine, 0.6 * middle);
  EXPECT_LT(coarse, 0.05);
}

TEST(MeshError, IsLargestAtTheCornersAndSymmetric) {
  const auto mesh = breakwater_mesh(0.5, {{"grading", 1.}});
  const MeshError error = error_of(Compiled(breakwater(triangle(1e6, 0.15)), *mesh));
  const auto largest = std::max_element(error.of_cell.begin(), error.of_cell.end());
  std::vector<dealii::Point<dim>> where(error.of_cell.size());
  for (const auto& cell : mesh->triangulation.active_cell_iterators())
    where[cell->active_cell_index()] = cell->center();
  const dealii::Point<dim> worst = where[static_cast<std::size_t>(largest - error.of_cell.begin())];
  EXPECT_LE(std::hypot(std::abs(worst[0]) - 9., worst[1] - 6.), 4.5);  // within the cell at the corner
  for (std::size_t i = 0; i < where.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (std::hypot(where[i][0] + where[j][0], where[i][1] - where[j][1]) > 1e-6) continue;
      EXPECT_NEAR(error.of_cell[i], error.of_cell[j], 1e-7 * *largest);
    }
}

/// The same scene in which everything takes so many times as long.
Scene slower(Scene scene, double times, const TimeFunction& force) {
  const double squared = times * times;
  scene.gravity /= squared;
  scene.fluid.bulk_modulus /= squared;
  for (auto& [name, region] : scene.regions) {
    if (region.kind != RegionKind::porous) continue;
    region.shear_modulus = *region.shear_modulus / squared;
    region.hydraulic_conductivity = *region.hydraulic_conductivity / times;
    for (double& frequency : region.damping->frequencies) frequency /= times;
  }
  scene.loads.at("impulse").history = force;
  scene.time.end *= times;
  return scene;
}

TEST(MeshError, KnowsNoUnitOfTime) {
  const auto mesh = breakwater_mesh(0.35);
  Scene scene = breakwater(triangle(1e6, 0.15));
  scene.time.end = 0.8;
  constexpr double times = 4.;
  const MeshError quick = error_of(Compiled(scene, *mesh)),
                  slow = error_of(Compiled(slower(scene, times, triangle(1e6, 0.15 * times)), *mesh));
  ASSERT_EQ(quick.of_cell.size(), slow.of_cell.size());
  for (std::size_t i = 0; i < quick.of_cell.size(); ++i)
    EXPECT_NEAR(slow.of_cell[i], quick.of_cell[i], 1e-6 * quick.sum);
}

/// Against a direct solve with the whole matrix.
TEST(Spectrum, SolvesTheSystem) {
  const auto mesh = breakwater_mesh(0.35);
  const Compiled compiled(breakwater(triangle(1e6, 0.15)), *mesh);
  const System& system = compiled.system;
  const int n = system.n_free();
  const std::complex<double> s(10., 40.);
  const Spectrum found = solve_spectrum(compiled.resolved, compiled.scene, std::vector{s});
  const Eigen::SparseMatrix<std::complex<double>> T =
      (s * s * system.M + s * system.C + system.K.cast<std::complex<double>>()).eval().topLeftCorner(n, n);
  Eigen::VectorXcd b = Eigen::VectorXcd::Zero(n);
  for (std::size_t k = 0; k < system.loads.size(); ++k)
    b += found.F(static_cast<Eigen::Index>(k), 0) * system.loads[k].vector.head(n);
  const Eigen::SparseLU<Eigen::SparseMatrix<std::complex<double>>> direct(T);
  const Eigen::VectorXcd X = direct.solve(b), off = found.X.col(0).head(n) - X;
  double moved = 0., wrong = 0.;
  for (int i = 0; i < n; ++i) {
    if (system.field[i] != Field::displacement) continue;
    moved += std::norm(X[i]);
    wrong += std::norm(off[i]);
  }
  EXPECT_LT(std::sqrt(wrong / moved), 0.01);
}

TEST(Spectrum, GivesTheDifferenceOfTwoResponses) {
  // The change of F_T near its peak by a change of the scene is that of two marches, within a tenth of the change.
  const auto mesh = breakwater_mesh(0.35);
  const Scene soft = breakwater(triangle(1e6, 0.15));
  Scene stiff = soft;
  stiff.regions["seabed"].shear_modulus = 1.05 * soft.regions.at("seabed").shear_modulus.value();
  const Compiled a(soft, *mesh), b(stiff, *mesh);
  const Spectrum of_a = solve_spectrum(a.resolved, a.scene, 0.), of_b = solve_spectrum(b.resolved, b.scene, 0.);
  std::vector<std::complex<double>> difference;
  for (std::size_t j = 0; j < of_a.s.size(); ++j) difference.push_back(of_b.shear[j] - of_a.shear[j]);
  const double step = 0.15 / 64;
  const Eigen::RowVectorXd marched =
      history(b, run(b, 0.15, step), "shear_force") - history(a, run(a, 0.15, step), "shear_force");
  const double largest = marched.cwiseAbs().maxCoeff();
  ASSERT_GT(largest, 0.);
  for (int i = 16; i <= 60; i += 4)
    EXPECT_NEAR(shear_at(of_a.s, difference, i * step), marched[i], 0.1 * largest) << i * step;
}

}  // namespace mesh_error_test
}  // namespace upbead::test
