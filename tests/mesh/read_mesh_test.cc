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

void convert(const std::string& script, const std::string& file, const std::map<std::string, double>& options) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  for (const auto& [name, value] : options) gmsh::option::setNumber("Mesh." + name, value);
  gmsh::open(script);
  gmsh::model::mesh::generate(2);
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
      convert(script.file, file, {{"MshFileVersion", version}, {"Binary", binary}});
      EXPECT_EQ(description(*read_mesh(request_for(file))), expected) << version << binary;
    }
}

/// Quadrilaterals with 8, 9 and more nodes, triangles with 6 and more, lines with 3 and more.
TEST(ReadMesh, CellsOfHigherOrderAreReadByTheirCorners) {
  const TemporaryFolder folder;
  const std::string triangles = folder.write("t.geo", rectangle_script("Mesh.MeshSizeMax = 0.5;"));
  for (const std::string& script : {geometry("composite").file, triangles}) {
    const auto expected = read_mesh(request_for(script));
    EXPECT_EQ(expected->n_high_order, 0);
    for (const double order : {2., 3.})
      for (const double incomplete : {0., 1.})
        for (const double version : {2.2, 4.1}) {
          const std::string file = folder.path("a.msh");
          convert(script, file,
                  {{"ElementOrder", order}, {"SecondOrderIncomplete", incomplete}, {"MshFileVersion", version}});
          const auto mesh = read_mesh(request_for(file));
          EXPECT_EQ(description(*mesh), description(*expected)) << script << order << incomplete << version;
          EXPECT_EQ(mesh->n_divided_triangles, expected->n_divided_triangles);
          EXPECT_GT(mesh->n_high_order, 0);
          EXPECT_LT(mesh->most_bent, 1e-9) << "its sides are straight";
        }
  }
}

/// The unit cell with nodes between its corners; `bent`: how far that of its right side is off.
MshFile cell_with_middles(int type, double bent) {
  MshFile file = unit_cell();
  file.nodes.insert(file.nodes.end(), {"5 0.25 0 0", "6 " + std::to_string(1 + bent) + " 0.5 0", "7 0.5 1 0",
                                       "8 0 0.5 0", "9 0.5 0.5 0"});
  file.elements = {"1 8 2 1 1 1 2 5", "2 8 2 2 2 2 3 6", "3 8 2 2 3 3 4 7", "4 8 2 2 4 4 1 8"};
  if (type == 9)
    file.elements.insert(file.elements.end(), {"5 9 2 1 1 1 2 3 5 6 9", "6 9 2 1 1 1 3 4 9 7 8"});
  else
    file.elements.push_back("5 " + std::to_string(type) + " 2 1 1 1 2 3 4 5 6 7 8" + (type == 10 ? " 9" : ""));
  return file;
}

TEST(ReadMesh, SidesThatAreBentAreTold) {
  for (const int type : {16, 10, 9})
    for (const double bent : {0., 0.125, -0.01}) {
      const TemporaryFolder folder;
      const auto mesh = read_mesh(request_for(folder.write("a.msh", cell_with_middles(type, bent).text())));
      EXPECT_NEAR(mesh->most_bent, std::abs(bent), 1e-12) << type;
      EXPECT_EQ(mesh->n_high_order, type == 9 ? 2 : 1);
      EXPECT_NEAR(areas(*mesh).at("soil"), 1., 1e-12) << type;
      EXPECT_NEAR(lengths(*mesh).at("rest"), 3., 1e-12) << type;
    }
}

/// The file with the coordinates of all nodes exchanged: x, y, z by their places in `order`, z at `height`.
std::string turned(MshFile file, const std::string& order, const std::string& height) {
  for (std::string& node : file.nodes) {
    std::map<char, std::string> at;
    std::stringstream words(node);
    std::string number;
    words >> number >> at['x'] >> at['y'] >> at['z'];
    at['z'] = height;
    node = number;
    for (const char axis : order) node += " " + at[axis];
  }
  return file.text();
}

TEST(ReadMesh, MayLieAtAnyHeightZ) {
  const TemporaryFolder folder;
  const auto flat = read_mesh(request_for(folder.write("a.msh", unit_cell().text())));
  for (const char* height : {"7.5", "-1e5", "1e-3"}) {
    const auto mesh = read_mesh(request_for(folder.write("a.msh", turned(unit_cell(), "xyz", height))));
    EXPECT_EQ(description(*mesh), description(*flat)) << height;
  }
  MshFile file = unit_cell();
  file.nodes.push_back("5 0 0 3");  // of no cell
  EXPECT_EQ(description(*read_mesh(request_for(folder.write("a.msh", file.text())))), description(*flat));
}

TEST(ReadMesh, OtherPlanesAreRefusedWithTheirCure) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& text) { return complaints(request_for(folder.write("a.msh", text))); };
  const std::string turn =
      "; turn it, so that x is landward and y up; in a script, of x and z: Rotate {{1, 0, 0}, {0, 0, "
      "0}, -Pi/2} {Surface{:};}";
  for (const char* height : {"0", "2"}) {
    EXPECT_EQ(said(turned(unit_cell(), "xzy", height)),
              test::said("it lies in the plane of x and z: y is the same throughout" + turn));
    EXPECT_EQ(said(turned(unit_cell(), "zxy", height)),
              test::said("it lies in the plane of y and z: x is the same throughout" + turn));
  }
  const std::string standing = folder.write(
      "a.geo", rectangle_script("Mesh.RecombineAll = 1; Rotate {{1, 0, 0}, {0, 0, 0}, Pi/2} {Surface{:};}"));
  EXPECT_EQ(complaints(request_for(standing)).size(), 1U);
  const std::string cured = folder.write(
      "a.geo", rectangle_script("Mesh.RecombineAll = 1; Rotate {{1, 0, 0}, {0, 0, 0}, Pi/2} {Surface{:};}\n"
                                "Rotate {{1, 0, 0}, {0, 0, 0}, -Pi/2} {Surface{:};}"));
  EXPECT_NEAR(areas(*read_mesh(request_for(cured))).at("soil"), 2., 1e-12);
}

TEST(ReadMesh, NamesMayHaveBlanksAndGroupsNoCells) {
  MshFile file = unit_cell();
  file.names = {"1 1 \"the base\"", "1 2 \"rest\"", "2 1 \"fine sand\"", "2 7 \"nowhere\"", "1 8 \"no line\""};
  const TemporaryFolder folder;
  const auto mesh = read_mesh(request_for(folder.write("a.msh", file.text())));
  EXPECT_NEAR(areas(*mesh).at("fine sand"), 1., 1e-12);
  EXPECT_NEAR(lengths(*mesh).at("the base"), 1., 1e-12);
  EXPECT_EQ(mesh->surfaces.size(), 1U);
}

TEST(ReadMesh, LinesMayEndAsOnWindows) {
  std::string text;
  for (const char c : unit_cell().text()) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const TemporaryFolder folder;
  EXPECT_NEAR(areas(*read_mesh(request_for(folder.write("a.msh", text)))).at("soil"), 1., 1e-12);
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
