// Claims: the slip circles of a reduced model come back from its file bit by bit, a file without them is as good as
// before, and circles that cannot be are refused with the reason.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sample_model.h"

namespace upbead::test {
namespace model_circles_test {

std::string refusal(const std::function<void(CircleModel&)>& change) {
  ReducedModelFile model = oscillator();
  model.circles = circles_under_an_oscillator();
  change(*model.circles);
  const TemporaryFile file(model_file(model));
  try {
    read_model_file(file.path());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST(ModelCircles, ComeBackBitByBit) {
  ReducedModelFile made = oscillator();
  EXPECT_FALSE(read_model_file(TemporaryFile(model_file(made)).path()).circles);
  made.circles = circles_under_an_oscillator();
  const TemporaryFile file(model_file(made));
  const ReducedModelFile read = read_model_file(file.path());
  ASSERT_TRUE(read.circles);
  const CircleFamily &found = read.circles->family, &family = made.circles->family;
  ASSERT_EQ(found.circles.size(), family.circles.size());
  EXPECT_EQ(found.right, family.right);
  EXPECT_EQ(found.circles[1].weight_moment, family.circles[1].weight_moment);
  EXPECT_EQ(found.circles[1].landward, family.circles[1].landward);
  EXPECT_EQ(found.circles[1].slices[2].friction, family.circles[1].slices[2].friction);
  EXPECT_EQ(read.circles->gap, 0.013);
  EXPECT_EQ(read.circles->pressures.reading, made.circles->pressures.reading);
  EXPECT_EQ(model_file(read), model_file(made));
}

TEST(ModelCircles, AreRefusedWhereTheyCannotBe) {
  using M = CircleModel;
  EXPECT_EQ(refusal([](M&) {}), "");
  const auto slice = [](M& m) -> FamilySlice& { return m.family.circles[1].slices[1]; };
  EXPECT_TRUE(
      says(refusal([](M& m) { m.family.circles[0].radius = 0.; }), "circle 0 has a radius that is not above 0"));
  EXPECT_TRUE(says(refusal([](M& m) { m.family.circles[0].from = 99.; }), "ends that are not in their order"));
  EXPECT_TRUE(says(refusal([&](M& m) { slice(m).width *= 2.; }), "slices that do not stand side by side"));
  EXPECT_TRUE(says(refusal([&](M& m) { slice(m).sine = 0.9; }), "a slope that is no angle"));
  EXPECT_TRUE(says(refusal([&](M& m) { slice(m).cohesion = -1.; }), "a strength below 0"));
  EXPECT_TRUE(says(refusal([&](M& m) { slice(m).weight = -1.; }), "a weight below 0"));
  EXPECT_TRUE(says(refusal([](M& m) { m.family.right = m.family.left; }), "ends that are not in their order"));
  EXPECT_TRUE(says(refusal([](M& m) { m.gap = -1.; }), "a gap below 0"));
  EXPECT_TRUE(says(refusal([](M& m) { m.pressures.pole[0] = {1., 0.}; }), "mode 0 grows"));
  EXPECT_TRUE(says(refusal([](M& m) { m.family.circles[1].slices.clear(); }), "0 slices in a row"));
}

}  // namespace model_circles_test
}  // namespace upbead::test
