// Files and parameters that give no mesh are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace bad_file_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

TEST(BadFile, Missing) {
  EXPECT_EQ(complaints(request_for("/no/where.msh")),
            said("there is no file '/no/where.msh'; check the name and the folder", "where.msh"));
}

TEST(BadFile, Folder) {
  const TemporaryFolder folder;
  EXPECT_THAT(complaints(request_for(folder.path(""))), ElementsAre(HasSubstr("is a folder")));
}

TEST(BadFile, OtherKind) {
  const TemporaryFolder folder;
  for (const char* name : {"a.txt", "a.inp", "a.unv"})
    EXPECT_THAT(complaints(request_for(folder.write(name, "hello\n"))),
                ElementsAre(testing::AllOf(HasSubstr("it is neither a .geo nor a .msh; give a gmsh script (.geo) or a "
                                                     "gmsh mesh (.msh)"),
                                           HasSubstr("gmsh FILE -save -o FILE.msh"))));
}

TEST(BadFile, NoMesh) {
  const TemporaryFolder folder;
  EXPECT_THAT(complaints(request_for(folder.write("a.msh", "hello\n"))),
              ElementsAre(HasSubstr("it has no $MeshFormat")));
  EXPECT_THAT(complaints(request_for(folder.write("b.msh", ""))), ElementsAre(HasSubstr("it has no $MeshFormat")));
}

TEST(BadFile, MeshCutShort) {
  const TemporaryFolder folder;
  const std::string text = unit_cell().text();
  const std::size_t last_element = text.find("5 3 2 1 1");
  for (std::size_t length = 40; length <= last_element; ++length)
    EXPECT_THAT(complaints(request_for(folder.write("a.msh", text.substr(0, length)))), SizeIs(testing::Ge(1u)))
        << text.substr(0, length);
}

TEST(BadFile, MeshThatGmshDoesNotSurvive) {
  // found by tests/fuzz: an element line with the type of a second-order tetrahedron makes gmsh read its nodes from
  // the lines below
  MshFile mesh = unit_cell();
  mesh.elements[1] = "2 11 2 2 3 3 4";
  mesh.elements.erase(mesh.elements.begin() + 2);
  EXPECT_EQ(complaints(mesh), said("gmsh breaks down on it, so it is damaged; save it again from gmsh: File > Export, "
                                   "format 2.2 or 4.1"));
  EXPECT_EQ(complaints(unit_cell()), std::vector<std::string>{});
}

TEST(BadFile, MeshWithNodesTwiceOnWhichGmshThrows) {
  const TemporaryFolder folder;  // found by tests/fuzz: gmsh reads past the end of the mesh and makes a list of size -1
  const std::string nodes = "4\n1 0 0 0\n2 9 0 0\n3 1 1 0\n4 0 0 0\n", end = "4 0 0 0\n$EndNodes\n";
  const std::string text = "$MeshFormat\n2.2 0 8\n$Nodes\n" + nodes +
                           "$EndNodes\n$Elements\n5\n1 1 2 1 1 1 2\n2 1 2 0 2 2\n" + end +
                           "$Elements\n5\n1 1 2 1 1 1 2 3 4\n$EndElements\n";
  EXPECT_THAT(complaints(request_for(folder.write("a.msh", text))), SizeIs(testing::Ge(1u)));
}

TEST(BadFile, ScriptWithSyntaxErrorLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string bad = folder.write("a.geo", "Point(1) = {0, 0, 0}\nPoint(2 = 3, 4, 5, 6 7 8 9 [[ {\n\n\nLine(");
  EXPECT_THAT(complaints(request_for(bad)), ElementsAre(HasSubstr("does not end with a newline")));
  std::string text = "Point(1) = {0, 0, 0}\n";
  for (int i = 0; i < 300; ++i) text += "Point(2 = 3, 4, 5, 6 7 8 9 [[ {\n";
  EXPECT_THAT(complaints(request_for(folder.write("b.geo", text))),
              ElementsAre(testing::AllOf(HasSubstr("gmsh says: "), HasSubstr("line 2: syntax error (Point)"))));
  EXPECT_EQ(complaints(geometry("column")), std::vector<std::string>{});
}

TEST(BadFile, UnknownParameter) {
  const TemporaryFolder folder;
  MeshRequest request = request_for(folder.write("a.geo", rectangle_script("")));
  request.parameters = {{"widht", 3.0}, {"zzz", 1.0}};
  request.parameter_places["widht"] = {"case.toml", 9, 2};
  EXPECT_THAT(
      complaints(request),
      ElementsAre("case.toml:9:2: mesh 'a.geo': it has no parameter 'widht'; did you mean 'width'? it has width = 2",
                  "case.toml:7:8: mesh 'a.geo': it has no parameter 'zzz'; it has width = 2"));
}

TEST(BadFile, ParameterOfMesh) {
  const TemporaryFolder folder;
  MeshRequest request = request_for(folder.write("a.msh", unit_cell().text()));
  request.parameters = {{"width", 3.0}};
  EXPECT_THAT(complaints(request), ElementsAre(HasSubstr("a .msh is finished and takes no parameters, not 'width'")));
}

TEST(BadFile, ParameterWithAnyName) {
  const TemporaryFolder folder;
  MeshRequest request = request_for(folder.write("a.geo", rectangle_script("")));
  for (const std::string name : {"(", "width[", "a\\", "", "*"}) {
    request.parameters = {{name, 3.0}};
    request.parameter_places = {{name, {"case.toml", 9, 2}}};
    EXPECT_THAT(complaints(request), ElementsAre(HasSubstr("it has no parameter '" + name + "'"))) << name;
  }
}

TEST(BadFile, ParameterNotFinite) {
  MeshRequest request = geometry("column", {{"height", INFINITY}});
  EXPECT_THAT(complaints(request), ElementsAre(HasSubstr("parameter 'height' is not a finite number")));
}

TEST(BadFile, ParameterOutOfRangeIsSaidAtItsPlace) {
  MeshRequest request = geometry("column", {{"height", -1.0}, {"cells_across", 0.0}});
  request.parameter_places["height"] = {"case.toml", 9, 2};
  EXPECT_THAT(
      complaints(request),
      ElementsAre(StartsWith("case.toml:9:2: mesh 'column.geo': gmsh says: height is -1; it must be greater than 0"),
                  StartsWith("case.toml:7:8: mesh 'column.geo': gmsh says: cells_across is 0;")));
}

TEST(BadFile, NegativeRefinement) {
  MeshRequest request = geometry("column");
  request.refine = -1;
  EXPECT_THAT(complaints(request), ElementsAre(HasSubstr("cannot be refined a negative number of times")));
}

}  // namespace bad_file_test
}  // namespace upbead::test
