// Claim: all mistakes in a design are reported at once, each with its place and cure.

#include <algorithm>

#include "design/design.h"
#include "good_case.h"
#include "upbead/base/error.h"

namespace upbead::test {
namespace bad_design_test {

const std::string good_design = R"(title = "breakwater"
gravity = 9.8

[fluid]
density = 1030

[section]
water_depth = 15.0
foundation_depth = 10.5
berm_depth = 8.5
crest = 6.0
width = 12.0
berm_width = 8.0
bed_slope = 0.01
weight = 4.27e6
submerged_weight = 3.0e6
centroid = 6.0
friction = 0.6
blocks = false
lambda_1 = 1.0

[duration]
a = 0.3
b = 2.0

[waves.design]
height = 12.0
significant_height = 6.67
period = 12.0
angle = 10.0

[waves.offshore]
deep_water_height = 6.0
period = 12.0

[waves.measured]
height = 8.0
period = 12.0
force = 2.0e6
shear_to_force_ratio = 0.4
uplift = 0.3e6
pulse_duration = 0.2

[ground]
stiffness = 6e8
mass = 2e5
damping = 4e6

[combined]
uplift = "sinusoidal"
uplift_gain = 1.2

[levels]
high = 1.2
low = -0.8
)";

struct BadDesign {
  std::string name;
  std::string good;  ///< text that occurs once in the valid design
  std::string bad;   ///< text that replaces it
  std::string messages;
};

void PrintTo(const BadDesign& row, std::ostream* stream) {
  *stream << row.name;
}

std::string name_of(const testing::TestParamInfo<BadDesign>& info) {
  return info.param.name;
}

class BadDesignTest : public InFolder, public testing::WithParamInterface<BadDesign> {};

TEST_P(BadDesignTest, IsExplained) {
  std::string text = good_design;
  const std::size_t at = text.find(GetParam().good);
  ASSERT_NE(at, std::string::npos) << "the good design has no '" << GetParam().good << "'";
  write("design.toml", text.replace(at, GetParam().good.size(), GetParam().bad));
  try {
    effective_design(read_design("design.toml", {}), ".");
    FAIL() << "read without a message";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().messages);
  }
}

const std::vector<BadDesign> rows{
    {"UnknownKey", "berm_width", "berm_widht",
     "design.toml:7:2: 'berm_width' is missing in [section]; add berm_width, a number (m)\n"
     "design.toml:13:1: unknown key 'berm_widht' in [section]; did you mean 'berm_width'?"},
    {"UnknownKeyAtTheTop", "title = \"breakwater\"", "titel = \"breakwater\"",
     "design.toml:1:1: unknown key 'titel' at the top of the file; did you mean 'title'?"},
    {"UnknownTable", "[duration]", "[durations]",
     "design.toml:22:2: unknown key 'durations' at the top of the file; did you mean 'duration'?"},
    {"UnknownKeyOfAWave", "angle = 10.0", "beta = 10.0",
     "design.toml:30:1: unknown key 'beta' in [waves.design]; known keys: height, significant_height, "
     "deep_water_height, period, angle, direction, force, shear_to_force_ratio, uplift, pulse_duration"},
    {"AngleBesideADirection", "angle = 10.0", "angle = 10.0\ndirection = 250",
     "design.toml:31:1: [waves.design]: both 'angle' and 'direction' are given; keep one of them\n"
     "design.toml:31:1: [waves.design]: 'direction' is given, but not where the wall looks at; add facing to "
     "[section], "
     "the direction of the wall's seaward normal, in degrees from north"},
    {"HarbourAboveTheCrest", "lambda_1 = 1.0", "lambda_1 = 1.0\nharbour_level = 7.0",
     "design.toml:21:1: [section]: harbour_level = 7 m is above the crest = 6 m; give the height of the harbour's "
     "still "
     "water above that of the sea (m)"},
    {"MissingDepth", "water_depth = 15.0\n", "",
     "design.toml:7:2: 'water_depth' is missing in [section]; add water_depth, a number (m)"},
    {"MissingWeight", "weight = 4.27e6\n", "",
     "design.toml:7:2: 'weight' is missing in [section]; add weight, a number (N/m)"},
    {"MissingBuoyantWeight", "submerged_weight = 3.0e6\n", "",
     "design.toml:7:2: 'submerged_weight' is missing in [section]; add submerged_weight, a number (N/m)"},
    {"MissingPeriod", "period = 12.0\nangle", "angle",
     "design.toml:26:8: 'period' is missing in [waves.design]; add period, a number (s)"},
    {"NoSection", "[section]", "[section_]",
     "design.toml: 'section' is missing at the top of the file; add [section]\n"
     "design.toml:7:2: unknown key 'section_' at the top of the file; did you mean 'section'?"},
    {"StringForANumber", "crest = 6.0", "crest = \"high\"",
     "design.toml:11:1: crest: expected a number (m), found a string; give the height h_c of the crest above still "
     "water (m)"},
    {"NumberInQuotes", "crest = 6.0", "crest = \"6.0\"",
     "design.toml:11:1: crest: expected a number (m), found a string; write the number without quotes"},
    {"NumberForABoolean", "blocks = false", "blocks = 1",
     "design.toml:19:1: blocks: expected true or false, found the number 1; write true or false"},
    {"NegativeCrest", "crest = 6.0", "crest = -1",
     "design.toml:11:1: crest = -1 is outside [0, 10000]; give the height h_c of the crest above still water (m)"},
    {"NoDepth", "water_depth = 15.0", "water_depth = 0",
     "design.toml:8:1: water_depth = 0 is outside [0.001, 10000]; give the depth h at the wall (m)"},
    {"InfiniteDepth", "water_depth = 15.0", "water_depth = inf",
     "design.toml:8:1: water_depth = inf is outside [0.001, 10000]; give the depth h at the wall (m)"},
    {"NotANumber", "berm_depth = 8.5", "berm_depth = nan",
     "design.toml:10:1: berm_depth = nan is outside [0.001, 10000]; give the depth d of the top of the mound's armour "
     "below still water (m)"},
    {"SlopeAsCotangent", "bed_slope = 0.01", "bed_slope = 100",
     "design.toml:14:1: bed_slope = 100 is outside [0, 1]; give the slope tan(theta) of the seabed in front"},
    {"FrictionOfNone", "friction = 0.6", "friction = 0",
     "design.toml:18:1: friction = 0 is outside [0.01, 10]; give the friction coefficient mu between the caisson and "
     "the mound"},
    {"BuoyantWeightNotBelowWeight", "submerged_weight = 3.0e6", "submerged_weight = 4.27e6",
     "design.toml:16:1: [section]: submerged_weight = 4.27e+06 N/m is not below weight = 4.27e+06 N/m; give W' in "
     "still "
     "water, W less the weight of the displaced water"},
    {"CentroidOutside", "centroid = 6.0", "centroid = 12",
     "design.toml:17:1: [section]: centroid = 12 m lies outside the caisson, width = 12 m; give the distance from the "
     "landward heel to the line of W' (m)"},
    {"LambdaOutOfRange", "lambda_1 = 1.0", "lambda_1 = -0.5",
     "design.toml:20:1: lambda_1 = -0.5 is outside [0, 2]; give the factor lambda_1 of the pressure by alpha_1, and of "
     "eta*"},
    {"HarbourWhosePushNothingHolds", "friction = 0.6\nblocks = false\nlambda_1 = 1.0",
     "friction = 0.05\nblocks = false\nlambda_1 = 1.0\nharbour_level = -10.4",
     "design.toml:21:1: [section]: harbour_level = -10.4 m: still water pushes the caisson with 556.4 kN/m, and mu (W' "
     "+ dW') = 181.5 kN/m is no more: it slides without a wave; give the harbour a level nearer to the sea's, or check "
     "friction, submerged_weight and width"},
    {"WavesWithoutPressure", "lambda_1 = 1.0", "lambda_1 = 0\nlambda_2 = 0",
     "design.toml:20:1: [section]: lambda_1 = 0 leaves the wave 'design' no force on the wall, P = 0, and its factors "
     "of "
     "safety have no value; give lambda_1 above 0, or lambda_2 above 0 where alpha* is"},
    {"ExponentOfNone", "a = 0.3", "a = 0",
     "design.toml:23:1: a = 0 is outside [0.001, 10]; give the exponent a of k = 1 / (alpha*^a + 1)^b, eq. (9)"},
    {"HeightOfNone", "height = 12.0\n", "height = 0\n",
     "design.toml:27:1: height = 0 is outside [0.001, 10000]; give the height H of the wave (m)"},
    {"NoHeight", "height = 12.0\n", "",
     "design.toml:26:8: [waves.design]: neither 'height' nor 'deep_water_height' is given; add height, that of the "
     "highest wave (m), or deep_water_height"},
    {"TwoHeights", "deep_water_height = 6.0", "deep_water_height = 6.0\nheight = 9.0",
     "design.toml:33:1: [waves.offshore]: both 'height' and 'deep_water_height' are given; keep one of them"},
    {"SignificantHeightBesideDeepWater", "deep_water_height = 6.0", "deep_water_height = 6.0\nsignificant_height = 5.0",
     "design.toml:34:1: [waves.offshore]: 'significant_height' is given, but follows from deep_water_height; remove "
     "it, or give height instead of deep_water_height"},
    {"PeriodNotPositive", "period = 12.0\nangle", "period = -12.0\nangle",
     "design.toml:29:1: period = -12 is outside [0.01, 10000]; give the significant wave period T (s)"},
    {"AngleAlongTheWall", "angle = 10.0", "angle = 90",
     "design.toml:30:1: angle = 90 is outside [0, 90); give the angle beta between the wave's direction and the wall's "
     "normal (deg)"},
    {"RatioWithoutForce", "force = 2.0e6\nshear_to_force_ratio = 0.4\nuplift = 0.3e6\npulse_duration = 0.2\n",
     "shear_to_force_ratio = 0.4\n",
     "design.toml:39:1: [waves.measured]: shear_to_force_ratio needs a measured or computed 'force': alpha_I was "
     "fitted to sliding tests, so the P of Goda's formula with it already is an effective sliding force, and the ratio "
     "would count twice; add force, the peak of P (N/m), or remove shear_to_force_ratio"},
    {"UpliftWithoutForce", "force = 2.0e6\nshear_to_force_ratio = 0.4\nuplift = 0.3e6\npulse_duration = 0.2\n",
     "uplift = 0.3e6\n",
     "design.toml:39:1: [waves.measured]: 'uplift' is that beside a measured or computed 'force', which is not given; "
     "add force, the peak of P (N/m), or remove uplift"},
    {"PulseWithoutForce", "force = 2.0e6\nshear_to_force_ratio = 0.4\nuplift = 0.3e6\n", "",
     "design.toml:39:1: [waves.measured]: 'pulse_duration' is that of a measured or computed 'force' on [ground], "
     "which is not given; add force, the peak of P (N/m)"},
    {"PulseWithoutGround", "[ground]\nstiffness = 6e8\nmass = 2e5\ndamping = 4e6\n", "",
     "design.toml:42:1: [waves.measured]: 'pulse_duration' is that of a measured or computed 'force' on [ground], and "
     "there is no [ground]; add [ground] with stiffness (N/m2)"},
    {"DashpotWithoutMass", "mass = 2e5\n", "",
     "design.toml:46:1: [ground]: 'damping' without a 'mass' that it could slow down; add mass (kg/m)"},
    {"GainOfAnUpliftInPhase", "uplift = \"sinusoidal\"", "uplift = \"in_phase\"",
     "design.toml:51:1: 'uplift_gain' does not belong in [combined] (only where the uplift is sinusoidal); remove it"},
    {"LevelBelowTheMound", "[levels]", "[levels]\nebb = -8.5",
     "design.toml:54:1: [levels]: ebb = -8.5 m: still water would fall to the seabed, the mound's armour or the "
     "caisson's bottom; give a rise over the section's still water above -8.5 m and of at most 6 m"},
    {"LevelAboveTheCrest", "[levels]", "[levels]\nflood = 6.01",
     "design.toml:54:1: [levels]: flood = 6.01 m: still water would rise above the crest; give a rise over the "
     "section's "
     "still water above -8.5 m and of at most 6 m"},
    {"LevelAtWhichItFloats", "submerged_weight = 3.0e6", "submerged_weight = 1.0e5",
     "design.toml:54:1: [levels]: high = 1.2 m: the caisson would float, W' = -4.535e+04 N/m; give a lower level, or "
     "check "
     "submerged_weight"},
    {"LevelThatIsNoNumber", "high = 1.2", "high = nan",
     "design.toml:54:1: high = nan is outside [-10000, 10000]; give the water levels by name, above that of the "
     "section "
     "(m)"},
    {"LevelByTheSectionsName", "high = 1.2", "section = 1.2",
     "design.toml:54:1: [levels]: 'section' is the name of the section's own level, 0 m; give the level another name"},
    {"NumberForAWave", "[waves.design]", "[waves]\nstorm = 3\n[waves.design]",
     "design.toml:27:1: waves.storm: expected a table, found the number 3; write [waves.storm] and its keys"},
    {"NotToml", "gravity = 9.8", "gravity = ",
     "design.toml:2:11: not TOML: Error while parsing key-value pair: expected value, saw '\\n'; see https://toml.io "
     "for the syntax"},
    {"ManyAtOnceInTheOrderOfTheFile", "weight = 4.27e6\nsubmerged_weight = 3.0e6\ncentroid = 6.0\nfriction = 0.6",
     "weight = 3.0e6\nsubmerged_weight = 4.0e6\ncentroid = 20.0\nfricton = 0.6",
     "design.toml:16:1: [section]: submerged_weight = 4e+06 N/m is not below weight = 3e+06 N/m; give W' in still "
     "water, "
     "W less the weight of the displaced water\n"
     "design.toml:17:1: [section]: centroid = 20 m lies outside the caisson, width = 12 m; give the distance from the "
     "landward heel to the line of W' (m)\n"
     "design.toml:18:1: unknown key 'fricton' in [section]; did you mean 'friction'?"},
};

INSTANTIATE_TEST_SUITE_P(, BadDesignTest, testing::ValuesIn(rows), name_of);

class Design : public InFolder {};

TEST_F(Design, WithEveryKeyIsReadAndEchoed) {
  write("design.toml", good_design);
  const std::string echo = effective_design(read_design("design.toml", {}), ".");
  for (const char* line :
       {"gravity = 9.8  # m/s2\n", "[section]\n", "berm_depth = 8.5  # m\n", "[waves.measured]\n",
        "shear_to_force_ratio = 0.4\n", "# lambda_2: 1; with blocks 0\n", "levels = { high = 1.2, low = -0.8 }  # m\n"})
    EXPECT_NE(echo.find(line), std::string::npos) << line << " is missing in\n" << echo;
  write("again.toml", echo);
  EXPECT_EQ(effective_design(read_design("again.toml", {}), "."), echo) << "what is echoed reads as the same design";
}

TEST_F(Design, ReferenceNamesEveryKeyOfTheGoodDesign) {
  const std::string text = design_reference();
  for (const char* key : {"water_depth", "foundation_depth", "berm_depth", "crest", "berm_width", "bed_slope", "blocks",
                          "deep_water_height", "shear_to_force_ratio", "lambda_3"})
    EXPECT_NE(text.find("| `" + std::string(key) + "` |"), std::string::npos) << key;
}

}  // namespace bad_design_test
}  // namespace upbead::test
