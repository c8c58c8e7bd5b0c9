// Claim: contradictory keys of a load by a wave are reported before meshing.
#include "bad_case.h"

namespace upbead::test {

namespace bad_waves_test {

const std::string pulse = R"(kind = "force"
direction = [1.0, 0.5]
shape = [[6.0, 1.0], [26.0, 0.5]]

[loads.impact.pulse]
shape = "church_roof"
peak = 2e6
rise = 0.04
duration = 0.1
start = 0.01
plateau = 0.3
plateau_duration = 3
)";

const std::string section_table = R"(
[section]
water_depth = 15.0
foundation_depth = 9.0
berm_depth = 7.5
crest = 7.0
width = 18.0
berm_width = 7.0
bed_slope = 0.01
weight = 7.41e6
submerged_weight = 4.3e6
friction = 0.55
)";

const std::string good_wave = "wave = { height = 8.0, period = 12.0, course = \"sine\" }\n";

/// A load by a wave from line 48 on, and a section.
std::string wave_load(const std::string& keys, const std::string& section = section_table) {
  return "kind = \"wave\"\n" + keys + section;
}

/// A valid load by a wave, with one line of its section replaced.
std::string with_section(const std::string& before, const std::string& after) {
  std::string section = section_table;
  return wave_load(good_wave, section.replace(section.find(before), before.size(), after));
}

class BadWaves : public BadCaseTest {};

TEST_P(BadWaves, IsExplained) {
  check();
}

const std::vector<BadCase> rows{
    BadCase{
        "NoSection", pulse, wave_load(good_wave, ""),
        "case.toml:48:1: [loads.impact]: a load by a wave needs the cross-section that Goda's formulas take, and there "
        "is no [section]; add [section], as in a design"},
    BadCase{
        "NoWave", pulse, wave_load(""),
        "case.toml:46:8: [loads.impact]: 'wave' is missing, which kind = \"wave\" needs; add wave = { height = ..., "
        "period = ..., course = \"church_roof\" }"},
    BadCase{
        "NoHeight", pulse, wave_load("wave = { period = 12.0, course = \"sine\" }\n"),
        "case.toml:49:1: [loads.impact]: neither 'height' nor 'deep_water_height' is given; add height, that of the "
        "highest wave (m), or deep_water_height"},
    BadCase{"TwoHeights", pulse,
            wave_load("wave = { height = 8.0, deep_water_height = 6.0, period = 12.0, course = \"sine\" }\n"),
            "case.toml:49:24: [loads.impact]: both 'height' and 'deep_water_height' are given; keep one of them"},
    BadCase{"NoPeriod", pulse, wave_load("wave = { height = 8.0, course = \"sine\" }\n"),
            "case.toml:49:1: 'period' is missing in [loads.impact.wave]; add period, a number (s)"},
    BadCase{
        "NoCourse", pulse, wave_load("wave = { height = 8.0, period = 12.0 }\n"),
        "case.toml:49:1: 'course' is missing in [loads.impact.wave]; add course, one of church_roof, triangle, sine, "
        "combined, standing"},
    BadCase{"NoSuchCourse", pulse, wave_load("wave = { height = 8.0, period = 12.0, course = \"sin\" }\n"),
            "case.toml:49:39: course = \"sin\" is none of church_roof, triangle, sine, combined, standing; did you "
            "mean 'sine'?"},
    BadCase{
        "ImpactOfASine", pulse,
        wave_load("wave = { height = 8.0, period = 12.0, course = \"sine\", force = \"impulse\" }\n"),
        "case.toml:49:56: 'force' does not belong in [loads.impact.wave] (only where course = \"church_roof\"); remove "
        "it"},
    BadCase{"DirectionWithoutFacing", pulse,
            wave_load("wave = { height = 8.0, period = 12.0, course = \"sine\", direction = 250 }\n"),
            "case.toml:49:56: [loads.impact]: 'direction' is given, but not where the wall looks at; add facing to "
            "[section], the direction of the wall's seaward normal, in degrees from north"},
    BadCase{"WaveFromBehind", pulse,
            wave_load("wave = { height = 8.0, period = 12.0, course = \"sine\", direction = 10 }\n",
                      section_table + "facing = 230\n"),
            "case.toml:49:56: [loads.impact]: the wave comes from 10 degrees, 140 degrees to the wall's normal: it "
            "does not "
            "meet the wall; give where the wave comes from, and where the wall looks at (degrees from north)"},
    BadCase{
        "ProverbsForAnotherForce", pulse,
        wave_load("wave = { height = 8.0, period = 12.0, course = \"church_roof\", impact = { proverbs = {} } }\n"),
        "case.toml:49:74: [loads.impact]: 'proverbs' is given, but the peak is not by it; write force = \"proverbs\""},
    BadCase{"SeveralStandingWaves", pulse,
            wave_load("wave = { height = 4.0, period = 12.0, course = \"standing\", number = 2 }\n"),
            "case.toml:49:60: [loads.impact]: a standing wave has a course of its own, of one whole wave between two "
            "halves; remove number, or write another course"},
    BadCase{"HarbourOfTheSectionAlone", pulse, wave_load(good_wave, section_table + "harbour_level = -1.0\n"),
            "case.toml:62:1: [section]: harbour_level = -1 m above the sea, but in [initial] the harbour has no level "
            "of its "
            "own; give the same in both: initial.harbour_level = initial.water_level + section.harbour_level"},
    BadCase{
        "PulseBesideAWave", pulse, wave_load(good_wave + "pulse = { shape = \"step\", peak = 1.0 }\n"),
        "case.toml:50:1: [loads.impact]: 'pulse' does not belong to a load by a wave; remove pulse, or write kind = "
        "\"force\""},
    BadCase{"WaveOfAForce", "kind = \"force\"\n", "kind = \"force\"\n" + good_wave,
            "case.toml:49:1: 'wave' does not belong in [loads.impact] (only where kind = \"wave\"); remove it"},
    BadCase{"SectionWithoutDepth", pulse, with_section("water_depth = 15.0\n", ""),
            "case.toml:51:2: 'water_depth' is missing in [section]; add water_depth, a number (m)"},
    BadCase{"NoStandingWave", pulse, with_section("friction = 0.55", "friction = 0.55\nlambda_1 = 0.0"),
            "case.toml:62:1: [section]: lambda_1 = 0 leaves nothing of the standing wave, which is a part of the load "
            "[loads.impact]; give at least 0.001"},
    BadCase{
        "SectionHeavierInWater", pulse, with_section("submerged_weight = 4.3e6", "submerged_weight = 8e6"),
        "case.toml:60:1: [section]: submerged_weight = 8e+06 N/m is not below weight = 7.41e+06 N/m; give W' in still "
        "water, W less the weight of the displaced water\n"
        "case.toml:86:1: [sliding]: submerged_weight = 4300000 is not that of [section], submerged_weight = 8e6; give "
        "the same number, or only that of [section]"},
    BadCase{"OtherFriction", pulse, with_section("friction = 0.55", "friction = 0.6"),
            "case.toml:85:1: [sliding]: friction = 0.55 is not that of [section], friction = 0.6; give the same "
            "number, or only "
            "that of [section]"},
    BadCase{"OtherSubmergedWeight", pulse, with_section("submerged_weight = 4.3e6", "submerged_weight = 4.4e6"),
            "case.toml:86:1: [sliding]: submerged_weight = 4300000 is not that of [section], submerged_weight = "
            "4400000; give "
            "the same number, or only that of [section]"},
    BadCase{"OtherWeight", pulse, with_section("weight = 7.41e6", "weight = 7.4e6"),
            "case.toml:87:1: [sliding]: weight = 7410000 is not that of [section], weight = 7400000; give the same "
            "number, or "
            "only that of [section]"},
    BadCase{"UpliftOfNoWave", "kind = \"prescribed\"\npeak = 5e5\n", "kind = \"wave\"\n",
            "case.toml:90:1: [sliding.uplift]: kind = \"wave\" is the uplift of a load by a wave, and no load that "
            "acts has "
            "kind = \"wave\"; add one, or write kind = \"prescribed\""},
    BadCase{
        "PeakBesideTheWaves", "kind = \"prescribed\"", "kind = \"wave\"",
        "case.toml:91:1: 'peak' does not belong in [sliding.uplift] (only where the uplift is prescribed); remove it"},
};

INSTANTIATE_TEST_SUITE_P(, BadWaves, testing::ValuesIn(rows), name_of);

}  // namespace bad_waves_test
}  // namespace upbead::test
