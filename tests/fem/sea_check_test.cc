// Claims: invalid keys of a sea, of open sides and of waves are reported at the key to change; for a sea that the
// mesh leaves out, its tables are left out as well.
#include <gtest/gtest.h>

#include <limits>

#include "scenes.h"

namespace upbead::test {
namespace sea_check_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

Scene sea_scene() {
  Scene scene = breakwater(triangle(1., 0.1));
  add_sea(scene);
  return scene;
}

struct Misfit {
  const char* name;
  void (*edit)(Scene&);
  const char* key;
  const char* what;
};

void PrintTo(const Misfit& misfit, std::ostream* out) {
  *out << misfit.name;
}

class SeaCheck : public ::testing::TestWithParam<Misfit> {};

TEST_P(SeaCheck, SaysWhatDoesNotFit) {
  Scene scene = sea_scene();
  GetParam().edit(scene);
  const auto mesh = breakwater_mesh(0.5, with_sea());
  const auto wrong = mistakes(scene, *mesh);
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_EQ(wrong[0].place.key, GetParam().key);
  EXPECT_NE(wrong[0].what.find(GetParam().what), std::string::npos) << wrong[0].what;
  EXPECT_FALSE(wrong[0].cure.empty());
}

void press_on(Scene& scene, const char* curve) {
  scene.loads["impulse"].boundary = curve;
  scene.loads["impulse"].kind = LoadKind::pressure;
}

const Misfit misfits[] = {
    {"PressureOnABedUnderWater", [](Scene& s) { press_on(s, "mound_surface"); }, "loads.impulse.kind",
     "would count it twice"},
    {"ForceOnWater", [](Scene& s) { s.loads["impulse"].boundary = "sea_surface"; }, "loads.impulse.boundary",
     "there is only water"},
    {"PressureOnAClosedEnd", [](Scene& s) { press_on(s, "sea_left"); }, "loads.impulse.boundary",
     "there is only water"},
    {"HeldWater", [](Scene& s) { s.boundaries["sea_left"].displacement = DisplacementCondition::roller; },
     "boundaries.sea_left.displacement", "nothing holds"},
    {"NoConditionOfWater", [](Scene& s) { s.boundaries["sea_surface"].pressure.reset(); }, "boundaries.sea_surface",
     "there is water"},
    {"SurfaceWavesOnSoil", [](Scene& s) { s.boundaries["left"].pressure = PressureCondition::surface_waves; },
     "boundaries.left.pressure", "level of free water"},
    {"CaissonOfWater",
     [](Scene& s) {
       s.regions["caisson"] = Region();
       s.regions["caisson"].kind = RegionKind::water;
       for (const char* side : {"front", "back", "top"}) s.boundaries[side].pressure = PressureCondition::open;
       s.loads["impulse"].kind = LoadKind::pressure;
     },
     "regions.caisson.kind", "cannot be water"},
    {"WavesThroughIncompressibleSoil",
     [](Scene& s) {
       s.fluid.bulk_modulus = infinity;
       s.boundaries["left"].displacement = DisplacementCondition::absorbing;
     },
     "boundaries.left.displacement", "no finite speed"},
    {"WavesThroughIncompressibleWater",
     [](Scene& s) {
       s.fluid.bulk_modulus = infinity;
       s.boundaries["sea_left"].pressure = PressureCondition::absorbing;
     },
     "boundaries.sea_left.pressure", "no pressure waves"},
    {"AbsorbingPoresOfAFreeSkeleton",
     [](Scene& s) {
       s.boundaries["left"] = {DisplacementCondition::free, PressureCondition::absorbing};
     },
     "boundaries.left.displacement", "held or absorbs"},
    {"AbsorbingRigidRegion", [](Scene& s) { s.boundaries["top"].displacement = DisplacementCondition::absorbing; },
     "boundaries.top.displacement", "rigid region ('caisson')"},
};

INSTANTIATE_TEST_SUITE_P(Misfits, SeaCheck, ::testing::ValuesIn(misfits),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SeaCheckOfAGoodScene, IsSilent) {
  const auto mesh = breakwater_mesh(0.5, with_sea());
  EXPECT_TRUE(mistakes(sea_scene(), *mesh).empty());
}

TEST(SeaCheckOfAGoodScene, IsSilentWhereTheMeshLeavesTheSeaOut) {
  const auto mesh = breakwater_mesh(0.5);
  const Scene scene = sea_scene();
  EXPECT_TRUE(mistakes(scene, *mesh).empty());
  const ResolvedScene resolved = resolve(scene, *mesh);
  EXPECT_EQ(resolved.scene.regions.count("sea_front"), 0u);
  EXPECT_EQ(resolved.decisions.front().left_out, "sea_back");
}

TEST(QuasiStatic, RefusesWaterAndWaves) {
  Scene scene = sea_scene();
  scene.time.inertia = false;
  scene.boundaries["left"].displacement = DisplacementCondition::absorbing;
  const auto wrong = mistakes(scene, *breakwater_mesh(0.5, with_sea()));
  ASSERT_EQ(wrong.size(), 3u);
  EXPECT_EQ(wrong[0].place.key, "regions.sea_back.kind");
  EXPECT_EQ(wrong[2].place.key, "boundaries.left.displacement");
}

TEST(ALoadOnAWetWall, ActsOnTheWholeWall) {
  const auto mesh = breakwater_mesh(0.5, with_sea());
  const Compiled compiled(sea_scene(), *mesh);
  const LoadOnCaisson& load = compiled.loads_on_caisson.front();
  EXPECT_NEAR(load.force_x, 1., 1e-12);
  EXPECT_NEAR(*load.arm(), 8., 1e-9);
}

TEST(AForceMeasuredOnTheWall, SwitchesOffTheSeaThereOnly) {
  const auto mesh = breakwater_mesh(0.5, with_sea());
  Scene scene = sea_scene();
  const auto row_of = [&](const char* name) {
    const Compiled compiled(scene, *mesh);
    return compiled.system.readings[compiled.system.reading(name)].velocity.size();
  };
  EXPECT_GT(row_of("water_force_front"), 0u);
  const auto both = row_of("water_force");
  scene.loads["impulse"].measured_on_wall = true;
  EXPECT_EQ(row_of("water_force_front"), 0u);
  EXPECT_EQ(row_of("water_force"), both / 2);
}

}  // namespace sea_check_test
}  // namespace upbead::test
