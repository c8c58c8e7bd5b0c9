// Claims: a case with more steps or fields than a machine can handle is refused before meshing, at the key that
// causes the number; a consolidation of days with automatic steps is not.
#include "upbead/run/simulation.h"

#include "good_case.h"
#include "upbead/base/error.h"
#include "upbead/case/case.h"

namespace upbead::test {
namespace limits_of_size_test {

class LimitsOfSize : public InFolder {
 protected:
  /// The message about the good case with overrides; "" if there is none.
  static std::string said(const std::vector<std::string>& overrides) {
    write("case.toml", good_case);
    const Case input = read_case("case.toml", overrides);
    try {
      check_size(input.scene);
    } catch (const InputError& error) {
      return input.placed(error).what();
    }
    return "";
  }
  static void expect_all(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
};

TEST_F(LimitsOfSize, GoodCasePasses) {
  EXPECT_EQ(said({}), "");
  EXPECT_EQ(said({"time.step=2e-6", "time.end=1.9"}), "");
}

TEST_F(LimitsOfSize, AtTheGivenStep) {
  expect_all(said({"time.step=1e-8"}), {"time.step = 1e-08 s", "2e+08 steps, more than 1e+06", "raise time.step"});
  expect_all(said({"output.fields.every=1e9", "time.end=1e12"}), {"case.toml:68:", "1e+15 steps", "lower time.end"});
}

TEST_F(LimitsOfSize, AtFields) {
  expect_all(said({"output.fields.every=1e-10"}), {"every = 1e-10 s", "2e+10 fields, more than 1e+04", "raise every"});
}

TEST_F(LimitsOfSize, AtTheEndWithAutomaticSteps) {
  expect_all(said({"time.step=\"auto\"", "loads.impact.pulse.duration=1e-12", "loads.impact.pulse.rise=5e-13"}),
             {"time.end = 2 s", "[loads.impact]", "give time.step"});
  expect_all(said({"time.step=\"auto\"", "time.end=1e12", "output.fields.every=1e9"}), {"time.end = 1e+12 s", "steps"});
}

TEST_F(LimitsOfSize, ConsolidationOfDaysPasses) {
  EXPECT_EQ(said({"time.step=\"auto\"", "time.inertia=false", "regions.rubble.flow=auto", "time.end=1e6",
                  "output.fields.every=1e4"}),
            "");
}

}  // namespace limits_of_size_test
}  // namespace upbead::test
