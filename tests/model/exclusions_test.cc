// Claims: a way that cannot solve a scene is reported at the key that asks for what the way lacks, and only then; the
// table names each exclusion once.
#include "model/exclusions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace upbead::test {
namespace exclusions_test {

constexpr Treatment ways[] = {Treatment::reduced_model,  Treatment::generalised_alpha, Treatment::adapted_mesh,
                              Treatment::reduce_command, Treatment::soil_model,        Treatment::several_processes,
                              Treatment::checkpoints,    Treatment::contact,           Treatment::consolidation};

TEST(Exclusions, OfAPlainSceneAreNone) {
  Scene scene;
  scene.regions["sand"].kind = RegionKind::porous;
  for (const Treatment way : ways) EXPECT_TRUE(excluded(scene, way).empty());
}

TEST(Exclusions, AreToldAtTheKeyThatAsks) {
  Scene scene;
  scene.fields_every = 0.1;
  scene.time.stop_at_energy = 1e-3;
  scene.regions["sand"].strain_law = StrainLaw();
  scene.regions["mound"].strain_law = StrainLaw();
  std::vector<std::string> keys;
  for (const Exclusion& reason : excluded(scene, Treatment::checkpoints)) keys.push_back(reason.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"regions.mound.strain", "regions.sand.strain"}));
  ASSERT_EQ(excluded(scene, Treatment::reduced_model).size(), 1U);  // a reduced model gives fields, too
  EXPECT_EQ(excluded(scene, Treatment::reduced_model).front().key, "time.stop_at_energy");
  EXPECT_TRUE(excluded(scene, Treatment::adapted_mesh).empty());
  scene.time.inertia = false;
  ASSERT_EQ(excluded(scene, Treatment::adapted_mesh).size(), 1U);
  EXPECT_EQ(excluded(scene, Treatment::adapted_mesh).front().key, "time.inertia");
}

TEST(Exclusions, StandInTheTable) {
  Scene scene;
  scene.fields_every = 0.1;
  scene.time = {1., {}, TimeScheme::reduced, false, 2., 1e-3};
  scene.regions["sand"].strain_law = StrainLaw();
  scene.regions["sand"].strength = Strength();
  scene.regions["mound"].law = SoilLaw::python;  // which yields, too
  scene.regions["mound"].densification = Densification();
  scene.regions["sand"].flow = Flow::inertial;
  scene.regions["sand"].air_by_depth = true;
  scene.regions["mound"].forchheimer = 1.;
  scene.regions["sea"].kind = RegionKind::water;
  scene.regions["caisson"].kind = RegionKind::solid;
  scene.initial = InitialState();
  scene.initial->harbour_level = 1.;
  scene.boundaries["left"] = {DisplacementCondition::absorbing, PressureCondition::absorbing};
  scene.regions["caisson"].springs = BaseSupport{1., 1., 1.};
  scene.regions["caisson"].interface = ContactLaw{ContactKind::friction, {}};
  scene.boundaries["base"].displacement = DisplacementCondition::fixed;
  scene.loads["quake"].kind = LoadKind::acceleration;
  scene.loads["quake"].boundary = "base";
  scene.loads["weight"].kind = LoadKind::gravity;
  scene.regions["mound"].stress_law = StressLaw();
  scene.cycles = Cycles();
  scene.limits.liquefaction = scene.limits.peak_safety = 1.;
  scene.accuracy.estimate = true;
  scene.mesh.refine.reset();
  ASSERT_TRUE(has_frictional_contact(scene));
  const std::string table = exclusion_table();
  std::size_t told = 0;
  for (const Treatment way : ways)
    for (const Exclusion& reason : excluded(scene, way)) {
      EXPECT_NE(table.find("| " + reason.why + " |"), std::string::npos) << reason.why;
      ++told;
    }
  scene = Scene();
  scene.time.scheme = TimeScheme::sdirk4;  // no scene asks for two schemes
  told += excluded(scene, Treatment::soil_model).size();
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')), told + 2);
}

}  // namespace exclusions_test
}  // namespace upbead::test
