// Claims: the uplift of a wave that presses on the landward wall alone is that of its mirror image; a force that goes
// both ways has uplift while it is landward.

#include <gtest/gtest.h>

#include "run/sliding/uplift.h"
#include "upbead/base/time_function.h"

namespace upbead {
namespace uplift_course_test {

const double end = 4.;

UpliftChoice course(UpliftCourse how) {
  UpliftChoice uplift;
  uplift.kind = UpliftKind::prescribed;
  uplift.peak = 3e5;
  uplift.course = how;
  uplift.lag = 0.1;
  return uplift;
}

TEST(PrescribedUplift, OfALoadFromBehindIsThatOfItsMirrorImage) {
  const TimeFunction P = piecewise_linear({0., 0.2, 0.5, 1., 2.}, {0., 1e6, 2e5, 4e5, 0.});
  for (const UpliftCourse how : {UpliftCourse::held, UpliftCourse::in_phase}) {
    const TimeFunction U = prescribed_uplift(course(how), P, end),
                       mirrored = prescribed_uplift(course(how), scaled(P, -1.), end);
    EXPECT_NEAR(U(0.3), 3e5, 1.);
    for (double t = 0.; t < end; t += 0.037) EXPECT_DOUBLE_EQ(U(t), mirrored(t)) << t;
  }
}

TEST(PrescribedUplift, FollowsWhatIsLandwardOfAForceThatGoesBothWays) {
  const TimeFunction P = piecewise_linear({0., 1., 2., 3.}, {0., 1e5, -1e6, 0.});
  const TimeFunction U = prescribed_uplift(course(UpliftCourse::in_phase), P, end);
  EXPECT_NEAR(U(1.1), 3e5, 1.);
  EXPECT_EQ(U(2.1), 0.);
}

}  // namespace uplift_course_test
}  // namespace upbead
