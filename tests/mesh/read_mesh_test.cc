// The triangulation that a valid mesh gives.
#include <gmsh.h>
#include <gtest/gtest.h>

#include "mesh_test_tools.h"
#include "mirror.h"

namespace upbead::test {
namespace read_mesh_test {

/// Cells and named faces, by their middles, in a comparable form.
std::vector<std::string> description(const Mesh& mesh) {
  std::vector<std::string> lines;
  const auto text = [](const auto& object, const std::string& name) {
    const auto middle = object->center();
    return name + " " + std::to_string(middle[0]) + " " + std::to_string(middle[1]);
  };
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    lines.push_back(text(cell, mesh.surface_of(cell)));
  for (const auto& face : mesh.triangulation.active_face_iterators())
    if (!mesh.curve_of(face).empty()) lines.push_back(text(face, mesh.curve_of(face)));
  std::sort(lines.begin(), lines.end());
  return lines;
}

void convert(const std::string& script, const std::string& file, double version, bool binary) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open(script);
  gmsh::model::mesh::generate(2);
  gmsh::option::setNumber("Mesh.MshFileVersion", version);
  gmsh::option::setNumber("Mesh.Binary", binary);
  gmsh::write(file);
  gmsh::finalize();
}

TEST(ReadMesh, ScriptAndFilesOfEveryFormatAreAlike) {
  const MeshRequest script = geometry("composite");
  const auto expected = description(*read_mesh(script));
  const TemporaryFolder folder;
  for (const double version : {2.2, 4.1})
    for (const bool binary : {false, true}) {
      const std::string file = folder.path("a.msh");
      convert(script.file, file, version, binary);
      EXPECT_EQ(description(*read_mesh(request_for(file))), expected) << version << binary;
    }
}

TEST(ReadMesh, ClockwiseCellsAreTurned) {
  MshFile file = unit_cell();
  file.elements.back() = "5 3 2 1 1 4 3 2 1";
  const TemporaryFolder folder;
  const auto mesh = read_mesh(request_for(folder.write("a.msh", file.text())));
  EXPECT_NEAR(smallest_sine(*mesh), 1.0, 1e-12);
  EXPECT_NEAR(areas(*mesh).at("soil"), 1.0, 1e-12);
}

/// A quadrilateral beside two triangles: corners and midpoints of common sides coincide, names stay.
TEST(ReadMesh, TrianglesBecomeQuadrilateralsThatFitTheOthers) {
  MshFile file = unit_cell();
  file.nodes.insert(file.nodes.end(), {"5 2 0 0", "6 2 1 0"});
  file.elements[1] = "2 1 2 2 2 5 6";
  file.elements.insert(file.elements.end(), {"6 2 2 1 1 2 5 6", "7 2 2 1 1 3 2 6", "8 1 2 1 1 2 5", "9 1 2 2 3 6 3"});
  const TemporaryFolder folder;
  const auto mesh = read_mesh(request_for(folder.write("a.msh", file.text())));
  EXPECT_EQ(mesh->n_divided_triangles, 2);
  EXPECT_EQ(mesh->triangulation.n_active_cells(), 4u + 2u * 3u);
  EXPECT_EQ(mesh->triangulation.n_vertices(), 6u + 8u + 3u) << "corners, middles of sides, centres: each once";
  EXPECT_NEAR(areas(*mesh).at("soil"), 2., 1e-12);
  EXPECT_NEAR(lengths(*mesh).at("base"), 2., 1e-12);
  EXPECT_NEAR(lengths(*mesh).at("rest"), 4., 1e-12);
  EXPECT_GT(smallest_sine(*mesh), 0.3);
}

TEST(ReadMesh, TrianglesOfAScriptKeepItsAreaAndSides) {
  const TemporaryFolder folder;
  const auto mesh = read_mesh(request_for(folder.write("a.geo", rectangle_script("Mesh.MeshSizeMax = 0.2;"))));
  EXPECT_GT(mesh->n_divided_triangles, 50);
  EXPECT_EQ(mesh->triangulation.n_active_cells(), 3u * static_cast<unsigned>(mesh->n_divided_triangles));
  EXPECT_NEAR(areas(*mesh).at("soil"), 2., 1e-12);
  EXPECT_NEAR(lengths(*mesh).at("side"), 6., 1e-12);
  const auto divided_by_gmsh = read_mesh(
      request_for(folder.write("b.geo", rectangle_script("Mesh.MeshSizeMax = 0.2; Mesh.SubdivisionAlgorithm = 1;"))));
  EXPECT_EQ(divided_by_gmsh->n_divided_triangles, 0);
  EXPECT_EQ(description(*mesh), description(*divided_by_gmsh));
}

TEST(ReadMesh, UnusedNodesAndPhysicalPointsAreIgnored) {
  MshFile file = unit_cell();
  file.nodes.insert(file.nodes.begin(), "99 5 5 0");
  file.names.push_back("0 7 \"corner\"");
  file.elements.push_back("6 15 2 7 1 1");
  const TemporaryFolder folder;
  const auto mesh = read_mesh(request_for(folder.write("a.msh", file.text())));
  EXPECT_EQ(mesh->triangulation.n_vertices(), 4u);
}

TEST(ReadMesh, NamesSurviveRefinement) {
  MeshRequest request = geometry("composite");
  const auto coarse = read_mesh(request);
  request.refine = 2;
  const auto fine = read_mesh(request);
  EXPECT_EQ(fine->triangulation.n_active_cells(), 16 * coarse->triangulation.n_active_cells());
  for (const auto& [name, area] : areas(*coarse)) EXPECT_NEAR(areas(*fine).at(name), area, 1e-9 * area) << name;
  const auto expected = lengths(*coarse), found = lengths(*fine);
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [name, length] : expected) EXPECT_NEAR(found.at(name), length, 1e-9 * length) << name;
}

TEST(ReadMesh, InteriorCurvesAreNamedButNoBoundary) {
  const auto mesh = read_mesh(geometry("composite"));
  for (const auto& face : mesh->triangulation.active_face_iterators()) {
    const std::string& name = mesh->curve_of(face);
    EXPECT_EQ(face->at_boundary(), !name.empty() && name != "bottom") << name;
  }
}

TEST(ReadMesh, IncludedScriptsAreFoundBesideTheirOwn) {
  const TemporaryFolder folder;
  folder.write("rest.geo", "Transfinite Surface {1}; Recombine Surface {1};\n");
  MeshRequest request = request_for(folder.write("a.geo", rectangle_script("Include \"rest.geo\";")));
  EXPECT_NEAR(areas(*read_mesh(request)).at("soil"), 2.0, 1e-12);
  request.parameters = {{"width", 5}};
  EXPECT_NEAR(areas(*read_mesh(request)).at("soil"), 5.0, 1e-12);
}

TEST(ReadMesh, MirrorKeepsNamesAndAreas) {
  MeshRequest request = geometry("composite", {{"seabed_front", 30}, {"mound_crest_back", 20}});
  request.refine = 1;
  const auto mesh = read_mesh(request);
  const auto area = areas(*mesh), length = lengths(*mesh);
  mirror(*mesh);
  EXPECT_GT(smallest_sine(*mesh), 0.3);
  for (const auto& [name, value] : area) EXPECT_NEAR(areas(*mesh).at(name), value, 1e-9 * value) << name;
  for (const auto& [name, value] : length) EXPECT_NEAR(lengths(*mesh).at(name), value, 1e-9 * value) << name;
  for (const auto& face : mesh->triangulation.active_face_iterators())
    if (mesh->curve_of(face) == "front") {
      EXPECT_EQ(face->center()[0], 9.0);
    }
}

}  // namespace read_mesh_test
}  // namespace upbead::test
