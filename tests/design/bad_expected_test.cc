// Claim: all mistakes in a design for `upbead expected`, its record of sea states or its model are reported at once,
// each with its place and cure.
#include <string>
#include <vector>

#include "../output/sample_model.h"
#include "design/design.h"
#include "good_case.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace bad_expected_test {

const std::string good_design = R"(title = "expected"

[section]
water_depth = 15.0
foundation_depth = 9.0
berm_depth = 8.5
crest = 6.0
width = 18.0
berm_width = 8.0
bed_slope = 0.01
weight = 5.933e6
submerged_weight = 4.296e6

[sea]
states = "states.csv"
years = 9
highest = 2.0
heights = { high = 10.5 }

[life]
years = 50
simulated_lives = 100
seed = 7
sliding = "exact"

[scatter.force]
cov = 0.1
low = 0.5

[scatter.friction]
kind = "lognormal"
cov = 0.15
per = "life"

[scatter.water_level]
kind = "uniform"
low = -1.0
high = 1.0

[dynamics]
model = "model.h5"
load = "impact"

[impact]
peak_gain = 1.5
)";

const std::string good_states = "significant_height,period,waves\n6,12,600\n4,10,1000\n";

struct BadExpected {
  std::string name, good, bad, messages;
  bool in_states = false;  ///< whether the record is edited, not the design
  std::vector<std::string> overrides{};
};

void PrintTo(const BadExpected& row, std::ostream* stream) {
  *stream << row.name;
}

class ExpectedTest : public InFolder {
 protected:
  ExpectedTest() {
    write("states.csv", good_states);
    write("model.h5", model_file(oscillator()));
    ReducedModelFile other = oscillator();
    other.caisson_mass = 500e3;
    write("light.h5", model_file(other));
    other.modes.reading_label[1].name = "probes/A/pressure";
    write("column.h5", model_file(other));
  }
};

class BadExpectedTest : public ExpectedTest, public testing::WithParamInterface<BadExpected> {};

std::string edited(std::string text, const std::string& good, const std::string& bad) {
  const std::size_t at = text.find(good);
  EXPECT_NE(at, std::string::npos) << "there is no '" << good << "'";
  return at == std::string::npos ? text : text.replace(at, good.size(), bad);
}

const std::string good_sea = "[sea]\nstates = \"states.csv\"\nyears = 9\nhighest = 2.0\nheights = { high = 10.5 }\n";

const std::vector<BadExpected> rows{
    {"NoSea", "[sea]\nstates = \"states.csv\"\nyears = 9\nhighest = 2.0\nheights = { high = 10.5 }\n", "",
     "design.toml: the table [sea] is missing, which 'expected' needs; add [sea] with states = the path of a CSV file, "
     "or [storms]"},
    {"SeaAndStorms", "[life]", "[storms]\nlocation = 2\nscale = 1\nperiod = 12\n[life]",
     "design.toml:20:2: [storms]: both [sea] and [storms] are given; keep one of them"},
    {"StormsOfNothing", "[life]", "[storms]\nscale = 0\n[life]",
     "design.toml:20:2: 'location' is missing in [storms]; add location, a number (m)\ndesign.toml:20:2: [storms]: "
     "both [sea] and [storms] are given; keep one of them\ndesign.toml:20:2: [storms]: neither 'period' nor "
     "'steepness' is given; add one of them\ndesign.toml:21:1: scale = 0 is outside [1e-6, 100]; give the scale of "
     "H_0' (m)"},
    {"StormsWithTwoPeriods", good_sea, "[storms]\nlocation = 2\nscale = 1\nperiod = 12\nsteepness = 0.03\n",
     "design.toml:18:1: [storms]: both 'period' and 'steepness' are given; keep one of them"},
    {"StormsWithoutAPeriod", good_sea, "[storms]\nlocation = 2\nscale = 1\ntide_low = 1\n",
     "design.toml:14:2: [storms]: neither 'period' nor 'steepness' is given; add one of them\ndesign.toml:17:1: "
     "[storms]: tide_low = 1 m is above tide_high = 0 m; give tide_low <= tide_high"},
    {"ShapeOfAGumbel", good_sea,
     "[storms]\ndistribution = \"gumbel\"\nlocation = 2\nscale = 1\nperiod = 12\nshape = 2\n",
     "design.toml:19:1: 'shape' does not belong in [storms] (only in weibull); remove it"},
    {"HighTide", good_sea, "[storms]\nlocation = 2\nscale = 1\nperiod = 12\ntide_high = 5.5\n",
     "design.toml:35:10: still water may rise by 6.5 m, above the crest; give lower water levels, or cut "
     "[scatter.water_level] by high"},
    {"NoStates", "states = \"states.csv\"\n", "",
     "design.toml:14:2: 'states' is missing in [sea]; add states, a string"},
    {"NoSuchFile", "\"states.csv\"", "\"record.csv\"",
     "design.toml:15:1: cannot read 'record.csv'; check the path and the rights"},
    {"YearsOfZero", "years = 9", "years = 0",
     "design.toml:16:1: years = 0 is outside [0.001, 1e5]; give the time that the sea states cover (years)"},
    {"HighestOfZero", "highest = 2.0", "highest = 0",
     "design.toml:17:1: highest = 0 is outside [0.01, 10]; give the largest height of a wave over H_1/3"},
    {"HighestOfAWord", "highest = 2.0", "highest = \"some\"",
     "design.toml:17:1: highest: expected a number, \"breaking\" or \"none\", found a string; give the largest height "
     "of "
     "a wave over H_1/3"},
    {"HighestOfAList", "highest = 2.0", "highest = [2.0]",
     "design.toml:17:1: highest: expected a number, \"breaking\" or \"none\", found a list of 1; give the largest "
     "height "
     "of a wave over H_1/3"},
    {"HeightBelowZero", "high = 10.5", "high = -1",
     "design.toml:18:13: the height -1 m is not above 0; give heights above 0 (m)"},
    {"OneLife", "simulated_lives = 100", "simulated_lives = 1",
     "design.toml:22:1: simulated_lives = 1 is outside [2, 1e7]; give the number of lives to simulate"},
    {"TooManyStorms",
     "years = 9",
     "years = 0.001",
     "--set life.years=1e5: a life of 1e+05 years is the record 1e+08 times over, 2e+08 storms, more than 1e+08; lower "
     "life.years, or check sea.years",
     false,
     {"life.years=1e5"}},
    {"UnknownLaw", "\"exact\"", "\"goda\"",
     "design.toml:24:1: sliding = \"goda\" is none of paper, exact, combined, dynamic; choose one of them"},
    {"UnknownQuantity", "[scatter.force]", "[scatter.forces]",
     "design.toml:26:10: unknown key 'forces' in [scatter]; did you mean 'force'?"},
    {"ScatterOfTwoKinds", "cov = 0.1\n", "cov = 0.1\ndeviation = 0.1\n",
     "design.toml:27:1: [scatter.force]: both 'cov' and 'deviation' are given; keep one of them"},
    {"ScatterWithoutWidth", "cov = 0.1\n", "",
     "design.toml:26:10: [scatter.force]: neither 'cov' nor 'deviation' is given; add one of them"},
    {"ScatterThatReachesZero", "cov = 0.1\nlow = 0.5", "cov = 0.2",
     "design.toml:26:10: [scatter.force]: the factor may be -0.642, which is not above 0; cut the distribution by low, "
     "such as low = 0.2"},
    {"LowAboveHigh", "low = -1.0", "low = 3.0",
     "design.toml:37:1: [scatter.water_level]: low = 3 is not below high = 1; give low < high"},
    {"CovOfALevel", "kind = \"uniform\"\nlow = -1.0\nhigh = 1.0", "cov = 0.1",
     "design.toml:36:1: [scatter.water_level]: 'cov' means nothing with a mean of 0; give deviation instead"},
    {"MeanOfAUniform", "kind = \"uniform\"", "kind = \"uniform\"\nmean = 0.1",
     "design.toml:37:1: 'mean' does not belong in [scatter.water_level] (only in normal and lognormal); remove it"},
    {"LevelFromWaveToWave", "high = 1.0\n", "high = 1.0\nper = \"wave\"\n",
     "design.toml:39:1: [scatter.water_level]: water_level does not scatter from wave to wave; write per = \"storm\" "
     "or \"life\""},
    {"LevelAboveTheCrest", "high = 1.0\n", "high = 7.0\n",
     "design.toml:35:10: still water may rise by 7 m, above the crest; give lower water levels, or cut "
     "[scatter.water_level] by high"},
    {"LevelBelowTheMound", "low = -1.0", "low = -9.0",
     "design.toml:35:10: still water may fall by 9 m, below the mound or the caisson; give higher water levels, or cut "
     "[scatter.water_level] by low"},
    {"CaissonThatFloats", "[scatter.friction]",
     "[scatter.weight]\nkind = \"uniform\"\nlow = 0.2\nhigh = 1\n[scatter.friction]",
     "design.toml:30:10: at its least weight and in the highest water the caisson floats; cut [scatter.weight] by low, "
     "or [scatter.water_level] by high"},
    {"NoSuchModel", "\"model.h5\"", "\"models.h5\"",
     "design.toml:41:1: cannot read 'models.h5'; check the path and the rights"},
    {"NoModel", "\"model.h5\"", "\"states.csv\"",
     "design.toml:41:1: 'states.csv': no HDF5 file; give a model made by 'upbead reduce'"},
    {"ModelWithoutACaisson", "\"model.h5\"", "\"column.h5\"",
     "design.toml:41:1: the model 'column.h5' has no caisson, so nothing can slide; reduce a case with a caisson"},
    {"ModelOfAnotherCaisson", "\"model.h5\"", "\"light.h5\"",
     "design.toml:41:1: the caisson of the model weighs 4.905e+06 N/m, that of [section] weight = 5.933e+06 N/m; give "
     "one caisson in both, within 1 %"},
    {"NoSuchLoad", "load = \"impact\"", "load = \"impulse\"",
     "design.toml:41:1: the model has no load 'impulse'; known loads: impact, slow"},
    {"DynamicWithoutAModel",
     "[dynamics]\nmodel = \"model.h5\"\nload = \"impact\"\n",
     "",
     "--set life.sliding=dynamic: sliding = \"dynamic\" needs the caisson's dynamics; add [dynamics] with model = the "
     "path of a reduced model, made by 'upbead reduce'",
     false,
     {"life.sliding=dynamic"}},
    {"GodaThroughTheDynamics", "peak_gain = 1.5", "force = \"goda_with_alpha_I\"",
     "design.toml:45:1: Goda's P with alpha_I is no force to send through the caisson's dynamics: alpha_I was fitted "
     "to sliding tests, so this P already is the force that slides, and its dynamic reduction would count twice; write "
     "force = \"impulse\""},
    {"PeakGainBesideProverbs", "peak_gain = 1.5", "peak_gain = 1.5\nforce = \"proverbs\"",
     "design.toml:45:1: [impact]: 'peak_gain' is given, but the peak is by force = \"proverbs\"; remove peak_gain, or "
     "write force = \"impulse\""},
    {"HarbourAtAnotherLevel", "submerged_weight = 4.296e6", "submerged_weight = 4.296e6\nharbour_level = -1.0",
     "design.toml:42:1: still water pushes the caisson of the model with 0 N/m, that of [section] harbour_level = -1 m "
     "with 85887 N/m; give [initial] harbour_level of the model's case and [section] harbour_level the same two "
     "levels"},
    {"UnknownUplift", "peak_gain = 1.5", "uplift = \"none\"",
     "design.toml:45:1: uplift = \"none\" is none of held, in_phase, sinusoidal; choose one of them"},
    {"NoColumnOfPeriods", "period", "periods",
     "states.csv:1:1: there is no column 'period'; add it\nstates.csv:1:1: unknown column 'periods'; did you mean "
     "'period'?",
     true},
    {"TwoColumnsOfWaves", "period,waves", "waves,waves",
     "states.csv:1:1: there is no column 'period'; add it\nstates.csv:1:1: there are 2 columns 'waves'; keep one of "
     "them",
     true},
    {"HeightOfZero", "\n6,", "\n0,",
     "states.csv:2:1: significant_height = 0 is not possible; give H_1/3 from 0.001 to 1000 (m)", true},
    {"WavesBelowZero", "600", "-600", "states.csv:2:1: waves = -600 is not possible; give a number from 0 to 4e9",
     true},
    {"WordForAPeriod", "12", "long",
     "states.csv:2:3: 'long' is not a number (column period); give a finite number such as 1.5e6", true},
    {"MarkForAMissingValue", "6,12,600\n4,10,1000", "6,12,600\n99.00,99.00,5\n4,10,1000",
     "states.csv:3:1: 99 stands for a missing value (column significant_height); leave such rows out, or put in what "
     "was measured",
     true},
    {"TableOfABuoy", "significant_height,period,waves", "WVHT,DPD,hh",
     "states.csv:1:1: a table with the columns WVHT, DPD, hh does not tell which are significant_height, period, "
     "waves; "
     "call H_1/3 (m; WVHT, Hs, Hm0 elsewhere) significant_height and T_1/3 (s) period, and add waves, the number of "
     "waves that each row stands for",
     true},
    {"NoStateAtAll", "6,12,600\n4,10,1000\n", "",
     "design.toml:15:1: 'states.csv': no row of numbers below the header; write at least one row", true},
    {"SteepAngle", "period,waves\n6,12,600\n4,10,1000", "period,waves,angle\n6,12,600,90\n4,10,1000,0",
     "states.csv:2:1: angle = 90 is not possible; give the angle to the wall's normal, from 0 to below 90 (degrees)",
     true},
    {"LevelOfAState", "period,waves\n6,12,600\n4,10,1000", "period,waves,water_level\n6,12,600,6\n4,10,1000,0",
     "design.toml:35:10: still water may rise by 7 m, above the crest; give lower water levels, or cut "
     "[scatter.water_level] by high",
     true},
    {"SeveralAtOnce", "years = 50\nsimulated_lives = 100", "years = 0\nsimulated_lives = 1.5",
     "design.toml:21:1: years = 0 is outside [0.001, 1e5]; give the life of the structure (years)\ndesign.toml:22:1: "
     "simulated_lives: expected a whole number, found the number 1.5; give the number of lives to simulate"}};

TEST_F(ExpectedTest, AGoodDesignIsReadWithoutAMessage) {
  write("design.toml", good_design);
  EXPECT_NO_THROW(read_design("design.toml", {}, {check_expected}));
}

TEST_P(BadExpectedTest, IsExplained) {
  const BadExpected& row = GetParam();
  write("design.toml", row.in_states ? good_design : edited(good_design, row.good, row.bad));
  if (row.in_states) write("states.csv", edited(good_states, row.good, row.bad));
  try {
    read_design("design.toml", row.overrides, {check_expected});
    FAIL() << "read without a message";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), row.messages);
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, BadExpectedTest, testing::ValuesIn(rows),
                         [](const testing::TestParamInfo<BadExpected>& row) { return row.param.name; });

}  // namespace bad_expected_test
}  // namespace upbead::test
