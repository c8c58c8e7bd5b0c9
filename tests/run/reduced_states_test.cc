// Claims: the states of a reduced model, and the mobilised strengths, are those of a march within the error that the
// run states; a model that is not accurate enough is refused; states that no observer wants are not computed.
// Reference: marches in steps of a 64th of the load, whose own error is below a tenth of the tolerance.

#include <algorithm>
#include <cmath>

#include "good_case.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace reduced_states_test {

constexpr double every = 0.05;
const std::string fields = "output.fields={ every = 0.05 }";
const std::vector<std::string> strengths{"regions.mound.strength.friction_angle=40",
                                         "regions.seabed.strength.friction_angle=35"};

/// Keeps the states that a writer of fields would write.
class States : public MarchObserver {
 public:
  void see(const State& state, int, int) override {
    if (wants(state.time)) states.push_back(state);
    ++seen;
  }
  bool wants(double time) const override { return std::abs(time / every - std::round(time / every)) < 1e-6; }

  std::vector<State> states;
  int seen = 0;
};

/// With the rows of phi multiplied by -1, the matrices are those of the energy.
double energy(const System& system, const Vector& x, const Vector& v) {
  Vector sign(system.size());
  for (int i = 0; i < system.size(); ++i)
    sign[i] = system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse ? -1. : 1.;
  return 0.5 * (sign.cwiseProduct(v).dot(system.M * v) + sign.cwiseProduct(x).dot(system.K * x));
}

struct Solved {
  upbead::Run run;
  States seen;
};

Solved solve_with(std::vector<std::string> overrides) {
  static const PetscSession petsc;
  overrides.insert(overrides.end(), strengths.begin(), strengths.end());
  overrides.push_back(fields);
  const Case problem = read_case("case.toml", overrides);
  Solved solved;
  RunOptions options;
  options.observer = [&solved](const Simulation&) { return &solved.seen; };
  solved.run = simulation_of(problem).run(options);
  return solved;
}

struct OtherScene {
  std::string name;
  std::vector<std::string> overrides;
};

class ReducedStates : public InFolder, public testing::WithParamInterface<OtherScene> {
 protected:
  ReducedStates() {
    unsetenv("UPBEAD_MESHES");
    write("case.toml", section_case({{"cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.5"}}) +
                           "[initial]\nwater_level = 15.0\n");
  }
  std::vector<std::string> with(const std::string& more) const {
    std::vector<std::string> overrides = GetParam().overrides;
    overrides.push_back(more);
    return overrides;
  }
};

void expect_same_strengths(const std::vector<MobilisedStrength>& a, const std::vector<MobilisedStrength>& b) {
  ASSERT_EQ(a.size(), 2u);
  ASSERT_EQ(b.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(a[i].region, b[i].region);
    EXPECT_NEAR(a[i].share, b[i].share, 0.02);
    EXPECT_NEAR(b[i].largest / a[i].largest, 1., 0.03);
    EXPECT_EQ(a[i].left_out, b[i].left_out);
  }
}

TEST_P(ReducedStates, AndStrengthsAreThoseOfAMarch) {
  const Solved reduced = solve_with(with("time={ end = 1.2, scheme = \"reduced\" }")),
               marched = solve_with(with("time={ end = 1.2, scheme = \"sdirk4\", step = 0.0025 }"));
  ASSERT_EQ(reduced.run.summary.discretisation.scheme, "reduced");
  ASSERT_EQ(marched.run.summary.discretisation.scheme, "sdirk4");
  ASSERT_EQ(reduced.seen.states.size(), 25u);
  ASSERT_EQ(marched.seen.states.size(), 25u);
  EXPECT_EQ(reduced.seen.seen, 25) << "states between fields are not made";

  const System& system = marched.run.simulation->system();
  double largest = 0., apart = 0., pressure = 0., of_pressure = 0.;
  for (std::size_t i = 0; i < 25; ++i) {
    const State &a = marched.seen.states[i], &b = reduced.seen.states[i];
    EXPECT_NEAR(a.time, b.time, 1e-9);
    largest = std::max(largest, energy(system, a.x, a.v));
    apart = std::max(apart, energy(system, b.x - a.x, b.v - a.v));
    pressure = std::max(pressure, a.v.cwiseAbs().maxCoeff());
    of_pressure = std::max(of_pressure, (b.v - a.v).cwiseAbs().maxCoeff());
  }
  ASSERT_TRUE(reduced.run.summary.reduction->error_of_states);
  const double told = *reduced.run.summary.reduction->error_of_states;
  EXPECT_LT(std::sqrt(apart / largest), std::max(told, 2e-3));
  EXPECT_LT(told, 0.1);
  EXPECT_LT(of_pressure, 0.05 * pressure);
  expect_same_strengths(marched.run.summary.strength, reduced.run.summary.strength);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, ReducedStates,
    testing::Values(OtherScene{"Damped", {}},
                    OtherScene{"Undamped", {"regions.mound.damping.ratio=1e-9", "regions.seabed.damping.ratio=1e-9"}},
                    OtherScene{"ElasticCaisson",
                               {"regions.caisson={ kind = \"solid\", density = 2100, youngs_modulus = 30e9, "
                                "poissons_ratio = 0.2 }"}},
                    OtherScene{"SlowAndSeaward", {"loads.impulse.factor=-0.5", "loads.impulse.pulse.duration=0.4"}}),
    [](const auto& scene) { return scene.param.name; });

}  // namespace reduced_states_test
}  // namespace upbead::test
