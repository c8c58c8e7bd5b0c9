// Claims: a check stands on the sheet under its way to fail, whatever it is called; one of its own stands by itself, in
// the end; of each way the worst governs.
#include "design/sheet.h"

#include <gtest/gtest.h>

namespace upbead {
namespace sheet_test {

Check factor(FailureMode mode, const std::string& name, double value) {
  return at_least_as(check_of(mode, name, "", value, "", ""), 1.);
}

TEST(Sheet, ChecksStandByTheirWayToFail) {
  const Checks checks{factor(FailureMode::other, "moon", 2.), factor(FailureMode::tilt, "heel pressure", 1.1),
                      factor(FailureMode::sliding, "a", 1.5), factor(FailureMode::sliding, "tilt", 0.9)};
  const Sheet sheet = sheet_of("", {{"run", checks, {}, ""}}, {});
  ASSERT_EQ(sheet.rows.size(), 4U);
  const char* const modes[] = {"sliding landward", "sliding landward", "tilt", "moon"};
  const char* const names[] = {"tilt", "a", "heel pressure", "moon"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(sheet.rows[i].mode, modes[i]);
    EXPECT_EQ(sheet.rows[i].check.name, names[i]);
    EXPECT_EQ(sheet.rows[i].governs, i != 1);
  }
  ASSERT_EQ(sheet.disagreements.size(), 1U);
  EXPECT_EQ(sheet.disagreements[0].mode, "sliding landward");
}

}  // namespace sheet_test
}  // namespace upbead
