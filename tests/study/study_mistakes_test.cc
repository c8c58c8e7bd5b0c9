// Claim: every mistake in a study is reported at its place with a cure, also those in the settings of its cases.
#include "good_case.h"
#include "study/study.h"

namespace upbead::test {
namespace study_mistakes_test {

const std::string good_study = R"(title = "stiffness"
case = "case.toml"
sample = "grid"
read = ["response.peak_shear"]
[set]
"time.end" = 3
[vary."regions.rubble.shear_modulus"]
values = [1e7, 2e7]
[vary."gravity"]
from = 9
to = 10
n = 3
[follow."regions.block.youngs_modulus"]
key = "regions.rubble.shear_modulus"
)";

struct BadStudy {
  std::string name;
  std::string good;  ///< text that occurs once in the valid study
  std::string bad;   ///< text that replaces it
  std::string messages;
};

void PrintTo(const BadStudy& row, std::ostream* stream) {
  *stream << row.name;
}

class StudyMistakes : public InFolder, public testing::WithParamInterface<BadStudy> {};

TEST_P(StudyMistakes, AreExplained) {
  write("case.toml", good_case);
  std::string text = good_study;
  const std::size_t at = text.find(GetParam().good);
  ASSERT_NE(at, std::string::npos) << "the good study has no '" << GetParam().good << "'";
  write("study.toml", text.replace(at, GetParam().good.size(), GetParam().bad));
  try {
    read_study("study.toml");
    FAIL() << "read without a message";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().messages);
  }
}

TEST_F(InFolder, TheGoodStudyIsGood) {
  write("case.toml", good_case);
  write("study.toml", good_study);
  EXPECT_EQ(read_study("study.toml").runs.size(), 6U);
}

const std::string random_sample = "sample = \"random\"\nn = 5\n";

const std::vector<BadStudy> rows{
    BadStudy{"NoCase", "case = \"case.toml\"\n", "",
             "study.toml: the study has no case; add case = the path of a case file"},
    BadStudy{"CaseAndCases", "case = \"case.toml\"", "case = \"case.toml\"\ncases = [\"a.toml\"]",
             "study.toml:3:1: both 'case' and 'cases' are given; keep one of them"},
    BadStudy{"CaseTwice", "case = \"case.toml\"", "cases = [\"case.toml\", \"case.toml\"]",
             "study.toml:2:1: a case is named twice; remove one of them"},
    BadStudy{"CaseThatIsNotThere", "case = \"case.toml\"", "case = \"no.toml\"",
             "cannot read 'no.toml'; check the path and the rights"},
    BadStudy{"UnknownKey", "title", "titel",
             "study.toml:1:1: unknown key 'titel' at the top of the file; did you mean 'title'?"},
    BadStudy{"WordOutOfAList", "\"grid\"", "\"latin\"",
             "study.toml:3:1: sample = \"latin\" is none of grid, paired, random, sobol; choose one of them"},
    BadStudy{
        "NumberOfDrawsInAGrid", "sample = \"grid\"", "sample = \"grid\"\nn = 3",
        "study.toml:4:1: 'n' does not belong at the top of the file (only where sample = random or sobol); remove it"},
    BadStudy{"ReadOfNothing", "response.peak_shear", "response.peak_sheer",
             "study.toml:4:1: 'response.peak_sheer' cannot be read: no summary has it; did you mean "
             "'response.peak_shear'?"},
    BadStudy{"ReadOfAWavesWord", "response.peak_shear", "wave_loads.wave.reading",
             "study.toml:4:1: 'wave_loads.wave.reading' cannot be read: of a wave it takes "
             "wave_loads.NAME.safety_sliding or the like"},
    BadStudy{"ReadTwice", "[\"response.peak_shear\"]", "[\"response.peak_shear\", \"response.peak_shear\"]",
             "study.toml:4:1: a number is read twice; remove one of them"},
    BadStudy{"NumberForAPath", "[\"response.peak_shear\"]", "[3]",
             "study.toml:4:9: read: expected a string, found the number 3; give the list of numbers to read of each "
             "run, as paths into its summary.json"},
    BadStudy{"KeyWithoutQuotes", "[vary.\"gravity\"]", "[vary.time.end]",
             "study.toml:9:12: the key 'time.end...' is written without quotes; write [vary.\"time.end...\"]"},
    BadStudy{"UnknownKeyOfTheCase", "[vary.\"gravity\"]", "[vary.\"gravty\"]",
             "study.toml:9:7: gravty=9: unknown key 'gravty' at the top of the file; did you mean 'gravity'?"},
    BadStudy{"UnknownFixedKeyOfTheCase", "\"time.end\" = 3", "\"time.ent\" = 3",
             "study.toml:5:2: time.ent=3: unknown key 'ent' in [time]; did you mean 'end'?"},
    BadStudy{"WordForANumber", "[1e7, 2e7]", "[\"soft\", \"stiff\"]",
             "study.toml:14:1: 'regions.rubble.shear_modulus' has values that are no numbers; vary both keys, paired"},
    BadStudy{"NoValues", "values = [1e7, 2e7]", "",
             "study.toml:7:7: [vary.\"regions.rubble.shear_modulus\"] has no values; give either values, or from, to "
             "and n"},
    BadStudy{"ValuesAndRange", "values = [1e7, 2e7]", "values = [1e7]\nfrom = 1\nto = 2\nn = 2",
             "study.toml:7:7: [vary.\"regions.rubble.shear_modulus\"] has values of more than one kind; give either "
             "values, or from, to and n"},
    BadStudy{"RangeWithoutEnd", "to = 10\n", "",
             "study.toml:9:7: 'to' is missing in [vary.gravity]; a range needs from, to and n"},
    BadStudy{"RangeOfOne", "n = 3", "n = 1",
             "study.toml:12:1: n = 1 is outside [2, 1e5]; give the number of values of a range"},
    BadStudy{"LogarithmOfZero", "from = 9", "from = 0\nspacing = \"log\"",
             "study.toml:11:1: a range from 0 to 10 has no logarithmic spacing; give ends of the same sign, neither of "
             "them 0"},
    BadStudy{"DistributionInAGrid", "values = [1e7, 2e7]", "distribution = \"uniform\"\nlow = 1\nhigh = 2",
             "study.toml:8:1: a distribution belongs only where sample = \"random\" or \"sobol\"; write from, to and "
             "n, or sample = "
             "\"random\""},
    BadStudy{"RangeInARandomSample", "sample = \"grid\"\n", random_sample,
             "study.toml:11:1: a range does not belong where sample = \"random\"; write distribution = \"uniform\" "
             "with low and high"},
    BadStudy{"RangeInASobolSample", "sample = \"grid\"\n", "sample = \"sobol\"\nn = 4\n",
             "study.toml:11:1: a range does not belong where sample = \"sobol\"; write distribution = \"uniform\" "
             "with low and high"},
    BadStudy{"RandomWithoutNumber", "sample = \"grid\"", "sample = \"random\"",
             "study.toml: 'n' is missing at the top of the file; add n, a whole number\n"
             "study.toml:10:1: a range does not belong where sample = \"random\"; write distribution = \"uniform\" "
             "with low and high"},
    BadStudy{"PairsOfDifferentLength", "\"grid\"", "\"paired\"",
             "study.toml:9:7: 'gravity' has 3 values, 'regions.rubble.shear_modulus' has 2; give paired keys equally "
             "many values, or write sample = \"grid\""},
    BadStudy{"TooManyRuns", "n = 3", "n = 100000",
             "study.toml:7:2: the study has 2e5 runs, more than 1e5; vary fewer values"},
    BadStudy{"VariedAndSet", "\"time.end\" = 3", "gravity = 9.81",
             "study.toml:9:7: 'gravity' is varied and set; remove it from [set] or from [vary]"},
    BadStudy{"FollowsWhatIsNotVaried", "key = \"regions.rubble.shear_modulus\"", "key = \"regions.rubble.shear\"",
             "study.toml:14:1: 'regions.rubble.shear' is not varied; did you mean 'regions.rubble.shear_modulus'?"},
    BadStudy{"FollowsItself", "[follow.\"regions.block.youngs_modulus\"]", "[follow.\"gravity\"]",
             "study.toml:13:9: 'gravity' follows and is varied; keep one of them"},
    BadStudy{"TwoMistakesInTheOrderOfTheFile", "case = \"case.toml\"\nsample = \"grid\"", "sample = \"net\"",
             "study.toml: the study has no case; add case = the path of a case file\n"
             "study.toml:2:1: sample = \"net\" is none of grid, paired, random, sobol; choose one of them"},
    BadStudy{"NotToml", "n = 3", "n = ",
             "study.toml:12:5: not TOML: Error while parsing key-value pair: expected value, saw '\\n'; see "
             "https://toml.io for the syntax"},
};

INSTANTIATE_TEST_SUITE_P(, StudyMistakes, testing::ValuesIn(rows), [](const auto& row) { return row.param.name; });

struct BadDraw {
  std::string name, axis, messages;
};

void PrintTo(const BadDraw& row, std::ostream* stream) {
  *stream << row.name;
}

class DrawMistakes : public InFolder, public testing::WithParamInterface<BadDraw> {};

TEST_P(DrawMistakes, AreExplained) {
  write("case.toml", good_case);
  write("study.toml", "case = \"case.toml\"\n" + random_sample + "[vary.gravity]\n" + GetParam().axis);
  try {
    read_study("study.toml");
    FAIL() << "read without a message";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().messages);
  }
}

const std::vector<BadDraw> draws{
    BadDraw{"LowAboveHigh", "distribution = \"uniform\"\nlow = 10\nhigh = 9\n",
            "study.toml:7:1: high = 9 is not above low = 10; give the least value as low and the largest as high"},
    BadDraw{"LogarithmOfZero", "distribution = \"log_uniform\"\nlow = 0\nhigh = 9\n",
            "study.toml:6:1: low = 0 has no logarithm; give low above 0"},
    BadDraw{"LogarithmOfANegativeMean", "distribution = \"log_normal\"\nmean = -1\ncov = 0.1\n",
            "study.toml:6:1: mean = -1 has no logarithm; give a mean above 0"},
    BadDraw{"BoundsOfABell", "distribution = \"normal\"\nmean = 9.8\ncov = 0.01\nlow = 9\n",
            "study.toml:8:1: 'low' does not belong in [vary.gravity] (only of uniform and log_uniform); remove it"},
    BadDraw{"NoSpread", "distribution = \"normal\"\nmean = 9.8\n",
            "study.toml:4:7: 'cov' is missing in [vary.gravity]; add cov, a number"},
    BadDraw{"NegativeSpread", "distribution = \"normal\"\nmean = 9.8\ncov = -0.1\n",
            "study.toml:7:1: cov = -0.1 is outside [0, inf); give the standard deviation over the mean"},
};

INSTANTIATE_TEST_SUITE_P(, DrawMistakes, testing::ValuesIn(draws), [](const auto& row) { return row.param.name; });

}  // namespace study_mistakes_test
}  // namespace upbead::test
