// Claim: a load by regular waves is a cos(k x -/+ omega t) at every place and time after its growth, with a and k of
// linear waves where they are not given; a standing wave does not travel; the case is echoed as it was; mistakes are
// reported.
#include "case/wave_train.h"

#include <cmath>
#include <random>

#include "bad_case.h"
#include "base/numbers.h"
#include "good_case.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"
#include "upbead/waves/wave_heights.h"

namespace upbead::test {
namespace wave_train_test {

double pressure(const Scene& scene, double x, double t) {
  double p = 0.;
  for (const auto& [name, load] : scene.loads) p += intensity(load, x, 0.) * load.history(t);
  return p;
}

Scene loaded(const WaveTrain& train) {
  Load load;
  load.boundary = "bed";
  load.factor = 1.5;
  Scene scene;
  scene.loads = train_loads("sea", load, train, 1030., 9.81);
  return scene;
}

TEST(WaveTrain, RunsOrStandsOnceItHasGrown) {
  WaveTrain train;
  train.height = 4.;
  train.depth = 12.;
  train.period = 9.;
  train.crest = 3.;
  const double k = 2. * pi / wavelength(9., 12., 9.81), omega = 2. * pi / 9.;
  EXPECT_NEAR(omega * omega, 9.81 * k * std::tanh(12. * k), 1e-9);
  const double a = 1.5 * 1030. * 9.81 * 2. / std::cosh(12. * k);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-200., 200.), time(9., 100.);
  for (const TrainCourse course : {TrainCourse::landward, TrainCourse::seaward, TrainCourse::stands}) {
    train.course = course;
    const Scene scene = loaded(train);
    for (int i = 0; i < 100; ++i) {
      const double x = place(random), t = time(random), kx = k * (x - 3.);
      const double expected = course == TrainCourse::landward  ? std::cos(kx - omega * t)
                              : course == TrainCourse::seaward ? std::cos(kx + omega * t)
                                                               : std::cos(kx) * std::cos(omega * t);
      EXPECT_NEAR(pressure(scene, x, t), a * expected, 1e-9 * a);
    }
    EXPECT_EQ(pressure(scene, 3., 0.), 0.) << "it grows from rest";
    for (double t = 0.; t < 9.; t += 0.1) EXPECT_LE(std::abs(pressure(scene, 11., t)), a);
  }
}

TEST(WaveTrain, HasTheAmplitudeAndLengthThatAreGiven) {
  WaveTrain train;
  train.amplitude = 20e3;
  train.length = 77.;
  train.period = 8.;
  train.growth = 0.;
  const Scene scene = loaded(train);
  EXPECT_DOUBLE_EQ(pressure(scene, 0., 0.), 30e3);
  EXPECT_NEAR(pressure(scene, 77., 8.), 30e3, 1e-6);
  EXPECT_EQ(scene.loads.at("sea.cosine").duration, 4.);
}

class WaveTrainCase : public InFolder {
 protected:
  WaveTrainCase() {
    static const PetscSession petsc;  // MPI starts once in a process
    unsetenv("UPBEAD_MESHES");
  }
};

std::string train_case(const std::string& train) {
  return section_case({{"[loads.impulse]",
                        "[loads.sea]\nboundary = \"bed\"\nkind = \"train\"\ntrain = " + train + "\n[loads.impulse]"}});
}

TEST_F(WaveTrainCase, LoadsTheBedAndIsEchoedAsItWas) {
  write("case.toml", train_case("{ height = 4, depth = 8, period = 7, course = \"seaward\" }"));
  const Case problem = read_case("case.toml");
  const Simulation simulation = simulation_of(problem);
  EXPECT_EQ(simulation.scene().loads.count("sea.cosine") + simulation.scene().loads.count("sea.sine"), 2u);
  write("again.toml", effective_case(problem, "."));
  const Case again = read_case("again.toml");
  for (const char* name : {"sea.cosine", "sea.sine"}) {
    const Load &before = problem.scene.loads.at(name), &after = again.scene.loads.at(name);
    EXPECT_EQ(before.cosine->length, after.cosine->length);
    EXPECT_EQ(before.history(8.3), after.history(8.3));
  }
}

TEST_F(WaveTrainCase, MistakesAreTold) {
  const auto complaint = [](const std::string& train) -> std::string {
    write("case.toml", train_case(train));
    try {
      read_case("case.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(complaint("{ height = 4, period = 7 }").find("'depth' is missing, which 'height' needs"),
            std::string::npos);
  EXPECT_NE(complaint("{ height = 4, amplitude = 1e3, depth = 8, period = 7 }").find("keep one of them"),
            std::string::npos);
  EXPECT_NE(complaint("{ amplitude = 1e3, period = 7 }").find("add length (m) or depth (m)"), std::string::npos);
  EXPECT_NE(complaint("{ amplitude = 1e3, length = 50, period = 7 }\nshape = [[0, 1], [1, 1]]")
                .find("'shape' does not belong to a train of waves"),
            std::string::npos);
}

}  // namespace wave_train_test
}  // namespace upbead::test
