// Surfaces and curves without a name, or with more than one, are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace bad_groups_test {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(BadGroups, UnitCellIsGood) {
  EXPECT_EQ(complaints(unit_cell()), std::vector<std::string>{});
}

TEST(BadGroups, CellOnNoSurface) {
  MshFile file = unit_cell();
  file.elements.back() = "5 3 2 0 1 1 2 3 4";
  EXPECT_EQ(complaints(file), said("1 cell on no physical surface, the first at (0.5, 0.5); "
                                   "name what it is made of: Physical Surface(\"name\") = {...};"));
}

TEST(BadGroups, SurfaceWithoutName) {
  MshFile file = unit_cell();
  file.names.pop_back();
  EXPECT_EQ(complaints(file), said("physical surface 1 has no name of its own; give it one that no other surface has: "
                                   "Physical Surface(\"name\", 1) = {...};"));
}

TEST(BadGroups, CurveWithoutName) {
  MshFile file = unit_cell();
  file.names.erase(file.names.begin());
  EXPECT_EQ(complaints(file), said("physical curve 1 has no name of its own; give it one that no other curve has: "
                                   "Physical Curve(\"name\", 1) = {...};"));
}

TEST(BadGroups, TwoCurvesOfOneName) {
  MshFile file = unit_cell();
  file.names[1] = "1 2 \"base\"";
  EXPECT_EQ(complaints(file), said("physical curve 2 has no name of its own; give it one that no other curve has: "
                                   "Physical Curve(\"name\", 2) = {...};"));
}

TEST(BadGroups, TwoSurfacesOfOneName) {
  MshFile file = unit_cell();
  file.nodes.insert(file.nodes.end(), {"5 2 0 0", "6 2 1 0"});
  file.names.push_back("2 2 \"soil\"");
  file.elements.push_back("6 3 2 2 2 2 5 6 3");
  EXPECT_THAT(complaints(file), testing::Contains(HasSubstr("physical surface 2 has no name of its own")));
}

TEST(BadGroups, SurfaceInTwoGroups) {
  EXPECT_THAT(complaints_of_script(rectangle_script("Transfinite Surface {1}; Recombine Surface {1};\n"
                                                    "Physical Surface(\"sand\") = {1};")),
              ElementsAre(HasSubstr("some cells are on two physical surfaces, 'soil' and 'sand'; keep every surface")));
}

TEST(BadGroups, OuterEdgesOnNoCurve) {
  MshFile file = unit_cell();
  file.elements.erase(file.elements.begin() + 1, file.elements.begin() + 3);
  EXPECT_EQ(complaints(file), said("2 outer edges on no physical curve, the first at (1, 0.5); "
                                   "name every outer curve: Physical Curve(\"name\") = {...};"));
}

TEST(BadGroups, EdgeOnTwoCurves) {
  MshFile file = unit_cell();
  file.elements.push_back("6 1 2 2 9 1 2");
  EXPECT_EQ(complaints(file), said("1 edge on two physical curves, 'base' and 'rest', the first at (0.5, 0); "
                                   "keep every curve in one group only"));
}

TEST(BadGroups, CurveInTwoGroups) {
  EXPECT_THAT(complaints_of_script(rectangle_script("Transfinite Curve {1, 2, 3, 4} = 3;\n"
                                                    "Transfinite Surface {1}; Recombine Surface {1};\n"
                                                    "Physical Curve(\"top\") = {3};")),
              ElementsAre(HasSubstr("2 edges on two physical curves, 'side' and 'top'")));
}

TEST(BadGroups, CurveAwayFromCells) {
  MshFile file = unit_cell();
  file.names.push_back("1 3 \"diagonal\"");
  file.elements.push_back("6 1 2 3 9 1 3");
  EXPECT_EQ(complaints(file),
            said("curve 'diagonal' lies on no side of a cell; draw it as a side of a surface, or drop it"));
}

}  // namespace bad_groups_test
}  // namespace upbead::test
