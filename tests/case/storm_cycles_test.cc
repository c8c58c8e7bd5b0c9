// Claims: [cycles] of sea states is the storm that a person writes by hand after Rayleigh, class by class; all waves
// and the mean of their fourth powers are kept; the record [sea] and the load by a wave give what the table leaves out,
// and what the table gives wins; the effective case is the same storm without those; what is missing or twofold is
// told.
#include "case/storm_cycles.h"

#include <cmath>
#include <numeric>

#include "case/case_schema.h"
#include "good_case.h"
#include "upbead/case/case.h"

namespace upbead::test {
namespace storm_cycles_test {

const std::string dry_soil = R"([mesh]
file = "my.msh"
[regions.soil]
kind = "porous"
shear_modulus = 1e7
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650
hydraulic_conductivity = 1e-4
cyclic = { relative_density = 0.6 }
[boundaries.top]
[loads.step]
boundary = "top"
pulse = { shape = "step", peak = 3 }
)";

// 300 waves of H_1/3 = 5 m up to 9 m in two groups, 100 waves of 4 m up to 7.2 m in one; shares and heights by midpoint
// quadrature of 4 h exp(-2 h^2), of h^0 and h^4, in another program.
const std::string by_hand = R"([cycles]
number = [14.443938, 35.50954, 39.743314, 30.618403, 17.750879, 8.015715, 2.867586, 1.050625,
  14.443938, 35.50954, 39.743314, 30.618403, 17.750879, 8.015715, 2.867586, 1.050625]
period = [11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11]
height = [0.849373, 1.80476, 2.857454, 3.938077, 5.029714, 6.126855, 7.227257, 8.490576,
  0.849373, 1.80476, 2.857454, 3.938077, 5.029714, 6.126855, 7.227257, 8.490576]
run_height = 7.5
)";

class StormCycles : public InFolder {
 protected:
  Cycles cycles_of(const std::string& table) {
    write("case.toml", dry_soil + table);
    return *read_case("case.toml").scene.cycles;
  }
  std::string refusal(const std::string& table) {
    write("case.toml", dry_soil + table);
    try {
      read_case("case.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

void expect_same(const Cycles& a, const Cycles& b, double tolerance) {
  ASSERT_EQ(a.number.size(), b.number.size());
  EXPECT_EQ(a.period, b.period);
  for (std::size_t i = 0; i < a.number.size(); ++i) {
    EXPECT_NEAR(a.number[i], b.number[i], tolerance * b.number[i]) << i;
    EXPECT_NEAR(a.share(i), b.share(i), tolerance * b.share(i)) << i;
  }
}

TEST_F(StormCycles, OfASeaStateAreTheTableByHand) {
  const Cycles hand = cycles_of(by_hand);
  const std::string rest = "significant_height = [5]\nrun_height = 7.5\n";
  expect_same(cycles_of("[cycles]\nnumber = [300]\nperiod = [11]\n" + rest), hand, 1e-5);
  expect_same(cycles_of("[cycles]\nduration = [3300]\nperiod = [11]\n" + rest), hand, 1e-5);
}

TEST_F(StormCycles, OfTheRecordFollowEachOther) {
  write("storm.csv", "significant_height,period,waves\n5,11,300\n6,12,0\n4,10,100\n");
  const std::string sea = "[sea]\nstates = \"storm.csv\"\n";
  const Cycles found = cycles_of(sea + "[cycles]\nrun_height = 7.5\ncalm = 60\nhighest = 1.6\n");
  const Cycles given = cycles_of(
      "[cycles]\nnumber = [300, 100]\nperiod = [11, 10]\nsignificant_height = [5, 4]\nhighest = 1.6\nrun_height = "
      "7.5\ncalm = 60\n");
  expect_same(found, given, 1e-15);
  EXPECT_EQ(*found.calm, 60.);
  EXPECT_NEAR(found.number.back(), 1.984109, 2e-6);  // of 100 waves; broken ones with them
  EXPECT_NEAR(found.height.back(), 6.091924, 2e-6);
  expect_same(cycles_of(sea + by_hand), cycles_of(by_hand), 0.);  // explicit keys win
}

TEST_F(StormCycles, KeepAllWavesAndTheirFourthPowers) {
  const Cycles found = rayleigh_cycles({{5., 11., 977., 0., 0.}}, 1.8, 1.);
  EXPECT_NEAR(std::accumulate(found.number.begin(), found.number.end(), 0.), 977., 1e-9);
  double sum = 0., exact = 0.;
  for (std::size_t i = 0; i < found.number.size(); ++i) sum += found.number[i] * std::pow(found.height[i], 4);
  constexpr int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double h = 1.8 * (i + 0.5) / n;
    exact += std::pow(h, 4) * 4. * h * std::exp(-2. * h * h) * 1.8 / n;
  }
  exact += std::pow(1.8, 4) * std::exp(-2. * 1.8 * 1.8);
  EXPECT_NEAR(sum / (977. * std::pow(5., 4)), exact, 1e-9);
}

TEST_F(StormCycles, OfALoadByAWave) {
  const std::string wave = R"([section]
water_depth = 12
foundation_depth = 7
berm_depth = 7
crest = 10
width = 20
berm_width = 8
bed_slope = 0.02
weight = 7e6
submerged_weight = 5.6e6
[loads.storm]
boundary = "top"
kind = "wave"
wave = { height = 7.5, significant_height = 5, period = 11, course = "sine" }
)";
  expect_same(cycles_of(wave + "[cycles]\nnumber = [300]\n"), cycles_of(by_hand), 1e-5);
  const Cycles own = cycles_of(wave + "[cycles]\nnumber = [300]\nsignificant_height = [4]\nrun_height = 6\n");
  EXPECT_NEAR(own.share(15), 0.8 * 8.490576 / 6., 1e-6);
  EXPECT_EQ(own.period.front(), 11.);
}

TEST_F(StormCycles, AreTheSameInTheEffectiveCase) {
  write("storm.csv", "significant_height,period,waves\n5,11,300\n4,10,100\n");
  write("case.toml", dry_soil + "[sea]\nstates = \"storm.csv\"\n[cycles]\nrun_height = 7.5\n");
  const Case given = read_case("case.toml");
  ASSERT_EQ(given.notes.size(), 1u);
  EXPECT_NE(given.notes.front().what.find("assumed: heights of the storm by Rayleigh"), std::string::npos);
  EXPECT_NE(given.notes.front().what.find("all rows of [sea]"), std::string::npos);
  std::filesystem::create_directories("out");
  write("out/case.toml", effective_case(given, "out"));
  expect_same(*read_case("out/case.toml").scene.cycles, *given.scene.cycles, 1e-15);
}

TEST_F(StormCycles, TellWhatIsMissing) {
  EXPECT_NE(refusal("[cycles]\n").find("nothing is said of the storm"), std::string::npos);
  EXPECT_NE(refusal("[cycles]\nnumber = [3]\nduration = [4]\nperiod = [1]\n").find("both 'number' and 'duration'"),
            std::string::npos);
  EXPECT_NE(refusal("[cycles]\nnumber = [3]\nperiod = [1]\nheight = [1]\nsignificant_height = [1]\n")
                .find("both 'height' and 'significant_height'"),
            std::string::npos);
  EXPECT_NE(refusal("[cycles]\nnumber = [3, 4]\nperiod = [1]\nsignificant_height = [1, 2]\nrun_height = 1\n")
                .find("period has 1 value, and the storm 2 parts"),
            std::string::npos);
  EXPECT_NE(refusal("[cycles]\nnumber = [3]\nperiod = [1]\nsignificant_height = [1]\n").find("run's wave is not known"),
            std::string::npos);
  EXPECT_NE(refusal("[cycles]\nnumber = [3]\nrun_height = 1\n").find("'period' is missing"), std::string::npos);
  EXPECT_NE(refusal("[sea]\nstates = \"none.csv\"\n[cycles]\nrun_height = 1\n").find("none.csv"), std::string::npos);
}

}  // namespace storm_cycles_test
}  // namespace upbead::test
