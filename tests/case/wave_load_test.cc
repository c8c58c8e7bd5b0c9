// Claim: a load by a wave puts P, M_P and U of Goda's formulas on the meshed caisson, with the course in time that it
// names; these are the same as of `waves` and `expected`; a mesh that does not fit the section is refused.
#include "case/wave_load.h"

#include <cmath>
#include <random>

#include "base/numbers.h"
#include "case/case_schema.h"
#include "case/scale.h"
#include "case/time_end.h"
#include "expected/dynamic_law.h"
#include "fem/compile.h"
#include "meshed_wave.h"
#include "upbead/sliding/combined.h"
#include "upbead/waves/wave_heights.h"
#include "wave_case.h"

namespace upbead::test {

namespace {

const Section section_of_test{15., 9., 7.5, 7., 18., 7., 0.01, 5.933088e6, 4.296e6, {}, 0.6, false, {}, {}, {}};
const Water water_of_test{1030., 9.81};

}  // namespace

class WaveLoadTest : public MeshedWave {
 protected:
  static const WaveLoad& wave_of(const Case& problem) { return *sources_of_type<WaveLoad>(problem).front(); }

  /// P and M_P on the caisson and U are those of `pressure`.
  static void expect_forces(const std::string& text, const WavePressure& pressure) {
    const Case problem = read(text);
    const Simulation simulation = simulation_of(problem);
    const LoadOnCaisson& load = simulation.compiled()->loads_on_caisson.front();
    const double peak = extremum(simulation.scene().loads.at("storm").history, 0., 100., 1).value;
    EXPECT_NEAR(load.force_x * peak, pressure.force, 1e-12 * pressure.force);
    EXPECT_NEAR(load.force_y, 0., 1e-12);
    EXPECT_NEAR(load.moment * peak, pressure.force_moment,
                1e-9 * pressure.force_moment);  // the rounding of heights in gmsh's file
    EXPECT_EQ(simulation.scene().sliding->uplift->kind, UpliftKind::prescribed);
    EXPECT_EQ(*simulation.scene().sliding->uplift->peak, pressure.uplift);
    EXPECT_NEAR(*simulation.scene().sliding->uplift->peak, 0.5 * pressure.pu * problem.tables->section->width,
                1e-15 * pressure.uplift);
  }
};

TEST_F(WaveLoadTest, PutsGodasResultantsOnTheMesh) {
  const DesignWave wave{8., 8. / 1.8, 12., 0.};
  const WavePressure pressure = Goda(section_of_test, water_of_test, wave).at(8.);
  EXPECT_GT(pressure.p4, 0.);
  expect_forces(wave_case("{ height = 8.0, period = 12.0, course = \"sine\" }"), pressure);
  // the same by the sea state that `expected` uses
  const SeaState state{8. / 1.8, 12., 1., 0., 0.};
  const WavePressure expected = WaveForces({section_of_test, water_of_test, {}, {}}, state).at(8., {});
  EXPECT_EQ(expected.force, pressure.force);
  EXPECT_EQ(expected.uplift, pressure.uplift);
}

TEST_F(WaveLoadTest, PutsThoseOfALowObliqueWaveBeforeASea) {
  const double beta = 20. * std::acos(-1.) / 180.;
  const WavePressure pressure = Goda(section_of_test, water_of_test, {4., 2.5, 9., beta}).at(4.);
  EXPECT_EQ(pressure.p4, 0.);  // eta* below the crest
  std::string text =
      wave_case("{ height = 4.0, significant_height = 2.5, period = 9.0, angle = 20.0, course = \"triangle\" }",
                "cells = 0.3, grading = 4, sea_front = 3, water_depth = 15");
  text += "[regions.sea_front]\nkind = \"water\"\n";
  const std::string front = "front = {}";
  text.replace(text.find(front), front.size(),
               "front = {}\nsea_surface = { pressure = \"open\" }\nsea_left = { pressure = \"sealed\" }");
  expect_forces(text, pressure);
}

TEST_F(WaveLoadTest, RunAnswersWithPAndU) {
  const Case problem = read(wave_case("{ height = 8.0, period = 12.0, course = \"triangle\" }"), {"time.end=1.5"});
  const Simulation simulation = simulation_of(problem);
  const upbead::Run run = solve(problem, simulation);
  const WavePressure pressure = Goda(section_of_test, water_of_test, {8., 8. / 1.8, 12., 0.}).at(8.);
  EXPECT_NEAR(run.summary.response->peak_force, pressure.force, 1e-12 * pressure.force);
  EXPECT_NEAR(*run.summary.response->arm, pressure.force_moment / pressure.force, 1e-8);
  ASSERT_EQ(run.summary.waves.size(), 1u);
  EXPECT_EQ(run.summary.waves[0].pressure.force, pressure.force);
  EXPECT_EQ(run.summary.waves[0].pressure.uplift, pressure.uplift);
  EXPECT_EQ(run.summary.sliding->submerged_weight, section_of_test.submerged_weight);
  EXPECT_EQ(run.summary.sliding->friction, section_of_test.friction);
  // tau_0 is that of the same wave
  EXPECT_NEAR(run.summary.sliding->pulse->duration, run.summary.waves[0].duration, 1e-15);
}

TEST_F(WaveLoadTest, CoursesHaveTheirPeaksAndImpulses) {
  const Goda goda(section_of_test, water_of_test, {8., 8. / 1.8, 12., 0.});
  const WavePressure p = goda.at(8.);
  const double standing = goda.at(8., PressureFormula::standing).force, half_wave = standing * 12. / std::acos(-1.);
  const double tau_0 = DurationFactor()(p.alpha_star) * standing_duration(8., 15., 12.);
  const std::vector<std::pair<std::string, double>> impulses{{"triangle", 0.5 * p.force * tau_0},
                                                             {"sine", p.force * 12. / std::acos(-1.)},
                                                             {"combined", half_wave},
                                                             {"church_roof", half_wave}};
  for (const auto& [course, impulse] : impulses) {
    const Case problem = read(wave_case("{ height = 8.0, period = 12.0, course = \"" + course + "\" }"));
    const WaveLoadSummary summary = wave_summaries(problem).front();
    EXPECT_EQ(summary.course, course);
    EXPECT_NEAR(summary.peak, p.force, 1e-14 * p.force) << course;
    EXPECT_NEAR(extremum(wave_of(problem).history, 0., 6., 1).value, p.force, 1e-12 * p.force) << course;
    // chords of the sine of combined_force are 8e-6 too low
    EXPECT_NEAR(summary.impulse, impulse, (course == "combined" ? 1e-5 : 1e-8) * impulse) << course;
    EXPECT_NEAR(integral(wave_of(problem).history, 0., 20.), summary.impulse, 1e-8 * impulse) << course;
  }
}

TEST_F(WaveLoadTest, ChurchRoofOfAnImpulseIsThatOfExpected) {
  const Breakwater breakwater{section_of_test, water_of_test, {}, {}};
  for (const std::string height : {"4.0", "8.0", "11.0"}) {
    const double H = std::stod(height);
    const Case problem =
        read(wave_case("{ height = " + height + ", significant_height = 4.0, period = 12.0, course = " +
                       "\"church_roof\", force = \"impulse\", impact = { peak_gain = 2.0 } }"));
    const WaveForces forces(breakwater, {4., 12., 1., 0., 0.});
    const WavePressure standing = forces.at(H, {}, PressureFormula::standing);
    ImpactAssumptions assumptions;
    assumptions.peak_gain = 2.;
    const ImpactWave wave = impact_wave(assumptions, {H, 12., standing.force, standing.alpha_star, standing.uplift, 0.},
                                        water_of_test, section_of_test.berm_depth);
    const double step = 0.01;
    const int n = number_of_samples(wave, step);
    std::vector<double> force(static_cast<std::size_t>(n));
    sample_force(wave, step, n, force.data());
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(wave_of(problem).history(i * step), force[static_cast<std::size_t>(i)], 1e-11 * wave.peak) << height;
    EXPECT_NEAR(wave_summaries(problem).front().peak, standing.force * (1. + 2. * standing.alpha_star), 1e-9);
  }
}

/// P_1 (1 + 0.5 alpha*) was below Goda's P for every alpha* > 0, as 0.5 alpha_1 < 1.
TEST_F(WaveLoadTest, NoImpactIsMilderThanGodasForceUnlessAskedFor) {
  std::mt19937 draw(41);
  const auto between = [&draw](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(draw);
  };
  for (int i = 0; i < 200; ++i) {
    Section s = section_of_test;
    s.berm_depth = between(2., 9.);
    s.berm_width = between(0., 30.);
    s.dissipating_blocks = i % 5 == 0;
    WaveLoadTable table;
    table.force = ImpactForce::impulse;
    table.height = between(2., 12.);
    table.period = between(6., 16.);
    table.angle = between(0., 60.);
    const auto own = wave_load(table, s, water_of_test);
    EXPECT_GE(own->peak(), own->pressure.force * (1. - 1e-12)) << i;
    table.impact.peak_gain = 3.;
    EXPECT_GE(wave_load(table, s, water_of_test)->peak(), own->peak() * (1. - 1e-12)) << i;
  }
}

TEST_F(WaveLoadTest, WarnsOfAnImpactMilderThanGodasForce) {
  const auto warned = [this](const std::string& impact) {
    const Case problem = read(wave_case(
        "{ height = 8.0, period = 12.0, course = \"church_roof\", force = \"impulse\"" + impact + " }", "cells = 0.4"));
    for (const NumberedWarning& warning : wave_of(problem).warnings)
      if (warning.name == "impact_below_goda") return true;
    return false;
  };
  EXPECT_FALSE(warned(""));
  EXPECT_TRUE(warned(", impact = { peak_gain = 0.5 }"));
  EXPECT_FALSE(warned(", impact = { peak_gain = 2.0 }"));
}

TEST_F(WaveLoadTest, ChecksByFormulasAreThoseOfTheSectionInItsWave) {
  for (const std::string course : {"church_roof", "sine", "standing"}) {
    const Case problem = read(wave_case("{ height = 5.0, period = 12.0, course = \"" + course + "\" }"));
    Limits limits;
    limits.sliding = 0.3;
    limits.base_pressure = 300e3;
    limits.overturning = 1.2;
    const Checks checks = formula_checks(wave_summaries(problem), limits);
    const Stability goda =
        stability(section_of_test, Goda(section_of_test, water_of_test, {5., 5. / 1.8, 12., 0.}).at(5.));
    const StandingResult standing = standing_answer(section_of_test, water_of_test, {5., 5. / 1.8, 12., 0.});
    const std::vector<std::pair<std::string, double>> wanted{
        {"sliding by formulas", goda.safety_sliding},
        {"overturning by formulas", goda.safety_overturning},
        {"heel pressure p_e", *goda.heel_pressure},
        {"sliding by formulas, standing wave", standing.answer->landward.safety_sliding},
        {"sliding seaward by formulas", standing.answer->seaward.safety_sliding},
        {"toe pressure p_e", *standing.answer->seaward.heel_pressure}};
    for (const auto& [name, value] : wanted) {
      const auto found = std::find_if(checks.begin(), checks.end(), [&](const Check& c) { return c.name == name; });
      ASSERT_NE(found, checks.end()) << name;
      EXPECT_NEAR(*found->demand, value, 1e-12 * value) << name << ", " << course;
      EXPECT_EQ(found->wave, "storm");
      EXPECT_TRUE(found->holds) << name;
    }
  }
}

TEST_F(WaveLoadTest, ChurchRoofTakesRiseAndDurationOfItsPeak) {
  const Case problem = read(wave_case("{ height = 8.0, period = 12.0, course = \"church_roof\" }"));
  const WaveLoadSummary s = wave_summaries(problem).front();
  const double rise = 0.769 * std::sqrt(7.5 / 9.81) * 1030. * 9.81 * 64. / s.pressure.force;
  EXPECT_NEAR(s.rise, rise, 1e-12 * rise);
  EXPECT_NEAR(s.duration, rise * (2. + 8. * std::exp(-18. * rise / 12.)), 1e-12 * s.duration);
}

/// Over the whole range that the schema allows, far beyond that of real breakwaters.
TEST_F(WaveLoadTest, IsFiniteAndPeaksAtPOfAnyWave) {
  std::mt19937 draw(22);
  const auto between = [&draw](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0., 1.)(draw));
  };
  for (int i = 0; i < 2000; ++i) {
    Section section = section_of_test;
    for (double* length : {&section.water_depth, &section.foundation_depth, &section.berm_depth, &section.crest,
                           &section.width, &section.berm_width})
      *length = i % 2 == 0 ? between(0.1, 100.) : between(1e-3, 1e4);
    section.bed_slope = between(1e-4, 1.);
    WaveLoadTable table;
    table.height = i % 2 == 0 ? between(0.1, 20.) : between(1e-3, 1e4);
    table.period = i % 2 == 0 ? between(1., 30.) : between(0.01, 1e4);
    table.angle = between(1e-3, 89.9);
    for (const WaveCourse course :
         {WaveCourse::church_roof, WaveCourse::triangle, WaveCourse::sine, WaveCourse::combined}) {
      table.course = course;
      const auto wave = wave_load(table, section, water_of_test);
      const double P = wave->pressure.force, largest = extremum(wave->history, 0., wave->end, 1).value;
      ASSERT_TRUE(std::isfinite(P) && P > 0.) << i;
      EXPECT_NEAR(wave->peak(), P, 1e-12 * P) << i;
      EXPECT_NEAR(largest, P, 1e-9 * P) << i << " of course " << static_cast<int>(course);
      const double impulse = integral(wave->history, 0., wave->end);
      ASSERT_TRUE(std::isfinite(impulse) && impulse > 0.) << i;
      for (const Pair& point : pressure_profile(*wave, 3.)) ASSERT_TRUE(std::isfinite(point[0] + point[1])) << i;
    }
  }
}

TEST_F(WaveLoadTest, TakesItsPeakFromProverbsWhereItBreaks) {
  const auto summary = [](const std::string& keys) {
    return wave_summaries(read(wave_case("{ height = 11.0, period = 12.0, course = \"church_roof\"" + keys + " }")))
        .front();
  };
  const WaveLoadSummary s =
      summary(", force = \"proverbs\", impact = { proverbs = { breaker = 8.0, quantile = 0.5 } }");
  EXPECT_NEAR(s.peak, relative_impact({}, 0.5) * 1030. * 9.81 * 64., 1e-9 * s.peak);
  EXPECT_TRUE(s.impact->breaks);
  EXPECT_NE(s.assumptions.front().find("PROVERBS (Oumeraci et al. 2001), its numbers assumed"), std::string::npos);
  EXPECT_NE(s.assumptions.front().find("as peak_gain = "), std::string::npos);
  // the same peak by the peak_gain that it names
  const std::string text = s.assumptions.front();
  const std::string gain = text.substr(text.find("as peak_gain = ") + 15);
  EXPECT_NEAR(summary(", force = \"impulse\", impact = { peak_gain = " + gain + " }").peak, s.peak, 0.01 * s.peak);
  const WaveLoadSummary unbroken = summary(", force = \"proverbs\", impact = { proverbs = { breaker = 12.0 } }");
  EXPECT_FALSE(unbroken.impact->breaks);
  EXPECT_NEAR(unbroken.peak, unbroken.pressure.force, 1e-12 * unbroken.pressure.force);
  EXPECT_FALSE(summary("").impact);
}

TEST_F(WaveLoadTest, ComesSeveralTimesInARow) {
  const Case one = read(wave_case("{ height = 8.0, period = 12.0, course = \"triangle\" }"));
  const Case row = read(wave_case("{ height = 8.0, period = 12.0, course = \"triangle\", number = 3 }"));
  const TimeFunction &P = wave_of(one).history, &three = wave_of(row).history;
  for (int k = 0; k < 3; ++k)
    for (const double t : {0.1, 0.4, 1., 2., 8.}) EXPECT_NEAR(three(t + 12. * k), P(t), 1e-9 * wave_of(one).peak());
  EXPECT_EQ(three(36.5), 0.);
  EXPECT_NEAR(wave_of(row).end, wave_of(one).end + 24., 1e-12);
  EXPECT_NEAR(wave_summaries(row).front().impulse, 3. * wave_summaries(one).front().impulse, 1e-6);
}

TEST_F(WaveLoadTest, TurnsTheDirectionOfTheChartTowardsTheNormal) {
  const std::string waves = "{ height = 8.0, period = 12.0, course = \"sine\", ";
  const Case chart = read(wave_case(waves + "direction = 250 }") + "facing = 230\n");
  const Case turned = read(wave_case(waves + "angle = 5.0 }"));
  EXPECT_DOUBLE_EQ(wave_of(chart).pressure.force, wave_of(turned).pressure.force);
  const WaveLoadSummary s = wave_summaries(chart).front();
  EXPECT_DOUBLE_EQ(s.angle, 5.);
  EXPECT_EQ(*s.direction, 250.);
  EXPECT_EQ(
      s.assumptions.back(),
      "direction: it comes from 250 degrees, the wall looks at 230: 20 degrees to the normal, turned by 15 towards "
      "it (Goda 2000): beta = 5 degrees");
}

TEST_F(WaveLoadTest, HasATroughInEveryCase) {
  const Case oblique = read(wave_case("{ height = 8.0, period = 12.0, course = \"sine\", angle = 20.0 }"));
  const Checks checks = formula_checks(wave_summaries(oblique), {});
  const auto seaward = std::find_if(checks.begin(), checks.end(),
                                    [](const Check& c) { return c.name == "sliding seaward by formulas"; });
  ASSERT_NE(seaward, checks.end());
  EXPECT_TRUE(seaward->holds.has_value()) << "it is judged";
  EXPECT_EQ(seaward->measure, "wave_loads.storm.trough_bound.safety_sliding");
}

TEST_F(WaveLoadTest, FactorScalesPAndU) {
  const std::string text = wave_case("{ height = 8.0, period = 12.0, course = \"sine\" }");
  const Case once = read(text), twice = read(text, {"loads.storm.factor=2"});
  EXPECT_EQ(extremum(twice.scene.loads.at("storm").history, 0., 6., 1).value,
            2. * extremum(once.scene.loads.at("storm").history, 0., 6., 1).value);
  EXPECT_EQ(*twice.scene.sliding->uplift->peak, 2. * *once.scene.sliding->uplift->peak);
  EXPECT_EQ(wave_summaries(twice).front().peak, 2. * wave_summaries(once).front().peak);
}

TEST_F(WaveLoadTest, DeepWaterHeightBreaksAsInWaves) {
  const Case problem = read(wave_case("{ deep_water_height = 6.3, period = 11.4, course = \"sine\" }"));
  const DesignHeights heights = design_heights({6.3, 11.4, 15., 0.01}, 9.81);
  EXPECT_EQ(wave_of(problem).wave.height, heights.highest);
  EXPECT_EQ(wave_of(problem).wave.significant_height, heights.significant);
}

TEST_F(WaveLoadTest, EchoRunsAsItIs) {
  const Case problem = read(wave_case("{ height = 8.0, period = 12.0, course = \"church_roof\" }"));
  std::filesystem::create_directories("out");
  const std::string echo = effective_case(problem, "out");
  write("out/case.toml", echo);
  const Case again = read_case("out/case.toml");
  EXPECT_EQ(effective_case(again, "out"), echo);
  EXPECT_EQ(wave_of(again).pressure.force, wave_of(problem).pressure.force);
  EXPECT_EQ(*again.scene.sliding->uplift->peak, *problem.scene.sliding->uplift->peak);
  for (const char* part :
       {"kind = \"wave\"\n", "[loads.storm.wave]\nheight = 8.0  # m\n", "[loads.storm.wave.impact]\n", "[section]\n"})
    EXPECT_NE(echo.find(part), std::string::npos) << part << " is missing in\n" << echo;
  for (const char* part : {"[sliding.wave]", "[loads.storm.pulse]"})
    EXPECT_EQ(echo.find(part), std::string::npos) << part << " stands in\n" << echo;
}

TEST_F(WaveLoadTest, ScalesByFroude) {
  write("case.toml", wave_case("{ height = 8.0, period = 12.0, course = \"church_roof\" }"));
  const Case problem = read_case("case.toml");
  std::filesystem::create_directories("out");
  write("out/case.toml", scale_case(problem, {0.05, SoilScaling::froude, {}}, "out").text);
  const Case model = read_case("out/case.toml");
  const WaveLoadSummary large = wave_summaries(problem).front(), small = wave_summaries(model).front();
  EXPECT_NEAR(small.pressure.force * 400., large.pressure.force, 1e-9 * large.pressure.force);
  EXPECT_NEAR(small.rise * std::sqrt(20.), large.rise, 1e-9);
  EXPECT_NEAR(small.impulse * 400. * std::sqrt(20.), large.impulse, 1e-8 * large.impulse);
}

TEST_F(WaveLoadTest, MeshThatIsNotTheSectionsIsRefused) {
  const std::string text = wave_case("{ height = 8.0, period = 12.0, course = \"sine\" }");
  EXPECT_EQ(objections(text), "");
  EXPECT_EQ(
      objections(text, {"section.crest=6.5"}),
      "--set section.crest=6.5: foundation_depth + crest = 15.5 m, but the wall 'front' is 16 m high, from y = 6 to "
      "22 m; give the section that is meshed, or the mesh of the section");
  EXPECT_EQ(objections(text, {"section.width=17"}),
            "--set section.width=17: width = 17 m, but the caisson is 18 m wide at its bottom; give one width in both");
  EXPECT_EQ(objections(text, {"initial.water_level=14.5"}),
            "case.toml:46:1: still water stands at y = 15 m, foundation_depth = 9 m above the foot of 'front', but "
            "initial.water_level at y = 14.5 m; give one water level in both");
  EXPECT_EQ(objections(text, {"section.weight=5.8e6"}),
            "--set section.weight=5.8e6: weight = 5.8e+06 N/m is not mass x g of the caisson, 5.9331e+06 N/m; give one "
            "caisson in both, within 1 %");
  EXPECT_NE(objections(text, {"loads.storm.boundary=back"}).find("'back' is the landward wall of the caisson"),
            std::string::npos);
  EXPECT_NE(objections(text, {"loads.storm.boundary=top"}).find("'top' is not upright"), std::string::npos);
  EXPECT_NE(objections(text, {"loads.storm.boundary=left", "mesh.parameters.seabed_depth=16"}).find("acts 0 of P"),
            std::string::npos);
}

TEST_F(WaveLoadTest, FrictionAndWeightAreTheSections) {
  const std::string text = wave_case("{ height = 8.0, period = 12.0, course = \"sine\" }");
  const Case problem = read(text, {"section.friction=0.5", "section.submerged_weight=4.2e6"});
  EXPECT_EQ(problem.scene.sliding->friction, 0.5);
  EXPECT_EQ(problem.scene.sliding->submerged_weight, 4.2e6);
  const std::vector<std::string> contact{"section.friction=0.5", "regions.caisson.interface={kind=\"friction\"}",
                                         "sliding.uplift={kind=\"computed\"}"};
  EXPECT_EQ(contact_friction(read(text, contact).scene), 0.5);
  std::string without = text;
  without.replace(without.find(sliding_table), sliding_table.size(), "");
  EXPECT_EQ(contact_friction(read(without, {contact[0], contact[1]}).scene), 0.5);
  EXPECT_NE(objections(text, {"section.friction=0.5", contact[2],
                              "regions.caisson.interface={kind=\"friction\", coefficient=0.7}"})
                .find("friction = 0.5 is not the coefficient = 0.7 of [regions.caisson] interface"),
            std::string::npos);
}

TEST_F(WaveLoadTest, UpliftOfTwoWavesIsRefused) {
  const std::string text = wave_case("{ height = 8.0, period = 12.0, course = \"sine\" }");
  const std::string other = "boundary=\"front\", kind=\"wave\", wave={height=6.0, period=9.0, course=\"sine\"}";
  EXPECT_NE(
      objections(text, {"loads.other={" + other + "}"}).find("which of the loads by waves is meant: other, storm"),
      std::string::npos);
  EXPECT_EQ(objections(text, {"loads.other={" + other + ", factor=0.0}"}), "");
}

TEST_F(WaveLoadTest, WarnsWhereFormulasDoNotHold) {
  const auto names = [](const Case& problem) {
    std::string text;
    for (const NumberedWarning& warning : wave_of(problem).warnings) text += warning.name + " ";
    for (const NumberedWarning& warning : end_warnings(actions_of(problem), problem.scene.time.end))
      text += warning.name + " ";
    return text;
  };
  const std::string text = wave_case("{ height = 8.0, period = 12.0, course = \"church_roof\" }");
  EXPECT_EQ(names(read(text)), "effective_force wave_outside_formulas wave_cut ");
  EXPECT_EQ(names(read(text, {"time.end=6"})), "effective_force wave_outside_formulas ");
  EXPECT_EQ(names(read(text, {"loads.storm.wave.force=impulse"})), "wave_outside_formulas wave_cut ");
  EXPECT_EQ(names(read(text, {"loads.storm.factor=0", "sliding.uplift={kind=\"computed\"}"})), "");
  const std::string low = wave_case("{ height = 4.0, period = 12.0, angle = 25.0, course = \"sine\" }");
  EXPECT_EQ(names(read(low, {"time.end=6", "section.berm_depth=14"})), "wave_outside_formulas ");
}

namespace {

const std::string standing_wave = "{ height = 5.0, period = 9.0, course = \"standing\" }";

}  // namespace

TEST_F(WaveLoadTest, StandingWavePushesAndPullsAsOnItsWall) {
  const Case problem = read(wave_case(standing_wave), {"time.end=18", "time.step=0.02"});
  const Simulation simulation = simulation_of(problem);
  const upbead::Run run = solve(problem, simulation);
  const StandingExtremes worst = standing_extremes(StandingWave({15., 5., 9.}, water_of_test), section_of_test);
  const ShearResponse& response = *run.summary.response;
  EXPECT_NEAR(response.peak_force / worst.landward.force, 1., 1e-8);
  EXPECT_NEAR(response.peak_force_seaward / worst.seaward.force, 1., 1e-8);
  EXPECT_LT(response.peak_force_seaward, -0.3 * response.peak_force);
  // the wave is so slow that the response is nearly static
  EXPECT_NEAR(*response.shear_to_force_ratio, 1., 0.1);
  EXPECT_NEAR(response.peak_shear_seaward / worst.seaward.force, 1., 0.1);
  const WaveLoadSummary& told = run.summary.waves.front();
  EXPECT_NEAR(told.peak, response.peak_force, 1e-8 * told.peak);
  EXPECT_NEAR(*told.trough_force / response.peak_force_seaward, 1., 1e-8);
  EXPECT_NEAR(run.summary.sliding->history.peak_seaward, -response.peak_shear_seaward,
              0.02 * run.summary.sliding->history.resistance);
}

TEST_F(WaveLoadTest, StandingWaveHasItsMomentBeforeASea) {
  std::string text = wave_case(standing_wave, "cells = 0.3, grading = 4, sea_front = 3, water_depth = 15");
  text += "[regions.sea_front]\nkind = \"water\"\n";
  const std::string front = "front = {}";
  text.replace(text.find(front), front.size(),
               "front = {}\nsea_surface = { pressure = \"open\" }\nsea_left = { pressure = \"sealed\" }");
  const Case problem = read(text, {"time.end=18"});
  const StandingLoad& standing = *wave_of(problem).standing;
  const Simulation simulation = simulation_of(problem);
  for (const WallPressure* worst : {&standing.extremes.landward, &standing.extremes.seaward}) {
    // in the run the crest stands at the wall a whole wave before its own end
    double force = 0., moment = 0., nearest = infinity;
    for (const double t : standing.gauges.time) {
      double P = 0., M = 0.;
      for (const LoadOnCaisson& load : simulation.compiled()->loads_on_caisson) {
        const double p = simulation.scene().loads.at(load.name).history(t);
        P += load.force_x * p;
        M += load.moment * p;
      }
      if (std::abs(P - worst->force) > nearest) continue;
      nearest = std::abs(P - worst->force);
      force = P;
      moment = M;
    }
    EXPECT_NEAR(force / worst->force, 1., 1e-8);
    EXPECT_NEAR(moment / worst->force_moment, 1., 1e-8);
  }
}

TEST_F(WaveLoadTest, StandingWaveGrowsAndDiesWithoutAJump) {
  const Case problem = read(wave_case(standing_wave));
  const StandingLoad& standing = *wave_of(problem).standing;
  const double T = 9., largest = standing.extremes.landward.force;
  EXPECT_EQ(standing.end, 2. * T);
  for (const double t : {0., 2. * T, 2. * T + 1.}) EXPECT_NEAR(standing.force(t), 0., 1e-12 * largest) << t;
  EXPECT_NEAR(standing.force(0.5 * T), 0., 1e-9 * largest);
  EXPECT_NEAR(standing.force(1.5 * T), 0., 1e-9 * largest);
  for (std::size_t i = 1; i < standing.gauges.time.size(); ++i) {
    const double before = standing.gauges.time[i - 1], t = standing.gauges.time[i];
    EXPECT_LT(std::abs(standing.force(t) - standing.force(before)), 0.05 * largest) << t;
    EXPECT_GE(standing.uplift(t), 0.);
  }
  EXPECT_NEAR(standing.peak_uplift, extremum(standing.uplift, 0., standing.end, 1).value, 1e-12 * largest);
}

TEST_F(WaveLoadTest, StandingWaveHasItsOwnUplift) {
  const std::string text = wave_case(standing_wave);
  const Case once = read(text), twice = read(text, {"loads.storm.factor=2"});
  const StandingLoad& standing = *wave_of(once).standing;
  const UpliftChoice& uplift = *once.scene.sliding->uplift;
  EXPECT_EQ(uplift.kind, UpliftKind::prescribed);
  EXPECT_FALSE(uplift.peak);
  for (const double t : {3., 5., 6.5, 11.}) {
    EXPECT_EQ(uplift.history(t), standing.uplift(t));
    EXPECT_EQ(twice.scene.sliding->uplift->history(t), 2. * standing.uplift(t));
    EXPECT_EQ(twice.scene.loads.at("storm.05").history(t), 2. * once.scene.loads.at("storm.05").history(t));
  }
  std::filesystem::create_directories("out");
  const std::string echo = effective_case(twice, "out");
  write("out/case.toml", echo);
  EXPECT_EQ(effective_case(read_case("out/case.toml"), "out"), echo);
}

TEST_F(WaveLoadTest, StandingWaveThatThereIsNotIsRefused) {
  const auto with = [](const std::string& keys) { return wave_case("{ " + keys + ", course = \"standing\" }"); };
  EXPECT_NE(objections(with("height = 11.0, period = 12.0"))
                .find("no standing wave of H = 11 m and T = 12 s is found in 15 m of water: it breaks, or the water is "
                      "too shallow for its series; give a lower wave, or course = \"church_roof\""),
            std::string::npos);
  EXPECT_NE(objections(with("height = 5.0, period = 9.0, angle = 15.0")).find("comes straight at the wall"),
            std::string::npos);
  EXPECT_NE(objections(wave_case(standing_wave), {"section.blocks=true"}).find("leave no standing wave"),
            std::string::npos);
}

}  // namespace upbead::test
