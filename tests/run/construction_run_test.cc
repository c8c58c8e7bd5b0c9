// Claims: a run begins from the stresses after the last stage of construction: one stage with everything gives the
// numbers of a run without stages, several stages others, in the state at rest of Mohr-Coulomb soil, in the strength
// that elastic soil mobilises and in the forces of contact. Settlement by construction is told for each stage and is in
// no number of the wave. A stage that does not stand is named, and slow drainage is warned of.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "good_case.h"
#include "section_case.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/case/case_run.h"

namespace upbead::test {
namespace construction_run_test {

const char* const once = "[construction.all]\norder = 1\nregions = [\"seabed\", \"mound\", \"caisson\"]\n";
const char* const stages = R"([construction.ground]
order = 1
regions = ["seabed"]
[construction.mound]
order = 2
regions = ["mound"]
[construction.caisson]
order = 3
regions = ["caisson"]
caisson_share = 0.4
[construction.fill]
order = 4
caisson_share = 1.0
)";

std::string with_strength(const std::string& law, const std::string& mound_angle, const std::string& more) {
  const std::string sand = "law = \"" + law + "\"\nstrength = { friction_angle = 35, cohesion = 1e3 }\n";
  const std::string rubble = "law = \"" + law + "\"\nstrength = { friction_angle = " + mound_angle + " }\n";
  return section_case({{"cells = 0.5", "cells = 0.3"},
                       {"shear_modulus = 30e6", sand + "shear_modulus = 30e6"},
                       {"shear_modulus = 50e6", rubble + "shear_modulus = 50e6"},
                       {"end = 0.6", "end = 0.3"}}) +
         "[initial]\nwater_level = 15\nbounds = false\n" + more;
}

class ConstructionRun : public InFolder {
 protected:
  Summary run(const std::string& text) {
    static const PetscSession petsc;  // MPI starts once in a process
    unsetenv("UPBEAD_MESHES");
    write("case.toml", text);
    const Case input = read_case("case.toml");
    return solve(input, simulation_of(input)).summary;
  }
};

int count(const Summary& s, const std::string& name) {
  return static_cast<int>(
      std::count_if(s.warnings.begin(), s.warnings.end(), [&](const auto& w) { return w.name == name; }));
}

TEST_F(ConstructionRun, SoilThatYieldsBeginsFromTheLastStage) {
  const Summary plain = run(with_strength("mohr_coulomb", "40", ""));
  const Summary one = run(with_strength("mohr_coulomb", "40", once));
  const Summary built = run(with_strength("mohr_coulomb", "40", stages));
  EXPECT_FALSE(plain.construction);
  ASSERT_TRUE(one.construction && built.construction && plain.residual && one.residual && built.residual);
  EXPECT_NEAR(one.response->peak_shear, plain.response->peak_shear, 1e-10 * plain.response->peak_shear);
  EXPECT_NEAR(one.residual->displacement_y, plain.residual->displacement_y, 1e-9 * 1e-3);
  EXPECT_FALSE(one.construction->caisson || one.construction->stages[0].caisson) << "the ground as it is found";
  EXPECT_NE(built.nonlinear->rest->share_at_strength, plain.nonlinear->rest->share_at_strength);
  EXPECT_GT(std::abs(built.residual->displacement_y - plain.residual->displacement_y),
            3e-4 * std::abs(plain.residual->displacement_y));
  ASSERT_EQ(built.construction->stages.size(), 4u);
  const StageSummary& fill = built.construction->stages[3];
  EXPECT_EQ(fill.name, "fill");
  EXPECT_EQ(fill.share_at_strength, built.nonlinear->rest->share_at_strength);
  EXPECT_LE(*fill.mobilised, 1. + 1e-6);
  EXPECT_GT(fill.caisson->settlement, 1e-3);
  EXPECT_NEAR(built.construction->caisson->settlement,
              fill.caisson->settlement + built.construction->stages[2].caisson->settlement, 1e-15);
  EXPECT_GT(built.construction->caisson->settlement, 2. * std::abs(built.residual->displacement_y))
      << "the wave's settlement has none of it";
}

TEST_F(ConstructionRun, ElasticGroundTellsStagesAndMobilisesByThem) {
  const Summary plain = run(with_strength("elastic", "40", ""));
  const Summary one = run(with_strength("elastic", "40", once));
  const Summary built = run(with_strength("elastic", "40", stages));
  ASSERT_EQ(plain.strength.size(), 2u);
  bool differs = false;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(one.strength[i].initial, plain.strength[i].initial, 1e-9);
    EXPECT_NEAR(one.strength[i].share, plain.strength[i].share, 1e-9);
    differs = differs || std::abs(built.strength[i].initial_share - plain.strength[i].initial_share) > 1e-3;
  }
  EXPECT_TRUE(differs);
  EXPECT_EQ(built.response->peak_shear, plain.response->peak_shear) << "linear soil answers the wave alike";
  const auto& s = built.construction->stages;
  ASSERT_EQ(s.size(), 4u);
  EXPECT_EQ(s[0].regions, "seabed");
  EXPECT_FALSE(s[0].settlement || s[0].caisson || s[0].heel_pressure);
  EXPECT_TRUE(s[1].settlement && s[1].mobilised && !s[1].share_at_strength);
  const double lift = 1030. * 9.81 * 18. * 9., caisson = 2100. * 9.81 * 18. * 16.;
  EXPECT_NEAR(*s[2].heel_pressure, (0.4 * caisson - lift) / 18., 1e-6 * caisson);
  EXPECT_NEAR(*s[3].heel_pressure, (caisson - lift) / 18., 1e-6 * caisson);
  EXPECT_NEAR(*s[3].toe_pressure, *s[3].heel_pressure, 1e-6 * caisson);
  EXPECT_NEAR(s[3].caisson->settlement / s[2].caisson->settlement, 0.6 * caisson / (0.4 * caisson - lift), 1e-6);
  EXPECT_NEAR(s[3].caisson->rotation, 0., 1e-6) << "the section is symmetrical but for its cells";
}

TEST_F(ConstructionRun, ContactBeginsFromTheStages) {
  const auto text = [](const std::string& more) {
    return section_case({{"cells = 0.5", "cells = 0.3"},
                         {"density = 2100.0", "density = 2100.0\ninterface = { kind = \"friction\" }"},
                         {"peak = 1e6", "peak = 6e6"},
                         {"end = 0.6", "end = 0.2"}}) +
           "[initial]\nwater_level = 15\n" + more;
  };
  const Summary built = run(text(stages)), plain = run(text(""));
  ASSERT_TRUE(built.contact && built.construction);
  EXPECT_NEAR(built.contact->weight, plain.contact->weight, 1e-6 * plain.contact->weight);
  EXPECT_GT(std::abs(built.contact->demand.least_normal - plain.contact->demand.least_normal), 1e-3)
      << "the least N_i over that at rest";
}

TEST_F(ConstructionRun, AStageThatDoesNotStandIsNamedAndVoidsTheRest) {
  const Summary weak = run(with_strength("mohr_coulomb", "18", stages));
  ASSERT_TRUE(weak.construction && weak.nonlinear);
  EXPECT_EQ(weak.construction->falls_in, "mound");
  EXPECT_EQ(weak.construction->stages.size(), 1u);
  EXPECT_FALSE(weak.construction->caisson);
  EXPECT_EQ(weak.nonlinear->why_no_rest.rfind("in the stage 'mound' of construction no stress", 0), 0u)
      << weak.nonlinear->why_no_rest;
  EXPECT_NE(weak.why_void, "");
  EXPECT_EQ(count(weak, "no_rest"), 1);
}

TEST_F(ConstructionRun, SlowDrainageIsWarnedOf) {
  const auto text = [](const std::string& k, const std::string& more) {
    return section_case({{"cells = 0.5", "cells = 0.3"},
                         {"hydraulic_conductivity = 1e-4", "hydraulic_conductivity = " + k},
                         {"end = 0.6", "end = 0.1"}}) +
           "[initial]\nwater_level = 15\n" + more;
  };
  EXPECT_EQ(count(run(text("1e-4", stages)), "drained_stages"), 0);
  EXPECT_EQ(count(run(text("1e-10", once)), "drained_stages"), 0) << "nothing is placed on it";
  const Summary slow = run(text("1e-10", stages));
  ASSERT_EQ(count(slow, "drained_stages"), 1);
  const auto& warning = *std::find_if(slow.warnings.begin(), slow.warnings.end(),
                                      [](const auto& w) { return w.name == "drained_stages"; });
  // t_90 = 0.848 H^2 rho g/(k M), H = 15 m, M = 2 G (1 - nu)/(1 - 2 nu) = 118.2 MPa
  EXPECT_NEAR(warning.value, 0.848 * 225. * 1030. * 9.81 / (1e-10 * 30e6 * 2. * 0.67 / 0.34), 1e-6 * warning.value);
  EXPECT_NE(warning.what.find("'seabed'"), std::string::npos) << warning.what;
}

}  // namespace construction_run_test
}  // namespace upbead::test
