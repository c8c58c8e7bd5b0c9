// Claim: contradictory keys of [sliding] are reported before meshing.
#include "bad_case.h"

namespace upbead::test {
namespace bad_sliding_test {

class BadSliding : public BadCaseTest {};

TEST_P(BadSliding, IsExplained) {
  check();
}

const std::vector<BadCase> rows{
    BadCase{"NoBuoyantWeight", "submerged_weight = 4.3e6\n", "",
            "case.toml:82:2: 'submerged_weight' is missing in [sliding]; add submerged_weight, a number (N/m)"},
    BadCase{"FrictionZero", "friction = 0.55", "friction = 0",
            "case.toml:83:1: friction = 0 is outside (0, inf); give the friction coefficient mu of the bottom"},
    BadCase{
        "DragNegative", "drag = 1e4", "drag = -1.0",
        "case.toml:86:1: drag = -1 is outside [0, inf); give the drag force F_D over the sliding velocity (N s/m2)"},
    BadCase{
        "HeavierInWater", "submerged_weight = 4.3e6", "submerged_weight = 8e6",
        "case.toml:84:1: [sliding]: submerged_weight = 8e6 N/m is above weight = 7410000 N/m; give W' in still water, "
        "W less the weight of the water that the caisson displaces; of a dry block both are equal"},
    BadCase{"AlphaStarTooLarge", "alpha_star = 0.5", "alpha_star = 2.5",
            "case.toml:87:51: alpha_star = 2.5 is outside [0, 2]; give the pressure coefficient alpha* = max(alpha_I, "
            "alpha_2), as upbead waves gives it"},
    BadCase{"WaveWithoutPeriod", ", period = 13.6", "",
            "case.toml:87:1: 'period' is missing in [sliding.wave]; add period, a number (s)"},
    BadCase{"UpliftWithoutKind", "kind = \"prescribed\"\n", "",
            "case.toml:89:10: 'kind' is missing in [sliding.uplift]; add kind, one of prescribed, computed, wave"},
    BadCase{"UpliftOfNoPeak", "peak = 5e5\n", "",
            "case.toml:89:10: [sliding.uplift]: neither 'peak' nor 'history' nor 'gauges' of a prescribed "
            "uplift is given; add one of them"},
    BadCase{"PeakAndHistory", "lag = 0.02", "history = \"force.csv\"",
            "case.toml:93:1: [sliding.uplift]: both 'peak' and 'history' are given; keep one of them"},
    BadCase{"LagOfAHistory", "peak = 5e5\nshape = \"held\"", "history = \"force.csv\"",
            "case.toml:92:1: [sliding.uplift]: 'lag' is that of an uplift that follows P, a history has its own times; "
            "remove lag"},
    BadCase{"PeakOfAComputedUplift", "kind = \"prescribed\"", "kind = \"computed\"",
            "case.toml:91:1: 'peak' does not belong in [sliding.uplift] (only where the uplift is prescribed); remove "
            "it\ncase.toml:92:1: 'shape' does not belong in [sliding.uplift] (only where the uplift is prescribed); "
            "remove it\ncase.toml:93:1: 'lag' does not belong in [sliding.uplift] (only where the uplift is "
            "prescribed); remove it"},
    BadCase{"UpliftTwice", "history = \"force.csv\"", "history = \"force.csv\"\ndirection = [1.0, 0.2]",
            "case.toml:91:1: [sliding.uplift]: the load 'gauge' lifts the caisson, so that an uplift would count "
            "twice; remove [sliding.uplift] or the upward part of [loads.gauge]"},
    BadCase{"NoSuchHistory", "peak = 5e5\nshape = \"held\"\nlag = 0.02", "history = \"up.csv\"",
            "case.toml:91:1: cannot read 'up.csv'; check the path and the rights"},
    BadCase{"Misspelt", "friction = 0.55", "frction = 0.55",
            "case.toml:83:1: unknown key 'frction' in [sliding]; did you mean 'friction'?"},
};

INSTANTIATE_TEST_SUITE_P(Sliding, BadSliding, testing::ValuesIn(rows), name_of);

class BadUplift : public InFolder {};

TEST_F(BadUplift, BelowZeroIsExplained) {
  std::string text = good_case;
  const std::string prescribed = "peak = 5e5\nshape = \"held\"\nlag = 0.02";
  write("uplift.csv", "time,U\n0,0\n0.1,-3e5\n0.3,0\n");
  write("case.toml", text.replace(text.find(prescribed), prescribed.size(), "history = \"uplift.csv\""));
  try {
    read_case("case.toml");
    FAIL() << "read without a message";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "uplift.csv:3:1: the uplift is -3e5 N/m, below zero; give U upward, what it takes off the weight");
  }
}

}  // namespace bad_sliding_test
}  // namespace upbead::test
