// Claim: every way in which a scene and a mesh may not fit is reported with its key. Source: the checks' contract in
// scene_check.h.

#include <gtest/gtest.h>

#include <functional>

#include "scenes.h"

namespace upbead::test {
namespace scene_check_test {

struct Misfit {
  const char* name;
  std::function<void(Scene&)> edit;
  const char* key;
  const char* what;
};

void PrintTo(const Misfit& misfit, std::ostream* out) {
  *out << misfit.name;
}

class SceneCheck : public ::testing::TestWithParam<Misfit> {};

TEST_P(SceneCheck, SaysWhatDoesNotFit) {
  Scene scene = breakwater(triangle(1., 0.1));
  GetParam().edit(scene);
  const auto mesh = breakwater_mesh(0.5);
  const auto wrong = mistakes(scene, *mesh);
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_EQ(wrong[0].place.key, GetParam().key);
  EXPECT_NE(wrong[0].what.find(GetParam().what), std::string::npos) << wrong[0].what;
  EXPECT_FALSE(wrong[0].cure.empty());
}

const Misfit misfits[] = {
    {"SurfaceWithoutRegion", [](Scene& s) { s.regions.erase("seabed"); }, "regions", "surface 'seabed'"},
    {"RegionWithoutSurface", [](Scene& s) { s.regions["clay"] = sand(); }, "regions.clay", "no surface 'clay'"},
    {"CurveWithoutCondition", [](Scene& s) { s.boundaries.erase("left"); }, "boundaries", "outer curve 'left'"},
    {"ConditionWithoutCurve", [](Scene& s) { s.boundaries["lid"] = {}; }, "boundaries.lid", "no outer curve 'lid'"},
    {"ConditionInside", [](Scene& s) { s.boundaries["bottom"] = {}; }, "boundaries.bottom", "inside the mesh"},
    {"NoPressureCondition", [](Scene& s) { s.boundaries["bed"].pressure.reset(); }, "boundaries.bed", "pore water"},
    {"PressureWithoutWater", [](Scene& s) { s.boundaries["front"].pressure = PressureCondition::open; },
     "boundaries.front.pressure", "no pore water"},
    {"SupportOnRigidRegion", [](Scene& s) { s.boundaries["top"].displacement = DisplacementCondition::roller; },
     "boundaries.top.displacement", "rigid region ('caisson')"},
    {"RigidRegionsTouch",
     [](Scene& s) {
       s.regions["mound"] = s.regions["caisson"];
       s.boundaries["mound_surface"].pressure.reset();
     },
     "regions.mound.kind", "touch"},
    {"HarbourWithoutASea",
     [](Scene& s) {
       s.initial = InitialState();
       s.initial->harbour_level = 12.;
     },
     "initial.harbour_level", "the sea has none"},
    {"SurchargeOnNoSoil",
     [](Scene& s) {
       s.initial = InitialState{{}, {}, {{"blocks", {"front", 1e4, {}, {}}}}};
     },
     "initial.surcharge.blocks.boundary", "no soil lies under"},
    {"SurchargeBesideItsCurve",
     [](Scene& s) {
       s.initial = InitialState{{}, {}, {{"blocks", {"mound_surface", 1e4, 900., {}}}}};
     },
     "initial.surcharge.blocks.boundary", "no soil lies under"},
    {"SurchargeBackwards",
     [](Scene& s) {
       s.initial = InitialState{{}, {}, {{"blocks", {"mound_surface", 1e4, -10., -14.}}}};
     },
     "initial.surcharge.blocks.from", "not below"},
    {"PorousCaisson",
     [](Scene& s) {
       s.regions["caisson"] = sand();
       s.regions["caisson"].damping.reset();
       s.regions["caisson"].flow = Flow::drained;
     },
     "regions.caisson.kind", "cannot be porous"},
    {"DampedCaisson", [](Scene& s) { s.regions["caisson"].damping = Rayleigh(); }, "regions.caisson.damping", "F_T"},
    {"HeldCaisson",
     [](Scene& s) {
       s.regions["caisson"].kind = RegionKind::solid;
       s.boundaries["back"].displacement = DisplacementCondition::fixed;
     },
     "boundaries.back.displacement", "support of the caisson"},
    {"ShapeThatCancels",
     [](Scene& s) {
       s.loads["impulse"].shape = {{6., -1.}, {22., 1.}};
     },
     "loads.impulse.shape", "cancel"},
    {"ShapeOnALevelCurve",
     [](Scene& s) {
       s.loads["impulse"].boundary = "top";
       s.loads["impulse"].shape = {{6., 1.}, {23., 1.}};
     },
     "loads.impulse.shape", "runs over the height"},
    {"LoadWithoutCurve", [](Scene& s) { s.loads["impulse"].boundary = "wall"; }, "loads.impulse.boundary", "'wall'"},
    {"ShapeBesideTheCurve",
     [](Scene& s) {
       s.loads["impulse"].shape = {{-3., 1.}, {2., 1.}};
     },
     "loads.impulse.shape", "reaches from y = 6 to 22"},
    {"ProbeOutside",
     [](Scene& s) {
       s.probes["A"].at = {0., 30.};
     },
     "probes.A.at", "outside the mesh"},
};

INSTANTIATE_TEST_SUITE_P(Misfits, SceneCheck, ::testing::ValuesIn(misfits),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SceneCheckOfAGoodScene, IsSilent) {
  const auto mesh = breakwater_mesh(0.5);
  EXPECT_TRUE(mistakes(breakwater(triangle(1., 0.1)), *mesh).empty());
}

}  // namespace scene_check_test
}  // namespace upbead::test
