// Claim: all mistakes in a design for `upbead calibrate` are reported at once, each with its place and cure.
#include <string>
#include <vector>

#include "../output/sample_model.h"
#include "design/design.h"
#include "good_case.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace bad_calibration_test {

const std::string good_design = R"([section]
water_depth = 15.0
foundation_depth = 9.0
berm_depth = 8.5
crest = 6.0
width = 18.0
berm_width = 8.0
bed_slope = 0.01
weight = 5.933e6
submerged_weight = 4.296e6

[calibration]
relative_height = [0.3, 0.5]
period = { from = 8, to = 12, n = 3 }
relative_berm_depth = [0.35, 0.45]
relative_berm_width = [0.05, 0.12]
ratios = [1.05, 1.5]
steepness = [0.01, 0.1]

[calibration.models.full]
model = "model.h5"
load = "impact"

[calibration.models.small]
model = "small.h5"
load = "impact"
scale = 0.05
)";

struct BadCalibration {
  std::string name, good, bad, messages;
};

void PrintTo(const BadCalibration& row, std::ostream* stream) {
  *stream << row.name;
}

class CalibrationTest : public InFolder {
 protected:
  CalibrationTest() {
    ReducedModelFile model = oscillator();
    write("model.h5", model_file(model));
    model.caisson_mass /= 400.;
    write("small.h5", model_file(model));
  }
};

class BadCalibrationTest : public CalibrationTest, public testing::WithParamInterface<BadCalibration> {};

const std::string from_calibration = good_design.substr(good_design.find("[calibration]"));
const std::string from_models = good_design.substr(good_design.find("[calibration.models.full]"));

const std::vector<BadCalibration> rows{
    {"NoCalibration", from_calibration, "",
     "design.toml: the table [calibration] is missing, which 'calibrate' needs; add [calibration] with period = "
     "[T, ...] (s), and [calibration.models.NAME]"},
    {"NoModel", from_models, "",
     "design.toml:12:2: [calibration] has no reduced model; add a table [calibration.models.NAME] with model = "
     "the path of a reduced model, made by 'upbead reduce'"},
    {"NoPeriod", "period = { from = 8, to = 12, n = 3 }\n", "",
     "design.toml:12:2: 'period' is missing in [calibration]; add period, a list of numbers or { from, to, n } (s)"},
    {"ModelWithoutAPath", "model = \"model.h5\"\n", "",
     "design.toml:20:21: 'model' is missing in [calibration.models.full]; add model, a string"},
    {"NoSuchModel", "\"model.h5\"", "\"models.h5\"",
     "design.toml:21:1: cannot read 'models.h5'; check the path and the rights"},
    {"NoModelAtAll", "\"model.h5\"", "\"design.toml\"",
     "design.toml:21:1: 'design.toml': no HDF5 file; give a model made by 'upbead reduce'"},
    {"NoSuchLoad", "\"model.h5\"\nload = \"impact\"", "\"model.h5\"\nload = \"impulse\"",
     "design.toml:21:1: the model has no load 'impulse'; known loads: impact, slow"},
    {"ForgottenScale", "scale = 0.05\n", "",
     "design.toml:25:1: the caisson of the model weighs 14833 N/m, that of [section] weight = 5.933e+06 N/m; give "
     "one caisson in both, within 1 %"},
    {"ScaleOfZero", "scale = 0.05", "scale = 0",
     "design.toml:27:1: scale = 0 is outside [0.001, 1000]; give the length of its breakwater over that of "
     "[section]"},
    {"RatioOfOne", "[1.05, 1.5]", "[1.0, 1.5]",
     "design.toml:17:11: ratios = 1 is outside [1.001, 100]; give the ratios r = F_Smax/(mu W') at which tau_0 is "
     "taken"},
    {"EmptyList", "relative_height = [0.3, 0.5]", "relative_height = []",
     "design.toml:13:1: relative_height: the list is empty; give the heights of the waves over the depth, H/h"},
    {"NumberForAList", "relative_height = [0.3, 0.5]", "relative_height = 0.3",
     "design.toml:13:1: relative_height: expected a list of numbers or { from, to, n }, found the number 0.3; "
     "give the heights of the waves over the depth, H/h"},
    {"WordInAList", "relative_height = [0.3, 0.5]", "relative_height = [0.3, \"high\"]",
     "design.toml:13:25: relative_height: expected a number, found a string; give the heights of the waves over "
     "the depth, H/h"},
    {"HeightTwice", "[0.3, 0.5]", "[0.5, 0.5]",
     "design.toml:13:25: relative_height: the values do not ascend; give the heights of the waves over the depth, "
     "H/h"},
    {"RangeWithoutAnEnd", "to = 12, ", "",
     "design.toml:14:1: period: the range has no 'to'; give the periods T of the waves at the size of [section] "
     "(s)"},
    {"RangeBackwards", "to = 12", "to = 7",
     "design.toml:14:1: period: 'from' is not below 'to'; give the periods T of the waves at the size of "
     "[section] (s)"},
    {"RangeOfOneValue", "n = 3", "n = 1",
     "design.toml:14:31: period.n = 1 is outside [2, 1000]; give the number of values"},
    {"RangeWithAStep", "n = 3", "n = 3, step = 2",
     "design.toml:14:38: unknown key 'step' in the range period; known keys: from, to, n"},
    {"SteepnessTheOtherWayRound", "[0.01, 0.1]", "[0.1, 0.01]",
     "design.toml:18:1: no steepness lies between the two limits; give the least steepness H/L first, then a "
     "larger one"},
    {"EveryWaveBreaks", "{ from = 8, to = 12, n = 3 }", "[2.0]",
     "design.toml:12:2: every wave of the grid is beyond the limits of the formulas; give H/h up to 0.8, periods "
     "with H below 0.142 L tanh(kh) and H/L within steepness, and d up to h'"},
    {"TooManyWaves", "relative_height = [0.3, 0.5]\nperiod = { from = 8, to = 12, n = 3 }\nrelative_berm_depth = [0.35",
     "relative_height = { from = 0.1, to = 0.8, n = 1000 }\nperiod = { from = 8, to = 12, n = 1000 }\n"
     "relative_berm_depth = [0.35",
     "design.toml:12:2: the grid has 4e+06 waves, more than 1e+06; give fewer heights, periods or berms"},
    {"UnknownKey",
     "ratios =", "ratio =", "design.toml:17:1: unknown key 'ratio' in [calibration]; did you mean 'ratios'?"},
    {"GodaThroughTheDynamics", "[calibration]\n", "[impact]\nforce = \"goda_with_alpha_I\"\n[calibration]\n",
     "design.toml:13:1: Goda's P with alpha_I is no force to send through the caisson's dynamics: alpha_I was "
     "fitted to sliding tests, so this P already is the force that slides, and its dynamic reduction would count "
     "twice; write force = \"impulse\""},
    {"SeveralAtOnce", "ratios = [1.05, 1.5]\nsteepness = [0.01, 0.1]", "ratios = [0.5]\nsteepness = [0.01]",
     "design.toml:17:11: ratios = 0.5 is outside [1.001, 100]; give the ratios r = F_Smax/(mu W') at which tau_0 "
     "is taken\ndesign.toml:18:1: steepness: expected a pair of numbers, found a list of 1; give the least and "
     "largest steepness H/L"}};

TEST_F(CalibrationTest, AGoodDesignIsReadWithoutAMessage) {
  write("design.toml", good_design);
  EXPECT_NO_THROW(read_design("design.toml", {}, {check_calibration}));
}

TEST_P(BadCalibrationTest, IsExplained) {
  std::string text = good_design;
  const std::size_t at = text.find(GetParam().good);
  ASSERT_NE(at, std::string::npos);
  write("design.toml", text.replace(at, GetParam().good.size(), GetParam().bad));
  try {
    read_design("design.toml", {}, {check_calibration});
    FAIL() << "read without a message";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().messages);
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, BadCalibrationTest, testing::ValuesIn(rows),
                         [](const testing::TestParamInfo<BadCalibration>& row) { return row.param.name; });

}  // namespace bad_calibration_test
}  // namespace upbead::test
