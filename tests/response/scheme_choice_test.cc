// Claim: a scene is reduced where that is less work than marching, and marched for each of the reasons that the
// function lists.
#include "response/time_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace upbead::test {
namespace scheme_choice_test {

/// Long enough for a reduced model to pay.
Scene long_run() {
  Scene scene = breakwater(triangle(1.6e6, 0.15));
  scene.time.end = 20.;
  return scene;
}

/// Of the compiled scene, the choice uses only the system and whether there is a caisson.
const Compiled& compiled() {
  static const auto mesh = breakwater_mesh(0.5);
  static const Compiled compiled(long_run(), *mesh);
  return compiled;
}

void expect_march(const Scene& scene, const CompiledScene& on, const std::string& reason) {
  const SchemeChoice choice = choose_scheme(scene, on);
  EXPECT_EQ(choice.scheme, TimeScheme::sdirk4);
  EXPECT_NE(choice.reason.find(reason), std::string::npos) << choice.reason;
  EXPECT_FALSE(choice.most_vectors);
}

TEST(SchemeChoice, ReducesALongRun) {
  const SchemeChoice choice = choose_scheme(long_run(), compiled().scene);
  EXPECT_EQ(choice.scheme, TimeScheme::reduced);
  EXPECT_NE(choice.reason.find("solves instead of"), std::string::npos) << choice.reason;
  ASSERT_TRUE(choice.most_vectors);
  EXPECT_GE(*choice.most_vectors, 46);
}

TEST(SchemeChoice, MayTryLongerWhereMarchingTakesLonger) {
  Scene longer = long_run();
  longer.time.end *= 4.;
  EXPECT_GT(*choose_scheme(longer, compiled().scene).most_vectors,
            *choose_scheme(long_run(), compiled().scene).most_vectors);
}

/// A march factorises once for each length of step.
TEST(SchemeChoice, MayTryLongerWhereKinksDivideNoStep) {
  CompiledScene uneven = compiled().scene;
  uneven.system.loads[0].history = piecewise_linear({0., 0.075, 0.15, 0.15 * std::sqrt(7.)}, {0., 1.6e6, 1e6, 0.});
  Scene scene = long_run();
  scene.time.end = 2.;
  EXPECT_GE(*choose_scheme(scene, uneven).most_vectors, *choose_scheme(scene, compiled().scene).most_vectors + 2);
}

TEST(SchemeChoice, KeepsWhatIsGiven) {
  for (const TimeScheme given : {TimeScheme::sdirk4, TimeScheme::generalised_alpha, TimeScheme::reduced}) {
    Scene scene = long_run();
    scene.time.scheme = given;
    const SchemeChoice choice = choose_scheme(scene, compiled().scene);
    EXPECT_EQ(choice.scheme, given);
    EXPECT_NE(choice.reason.find("given"), std::string::npos) << choice.reason;
    EXPECT_FALSE(choice.most_vectors) << "a model that is asked for may take what it needs";
  }
}

TEST(SchemeChoice, TellsTheSolvesOfAMarch) {
  Scene scene = long_run();
  scene.time.end = 1.;
  scene.time.step = 1e-4;
  for (const auto& [given, solves] :
       {std::pair{TimeScheme::sdirk4, "about 50020 solves"},
        std::pair{TimeScheme::generalised_alpha, "about 10000 solves"}, std::pair{TimeScheme::reduced, ""}}) {
    scene.time.scheme = given;
    EXPECT_EQ(choose_scheme(scene, compiled().scene).solves, solves);
  }
  scene.time.scheme = TimeScheme::sdirk4;
  scene.time.step.reset();
  EXPECT_NE(choose_scheme(scene, compiled().scene).solves.find("solves or more"), std::string::npos)
      << "the apparent period may ask for shorter steps";
}

TEST(SchemeChoice, MarchesConsolidation) {
  Scene scene = long_run();
  scene.time.inertia = false;
  expect_march(scene, compiled().scene, "consolidation");
}

TEST(SchemeChoice, MarchesWithoutACaisson) {
  Scene scene = column(sand(), triangle(1e4, 0.15));
  scene.time.end = 20.;
  const auto mesh = column_mesh(10., 4);
  const Compiled soil(scene, *mesh);
  expect_march(scene, soil.scene, "without a caisson");
}

TEST(SchemeChoice, MarchesWithoutALoad) {
  CompiledScene unloaded = compiled().scene;
  unloaded.system.loads.clear();
  expect_march(long_run(), unloaded, "no load");
}

TEST(SchemeChoice, FieldsAndStrengthsNeedNoMarch) {
  Scene scene = long_run();
  scene.fields_every = 0.1;
  scene.regions.at("mound").strength.emplace();
  EXPECT_EQ(choose_scheme(scene, compiled().scene).scheme, TimeScheme::reduced);
}

TEST(SchemeChoice, MarchesToStopEarly) {
  Scene scene = long_run();
  scene.time.stop_at_energy = 1e-3;
  expect_march(scene, compiled().scene, "stop early");
}

TEST(SchemeChoice, MarchesFewSteps) {
  Scene scene = long_run();
  scene.time.end = 0.3;
  expect_march(scene, compiled().scene, "solves or more; a reduced model would cost");
  scene = long_run();
  scene.time.step = 1.;
  expect_march(scene, compiled().scene, "solves; a reduced model would cost");
}

/// The period found under a jump is nearly that under a pulse as long as the period, however long the run is.
TEST(StepChoice, OfALoneJumpKnowsTheCaissonsPeriod) {
  const auto period = [](const TimeFunction& history, double end) {
    Scene scene = breakwater(history);
    scene.time.end = end;
    return choose_step(scene, compiled().scene, 4).apparent_period;
  };
  const TimeFunction jump({}, {[](double) { return 1e6; }});
  const double found = period(jump, 2.);
  ASSERT_GT(found, 0.);
  EXPECT_NEAR(period(jump, 20.), found, 0.06 * found);
  EXPECT_NEAR(period(triangle(1e6, found), 2.), found, 0.06 * found);
}

TEST(LoadStepOfLoads, GrowsInConsolidationOnceTheLoadsStay) {
  Scene scene = column(sand(), piecewise_linear({0., 0.1, 100.}, {0., 1e4, 1e4}));
  scene.time.end = 100.;
  EXPECT_FALSE(step_of_loads(scene, 4).growth) << "with inertia";
  scene.time.inertia = false;
  for (const double factor : {1.5, 2.}) {
    scene.time.growth = factor;
    const auto growth = step_of_loads(scene, 4).growth;
    ASSERT_TRUE(growth) << factor;
    EXPECT_EQ(growth->factor, factor);
    EXPECT_EQ(growth->after, 0.1);
    EXPECT_EQ(growth->largest, 2.);
  }
  scene.time.growth = 1.;
  EXPECT_FALSE(step_of_loads(scene, 4).growth);
  scene.time.growth = 2.;
  scene.loads.begin()->second.history = piecewise_linear({0., 0.1, 100.}, {0., 1e4, 2e4});
  EXPECT_FALSE(step_of_loads(scene, 4).growth) << "the load does not stay";
}

}  // namespace scheme_choice_test
}  // namespace upbead::test
