// Claim: springs and dashpots on a side, a rigid smooth plate, motions along rollers, tractions on the skeleton and
// shapes along a curve have their exact effect, or satisfy an identity.
#include <gtest/gtest.h>

#include <cmath>

#include "layer.h"
#include "record.h"
#include "reference.h"
#include "tensor_mesh.h"
#include "upbead/model/region.h"

namespace upbead::test {
namespace supports_test {

/// A scene of one solid that fills the unit square, or more, with the sides "left", "right", "base" and "top".
std::unique_ptr<Mesh> square(double width, double height, int n) {
  return tensor_mesh(
      even_lines(0., width, n), even_lines(0., height, n), [](const auto&) { return "soil"; },
      [width, height](const dealii::Point<dim>& p) -> std::string {
        if (p[1] < 1e-9 || p[1] > height - 1e-9) return p[1] < 1e-9 ? "base" : "top";
        return p[0] < 1e-9 ? "left" : p[0] > width - 1e-9 ? "right" : "";
      });
}

Scene solid_scene() {
  Scene scene;
  scene.regions["soil"] = layer_soil({});
  for (const char* side : {"left", "right", "base", "top"}) scene.boundaries[side] = {};
  return scene;
}

Load load_on(const std::string& boundary, LoadKind kind, std::array<double, 2> direction, const TimeFunction& history) {
  Load load;
  load.boundary = boundary;
  load.kind = kind;
  load.direction = direction;
  load.history = history;
  return load;
}

TimeFunction constant(double value) {
  return TimeFunction({0.}, {[](double) { return 0.; }, [value](double) { return value; }});
}

TEST(Springs, CarryAColumnOnTheirOwn) {
  Scene scene = solid_scene();
  scene.time.inertia = false;
  scene.boundaries["base"].spring = {{2e6, 5e5}};
  scene.boundaries["left"].displacement = scene.boundaries["right"].displacement = DisplacementCondition::roller;
  scene.loads["top"] = load_on("top", LoadKind::traction, {0., -1.}, constant(1e4));
  scene.probes["base"].at = {0.5, 0.};
  scene.probes["top"].at = {0.5, 3.};
  const auto mesh = square(1., 3., 2);
  const Compiled column(scene, *mesh);
  const Response response = run(column, 1., 0.25);
  const double sinks = 1e4 / 2e6, shortens = 1e4 * 3. / modulus(layer_soil({}), true);
  Record record("supports");
  const auto last = [&](const char* reading) { return history(column, response, reading).tail(1)[0]; };
  record.at_most("springs: settlement of the base, relative",
                 std::abs(last("probes/base/displacement_y") / -sinks - 1.), 1e-9);
  record.at_most("springs: settlement of the top, relative",
                 std::abs(last("probes/top/displacement_y") / -(sinks + shortens) - 1.), 1e-9);
}

TEST(Springs, SwayAColumnAlongThem) {
  Scene scene = solid_scene();
  scene.time.inertia = false;
  scene.boundaries["base"].spring = {{2e6, 5e5}};
  scene.loads["side"] = load_on("base", LoadKind::traction, {1., 0.}, constant(1e3));
  scene.probes["base"].at = {0.5, 0.};
  const auto mesh = square(1., 1., 2);
  const Compiled block(scene, *mesh);
  const Response response = run(block, 1., 0.5);
  Record record("supports");
  record.at_most("springs: shift along them, relative",
                 std::abs(history(block, response, "probes/base/displacement_x").tail(1)[0] / (1e3 / 5e5) - 1.), 1e-9);
}

/// Dashpots of the soil's own impedances are the absorbing side of Lysmer and Kuhlemeyer.
TEST(Dashpots, OfTheSoilsImpedanceAbsorb) {
  const Region soil = layer_soil({});
  const double rho = *soil.density;
  const auto reading = [&](bool dashpots) {
    Scene scene = solid_scene();
    if (dashpots)
      scene.boundaries["base"].dashpot = {
          {std::sqrt(rho * modulus(soil, true)), std::sqrt(rho * modulus(soil, false))}};
    else
      scene.boundaries["base"].displacement = DisplacementCondition::absorbing;
    scene.loads["push"] = load_on("top", LoadKind::traction, {0.6, -0.8}, triangle(1e4, 0.05));
    scene.probes["top"].at = {2., 4.};
    const auto mesh = square(4., 4., 4);
    const Compiled block(scene, *mesh);
    const Response response = run(block, 0.2, 0.002);
    double mismatch = 0.;
    for (const EnergyAccount& energy : response.energy) mismatch = std::max(mismatch, energy.mismatch());
    EXPECT_LT(mismatch, 1e-10);
    EXPECT_GT(response.energy.back().radiated, 0.);
    return std::pair{response.ends.time, history(block, response, "probes/top/velocity_x")};
  };
  const auto [time, absorbing] = reading(false);
  const auto dashpots = reading(true).second;
  Record record("supports");
  record.at_most("dashpots of the soil's impedance against an absorbing side, over the largest velocity",
                 (absorbing - dashpots).cwiseAbs().maxCoeff() / absorbing.cwiseAbs().maxCoeff(), 1e-12);
}

/// An oedometer with a driven piston: stress = (lambda + 2 G) strain.
TEST(Motion, OfARollerIsThatOfAPiston) {
  Scene scene = solid_scene();
  scene.time.inertia = false;
  scene.boundaries["base"].displacement = scene.boundaries["top"].displacement = DisplacementCondition::roller;
  scene.boundaries["left"].displacement = scene.boundaries["right"].displacement = DisplacementCondition::roller;
  scene.loads["piston"] = load_on("top", LoadKind::displacement, {0., -1.}, triangle(0.2, 1.));
  scene.probes["middle"].at = {0.5, 1.};
  const auto mesh = square(1., 2., 3);
  const Compiled sample(scene, *mesh);
  const Response response = run(sample, 0.5, 0.05);
  const double moved = 0.5 * 0.2 * 0.5, stress = -modulus(layer_soil({}), true) * moved / 2.;
  Record record("supports");
  record.at_most("piston of an oedometer: stress, relative",
                 std::abs(history(sample, response, "probes/middle/stress_yy").tail(1)[0] / stress - 1.), 1e-9);
}

/// A plate under a load at its edge settles evenly, by the mean stress; the side is free, so the stiffness is E/(1 -
/// nu^2).
TEST(Plate, SettlesEvenlyUnderALoadAtItsEdge) {
  Scene scene = solid_scene();
  scene.time.inertia = false;
  scene.boundaries["base"].displacement = scene.boundaries["left"].displacement = DisplacementCondition::roller;
  scene.boundaries["top"].displacement = DisplacementCondition::plate;
  scene.loads["force"] = load_on("top", LoadKind::force, {0., -1.}, constant(1e4));
  scene.loads["force"].over_x = true;
  scene.loads["force"].shape = {{{1.5, 1.}, {2., 1.}}};
  scene.probes["near"].at = {2., 1.};
  scene.probes["far"].at = {0., 1.};
  const auto mesh = square(2., 1., 4);
  const Compiled sample(scene, *mesh);
  const Response response = run(sample, 1., 0.5);
  const Region soil = layer_soil({});
  const double E = 2. * *soil.shear_modulus * (1. + *soil.poissons_ratio), nu = *soil.poissons_ratio;
  const double settles = 1e4 / 2. * (1. - nu * nu) / E;  // plane strain, free side
  const auto last = [&](const char* reading) { return history(sample, response, reading).tail(1)[0]; };
  Record record("supports");
  record.at_most("plate: settlement, relative", std::abs(last("probes/near/displacement_y") / -settles - 1.), 1e-9);
  record.at_most("plate: its other end, relative",
                 std::abs(last("probes/far/displacement_y") / last("probes/near/displacement_y") - 1.), 1e-12);
}

/// A traction normal to an open side compresses the skeleton and not, once drained, the pore water; a pressure does
/// not compress the skeleton.
TEST(NormalTraction, SqueezesTheSkeletonAlone) {
  const auto settles = [](LoadKind kind) {
    Scene scene = column(sand(), {});
    scene.time.inertia = false;
    scene.loads["top"] = load_on("top", kind, {0., -1.}, constant(1e4));
    scene.probes["top"].at = {0.5, 1.};
    scene.probes["base"].at = {0.5, 0.};
    const auto mesh = column_mesh(1., 8);
    const Compiled drained(scene, *mesh);
    const Response response = run(drained, 100., 1.);
    return std::pair{history(drained, response, "probes/top/displacement_y").tail(1)[0],
                     history(drained, response, "probes/base/pressure").tail(1)[0]};
  };
  const double E = modulus(sand(), true);
  const auto [by_normal, p_normal] = settles(LoadKind::normal);
  const auto [by_traction, p_traction] = settles(LoadKind::traction);
  const auto [by_pressure, p_pressure] = settles(LoadKind::pressure);
  Record record("supports");
  record.at_most("normal traction: settlement once drained, relative", std::abs(by_normal / (-1e4 / E) - 1.), 1e-6);
  record.at_most("normal traction against a traction downward, relative", std::abs(by_normal / by_traction - 1.),
                 1e-12);
  record.at_most("normal traction: pore pressure once drained, over the traction", std::abs(p_normal) / 1e4, 1e-6);
  EXPECT_NEAR(p_pressure, 1e4, 1.);
  EXPECT_LT(std::abs(by_pressure), 1e-3 * std::abs(by_normal));
  EXPECT_NEAR(p_traction, p_normal, 1e-3);
}

/// On a straight level curve the length from its seaward end is x less x of that end; on a wall it is the height.
TEST(ShapesAlongACurve, AreThoseOverXAndHeight) {
  for (const bool wall : {false, true}) {
    Scene scene = solid_scene();
    scene.time.inertia = false;
    scene.boundaries["base"].displacement = DisplacementCondition::fixed;
    scene.loads["load"] = load_on(wall ? "left" : "top", LoadKind::traction, {1., -0.5}, constant(1e4));
    Load& load = scene.loads["load"];
    load.shape = {{{0.3, 1.}, {0.9, 0.2}, {1.4, 2.}}};
    load.over_x = !wall;
    scene.probes["corner"].at = {0., 2.};
    const auto mesh = square(2., 2., 4);
    const auto shift = [&] {
      const Compiled block(scene, *mesh);
      return history(block, run(block, 1., 1.), "probes/corner/displacement_x").tail(1)[0];
    };
    const double plain = shift();
    load.over_x = false;
    load.along_curve = true;
    Record record("supports");
    record.at_most(
        std::string("shape along a ") + (wall ? "wall" : "level curve") + " against its coordinate, relative",
        std::abs(shift() / plain - 1.), 1e-9);
  }
}

}  // namespace supports_test
}  // namespace upbead::test
