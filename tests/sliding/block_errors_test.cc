// Claim: input that makes no sense is refused with the reason.

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "upbead/sliding/block.h"

namespace upbead {
namespace block_errors_test {

struct Refused {
  double mass;
  History force, resistance;
  std::string says;
};

const double nan = std::numeric_limits<double>::quiet_NaN();
const History pulse{{0., 1., 2.}, {0., 2., 0.}}, constant{{0.}, {1.}};

TEST(Block, RefusesWrongInput) {
  const std::vector<Refused> table{
      {0., pulse, constant, "mass"},
      {nan, pulse, constant, "mass"},
      {1., {{0., 1.}, {0.}}, constant, "force: not as many values as times"},
      {1., {{0., 1., 0.5}, {0., 2., 0.}}, constant, "force: times must ascend"},
      {1., {{0., 1.}, {0., nan}}, constant, "force: a time or value that is not finite"},
      {1., {{0., nan}, {0., 1.}}, constant, "force: a time or value that is not finite"},
      {1., pulse, {}, "resistance: at least one value"},
      {1., pulse, {{0., 1.}, {1., -1.}}, "resistance: at least one value, none below zero"},
      {1., pulse, {{0.}, {0.}}, "no resistance is left to stop the block"},
  };
  for (const Refused& refused : table) {
    try {
      slide(refused.mass, refused.force, refused.resistance);
      ADD_FAILURE() << "accepted what should say: " << refused.says;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(refused.says), std::string::npos) << error.what();
    }
  }
}

TEST(Block, StaysWhereNothingPushesIt) {
  EXPECT_TRUE(slide(1., {}, 1.).slips.empty());
  EXPECT_TRUE(slide(1., {{0.}, {5.}}, 1.).slips.empty());  // one point has no duration
}

}  // namespace block_errors_test
}  // namespace upbead
