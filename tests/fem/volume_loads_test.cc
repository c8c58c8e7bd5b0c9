// Claims: loads on volumes are in balance with the reactions. A column settles under a body force as computed by
// hand; water that enters closed pores raises p by Q s t, and one that flows out upward by s b (H^2 - y^2)/2; under
// gravity the pore pressure becomes hydrostatic, on whatever slope the pores drain, and the effective stress that of
// the submerged weight; a rigid body has the weight of its mass, and both routes to F_T agree. Sources: statics, mass
// balance, Pascal; docs/theory.md. Tolerance: round-off, or the motion that remains after a slow ramp.

#include "fem/volume_loads.h"

#include <gtest/gtest.h>

#include "fem/domain_of_influence.h"
#include "response/shear_response.h"
#include "scenes.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace volume_loads_test {

constexpr double height = 10., g = 9.81, rho_f = 1030.;

TimeFunction ramp(double value, double until) {
  return piecewise_linear({0., until, 1e12}, {0., value, value});
}

Load on_volume(LoadKind kind, const std::string& region, const TimeFunction& history) {
  Load load;
  load.kind = kind;
  load.region = region;
  load.history = history;
  return load;
}

double oedometric(const Region& soil) {
  const double G = *soil.shear_modulus, nu = *soil.poissons_ratio;
  return 2. * G * (1. - nu) / (1. - 2. * nu);
}

double submerged_weight(const Region& soil) {
  return (1. - *soil.porosity) * (*soil.grain_density - rho_f) * g;
}

/// A column without a load, read at its top, its middle and its base.
Scene quiet_column(const Region& soil, int degree = 2) {
  Scene scene = column(soil, TimeFunction());
  scene.loads.clear();
  scene.mesh.degree = degree;
  scene.probes["top"].at = {0.5, height};
  scene.probes["middle"].at = {0.5, 0.4 * height};
  scene.probes["base"].at = {0.5, 0.};
  return scene;
}

double last(const Compiled& compiled, const Response& response, const std::string& reading) {
  return history(compiled, response, reading).tail<1>()[0];
}

TEST(BodyForce, ColumnSettlesByHalfItsForce) {
  Region soil = sand();
  soil.flow = Flow::drained;
  Scene scene = quiet_column(soil);
  scene.time.inertia = false;
  scene.loads["force"] = on_volume(LoadKind::body_force, "soil", ramp(2e4, 1.));
  scene.loads["force"].direction = {0., -1.};
  const auto mesh = column_mesh(height, 4);
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, 1000., 50.);
  const double E = oedometric(soil);
  EXPECT_NEAR(last(compiled, response, "probes/top/displacement_y"), -2e4 * height * height / (2. * E), 1e-9 * 1e6 / E);
  EXPECT_NEAR(last(compiled, response, "probes/base/effective_stress_yy"), -2e4 * height, 1e-3);
}

class Flows : public ::testing::TestWithParam<Flow> {};
INSTANTIATE_TEST_SUITE_P(VolumeLoads, Flows, ::testing::Values(Flow::darcy, Flow::inertial));

TEST_P(Flows, SourceInAClosedBoxRaisesThePressureByItsVolume) {
  for (const bool free_top : {false, true}) {
    Region soil = sand();
    soil.flow = GetParam();
    soil.damping.reset();
    soil.biot = 0.9;
    soil.grain_bulk_modulus = 3.6e10;
    Scene scene = quiet_column(soil);
    scene.boundaries["top"] = {free_top ? DisplacementCondition::free : DisplacementCondition::fixed,
                               PressureCondition::sealed};
    scene.loads["source"] = on_volume(LoadKind::source, "soil", ramp(1e-6, 100.));
    const auto mesh = column_mesh(height, 4);
    const Compiled compiled(scene, *mesh);
    const Response response = run(compiled, 300., 1.);
    const double storage = 0.4 / 2.2e9 + (0.9 - 0.4) / 3.6e10 + (free_top ? 0.81 / oedometric(soil) : 0.);
    const double p = 1e-6 * 250. / storage;  // the ramp contributes half of its 100 s
    for (const char* probe : {"top", "middle", "base"})
      EXPECT_NEAR(last(compiled, response, std::string("probes/") + probe + "/pressure"), p, 1e-5 * p);
    EXPECT_LE(response.energy.back().mismatch(), 1e-8);
  }
}

TEST(Source, FlowsOutThroughAnOpenSide) {
  Region soil = sand();
  soil.flow = Flow::darcy;
  for (const double s : {1e-6, -1e-6}) {
    Scene scene = quiet_column(soil, 3);
    scene.time.inertia = false;
    scene.loads["source"] = on_volume(LoadKind::source, "soil", ramp(s, 1.));
    const auto mesh = column_mesh(height, 5);
    const Compiled compiled(scene, *mesh);
    const Response response = run(compiled, 1e6, 2e4);
    const double b = rho_f * g / 1e-4;
    EXPECT_NEAR(last(compiled, response, "probes/base/pressure"), 0.5 * s * b * height * height, 1e-7 * 5e3);
    EXPECT_NEAR(last(compiled, response, "probes/middle/pressure"), 0.5 * s * b * height * height * (1. - 0.16),
                1e-7 * 5e3);
  }
}

TEST(Gravity, PoresBecomeHydrostaticAndTheSkeletonSubmerged) {
  Region soil = sand();
  soil.flow = Flow::darcy;
  for (const double head : {0., 3e4}) {
    Scene scene = quiet_column(soil);
    scene.time.inertia = false;
    scene.loads["weight"] = on_volume(LoadKind::gravity, "", ramp(g, 1.));
    Load water = on_volume(LoadKind::pressure, "", ramp(head, 1.));
    water.boundary = "top";
    scene.loads["water"] = water;
    const auto mesh = column_mesh(height, 4);
    const Compiled compiled(scene, *mesh);
    const Response response = run(compiled, 1e6, 2e4);
    const double weight = submerged_weight(soil), E = oedometric(soil);
    EXPECT_NEAR(last(compiled, response, "probes/base/pressure"), head + rho_f * g * height, 1e-7 * 1e5);
    EXPECT_NEAR(last(compiled, response, "probes/middle/pressure"), head + rho_f * g * 0.6 * height, 1e-7 * 1e5);
    EXPECT_NEAR(last(compiled, response, "probes/base/effective_stress_yy"), -weight * height, 1e-7 * 1e5);
    EXPECT_NEAR(last(compiled, response, "probes/top/displacement_y"), -0.5 * weight * height * height / E,
                1e-7 * 1e6 / E);
  }
}

/// Stiff sand on soft clay, each with its own weight: the base bears both.
TEST_P(Flows, GravityInLayersWithInertiaSettlesToTheSame) {
  Region lower = sand(), upper = rubble();
  upper.porosity = 0.3;
  for (Region* soil : {&lower, &upper}) {
    soil->flow = GetParam();
    soil->hydraulic_conductivity = 0.01;
    soil->damping = Rayleigh{0.3, {1., 10.}};
  }
  Scene scene = quiet_column(lower);
  scene.regions = {{"lower", lower}, {"upper", upper}};
  scene.loads["weight"] = on_volume(LoadKind::gravity, "", ramp(g, 1.));
  const auto mesh = tensor_mesh(
      {0., 0.5, 1.}, even_lines(0., height, 6), [](const auto& at) { return at[1] > 5. ? "upper" : "lower"; },
      [](const auto& at) -> std::string {
        if (at[1] == 0. || at[1] == height) return at[1] == 0. ? "base" : "top";
        return at[0] == 0. ? "left" : at[0] == 1. ? "right" : "";
      });
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, 60., 0.1);
  const double weight = 5. * (submerged_weight(lower) + submerged_weight(upper));
  EXPECT_NEAR(last(compiled, response, "probes/base/pressure"), rho_f * g * height, 1e-5 * 1e5);
  EXPECT_NEAR(last(compiled, response, "probes/base/effective_stress_yy"), -weight, 1e-5 * 1e5);
  EXPECT_LE(response.energy.back().mismatch(), 1e-8);
}

/// The shipped section under still water; the water pressure is given on every wet side.
Scene under_still_water(double level) {
  Scene scene = breakwater(TimeFunction());
  scene.loads.clear();
  scene.time.inertia = false;
  scene.loads["weight"] = on_volume(LoadKind::gravity, "", ramp(g, 1.));
  for (const char* side : {"bed", "mound_surface", "front", "back"}) {
    Load water = on_volume(LoadKind::pressure, "", ramp(rho_f * g, 1.));
    water.boundary = side;
    water.shape = {{-100., level + 100.}, {level, 0.}};
    scene.loads[std::string("water_") + side] = water;
  }
  for (const char* name : {"mound", "seabed"}) scene.regions[name].flow = Flow::darcy;
  scene.probes["mound"].at = {-12., 3.};
  scene.probes["seabed"].at = {20., -7.};
  return scene;
}

TEST(Gravity, StillWaterStandsInAMoundWithSlopesAndTheCaissonWeighsItsMass) {
  const Scene scene = under_still_water(15.);
  const auto mesh = breakwater_mesh(0.5);
  const Compiled compiled(scene, *mesh);
  const Response response = run(compiled, 1e7, 2e5);
  EXPECT_NEAR(last(compiled, response, "probes/mound/pressure"), rho_f * g * 12., 1e-6 * 1e5);
  EXPECT_NEAR(last(compiled, response, "probes/seabed/pressure"), rho_f * g * 22., 1e-6 * 1e5);
  const double mass = 2100. * 16. * 18.;
  EXPECT_NEAR(last(compiled, response, "force_vertical"), -mass * g, 1e-9 * mass * g);
  EXPECT_NEAR(last(compiled, response, "normal_force"), mass * g, 1e-7 * mass * g);
  EXPECT_NEAR(last(compiled, response, "uplift"), rho_f * g * 9. * 18., 1e-6 * mass * g);
  EXPECT_NEAR(last(compiled, response, "shear_force") - last(compiled, response, "shear_force_by_inertia"), 0.,
              1e-8 * mass * g);
}

/// A body force on the ground under the caisson and on the caisson, by both routes to F_T.
TEST_P(Flows, BothRoutesToTheShearForceAgree) {
  for (const bool elastic : {false, true}) {
    Scene scene = breakwater(TimeFunction());
    scene.loads.clear();
    if (elastic) {
      Region& caisson = scene.regions["caisson"];
      caisson.kind = RegionKind::solid;
      caisson.deformation = Deformation::elastic;
      caisson.shear_modulus = 1e9;
      caisson.poissons_ratio = 0.2;
    }
    for (const char* region : {"mound", "caisson", "seabed"}) {
      Load& load = scene.loads[region] = on_volume(LoadKind::body_force, region, triangle(5e3, 0.2));
      load.direction = {1., -0.5};
    }
    scene.loads["weight"] = on_volume(LoadKind::gravity, "", triangle(g, 0.2));
    scene.loads["source"] = on_volume(LoadKind::source, "mound", triangle(1e-3, 0.2));
    for (const char* name : {"mound", "seabed"}) scene.regions[name].flow = GetParam();
    const auto mesh = breakwater_mesh(0.5);
    const Compiled compiled(scene, *mesh);
    const Response response = run(compiled, 0.4, 0.02);
    const auto F = history(compiled, response, "shear_force"),
               other = history(compiled, response, "shear_force_by_inertia");
    EXPECT_LE((F - other).cwiseAbs().maxCoeff(), 1e-8 * F.cwiseAbs().maxCoeff());
    EXPECT_LE(response.energy.back().mismatch(), 1e-8);
    for (const LoadOnCaisson& load : compiled.loads_on_caisson) {
      const bool on_it = load.name == "caisson";
      EXPECT_NEAR(load.force_x, on_it ? 16. * 18. : 0., 1e-9) << load.name;
      EXPECT_NEAR(load.moment, on_it ? 8. * 16. * 18. : 0., 1e-7) << load.name;
      EXPECT_NEAR(load.force_y,
                  on_it                   ? -0.5 * 16. * 18.
                  : load.name == "weight" ? -2100. * 16. * 18.
                                          : 0.,
                  1e-7)
          << load.name;
    }
  }
}

TEST(DomainOfInfluence, HoldsARegionThatIsLoadedInside) {
  Scene scene = breakwater(TimeFunction());
  scene.loads.clear();
  scene.regions["seabed"].flow = scene.regions["mound"].flow = Flow::darcy;
  scene.time.end = 0.005;
  const auto mesh = breakwater_mesh(0.5);
  EXPECT_GT(domain_of_influence(scene, *mesh).n_outside, 0);
  scene.loads["source"] = on_volume(LoadKind::source, "seabed", ramp(1e-3, 1.));
  const int beside_caisson = domain_of_influence(scene, *mesh).n_outside;
  scene.probes["far"].at = {100., -7.};
  EXPECT_LT(domain_of_influence(scene, *mesh).n_outside, beside_caisson);
}

TEST(Gravity, KeepsAMoundFromBeingTakenAsDrained) {
  Scene scene = breakwater(triangle(1e6, 60.));
  scene.time.end = 60.;
  const auto mesh = breakwater_mesh(0.5);
  ASSERT_EQ(resolve(scene, *mesh).scene.regions.at("mound").flow, Flow::drained);
  scene.loads["weight"] = on_volume(LoadKind::gravity, "mound", triangle(g, 60.));
  EXPECT_EQ(resolve(scene, *mesh).scene.regions.at("mound").flow, Flow::darcy);
}

struct Misplaced {
  const char* name;
  LoadKind kind;
  const char* region;
  void (*edit)(Scene&);
  const char *key, *what;
};

void PrintTo(const Misplaced& row, std::ostream* out) {
  *out << row.name;
}

class MisplacedLoad : public ::testing::TestWithParam<Misplaced> {};

TEST_P(MisplacedLoad, IsToldAtItsKey) {
  Scene scene = breakwater(triangle(1., 0.1));
  scene.loads["a"] = on_volume(GetParam().kind, GetParam().region, triangle(1., 0.1));
  GetParam().edit(scene);
  const auto mesh = breakwater_mesh(0.5);
  const auto wrong = mistakes(scene, *mesh);
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_EQ(wrong[0].place.key, GetParam().key);
  EXPECT_NE(wrong[0].what.find(GetParam().what), std::string::npos) << wrong[0].what;
  EXPECT_FALSE(wrong[0].cure.empty());
}

void nothing(Scene&) {}

const Misplaced misplaced[] = {
    {"OnABoundary", LoadKind::body_force, "mound", [](Scene& s) { s.loads["a"].boundary = "bed"; }, "loads.a.boundary",
     "volume"},
    {"NoRegion", LoadKind::source, "", nothing, "loads.a.region", "in which region"},
    {"SourceInTheCaisson", LoadKind::source, "caisson", nothing, "loads.a.region", "no pore water"},
    {"SourceInDrainedSoil", LoadKind::source, "mound", [](Scene& s) { s.regions["mound"].flow = Flow::drained; },
     "loads.a.region", "no pore water"},
    {"GravityOnDrainedSoil", LoadKind::gravity, "", [](Scene& s) { s.regions["mound"].flow = Flow::drained; },
     "loads.a.kind", "'mound' is drained"},
    {"GravityAtAnAbsorbingSide", LoadKind::gravity, "seabed",
     [](Scene& s) { s.boundaries["left"].displacement = DisplacementCondition::absorbing; }, "loads.a.kind", "'left'"},
    {"GravityAndSliding", LoadKind::gravity, "", [](Scene& s) { s.sliding.emplace(); }, "loads.a.kind", "twice"},
    {"GravityAndStrength", LoadKind::gravity, "mound", [](Scene& s) { s.regions["mound"].strength.emplace(); },
     "loads.a.kind", "twice"},
};

INSTANTIATE_TEST_SUITE_P(VolumeLoads, MisplacedLoad, ::testing::ValuesIn(misplaced),
                         [](const auto& row) { return row.param.name; });

TEST(Gravity, IsRefusedBesideFreeWater) {
  Scene scene = breakwater(triangle(1., 0.1));
  add_sea(scene);
  scene.loads["weight"] = on_volume(LoadKind::gravity, "mound", triangle(1., 0.1));
  const auto mesh = breakwater_mesh(0.5, with_sea());
  const auto wrong = mistakes(scene, *mesh);
  ASSERT_EQ(wrong.size(), 2u);  // both are seas
  for (const auto& found : wrong) EXPECT_NE(found.what.find("does not feel gravity"), std::string::npos) << found.what;
}

}  // namespace volume_loads_test
}  // namespace upbead::test
