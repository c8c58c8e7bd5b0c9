// Claims: only loads on ground that deforms count, with the cells across their side, the probes of each region and
// their distances, whichever way the mesh numbers the corners of its cells; a load on the rigid caisson does not, nor
// one that is switched off.
#include "response/ground_waves.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace upbead::test {
namespace loaded_ground_test {

Scene probed_column() {
  Scene scene = column(sand(), triangle(1e3, 0.1));
  scene.probes["high"].at = {0.5, 8.};
  scene.probes["low"].at = {0.5, 3.};
  return scene;
}

TEST(LoadedGround, HasCellsAndDistancesOfAColumn) {
  const auto mesh = column_mesh(10., 40);
  const auto list = loaded_grounds(probed_column(), *mesh);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].load, "top");
  EXPECT_EQ(list[0].region, "soil");
  EXPECT_EQ(list[0].onlooker, "probe 'high'");
  EXPECT_TRUE(list[0].pushes);
  EXPECT_FALSE(list[0].shears);
  EXPECT_TRUE(list[0].is_plane);
  EXPECT_NEAR(list[0].cell, 0.25, 1e-9);
  EXPECT_NEAR(list[0].nearest, 2., 1e-9);
  EXPECT_NEAR(list[0].farthest, 7., 1e-9);
}

TEST(LoadedGround, KnowsDirectionsAndFields) {
  const auto mesh = column_mesh(10., 40);
  Scene scene = column(sand(), triangle(1e3, 0.1));
  EXPECT_TRUE(loaded_grounds(scene, *mesh).empty()) << "nobody looks";
  scene.fields_every = 0.1;
  scene.loads.at("top").direction = {1., 0.};
  const auto list = loaded_grounds(scene, *mesh);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_FALSE(list[0].pushes);
  EXPECT_TRUE(list[0].shears);
  EXPECT_EQ(list[0].onlooker, "the fields");
  EXPECT_GT(list[0].farthest, 9.);
  scene.loads.at("top").factor = 0.;
  EXPECT_TRUE(loaded_grounds(scene, *mesh).empty());
}

TEST(LoadedGround, IsNotUnderARigidCaisson) {
  Scene scene = breakwater(triangle(1e6, 0.15));
  scene.fields_every = 0.1;
  const auto mesh = breakwater_mesh(0.35);
  EXPECT_TRUE(loaded_grounds(scene, *mesh).empty());
  Load& load = scene.loads.begin()->second;
  load.boundary = "bed";
  load.kind = LoadKind::pressure;
  const auto list = loaded_grounds(scene, *mesh);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_TRUE(list[0].is_plane) << "from one end of the mesh to the other";
  EXPECT_EQ(list[1].region, "seabed");
  load.boundary = "mound_surface";
  EXPECT_FALSE(loaded_grounds(scene, *mesh).at(0).is_plane);
}

/// Two cells of 2 m beside each other under a ridge of that height: the upper face of the second runs the other way
/// than that of the first.
void make_opposed_cells(Mesh& mesh, double ridge) {
  const std::vector<dealii::Point<dim>> corners{{0., 0.}, {2., 0.}, {0., 1.}, {2., 1. + ridge}, {4., 0.}, {4., 1.}};
  std::vector<dealii::CellData<dim>> cells(2);
  cells[0].vertices = {0, 1, 2, 3};
  cells[1].vertices = {4, 5, 1, 3};
  mesh.triangulation.create_triangulation(corners, cells, {});
  mesh.surfaces = {"soil"};
  mesh.curves = {"top"};
  for (const auto& face : mesh.triangulation.active_face_iterators())
    if (face->center()[1] >= 1.) face->set_manifold_id(0);
  for (const auto& cell : mesh.triangulation.active_cell_iterators()) cell->set_material_id(0);
}

TEST(LoadedGround, PushesWhicheverWayFacesAreNumbered) {
  Mesh mesh;
  make_opposed_cells(mesh, 0.);
  Scene scene = column(sand(), triangle(1e3, 0.1));
  scene.probes["low"].at = {1.5, 0.25};
  const auto list = loaded_grounds(scene, mesh);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_TRUE(list[0].pushes);
  EXPECT_TRUE(list[0].is_plane);
  EXPECT_NEAR(list[0].cell, 1., 1e-12) << "across, not along";
  EXPECT_NEAR(list[0].nearest, 0.75, 1e-12);
}

TEST(LoadedGround, HasTheMeanNormalOfItsFaces) {
  Mesh mesh;
  make_opposed_cells(mesh, 1.);
  Scene scene = column(sand(), triangle(1e3, 0.1));
  scene.probes["low"].at = {1.5, 0.25};
  scene.loads.at("top").direction = {1., 0.};
  const auto list = loaded_grounds(scene, mesh);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_TRUE(list[0].shears);
  EXPECT_FALSE(list[0].pushes) << "what one slope is pushed, the other is pulled";
}

}  // namespace loaded_ground_test
}  // namespace upbead::test
