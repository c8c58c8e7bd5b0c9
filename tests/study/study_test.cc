// Claim: a study gives the runs that it describes: grids, pairs, draws, keys that follow others; its draws have the
// given distributions, and each depends only on its key and number.
#include <cmath>
#include <set>

#include "good_case.h"
#include "study/study.h"

namespace upbead::test {
namespace study_test {

class StudyFile : public InFolder {
 protected:
  StudyFile() { write("case.toml", good_case); }

  static Study read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    write("study.toml", "case = \"case.toml\"\n" + text);
    return read_study("study.toml", overrides);
  }

  static std::vector<std::string> overrides(const Study& study, std::size_t run) {
    return overrides_of(study.runs.at(run));
  }

  /// The drawn values of the first varied key.
  static std::vector<double> draws(const Study& study, std::size_t key = 0) {
    std::vector<double> list;
    for (const StudyRun& run : study.runs) list.push_back(std::stod(run.varied.at(key).second));
    return list;
  }

  static double mean(const std::vector<double>& values) {
    double sum = 0.;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }

  static double deviation(const std::vector<double>& values) {
    double sum = 0.;
    for (const double value : values) sum += std::pow(value - mean(values), 2);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
  }
};

using Texts = std::vector<std::string>;

TEST_F(StudyFile, GridRunsThroughTheLastKeyFastest) {
  const Study study = read(
      "[vary.\"time.end\"]\nvalues = [2, 3.5]\n[vary.\"regions.rubble.flow\"]\nvalues = [\"darcy\", \"inertial\"]\n"
      "[vary.gravity]\nfrom = 9\nto = 10\nn = 3\n");
  EXPECT_EQ(study.keys, (Texts{"time.end", "regions.rubble.flow", "gravity"}));
  ASSERT_EQ(study.runs.size(), 12U);
  EXPECT_EQ(overrides(study, 0), (Texts{"time.end=2", "regions.rubble.flow=\"darcy\"", "gravity=9"}));
  EXPECT_EQ(overrides(study, 1), (Texts{"time.end=2", "regions.rubble.flow=\"darcy\"", "gravity=9.5"}));
  EXPECT_EQ(overrides(study, 3), (Texts{"time.end=2", "regions.rubble.flow=\"inertial\"", "gravity=9"}));
  EXPECT_EQ(overrides(study, 11), (Texts{"time.end=3.5", "regions.rubble.flow=\"inertial\"", "gravity=10"}));
}

TEST_F(StudyFile, PairedValuesGoTogether) {
  const Study study =
      read("sample = \"paired\"\n[vary.\"time.end\"]\nvalues = [2, 3]\n[vary.gravity]\nfrom = 9\nto = 10\nn = 2\n");
  ASSERT_EQ(study.runs.size(), 2U);
  EXPECT_EQ(overrides(study, 0), (Texts{"time.end=2", "gravity=9"}));
  EXPECT_EQ(overrides(study, 1), (Texts{"time.end=3", "gravity=10"}));
}

TEST_F(StudyFile, LogarithmicRangesMeetTheirEndsAndGrowByAFactor) {
  const std::vector<double> values =
      draws(read("[vary.\"loads.impact.pulse.peak\"]\nfrom = 1e5\nto = 1e7\nn = 5\nspacing = \"log\"\n"));
  EXPECT_EQ(values.front(), 1e5);
  EXPECT_EQ(values.back(), 1e7);
  for (std::size_t i = 1; i < values.size(); ++i) EXPECT_NEAR(values[i] / values[i - 1], std::sqrt(10.), 1e-12);
}

TEST_F(StudyFile, FollowersAndFixedKeysGoAlong) {
  const Study study = read(
      "[set]\ntime.end = 4\n\"accuracy.tolerance\" = 0.02\n[vary.\"regions.rubble.shear_modulus\"]\nvalues = [1e7]\n"
      "[follow.\"regions.block.youngs_modulus\"]\nkey = \"regions.rubble.shear_modulus\"\nfactor = 2.5\n");
  EXPECT_EQ(overrides(study, 0),
            (Texts{"accuracy.tolerance=0.02", "time.end=4", "regions.rubble.shear_modulus=10000000",
                   "regions.block.youngs_modulus=25000000"}));
  EXPECT_EQ(study.runs[0].varied.size(), 1U);
}

TEST_F(StudyFile, EveryCaseGetsTheWholeSample) {
  write("other.toml", good_case);
  write("study.toml", "cases = [\"case.toml\", \"other.toml\"]\n[vary.\"time.end\"]\nvalues = [2, 3]\n");
  const Study study = read_study("study.toml");
  ASSERT_EQ(study.runs.size(), 4U);
  EXPECT_EQ(study.cases, (Texts{"case.toml", "other.toml"}));
  EXPECT_EQ(study.runs[1].case_index, 0);
  EXPECT_EQ(study.runs[2].case_index, 1);
  EXPECT_EQ(study.runs[2].varied, study.runs[0].varied);
}

TEST_F(StudyFile, DrawsHaveTheMomentsOfTheirDistributions) {
  const Study study = read(
      "sample = \"random\"\nn = 4000\n"
      "[vary.\"time.end\"]\ndistribution = \"uniform\"\nlow = 2\nhigh = 4\n"
      "[vary.\"regions.rubble.shear_modulus\"]\ndistribution = \"log_normal\"\nmean = 1e8\ncov = 0.3\n"
      "[vary.\"regions.rubble.grain_density\"]\ndistribution = \"normal\"\nmean = 2650\ncov = 0.02\n"
      "[vary.\"regions.rubble.hydraulic_conductivity\"]\ndistribution = \"log_uniform\"\nlow = 0.01\nhigh = 1\n"
      "[vary.\"mesh.refine\"]\nvalues = [0, 1, 2]\n");
  const double root = std::sqrt(4000.);  // tolerances are four standard errors
  EXPECT_NEAR(mean(draws(study, 0)), 3., 4. * 2. / std::sqrt(12.) / root);
  EXPECT_NEAR(mean(draws(study, 1)), 1e8, 4. * 0.3e8 / root);
  EXPECT_NEAR(deviation(draws(study, 1)), 0.3e8, 0.03e8);
  EXPECT_NEAR(mean(draws(study, 2)), 2650., 4. * 53. / root);
  EXPECT_NEAR(deviation(draws(study, 2)), 53., 3.);
  std::vector<double> decades;
  for (const double k : draws(study, 3)) decades.push_back(std::log10(k));
  EXPECT_NEAR(mean(decades), -1., 4. * 2. / std::sqrt(12.) / root);
  EXPECT_NEAR(mean(draws(study, 4)), 1., 4. * std::sqrt(2. / 3.) / root);
}

TEST_F(StudyFile, ADrawBelongsToItsKeyAndNumber) {
  const std::string end = "[vary.\"time.end\"]\ndistribution = \"uniform\"\nlow = 2\nhigh = 4\n";
  const std::string gravity = "[vary.gravity]\ndistribution = \"uniform\"\nlow = 9\nhigh = 10\n";
  const std::string head = "sample = \"random\"\nn = 20\n";
  const std::vector<double> alone = draws(read(head + end)), more = draws(read(head + end, {"n=40"}));
  const std::vector<double> second = draws(read(head + gravity + end), 1);
  EXPECT_EQ(second, alone);
  EXPECT_EQ(std::vector<double>(more.begin(), more.begin() + 20), alone);
  EXPECT_NE(draws(read(head + end, {"seed=2"})), alone);
  EXPECT_EQ(std::set<double>(alone.begin(), alone.end()).size(), 20U);
}

const std::string sobol_keys =
    "sample = \"sobol\"\nn = 8\n[vary.\"time.end\"]\ndistribution = \"uniform\"\nlow = 2\nhigh = 4\n"
    "[vary.gravity]\ndistribution = \"uniform\"\nlow = 9\nhigh = 10\n[vary.\"mesh.refine\"]\nvalues = [0, 1]\n";

TEST_F(StudyFile, ASobolSampleIsTwoMatricesAndTheFirstWithEachColumnOfTheSecond) {
  const Study study = read(sobol_keys);
  ASSERT_EQ(study.runs.size(), 8U * 5U);
  const Texts matrices{"A", "B", "time.end", "gravity", "mesh.refine"};
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const StudyRun& run = study.runs[i];
    EXPECT_EQ(run.matrix, matrices[i % 5]) << i;
    EXPECT_EQ(run.point, static_cast<int>(i / 5)) << i;
    const StudyRun &a = study.runs[i - i % 5], &b = study.runs[i - i % 5 + 1];
    for (std::size_t k = 0; k < 3; ++k)
      if (i % 5 >= 2) {
        EXPECT_EQ(run.varied[k], (k == i % 5 - 2 ? b : a).varied[k]) << i << " " << k;
      }
  }
}

/// Each of 2^k equal parts of an axis has one of 2^k points of Sobol's sequence, shifted or not; random ones have not.
TEST_F(StudyFile, ASobolSampleFillsEachAxisOfBothMatricesEvenly) {
  const Study study = read(sobol_keys, {"n=64"});
  const std::vector<double> end = draws(study, 0), gravity = draws(study, 1);
  for (const std::size_t matrix : {0U, 1U}) {
    std::set<int> parts_of_end, parts_of_gravity, parts_of_both;
    for (std::size_t i = matrix; i < study.runs.size(); i += 5) {
      parts_of_end.insert(static_cast<int>(64. * (end[i] - 2.) / 2.));
      parts_of_gravity.insert(static_cast<int>(64. * (gravity[i] - 9.)));
      parts_of_both.insert(4 * static_cast<int>(2. * (end[i] - 2.)) + static_cast<int>(4. * (gravity[i] - 9.)));
    }
    EXPECT_EQ(parts_of_end.size(), 64U) << matrix;
    EXPECT_EQ(parts_of_gravity.size(), 64U) << matrix;
    EXPECT_EQ(parts_of_both.size(), 16U) << matrix;
  }
}

TEST_F(StudyFile, MorePointsOfASobolSampleLeaveTheFirstOnesAndItsSeedMovesAll) {
  const std::vector<double> few = draws(read(sobol_keys)), more = draws(read(sobol_keys, {"n=20"}));
  EXPECT_EQ(std::vector<double>(more.begin(), more.begin() + 40), few);
  EXPECT_NE(draws(read(sobol_keys, {"seed=2"})), few);
  EXPECT_EQ(draws(read(sobol_keys)), few);
}

TEST_F(StudyFile, TheFingerprintChangesWithEverythingThatANumberRestsOn) {
  const std::string text = "[vary.\"loads.gauge.history\"]\nvalues = [\"force.csv\", \"second.csv\"]\n";
  write("second.csv", "time,force\n0,0\n0.2,1e6\n0.4,0\n");
  std::set<std::uint64_t> seen{read(text).fingerprint};
  const auto expect_news = [&](const std::string& what, const Study& study) {
    EXPECT_TRUE(seen.insert(study.fingerprint).second) << what;
  };
  EXPECT_EQ(read(text).fingerprint, *seen.begin());
  expect_news("title", read("title = \"x\"\n" + text));
  expect_news("override", read(text, {"title=y"}));
  write("second.csv", "time,force\n0,0\n0.2,2e6\n0.4,0\n");
  expect_news("a varied history", read(text));
  write("case.toml", good_case + "# more\n");
  expect_news("the case", read(text));
  write("meshes/composite.geo", "// more\n");
  expect_news("the geometry", read(text));
  write("meshes/composite.geo", "Include \"more.geo\";\n");
  expect_news("a geometry that includes", read(text));
  write("meshes/more.geo", "Merge \"drawn.stl\";\n");
  expect_news("what it includes", read(text));
  write("meshes/drawn.stl", "solid\n");
  expect_news("what that merges", read(text));
}

TEST_F(StudyFile, OneSoundRunIsEnoughToStart) {
  EXPECT_EQ(read("[vary.\"regions.rubble.poissons_ratio\"]\nvalues = [0.7, 0.3]\n").runs.size(), 2U);
}

TEST(StudyReference, TellsEveryTable) {
  for (const std::string table : {"[vary.NAME]", "[follow.NAME]"})
    EXPECT_NE(study_reference().find("## `" + table + "`"), std::string::npos) << table;
}

}  // namespace study_test
}  // namespace upbead::test
