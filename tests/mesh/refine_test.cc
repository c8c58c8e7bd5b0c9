// Claims: cells that are chosen are split; neighbours differ by one level at most; surfaces meet without hanging nodes;
// names survive, also those of a copy on cells half as large.
#include "mesh/refine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace refine_test {

std::unique_ptr<Mesh> section() {
  return read_mesh(geometry("composite", {{"cells", 0.35}, {"grading", 3}, {"sea_front", 4}, {"sea_back", 4}}));
}

/// Splits the cells around a point three times.
void refine_about(std::unique_ptr<Mesh>& mesh, const dealii::Point<dim>& point, double distance) {
  for (int level = 0; level < 3; ++level) {
    std::vector<bool> chosen(mesh->triangulation.n_active_cells(), false);
    for (const auto& cell : mesh->triangulation.active_cell_iterators())
      chosen[cell->active_cell_index()] = cell->center().distance(point) < distance;
    mesh = refined(*mesh, chosen);
  }
}

TEST(RefineCells, SplitsTheChosenOnes) {
  auto mesh = section();
  const auto before = mesh->triangulation.n_active_cells();
  std::vector<bool> chosen(before, false);
  for (const auto& cell : mesh->triangulation.active_cell_iterators())
    chosen[cell->active_cell_index()] = mesh->surface_of(cell) == "mound";
  mesh = refined(*mesh, chosen);
  EXPECT_GT(mesh->triangulation.n_active_cells(), before);
  for (const auto& cell : mesh->triangulation.active_cell_iterators()) {
    if (mesh->surface_of(cell) != "mound") continue;
    EXPECT_EQ(cell->level(), 1);
  }
}

TEST(RefineCells, SurfacesMeetWithoutHangingNodes) {
  auto mesh = section();
  refine_about(mesh, {-28., 0.}, 6.);  // the toe: sand, rubble and water
  refine_about(mesh, {9., 6.}, 4.);    // a corner of the caisson
  int n_hanging = 0, n_across = 0;
  for (const auto& cell : mesh->triangulation.active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f)) continue;
      const auto neighbour = cell->neighbor(f);
      if (neighbour->is_active()) {
        EXPECT_LE(std::abs(cell->level() - neighbour->level()), 1);
        n_hanging += cell->neighbor_is_coarser(f) ? 1 : 0;
      }
      if (neighbour->material_id() == cell->material_id()) continue;
      ++n_across;
      EXPECT_TRUE(neighbour->is_active() && neighbour->level() == cell->level());
    }
  EXPECT_GT(n_hanging, 20);
  EXPECT_GT(n_across, 50);
}

TEST(RefineCells, NamesOfSidesSurvive) {
  auto mesh = section();
  const auto length_of = [&](const std::string& curve) {
    double length = 0.;
    for (const auto& face : mesh->triangulation.active_face_iterators())
      if (mesh->curve_of(face) == curve) length += face->measure();
    return length;
  };
  const double bottom = length_of("bottom"), front = length_of("front");
  refine_about(mesh, {9., 6.}, 4.);
  EXPECT_NEAR(length_of("bottom"), bottom, 1e-12 * bottom);
  EXPECT_NEAR(length_of("front"), front, 1e-12 * front);
}

TEST(Halved, SplitsEveryCellOfACopy) {
  auto mesh = section();
  refine_about(mesh, {0., 0.}, 8.);
  const auto before = mesh->triangulation.n_active_cells();
  const auto finer = halved(*mesh);
  EXPECT_EQ(mesh->triangulation.n_active_cells(), before);
  ASSERT_EQ(finer->triangulation.n_active_cells(), 4 * before);
  for (const auto& cell : finer->triangulation.active_cell_iterators()) {
    const dealii::Triangulation<dim>::cell_iterator parent(&mesh->triangulation, cell->level() - 1,
                                                           cell->parent()->index());
    EXPECT_TRUE(parent->is_active());
    EXPECT_LT(parent->center().distance(cell->parent()->center()), 1e-12);
    EXPECT_EQ(finer->surface_of(cell), mesh->surface_of(parent));
  }
}

}  // namespace refine_test
}  // namespace upbead::test
