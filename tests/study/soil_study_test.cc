// Claims: a study of many soils is answered by one model of them: each run agrees with that solved alone within its
// estimate, tells the estimate, and says what was skipped; without share = "soils", few soils, and scenes that no model
// can answer are solved alone, to the last bit.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>

#include "good_case.h"
#include "section_case.h"
#include "study/runner.h"
#include "study/soil_runs.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead::test {
namespace soil_study_test {

class SoilStudy : public InFolder {
 protected:
  SoilStudy() {
    static const PetscSession petsc;
    unsetenv("UPBEAD_MESHES");
  }

  static Study study_of(int runs, const std::vector<Setting>& fixed = {}) {
    write("case.toml", section_case({}));
    Study study;
    study.share = StudyShare::soils;
    study.cases = {"case.toml"};
    study.reads = {"response.peak_shear", "response.peak_shear_time"};
    for (int i = 0; i < runs; ++i) {
      StudyRun run;
      run.settings = fixed;
      run.settings.emplace_back("regions.seabed.shear_modulus", std::to_string(2e7 * std::pow(4., i / (runs - 1.))));
      run.settings.emplace_back("regions.mound.shear_modulus",
                                std::to_string(5e7 * std::pow(3., (i * 7 % runs) / (runs - 1.))));
      run.settings.emplace_back("loads.impulse.factor", i % 2 == 0 ? "1.0" : "1.5");
      study.runs.push_back(run);
    }
    return study;
  }
  static std::vector<std::vector<int>> every_run(const Study& study) {
    std::vector<int> all(study.runs.size());
    std::iota(all.begin(), all.end(), 0);
    return {all};
  }
  /// A run has the answer of its own, to the last bit.
  static void expect_alone(const Study& study, int run) {
    make_soil_families(study, every_run(study), "out", false, {});
    Runner runner(study, "out", true, false), alone(study, "out", false, false);
    const RunResult a = runner.run(run, [] {}), b = alone.run(run, [] {});
    ASSERT_TRUE(a.done && b.done) << a.message << b.message;
    EXPECT_NE(a.shared, Shared::soils);
    EXPECT_EQ(a.values, b.values);
  }
};

TEST_F(SoilStudy, IsAnsweredByOneModel) {
  const Study study = study_of(static_cast<int>(least_soils));
  make_soil_families(study, every_run(study), "out", false, {});
  Runner together(study, "out", true, false), alone(study, "out", false, false);
  for (const int i : {0, 5, 11, 22}) {
    const RunResult a = together.run(i, [] {}), b = alone.run(i, [] {});
    ASSERT_TRUE(a.done && b.done) << a.message << b.message;
    EXPECT_EQ(a.shared, Shared::soils) << a.why_own;
    ASSERT_TRUE(a.error_estimate);
    EXPECT_FALSE(b.error_estimate);
    EXPECT_NEAR(*a.values[0], *b.values[0], *a.error_estimate * *b.values[0] + 1e-3 * *b.values[0]);
    EXPECT_LT(*a.error_estimate, 5e-3);
    EXPECT_NE(a.summary.find("one model answers all soils"), std::string::npos);
    EXPECT_EQ(a.doubts.warnings.size(), b.doubts.warnings.size());
  }
}

/// One model has one body: the mass of a rigid region is none of its parts.
TEST_F(SoilStudy, OfAnotherCaissonIsSolvedAlone) {
  Study study = study_of(static_cast<int>(least_soils));
  study.runs[11].settings.emplace_back("regions.caisson.density", "3000");
  expect_alone(study, 11);
}

TEST_F(SoilStudy, OfFewSoilsOrWithoutSharingIsSolvedAlone) {
  const Study few = study_of(static_cast<int>(least_soils) - 1);
  EXPECT_TRUE(soil_groups(few).empty());
  Study none = study_of(static_cast<int>(least_soils));
  EXPECT_EQ(soil_groups(none).size(), 1U);
  none.share = StudyShare::all;
  EXPECT_TRUE(soil_groups(none).empty());
  make_soil_families(none, every_run(none), "out", false, {});
  EXPECT_FALSE(std::filesystem::exists("out"));
  Runner runner(none, "out", true, false), alone(none, "out", false, false);
  EXPECT_EQ(runner.run(1, [] {}).values, alone.run(1, [] {}).values);
}

TEST_F(SoilStudy, ThatReadsWhatTheModelDoesNotTellIsSolvedAlone) {
  Study study = study_of(static_cast<int>(least_soils));
  study.reads.emplace_back("sliding.design.value");  // nor does a run of this case
  make_soil_families(study, every_run(study), "out", false, {});
  Runner runner(study, "out", true, false), alone(study, "out", false, false);
  const RunResult a = runner.run(3, [] {}), b = alone.run(3, [] {});
  ASSERT_TRUE(a.done && b.done) << a.message << b.message;
  EXPECT_EQ(a.values, b.values);
  EXPECT_FALSE(a.error_estimate);
  EXPECT_EQ(a.why_own, "one model of all soils does not tell every number that is read");
}

TEST_F(SoilStudy, HasWhatPressesOnTheBase) {
  Study study = study_of(static_cast<int>(least_soils), {{"sliding.submerged_weight", "4.3e6"}});
  study.reads = {"base.peak_heel_pressure", "base.peak_toe_pressure", "base.least_overturning_margin",
                 "base.least_normal_force", "response.peak_displacement"};
  make_soil_families(study, every_run(study), "out", false, {});
  Runner runner(study, "out", true, false), alone(study, "out", false, false);
  for (const int i : {2, 4}) {
    const RunResult a = runner.run(i, [] {}), b = alone.run(i, [] {});
    ASSERT_TRUE(a.done && b.done) << a.message << b.message;
    ASSERT_TRUE(a.error_estimate) << a.why_own;
    for (std::size_t k = 0; k < study.reads.size(); ++k)
      EXPECT_NEAR(*a.values[k] / *b.values[k], 1., 0.005) << study.reads[k];
  }
}

TEST_F(SoilStudy, HasNoPressureOfAnEdgeThatTheResultantSurelyLeaves) {
  Study study = study_of(static_cast<int>(least_soils), {{"sliding.submerged_weight", "6e5"}});
  study.reads = {"base.peak_heel_pressure", "base.least_overturning_margin", "response.peak_shear"};
  make_soil_families(study, every_run(study), "out", false, {});
  Runner together(study, "out", true, false), alone(study, "out", false, false);
  const RunResult a = together.run(3, [] {}), b = alone.run(3, [] {});
  ASSERT_TRUE(a.done && b.done) << a.message << b.message;
  ASSERT_TRUE(a.error_estimate) << a.why_own;
  EXPECT_LT(*b.values[1], 0.99);
  EXPECT_FALSE(a.values[0] || b.values[0]);
  EXPECT_NEAR(*a.values[1] / *b.values[1], 1., 0.005);
}

TEST_F(SoilStudy, ThatReadsWhatIsNotHeldIsSolvedAlone) {
  Study study = study_of(static_cast<int>(least_soils));
  study.reads.emplace_back("base.peak_computed_pressure");
  make_soil_families(study, every_run(study), "out", false, {});
  Runner runner(study, "out", true, false), alone(study, "out", false, false);
  const RunResult a = runner.run(3, [] {}), b = alone.run(3, [] {});
  ASSERT_TRUE(a.done && b.done) << a.message << b.message;
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(
      a.why_own,
      "'base.peak_computed_pressure' is read, and one model of all soils holds F_T, S, the caisson's displacement "
      "and what presses on its base to the tolerance, and no more");
}

TEST_F(SoilStudy, KeepsItsFamilyAndMakesATornOneAnew) {
  const Study study = study_of(static_cast<int>(least_soils));
  make_soil_families(study, every_run(study), "out", false, {});
  const std::string path = "out/journal/soils-0.h5";
  const auto written = std::filesystem::last_write_time(path);
  make_soil_families(study, every_run(study), "out", false, {});
  EXPECT_EQ(std::filesystem::last_write_time(path), written);
  Study other = study;
  ++other.fingerprint;
  EXPECT_FALSE(read_soil_family(other, 0, "out").family);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_FALSE(read_soil_family(study, 0, "out").family);
  make_soil_families(study, every_run(study), "out", false, {});
  EXPECT_TRUE(read_soil_family(study, 0, "out").family);
}

TEST_F(SoilStudy, OfAMarchIsSolvedAlone) {
  expect_alone(study_of(static_cast<int>(least_soils), {{"time.scheme", "\"sdirk4\""}}), 2);
}

}  // namespace soil_study_test
}  // namespace upbead::test
