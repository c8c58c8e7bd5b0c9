#include <gtest/gtest.h>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace column_test {

TEST(Column, Defaults) {
  const auto mesh = read_mesh(geometry("column"));
  EXPECT_EQ(cell_counts(*mesh), (std::map<std::string, unsigned int>{{"soil", 20}}));
  EXPECT_NEAR(areas(*mesh).at("soil"), 10.0, 1e-12);
  const auto length = lengths(*mesh);
  EXPECT_NEAR(length.at("base"), 1.0, 1e-12);
  EXPECT_NEAR(length.at("left"), 10.0, 1e-12);
  EXPECT_NEAR(length.at("right"), 10.0, 1e-12);
  EXPECT_NEAR(length.at("top"), 1.0, 1e-12);
  for (const auto& face : mesh->triangulation.active_face_iterators()) {
    if (mesh->curve_of(face) == "base") {
      EXPECT_EQ(face->center()[1], 0.0);
    }
    if (mesh->curve_of(face) == "left") {
      EXPECT_EQ(face->center()[0], 0.0);
    }
  }
}

TEST(Column, Grading) {
  const auto mesh = read_mesh(geometry("column", {{"cells", 5}, {"cells_across", 3}, {"width", 6}, {"grading", 4}}));
  EXPECT_EQ(mesh->triangulation.n_active_cells(), 15u);
  double lowest = 0, highest = 0;
  for (const auto& cell : mesh->triangulation.active_cell_iterators()) {
    const double height = cell->vertex(2)[1] - cell->vertex(0)[1];
    EXPECT_NEAR(cell->vertex(1)[0] - cell->vertex(0)[0], 2.0, 1e-9);
    if (cell->vertex(0)[1] < 1e-12) lowest = height;
    if (cell->vertex(2)[1] > 10 - 1e-12) highest = height;
  }
  EXPECT_NEAR(lowest / highest, 4.0, 1e-6);
}

TEST(Column, ParametersAreForgottenBetweenMeshes) {
  EXPECT_NEAR(areas(*read_mesh(geometry("column", {{"height", 3}}))).at("soil"), 3.0, 1e-12);
  EXPECT_NEAR(areas(*read_mesh(geometry("column", {{"width", 2}}))).at("soil"), 20.0, 1e-12);
  EXPECT_NEAR(areas(*read_mesh(geometry("column"))).at("soil"), 10.0, 1e-12);
}

}  // namespace column_test
}  // namespace upbead::test
