// Claim: a run of a study that takes over stages of the run before (mesh, System, basis, solution) has the whole
// summary of one that is solved alone, to the last bit: every key but the wall times. It enters at the stage that is
// expected. Over scenes unlike each other, keys of every stage, and every key of [sliding].
#include <nlohmann/json.hpp>
#include <set>

#include "case/case_findings.h"
#include "case/case_run.h"
#include "good_case.h"
#include "section_case.h"
#include "study/runner.h"
#include "upbead/algebra/petsc_session.h"

namespace upbead::test {
namespace same_answer_test {

using Json = nlohmann::ordered_json;
using Settings = std::vector<Setting>;

/// A run, and what it takes over from the one before.
struct Row {
  Settings settings;
  Shared shared = Shared::nothing;
};

/// The same settings in all rows, before their own.
std::vector<Row> with(const Settings& more, std::vector<Row> rows) {
  for (Row& row : rows) row.settings.insert(row.settings.begin(), more.begin(), more.end());
  return rows;
}

/// What must differ: wall times.
Json comparable(const std::string& summary) {
  Json json = Json::parse(summary);
  json.erase("timing");
  return json;
}

/// Path and both values of every difference.
void note_differences(const Json& a, const Json& b, const std::string& path, std::string& list) {
  if (a == b) return;
  if (a.is_structured() && a.type() == b.type() && a.size() == b.size()) {
    const Json flat_a = a.flatten(), flat_b = b.flatten();
    for (const auto& [key, value] : flat_a.items())
      if (!flat_b.contains(key) || flat_b[key] != value)
        list += path + key + ": " + value.dump() + " / " + (flat_b.contains(key) ? flat_b[key].dump() : "-") + "\n";
  }
  if (list.empty()) list = a.dump() + "\n" + b.dump();
}

class SameAnswer : public InFolder {
 protected:
  SameAnswer() {
    static const PetscSession petsc;
    unsetenv("UPBEAD_MESHES");
  }

  /// Runs of case.toml, one for each of the settings.
  static Study study_of(const std::string& text, const std::vector<Settings>& runs) {
    write("case.toml", text);
    Study study;
    study.cases = {"case.toml"};
    for (const Settings& settings : runs) study.runs.push_back({0, {}, settings});
    return study;
  }

  /// Compares runs one after the other in one process with those alone, by a study and as `upbead run` solves them.
  static void expect_same(const std::string& text, const std::vector<Settings>& runs, Shared shared) {
    std::vector<Row> rows;
    for (const Settings& settings : runs) rows.push_back({settings, rows.empty() ? Shared::nothing : shared});
    expect_same(text, rows);
  }

  static void expect_same(const std::string& text, const std::vector<Row>& rows) {
    std::vector<Settings> runs;
    for (const Row& row : rows) runs.push_back(row.settings);
    const Study study = study_of(text, runs);
    Runner sharing(study, "out", true, false);
    std::set<std::string> answers;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      Runner alone(study, "out", false, false);
      const RunResult a = sharing.run(static_cast<int>(i), [] {}), b = alone.run(static_cast<int>(i), [] {});
      ASSERT_TRUE(a.done && b.done) << i << ": " << a.message << " / " << b.message;
      EXPECT_EQ(a.shared, rows[i].shared) << i;
      EXPECT_EQ(b.shared, Shared::nothing);
      std::string differences;
      note_differences(comparable(a.summary), comparable(b.summary), "", differences);
      if (i == 0 || i + 1 == runs.size()) {
        const Case problem = read_case("case.toml", overrides_of(study.runs[i]));
        const Simulation simulation = simulation_of(problem);
        const upbead::Run run = upbead::solve(problem, simulation, read_records(problem, simulation));
        note_differences(comparable(a.summary), comparable(to_json(run.summary)), "by a run: ", differences);
      }
      EXPECT_EQ(differences, "") << "run " << i;
      answers.insert(comparable(a.summary).dump());
    }
    EXPECT_EQ(answers.size(), runs.size()) << "each setting must be felt";
  }
};

const std::string coarse = "cells = 0.3, grading = 4";

/// The section on few cells, hit until it slides.
std::string struck(const std::string& sliding, const std::string& more = "", const std::string& peak = "8e6") {
  return section_case({{"cells = 0.5, seabed_front = 60, seabed_back = 60", coarse},
                       {"peak = 1e6", "peak = " + peak},
                       {"end = 0.6", "end = 0.3"}}) +
         more + "[initial]\nwater_level = 15.0\n[limits]\nsliding = 0.05\nbase_pressure = 5e5\noverturning = 1.2\n" +
         sliding;
}

const std::string sliding_table = "[sliding]\nsubmerged_weight = 4.3e6\n";

Settings uplift(const std::string& keys) {
  return {{"sliding.uplift", "{ " + keys + " }"}};
}

/// Every key of [sliding] and its tables, each varied at least once.
const std::vector<Settings> every_key{
    {},
    {{"sliding.submerged_weight", "3.0e6"}},
    {{"sliding.submerged_weight", "5.9e6"}},
    {{"sliding.friction", "0.45"}},
    {{"sliding.weight", "5.96e6"}},
    {{"sliding.drag", "1e6"}},
    {{"sliding.wave", "{ height = 8, depth = 15.0, period = 13.6, alpha_star = 0.5 }"}},
    uplift("kind = \"computed\""),
    uplift("kind = \"prescribed\", peak = 8e5"),
    uplift("kind = \"prescribed\", peak = 8e5, shape = \"in_phase\""),
    uplift("kind = \"prescribed\", peak = 8e5, distribution = \"uniform\""),
    uplift("kind = \"prescribed\", peak = 8e5, lag = 0.03"),
    uplift("kind = \"prescribed\", history = \"force.csv\", column = \"force\""),
    uplift(
        "kind = \"prescribed\", gauges = \"gauges.csv\", positions = { a = -8, b = 8 }, ends = [-9, 9], to_seaward = "
        "\"constant\", to_landward = \"to_zero\", load_cell = \"cell\", zero = 0.02, record_start = 0.01"),
    uplift("kind = \"prescribed\", gauges = \"rated.csv\", positions = { a = -8, b = 8 }, ends = [-9, 9], to_seaward = "
           "\"none\", to_landward = \"none\", gauge_unit = \"kPa\", sampling_rate = 20"),
    {},
};

TEST_F(SameAnswer, WhateverKeyOfSlidingIsVaried) {
  write("gauges.csv",
        "time (s),a (kPa),b (kPa),cell\n0,1,1,0\n0.05,40,20,5e5\n0.1,60,30,8e5\n0.15,20,10,2e5\n0.3,1,1,0\n");
  write("rated.csv", "a,b\n0,0\n10,5\n40,20\n60,30\n20,10\n0,0\n0,0\n");
  std::vector<Settings> runs(every_key.begin(), every_key.end() - 1);
  expect_same(struck(sliding_table), runs, Shared::solution);
}

TEST_F(SameAnswer, AMistakeInARecordCostsItsRunAlone) {
  write("gauges.csv", "time (s),a (Pa),b (Pa)\n0,0,0\n0.05,1e5,5e4\n0.3,0,0\n");
  const Study study = study_of(
      struck(sliding_table),
      {uplift("kind = \"prescribed\", gauges = \"gauges.csv\", positions = { a = -8, b = 8 }, ends = [-9, 9], "
              "to_seaward = "
              "\"none\", to_landward = \"none\", sampling_rate = 20"),
       uplift(
           "kind = \"prescribed\", gauges = \"none.csv\", positions = { a = -8, b = 8 }, ends = [-9, 9], to_seaward = "
           "\"none\", to_landward = \"none\""),
       {}});
  Runner runner(study, "out", true, false);
  EXPECT_NE(runner.run(0, [] {}).message.find("sampling_rate"), std::string::npos);
  EXPECT_NE(runner.run(1, [] {}).message.find("none.csv"), std::string::npos);
  EXPECT_TRUE(runner.run(2, [] {}).done);
}

TEST_F(SameAnswer, TheListHasEveryKeyOfSliding) {
  std::string all;
  for (const Settings& settings : every_key)
    for (const auto& [key, value] : settings) all += key + " " + value + " ";
  const std::string reference = case_reference();
  for (std::size_t at = reference.find("## `[sliding"); at < reference.find("## `[cycles"); ++at) {
    if (reference.compare(at, 4, "\n| `") != 0) continue;
    const std::string key = reference.substr(at + 4, reference.find('`', at + 4) - at - 4);
    EXPECT_NE(all.find(key), std::string::npos) << key;
  }
}

TEST_F(SameAnswer, WithErrorsEstimated) {
  expect_same(struck(sliding_table, "[accuracy]\nestimate = true\n"),
              {{{"sliding.friction", "2"}}, {{"sliding.submerged_weight", "3.4e6"}}}, Shared::solution);
}

TEST_F(SameAnswer, WithFieldsAndStrengthByAReducedModel) {
  expect_same(struck(sliding_table, "[output]\nfields = { every = 0.1 }\nevery = 0.05\n[probes.A]\nat = [0.0, -5.0]\n"),
              {{{"time.scheme", "\"reduced\""}, {"regions.mound.strength", "{ friction_angle = 40 }"}},
               {{"time.scheme", "\"reduced\""},
                {"regions.mound.strength", "{ friction_angle = 40 }"},
                {"sliding.submerged_weight", "3.0e6"}}},
              Shared::solution);
}

TEST_F(SameAnswer, OfGroundThatYieldsOrFollowsItsStrain) {
  const std::string yields = struck(sliding_table, "", "4e6");
  const auto with_law = [](Settings more) {
    more.insert(more.begin(), {{"regions.seabed.law", "\"hysteretic\""},
                               {"regions.seabed.strength", "{ friction_angle = 38 }"},
                               {"time.step", "0.01"},
                               {"initial.bounds", "false"}});
    return more;
  };
  expect_same(yields, {with_law({}), with_law({{"sliding.friction", "0.4"}})}, Shared::solution);
}

Setting peak(const std::string& value) {
  return {"loads.impulse.pulse.peak", value};
}

Setting duration(const std::string& value) {
  return {"loads.impulse.pulse.duration", value};
}

/// Rows of a scene that is reduced: they enter at the basis as long as the loads last as long.
const std::vector<Row> of_reduced{{{}},
                                  {{peak("6e6")}, Shared::basis},
                                  {{peak("6e6"), duration("0.12")}, Shared::system},
                                  {{peak("7e6"), duration("0.12")}, Shared::basis}};
/// Of one that is marched: there is no basis.
const std::vector<Row> of_marched{{{}},
                                  {{peak("3e6")}, Shared::system},
                                  {{duration("0.12")}, Shared::system},
                                  {{{"time.end", "0.25"}}, Shared::system}};

TEST_F(SameAnswer, AtWhateverStageARunEnters) {
  const std::vector<Row> rows{{{}},
                              {{peak("5e6")}, Shared::basis},
                              {{peak("5e6"), {"limits.sliding", "0.01"}, {"title", "\"another\""}}, Shared::solution},
                              {{peak("5e6"), {"limits.liquefaction", "1.0"}}, Shared::basis},
                              {{peak("5e6"), {"accuracy.tolerance", "1e-4"}}, Shared::basis},
                              {{peak("4e6"), {"accuracy.tolerance", "0.02"}}, Shared::basis},
                              {{{"time.end", "0.25"}}, Shared::basis},
                              {{{"time.step", "0.003"}}, Shared::basis},
                              {{{"output.every", "0.01"}, peak("4.5e6")}, Shared::basis},
                              {{duration("0.12")}, Shared::system},
                              {{duration("0.12"), {"loads.impulse.pulse.rise", "0.02"}}, Shared::system},
                              {{{"loads.impulse.direction", "[0.9, -0.1]"}}, Shared::mesh},
                              {{{"regions.seabed.shear_modulus", "20e6"}}, Shared::mesh},
                              {{{"boundaries.left.displacement", "\"fixed\""}}, Shared::mesh},
                              {{{"fluid.density", "1000.0"}}, Shared::mesh},
                              {{{"gravity", "9.8"}}, Shared::mesh},
                              {{{"probes.A.at", "[0.0, -5.0]"}}, Shared::mesh},
                              {{{"mesh.degree", "3"}}, Shared::nothing},
                              {{{"mesh.parameters.cells", "0.35"}}, Shared::nothing},
                              {{{"mesh.parameters.cells", "0.35"}, peak("2e6")}, Shared::basis}};
  expect_same(struck(sliding_table), with({{"time.scheme", "\"reduced\""}}, rows));
}

TEST_F(SameAnswer, OfEveryKindOfBasis) {
  const Settings reduced{{"time.scheme", "\"reduced\""}};
  expect_same(struck(sliding_table, "[accuracy]\nestimate = true\n"), with(reduced, of_reduced));
  const Settings states{{"time.scheme", "\"reduced\""}, {"regions.mound.strength", "{ friction_angle = 40 }"}};
  expect_same(struck(sliding_table), with(states, of_reduced));
  const Settings elastic{{"time.scheme", "\"reduced\""},
                         {"regions.caisson.kind", "\"solid\""},
                         {"regions.caisson.deformation", "\"elastic\""},
                         {"regions.caisson.shear_modulus", "1e9"},
                         {"regions.caisson.poissons_ratio", "0.2"}};
  expect_same(struck(""), with(elastic, of_reduced));
}

TEST_F(SameAnswer, OfGroundWithoutDamping) {
  std::string text = struck(sliding_table);
  const std::string damping = "damping = { ratio = 0.05, frequencies = [1, 10] }\n";
  for (std::size_t at; (at = text.find(damping)) != std::string::npos;) text.erase(at, damping.size());
  expect_same(text, with({{"time.scheme", "\"reduced\""}}, of_reduced));
}

TEST_F(SameAnswer, OfAMarch) {
  expect_same(struck(sliding_table), with({{"time.scheme", "\"sdirk4\""}}, of_marched));
  expect_same(struck(sliding_table), with({{"time.scheme", "\"generalised_alpha\""}}, of_marched));
  expect_same(struck(sliding_table), with({{"time.inertia", "false"}}, of_marched));
}

TEST_F(SameAnswer, OfSoilThatIsNotLinear) {
  const Settings yields{{"regions.seabed.law", "\"hysteretic\""},
                        {"regions.seabed.strength", "{ friction_angle = 38 }"},
                        {"time.step", "0.01"},
                        {"initial.bounds", "false"}};
  expect_same(struck(sliding_table),
              with(yields, {{{}}, {{peak("3e6")}, Shared::system}, {{duration("0.12")}, Shared::system}}));
  const Settings follows{{"regions.seabed.strain", "{ reference_strain = 1e-3 }"}};
  expect_same(struck(sliding_table),
              with(follows, {{{}}, {{peak("3e6")}, Shared::system}, {{duration("0.12")}, Shared::system}}));
}

TEST_F(SameAnswer, OfStiffnessByStress) {
  const Settings by_stress{
      {"regions.seabed.shear_modulus", "{ reference = 60e6 }"}, {"initial.k0", "0.5"}, {"time.scheme", "\"reduced\""}};
  expect_same(struck(sliding_table),
              with(by_stress, {{{}}, {{peak("3e6")}, Shared::basis}, {{{"initial.k0", "0.6"}}, Shared::mesh}}));
}

TEST_F(SameAnswer, OfACaissonThatSlipsByFriction) {
  const Setting contact{"regions.caisson.interface", "{ kind = \"friction\" }"};
  expect_same(struck(sliding_table), with({contact}, {{{}},
                                                      {{{"sliding.submerged_weight", "3.6e6"}}, Shared::system},
                                                      {{{"sliding.friction", "0.5"}}, Shared::system},
                                                      {{{"limits.sliding", "0.01"}}, Shared::system},
                                                      {{peak("1e6")}, Shared::system},
                                                      {{peak("1e6"), {"limits.sliding", "0.01"}}, Shared::solution}}));
}

TEST_F(SameAnswer, OfContactOnAReducedGround) {
  const Settings by_name{{"time.scheme", "\"reduced\""}, {"regions.caisson.interface", "{ kind = \"friction\" }"}};
  expect_same(struck(sliding_table, "", "4e6"),
              with(by_name, {{{}},
                             {{peak("3.8e6")}, Shared::system},
                             {{peak("3.8e6"), duration("0.16")}, Shared::system},
                             {{peak("8e6"), duration("0.05")}, Shared::system},
                             {{peak("3.8e6"), {"sliding.friction", "0.5"}}, Shared::system},
                             {{{"regions.caisson.interface.coefficient", "0.5"}}, Shared::system},
                             {{{"sliding.submerged_weight", "4.1e6"}}, Shared::system},
                             {uplift("kind = \"prescribed\", peak = 8e5"), Shared::system},
                             {{{"initial.water_level", "14.9"}}, Shared::system},
                             {{{"regions.seabed.shear_modulus", "28e6"}}, Shared::mesh}}));
}

TEST_F(SameAnswer, OfALoadByAWave) {
  const std::string load = "pulse = { shape = \"triangle\", peak = 1e6, duration = 0.15 }";
  const std::string text =
      section_case({{"cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.4, grading = 4"},
                    {"kind = \"force\"", "kind = \"wave\""},
                    {load, "wave = { course = \"church_roof\", height = 11, period = 13.6 }"},
                    {"end = 0.6", "end = 0.5\nstep = 0.01"}}) +
      "[sliding]\nuplift = { kind = \"wave\", shape = \"held\" }\n[section]\nwater_depth = 15.0\nfoundation_depth = "
      "9.0\n"
      "berm_depth = 7.5\ncrest = 7.0\nwidth = 18.0\nberm_width = 7.0\nbed_slope = 0.01\nweight = 5.933088e6\n"
      "submerged_weight = 4.296e6\n";
  expect_same(text, {{}, {{"sliding.uplift", "{ kind = \"wave\", shape = \"in_phase\" }"}}, {{"sliding.drag", "1e6"}}},
              Shared::solution);
}

TEST_F(SameAnswer, OfAMeshForTheToleranceAtLength) {
  const Setting cells{"mesh.refine", "\"auto\""}, tolerance{"accuracy.tolerance", "0.05"};
  expect_same(struck(sliding_table), {{cells, tolerance}, {cells, tolerance, {"sliding.submerged_weight", "3.0e6"}}},
              Shared::nothing);
}

TEST_F(SameAnswer, WithoutInertiaAndFromAnotherCase) {
  const Setting slow{"time.inertia", "false"};
  expect_same(struck(sliding_table), {{slow}, {slow, {"sliding.submerged_weight", "3.0e6"}}}, Shared::solution);
  write("other.toml", struck(""));
  Study study = study_of(struck(sliding_table), {{}, {}});
  study.cases.push_back("other.toml");
  study.runs[1].case_index = 1;
  Runner sharing(study, "out", true, false), alone(study, "out", false, false);
  sharing.run(0, [] {});
  const RunResult a = sharing.run(1, [] {}), b = alone.run(1, [] {});
  EXPECT_EQ(a.shared, Shared::solution);
  EXPECT_EQ(comparable(a.summary), comparable(b.summary));
  EXPECT_TRUE(comparable(a.summary)["sliding"].is_null());
}

}  // namespace same_answer_test
}  // namespace upbead::test
