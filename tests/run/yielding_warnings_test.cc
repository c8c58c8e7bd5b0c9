// Claim: the program warns where a single cell has a strain that its neighbours do not have, and where strains are
// not small; not where strains do not matter or no soil yields.
#include "findings/find.h"
#include "findings/topics.h"

#include <gtest/gtest.h>

namespace upbead {
namespace yielding_warnings_test {

std::vector<std::string> told(double strain, std::optional<double> over_neighbours) {
  Summary summary;
  summary.nonlinear.emplace().peak_strain = {strain, {1., 2.}, over_neighbours};
  std::vector<std::string> names;
  for (const NumberedWarning& warning : yielding_warnings(summary)) {
    names.push_back(warning.name);
    EXPECT_NE(warning.text().find("(1, 2) m"), std::string::npos) << warning.text();
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(YieldingWarnings, TellSlipLinesAndLargeStrains) {
  EXPECT_EQ(told(0.02, 1.8), Names());
  EXPECT_EQ(told(0.02, 3.5), Names{"slip_line"});
  EXPECT_EQ(told(5e-4, 3.5), Names()) << "nothing follows from so small a strain";
  EXPECT_EQ(told(0.06, {}), Names{"large_strain"});
  EXPECT_EQ(told(0.06, 4.), (Names{"large_strain", "slip_line"}));
  EXPECT_TRUE(yielding_warnings(Summary()).empty());
}

TEST(YieldingWarnings, StrainsAboveATenthVoidTheVerdict) {
  const auto voids = [](double strain) {
    Summary summary;
    summary.nonlinear.emplace().peak_strain = {strain, {1., 2.}, {}};
    return yielding_warnings(summary).front().voids;
  };
  EXPECT_FALSE(voids(0.09));
  EXPECT_TRUE(voids(0.18));
}

/// Of hysteretic soil with another start, and a caisson that ends at 50 mm.
Check displacement(double moved, double of_other_start) {
  Scene scene;
  scene.limits.sliding = 0.1;
  Summary summary;
  summary.residual.emplace().displacement_x = 0.05;
  summary.residual->range_x = {0.05 - moved, 0.05};
  StartBound other;
  other.start = "virgin";
  other.residual.displacement_x = of_other_start;
  other.residual.range_x = {of_other_start, of_other_start};
  summary.nonlinear.emplace().bounds = {other};
  for (const Check& check : checks_of(scene, summary))
    if (check.name == "displacement with the ground") return check;
  return {};
}

TEST(YieldingWarnings, ACreepThatWouldPassTheLimitIsNotJudged) {
  EXPECT_TRUE(displacement(0.01, 0.).holds.value_or(false));
  const Check creeps = displacement(0.06, 0.);
  EXPECT_FALSE(creeps.holds.has_value());
  EXPECT_NE(creeps.why_not.find("moved by 60 mm"), std::string::npos) << creeps.why_not;
}

TEST(YieldingWarnings, TheStartWithTheLargestDisplacementIsJudged) {
  const Check check = displacement(0., 0.35);
  EXPECT_EQ(check.demand, 0.35);
  EXPECT_FALSE(check.holds.value_or(true));
}

}  // namespace yielding_warnings_test
}  // namespace upbead
