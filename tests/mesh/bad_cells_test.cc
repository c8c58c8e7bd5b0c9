// Meshes with cells on which nothing can be solved are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace bad_cells_test {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two cells side by side within the curve 'rest', the right one between the given nodes.
MshFile two_cells(const std::vector<std::string>& more_nodes, const std::string& right_nodes,
                  const std::vector<std::string>& right_edges) {
  MshFile file = unit_cell();
  file.nodes.insert(file.nodes.end(), more_nodes.begin(), more_nodes.end());
  file.elements[1] = "2 1 2 2 2 3 4";
  file.elements.push_back("6 3 2 1 1 " + right_nodes);
  for (std::size_t i = 0; i < right_edges.size(); ++i)
    file.elements.push_back(std::to_string(7 + i) + " 1 2 2 " + std::to_string(7 + i) + " " + right_edges[i]);
  return file;
}

TEST(BadCells, None) {
  MshFile file = unit_cell();
  file.elements.pop_back();
  EXPECT_EQ(complaints(file), said("it has no cells; mesh its surfaces in quadrilaterals (gmsh -2)"));
}

TEST(BadCells, SecondOrderIsNotKeptForTheNextMesh) {
  const std::string blocks = "Transfinite Surface {1}; Recombine Surface {1};";
  const TemporaryFolder folder;
  const auto n = [&](const std::string& more) {
    return read_mesh(request_for(folder.write("a.geo", rectangle_script(blocks + more))))->n_high_order;
  };
  EXPECT_GT(n("Mesh.ElementOrder = 2;"), 0);
  EXPECT_EQ(n(""), 0);
}

TEST(BadCells, Degenerate) {
  MshFile file = unit_cell();
  file.nodes[2] = "3 0.5 0.5 0";
  EXPECT_EQ(complaints(file),
            said("surface 'soil' has 1 cell without area or with an angle of 180 degrees or more, the "
                 "first at (0.375, 0.375); draw the block there nearer to a rectangle, or divide its "
                 "opposite sides alike"));
}

TEST(BadCells, BowTie) {
  MshFile file = unit_cell();
  file.elements.back() = "5 3 2 1 1 1 2 4 3";
  EXPECT_THAT(complaints(file), testing::Contains(HasSubstr("angle of 180 degrees or more")));
}

TEST(BadCells, TwoNodesAtOnePlace) {
  const MshFile file = two_cells({"5 1 0 0", "6 2 0 0", "7 2 1 0", "8 1 1 0"}, "5 6 7 8", {"5 6", "6 7", "7 8"});
  EXPECT_EQ(complaints(file),
            said("cells are not joined: two nodes at the same place, the first at (1, 0); use the same "
                 "points and curves for both blocks, or `Coherence;`, or Geometry.AutoCoherence = 1"));
}

TEST(BadCells, PartsThatLieApart) {
  for (const double gap : {1e-5, 0.5}) {
    const std::string from = std::to_string(1. + gap), to = std::to_string(2. + gap);
    const MshFile file = two_cells({"5 " + from + " 0 0", "6 " + to + " 0 0", "7 " + to + " 1 0", "8 " + from + " 1 0"},
                                   "5 6 7 8", {"5 6", "6 7", "7 8", "8 5"});
    EXPECT_THAT(complaints(file), testing::Contains(HasSubstr("2 parts that share no node"))) << gap;
  }
}

TEST(BadCells, HangingNode) {
  MshFile file = two_cells({"5 2 0 0", "6 2 0.5 0", "7 1 0.5 0", "8 2 1 0"}, "2 5 6 7", {"2 5", "5 6", "6 8", "8 3"});
  file.elements.push_back("20 3 2 1 1 7 6 8 3");
  EXPECT_EQ(complaints(file), said("cells are not joined: a node in the middle of another cell's side, the first at "
                                   "(1, 0.5); use the same curves for both blocks (`Coherence;`), so that they are "
                                   "divided alike"));
}

TEST(BadCells, OverEachOther) {
  MshFile file = unit_cell();
  file.elements.push_back("6 3 2 1 2 1 2 3 4");
  EXPECT_THAT(complaints(file), testing::Contains(HasSubstr("cells lie over each other, the first at (0.5, 0)")));
}

TEST(BadCells, OutOfPlane) {
  MshFile file = unit_cell();
  file.nodes[2] = "3 1 1 0.5";
  EXPECT_THAT(complaints(file), ElementsAre(HasSubstr("it leaves the plane z = 0: z reaches up to 0.5; draw")));
}

TEST(BadCells, ThreeDimensions) {
  MshFile file = unit_cell();
  file.nodes.push_back("5 0 0 1");
  file.elements.push_back("6 4 2 0 1 1 2 3 5");
  EXPECT_THAT(complaints(file), testing::Contains(HasSubstr("it has cells in three dimensions")));
}

TEST(BadCells, AllMistakesAtOnce) {
  MshFile file = unit_cell();
  file.elements[0] = "1 1 2 3 1 1 2";
  file.elements.back() = "5 3 2 2 1 1 2 3 4";
  EXPECT_THAT(complaints(file), ElementsAre(HasSubstr("physical surface 2 has no name of its own"),
                                            HasSubstr("physical curve 3 has no name of its own")));
}

}  // namespace bad_cells_test
}  // namespace upbead::test
