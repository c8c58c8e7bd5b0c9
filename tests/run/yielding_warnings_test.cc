// Claim: the program warns where a single cell has a strain that its neighbours do not have, and where strains are
// not small; not where strains do not matter or no soil yields.
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

}  // namespace yielding_warnings_test
}  // namespace upbead
