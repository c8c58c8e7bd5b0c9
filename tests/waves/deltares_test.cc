// Claim: loads, safety factors and heel pressure of the 15 cases in the tests of Deltares' coastal-structures-toolbox
// 1.0.0 (goda1985_test.py; the 15th differs from the first only by B_M, which is not in Goda's formula). Their
// numbers have 5 digits; the heel pressure is ill-conditioned. Some sections are not physical (h' > h), which does
// not matter for the comparison.

#include <gtest/gtest.h>

#include <algorithm>

#include "sections.h"
#include "upbead/waves/goda.h"

namespace upbead::test {
namespace deltares_test {

/// Units of these tests: m, s, deg, kg/m3.
struct Input {
  double H = 5.8, Hs = 3.05, T = 8., h = 5., d = 4., B_M = 2., cot = 50., density = 1025., h_1 = 6., crest = 5.,
         B = 10.;
  double above = 2400., below = 2100., friction = 0.6, t_over_B = 0.5, angle = 0.;
};

/// kN/m, kN, kPa.
struct Expected {
  double P, U, M_P, M_U, p1, p_e, p_u, sliding, overturning;
};

struct Row {
  std::string name;
  Input input;
  Expected expected;
};

void PrintTo(const Row& row, std::ostream* stream) {
  *stream << row.name;
}

Input changed(void (*change)(Input&)) {
  Input input;
  change(input);
  return input;
}

const Expected base{574.18, 219.06, 2929.8, 1460.392, 63.7030, 362.112, 43.812, 1.6624, 2.5904};

const std::vector<Row> rows{{"Base", {}, base},
                            {"LongerPeriod",
                             changed([](Input& i) { i.T = 10., i.H = 5.91, i.Hs = 3.13; }),
                             {635.32, 256.13, 3208.0, 1707.518, 68.8019, 389.329, 51.226, 1.4674, 2.2887}},
                            {"DeeperWater",
                             changed([](Input& i) { i.h = 10., i.H = 8.23, i.Hs = 4.55; }),
                             {1301.5, 269.73, 6880.0, 1798.226, 137.64, 4257.11, 53.947, 0.71005, 1.0540}},
                            {"HigherBerm",
                             changed([](Input& i) { i.d = 3.; }),
                             {768.17, 219.06, 3919.6, 1460.392, 85.2254, 459.785, 43.812, 1.2426, 1.9362}},
                            {"FlatterBed",
                             changed([](Input& i) { i.cot = 100., i.H = 5.07, i.Hs = 2.75; }),
                             {466.22, 191.49, 2332.6, 1276.593, 52.9407, 320.951, 38.298, 2.0828, 3.3324}},
                            {"FreshWater",
                             changed([](Input& i) { i.density = 1000.; }),
                             {560.17, 213.72, 2858.3, 1424.773, 62.1493, 357.442, 42.743, 1.7255, 2.6934}},
                            {"DeeperFoundation",
                             changed([](Input& i) { i.h_1 = 8.; }),
                             {674.34, 202.67, 4179.6, 1351.121, 63.7030, 481.871, 40.534, 1.6178, 2.0943}},
                            {"HighCrest",
                             changed([](Input& i) { i.crest = 20.; }),
                             {624.31, 219.06, 3543.1, 1460.392, 63.7030, 746.741, 43.812, 4.9230, 7.1258}},
                            {"Overturning",
                             changed([](Input& i) { i.B = 5.; }),
                             {574.18, 109.53, 2929.8, 365.098, 63.7030, -408.564, 43.812, 0.83121, 0.6476}},
                            {"HeavierAbove",
                             changed([](Input& i) { i.above = 2700.; }),
                             {574.18, 219.06, 2929.8, 1460.392, 63.7030, 373.259, 43.812, 1.8162, 2.8415}},
                            {"LighterBelow",
                             changed([](Input& i) { i.below = 1900.; }),
                             {574.18, 219.06, 2929.8, 1460.392, 63.7030, 355.399, 43.812, 1.5394, 2.3895}},
                            {"LessFriction",
                             changed([](Input& i) { i.friction = 0.3; }),
                             {574.18, 219.06, 2929.8, 1460.392, 63.7030, 362.112, 43.812, 0.83121, 2.5904}},
                            {"CentroidSeaward",
                             changed([](Input& i) { i.t_over_B = 0.75; }),
                             {574.18, 219.06, 2929.8, 1460.392, 63.7030, 85.2894, 43.812, 1.6624, 4.1349}},
                            {"Oblique",
                             changed([](Input& i) { i.angle = 30.; }),
                             {556.89, 215.33, 2835.0, 1435.511, 61.9555, 354.704, 43.065, 1.7181, 2.6858}},
                            {"WiderBerm", changed([](Input& i) { i.B_M = 20.; }), base}};

Section section(const Input& i) {
  Section s;
  s.water_depth = i.h;
  s.foundation_depth = i.h_1;
  s.berm_depth = i.d;
  s.crest = i.crest;
  s.width = i.B;
  s.berm_width = i.B_M;
  s.bed_slope = 1. / i.cot;
  s.weight = 9.81 * i.B * (i.below * i.h_1 + i.above * i.crest);
  s.submerged_weight = s.weight - 9.81 * i.density * i.h_1 * i.B;
  s.centroid = i.t_over_B * i.B;
  s.friction = i.friction;
  return s;
}

std::string name_of(const testing::TestParamInfo<Row>& info) {
  return info.param.name;
}

class Deltares : public testing::TestWithParam<Row> {};

TEST_P(Deltares, IsReproduced) {
  const auto& [name, i, expected] = GetParam();
  const Section s = section(i);
  const double angle = std::max(i.angle - 15., 0.) * degree;  // turned towards the normal
  const WavePressure p = Goda(s, {i.density, 9.81}, {i.H, i.Hs, i.T, angle}).at(i.H, PressureFormula::goda);
  const Stability safety = stability(s, p);
  const auto near = [](double value, double wanted, double relative, const char* what) {
    EXPECT_NEAR(value / wanted, 1., relative) << what;
  };
  near(p.force, 1e3 * expected.P, 5e-4, "P");
  near(p.uplift, 1e3 * expected.U, 5e-4, "U");
  near(p.force_moment, 1e3 * expected.M_P, 5e-4, "M_P");
  near(p.uplift_moment, 1e3 * expected.M_U, 5e-4, "M_U");
  near(p.p1, 1e3 * expected.p1, 5e-4, "p_1");
  near(p.pu, 1e3 * expected.p_u, 5e-4, "p_u");
  near(safety.safety_sliding, expected.sliding, 5e-4, "S.F. sliding");
  near(safety.safety_overturning, expected.overturning, 5e-4, "S.F. overturning");
  EXPECT_EQ(safety.heel_pressure.has_value(), expected.p_e > 0.) << "they give a negative p_e where it overturns";
  if (safety.heel_pressure) near(*safety.heel_pressure, 1e3 * expected.p_e, 5e-3, "p_e");
}

INSTANTIATE_TEST_SUITE_P(, Deltares, testing::ValuesIn(rows), name_of);

}  // namespace deltares_test
}  // namespace upbead::test
