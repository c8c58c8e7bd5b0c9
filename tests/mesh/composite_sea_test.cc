// The sea of a composite breakwater: its names, its limits and how it divides the seabed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_test_tools.h"

namespace upbead::test {
namespace composite_sea_test {

using Parameters = std::map<std::string, double>;

std::unique_ptr<Mesh> section(const Parameters& parameters) {
  return read_mesh(geometry("composite", parameters));
}

TEST(CompositeSea, IsNamedOnlyWhereItIs) {
  using testing::Contains, testing::Not, testing::StartsWith;
  const auto without = section({}), front = section({{"sea_front", 3}}), back = section({{"sea_back", 3}});
  EXPECT_THAT(without->curves, Not(Contains(StartsWith("sea_"))));
  EXPECT_THAT(without->surfaces, Not(Contains(StartsWith("sea_"))));
  EXPECT_THAT(front->curves, testing::IsSupersetOf({"sea_left", "sea_surface"}));
  EXPECT_THAT(front->curves, Not(Contains("sea_right")));
  EXPECT_THAT(front->surfaces, testing::ElementsAre("seabed", "mound", "caisson", "sea_front"));
  EXPECT_THAT(back->curves, testing::IsSupersetOf({"sea_right", "sea_surface"}));
  EXPECT_THAT(back->curves, Not(Contains("sea_left")));
  EXPECT_THAT(back->surfaces, testing::ElementsAre("seabed", "mound", "caisson", "sea_back"));
}

TEST(CompositeSea, CutsTheSeabedWithinItsGrading) {
  const auto mesh = section({{"sea_front", 3}, {"sea_back", 2}, {"caisson_width", 30}});
  std::map<double, double> seaward, landward;  // lengths by the distance from the middle
  for (const auto& face : mesh->triangulation.active_face_iterators()) {
    const double x = face->center()[0];
    if (mesh->curve_of(face) == "base" && std::abs(x) > 28)  // beyond the mound's toe
      (x < 0 ? seaward : landward)[std::abs(x)] = face->measure();
  }
  for (const auto& lengths : {seaward, landward}) {
    EXPECT_GE(lengths.size(), 10u);
    for (auto next = std::next(lengths.begin()); next != lengths.end(); ++next)
      EXPECT_NEAR(std::log(next->second / std::prev(next)->second), 0.0, 0.2) << "at " << next->first;
  }
}

TEST(CompositeSea, ImpossibleOnesAreAllSaid) {
  const std::string length = "; it must be greater than 1.266666667 (the mound's toe) and at most 9.266666667 (the ";
  const std::string depth =
      "; a sea must be deeper than 6 (the mound's crest) and shallower than 22 (the caisson's top)";
  const std::vector<std::pair<Parameters, std::vector<std::string>>> all = {
      {{{"sea_front", 1.2}, {"sea_back", 9.3}}, {"sea_front is 1.2" + length, "sea_back is 9.3" + length}},
      {{{"sea_front", 9.26666668}}, {"sea_front is 9.26667" + length}},
      {{{"sea_front", 19.0 / 15}}, {"sea_front is 1.26667" + length}},
      {{{"sea_front", -1}, {"sea_cells", 0}},
       {"sea_cells is 0; it must be greater than 0", "sea_front is -1; it must be 0 (no sea) or greater"}},
      {{{"sea_back", -0.5}, {"sea_cells", 101}},
       {"sea_cells is 101; it must be at most 100", "sea_back is -0.5; it must be 0 (no sea) or greater"}},
      {{{"sea_front", 3}, {"water_depth", 6}}, {"water_depth is 6" + depth}},
      {{{"sea_back", 3}, {"water_depth", 22}}, {"water_depth is 22" + depth}},
      {{{"sea_back", 3}, {"water_depth_back", 22}}, {"water_depth_back is 22" + depth}},
      {{{"sea_front", 3}, {"sea_back", 3}, {"water_depth", 5}, {"water_depth_back", 6}},
       {"water_depth is 5" + depth, "water_depth_back is 6" + depth}},
      {{{"sea_back", 1}, {"water_depth_back", 12}, {"mound_slope_back", 1}},
       {"sea_back is 1; it must be greater than 1.083333333 (the mound's toe) and at most 11.08333333"}},
      {{{"sea_front", 3}, {"water_depth_back", 99}}, {}},                    // no sea there
      {{{"sea_back", 3}, {"water_depth_back", 9}, {"water_depth", 3}}, {}},  // nor here
      {{{"sea_back", 9.266666667}}, {}},                                     // the longest sea that the message allows
      {{{"water_depth", -3}}, {}}};                                          // no sea
  for (const auto& [parameters, expected] : all) {
    const auto said = complaints(geometry("composite", parameters));
    ASSERT_EQ(said.size(), expected.size());
    for (std::size_t i = 0; i < said.size(); ++i) EXPECT_THAT(said[i], testing::HasSubstr(expected[i]));
  }
}

}  // namespace composite_sea_test
}  // namespace upbead::test
