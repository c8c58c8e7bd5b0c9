// Claim: every scene that once broke a measure of the stability map meets all bounds now, or is solved with a warning
// about the imbalance, or is refused for the reason in its first line; a scene known to fail still fails by that
// measure only, so that a repair is noticed. Bounds: those of the map, see judge.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "judge.h"

namespace upbead::test {
namespace {

std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(UPBEAD_SCENES))
    names.push_back(file.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class NamedScene : public ::testing::TestWithParam<std::string> {};

TEST_P(NamedScene, HoldsOrIsRefused) {
  const std::string path = std::string(UPBEAD_SCENES) + "/" + GetParam() + ".toml", refused = "# refused: ";
  std::string first;
  std::getline(std::ifstream(path), first);
  const Verdict verdict = judge(path);
  if (first == "# passes") {
    EXPECT_EQ(verdict.kind, Verdict::Kind::passed) << verdict.why;
    return;
  }
  if (first == "# told") {
    EXPECT_EQ(verdict.kind, Verdict::Kind::passed) << verdict.why;
    EXPECT_TRUE(verdict.measures.told_loose) << "the warning balance_loose";
    return;
  }
  if (const std::string fails = "# fails: "; first.rfind(fails, 0) == 0) {
    EXPECT_EQ(verdict.kind, Verdict::Kind::failed);
    EXPECT_EQ(verdict.why, first.substr(fails.size()));
    return;
  }
  ASSERT_EQ(first.rfind(refused, 0), 0U) << "the first line tells what must come out";
  EXPECT_TRUE(verdict.kind == Verdict::Kind::refused || verdict.kind == Verdict::Kind::contradictory) << verdict.why;
  EXPECT_NE(verdict.why.find(first.substr(refused.size())), std::string::npos) << verdict.why;
}

INSTANTIATE_TEST_SUITE_P(Stability, NamedScene, ::testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace upbead::test
