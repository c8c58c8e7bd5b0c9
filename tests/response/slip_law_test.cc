// Claims: the normal force of the slip's law is the change of the total normal force, minus the pore pressure on the
// bottom where the uplift is computed; another load has its values at the beginning and at the end of every step.
#include "response/slip_law.h"

#include <gtest/gtest.h>

#include "fem/caisson/reading_names.h"

namespace upbead::test {
namespace slip_law_test {

using Weighted = std::vector<std::pair<int, double>>;

TEST(SlipLaw, TakesTheModelledUpliftFromTheNormalForce) {
  ReducedSystem system;
  for (const char* name : {"other", reading::uplift, reading::normal_force})
    system.reading_label.push_back({name, "N/m", ""});
  const SlipLaw computed = slip_law(system, 0.6, UpliftKind::computed, {"other"});
  EXPECT_EQ(computed.friction, 0.6);
  EXPECT_EQ(computed.normal_force, (Weighted{{2, 1.}, {1, -1.}}));
  EXPECT_EQ(computed.readings, std::vector<int>{0});
  EXPECT_EQ(slip_law(system, 0.6, UpliftKind::prescribed).normal_force, (Weighted{{2, 1.}}));
}

TEST(WithLoad, HasItsValuesAtBothEndsOfEveryStep) {
  SampledLoads loads{{0., 1., 2.}, Eigen::MatrixXd::Ones(1, 2), Eigen::MatrixXd::Constant(1, 2, 2.)};
  loads = with_load(loads, Eigen::RowVector3d(3., 4., 5.));
  EXPECT_EQ(loads.begin, (Eigen::Matrix2d() << 1., 1., 3., 4.).finished());
  EXPECT_EQ(loads.end, (Eigen::Matrix2d() << 2., 2., 4., 5.).finished());
}

}  // namespace slip_law_test
}  // namespace upbead::test
