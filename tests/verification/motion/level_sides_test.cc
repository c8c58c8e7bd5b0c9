// Claim: between level sides, ground above a shaken base moves everywhere as a column of it does, under shear waves,
// pressure waves and both, dry and saturated. Source: the column with the exact condition of each motion (u_y = 0 under
// shear, u_x = 0 under compression), and their sum: the ground is linear.
#include <gtest/gtest.h>

#include <cmath>

#include "layer.h"
#include "tensor_mesh.h"

namespace upbead::test {
namespace level_sides_test {

constexpr double width = 30., height = 10.;

/// Two layers; the landward side has other heights of nodes than the seaward one where `uneven`.
std::unique_ptr<Mesh> layers(double wide, int across, bool unlike = false) {
  return tensor_mesh(
      even_lines(0., wide, across), even_lines(0., height, 8),
      [=](const dealii::Point<dim>& p) { return p[1] < 4. || (unlike && p[0] > 0.9 * wide) ? "lower" : "upper"; },
      [=](const dealii::Point<dim>& p) -> std::string {
        if (p[1] < 1e-9 || p[1] > height - 1e-9) return p[1] < 1e-9 ? "base" : "top";
        return p[0] < 1e-9 ? "left" : p[0] > wide - 1e-9 ? "right" : "";
      });
}

Scene ground(bool wet, DisplacementCondition sides) {
  Scene scene;
  scene.regions["upper"] = wet ? sand() : layer_soil({});
  scene.regions["lower"] = scene.regions["upper"];
  *scene.regions["lower"].shear_modulus *= 3.;
  for (auto& [name, region] : scene.regions) {
    region.damping = Rayleigh{0.05, {1., 10.}};
    region.flow = Flow::darcy;  // sealed sides hold back water whose own inertia lets it lag
  }
  using P = PressureCondition;
  const auto pressure = [wet](P condition) { return wet ? std::optional<P>(condition) : std::nullopt; };
  scene.boundaries["base"] = {DisplacementCondition::fixed, pressure(P::sealed)};
  scene.boundaries["top"] = {DisplacementCondition::free, pressure(P::open)};
  for (const char* side : {"left", "right"}) scene.boundaries[side] = {sides, pressure(P::sealed)};
  for (const auto& [name, x] : {std::pair{"side", 0.}, std::pair{"middle", 0.4}, std::pair{"end", 1.}})
    scene.probes[name].at = {x, 9.};
  return scene;
}

void shake(Scene& scene, std::array<double, 2> direction) {
  Load load;
  load.boundary = "base";
  load.kind = LoadKind::velocity;
  load.direction = direction;
  load.history = smooth_velocity(0.1, 0.3);
  scene.loads["quake"] = load;
}

Eigen::RowVectorXd found(Scene scene, const std::string& reading, double wide, int across) {
  for (auto& [name, probe] : scene.probes) probe.at[0] *= wide;
  const auto mesh = layers(wide, across);
  const Compiled compiled(scene, *mesh);
  return history(compiled, run(compiled, 0.8, 0.01), reading);
}

/// The column: of one cell across, held by fixed directions.
Eigen::RowVectorXd column(bool wet, bool vertical, double part, const std::string& quantity) {
  Scene scene = ground(wet, vertical ? DisplacementCondition::roller : DisplacementCondition::level);
  shake(scene, {vertical ? 0. : part, vertical ? part : 0.});
  return found(scene, "probes/middle/" + quantity, 2., 1);
}

TEST(LevelSides, LetGroundMoveAsAColumn) {
  for (const bool wet : {false, true})
    for (const auto& direction : {std::array{1., 0.}, std::array{0., 1.}, std::array{0.6, -0.8}}) {
      Scene scene = ground(wet, DisplacementCondition::level);
      shake(scene, direction);
      const Eigen::RowVectorXd x = column(wet, false, direction[0], "velocity_x"),
                               y = column(wet, true, direction[1], "velocity_y");
      const double scale = std::max(x.cwiseAbs().maxCoeff(), y.cwiseAbs().maxCoeff());
      for (const char* probe : {"side", "middle", "end"}) {
        const std::string of = std::string("probes/") + probe;
        EXPECT_LT((found(scene, of + "/velocity_x", width, 6) - x).cwiseAbs().maxCoeff(), 1e-8 * scale) << of;
        EXPECT_LT((found(scene, of + "/velocity_y", width, 6) - y).cwiseAbs().maxCoeff(), 1e-8 * scale) << of;
      }
    }
}

/// A side that holds the ground along the motion, and level sides that are not alike under both motions, are refused.
TEST(LevelSides, OrAreRefused) {
  using D = DisplacementCondition;
  struct Case {
    D sides;
    std::array<double, 2> direction;
    bool unlike, right;
  };
  for (const Case& at : {Case{D::roller, {1., 0.}, false, false}, Case{D::roller, {0., 1.}, false, true},
                         Case{D::fixed, {0., 1.}, false, false}, Case{D::roller, {0.6, 0.8}, false, false},
                         Case{D::level, {0.6, 0.8}, false, true}, Case{D::level, {0.6, 0.8}, true, false},
                         Case{D::level, {0., 1.}, true, true}}) {
    Scene scene = ground(false, at.sides);
    shake(scene, at.direction);
    for (auto& [name, probe] : scene.probes) probe.at[0] *= width;
    const auto wrong = mistakes(scene, *layers(width, 6, at.unlike));
    EXPECT_EQ(wrong.empty(), at.right) << at.direction[0];
    for (const auto& mistake : wrong) {
      EXPECT_NE(mistake.place.key.find(".displacement"), std::string::npos) << mistake.place.key;
      EXPECT_FALSE(mistake.cure.empty());
    }
  }
  Scene moved = ground(false, D::roller);  // walls that are driven as the base is
  shake(moved, {1., 0.});
  for (auto& [name, probe] : moved.probes) probe.at[0] *= width;
  for (const char* side : {"left", "right"}) {
    moved.loads[side] = moved.loads["quake"];
    moved.loads[side].boundary = side;
  }
  EXPECT_TRUE(mistakes(moved, *layers(width, 6)).empty());
}

}  // namespace level_sides_test
}  // namespace upbead::test
