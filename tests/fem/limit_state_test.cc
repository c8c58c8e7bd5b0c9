// Claims: whether ground can rest is answered as by limit analysis: a strip on clay bears (2 + pi) c, slopes have the
// factors of the most dangerous circle, by Bishop's method, whatever the mesh; the ground rests at `lower` and is shown
// not to at `upper`. A rest that is found is within the strength and in equilibrium, and what is found does not depend
// on the stress at the start. A search without an answer makes no bound.

#include "fem/limit_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/factor_search.h"
#include "fem/ground.h"
#include "fem/rest_state.h"
#include "fem/second_order_cone.h"
#include "slope.h"

namespace upbead::test {
namespace limit_state_test {

constexpr double H = Slope::height, weight = slope_weight, pi = 3.14159265358979323846;

/// F of one circle by Bishop's simplified method (1955); infinite where it cuts nothing off.
double bishop(const Slope& slope, const Strength& s, double x, double y, double R) {
  constexpr int n = 80;
  const double tangent = std::tan(s.friction_angle * pi / 180.), b = 2. * R / n;
  double F = 1.;
  for (int turn = 0; turn < 30; ++turn) {
    double resists = 0., drives = 0.;
    for (int i = 0; i < n; ++i) {
      const double at = x - R + (i + 0.5) * b, sine = (x - at) / R, cosine = std::sqrt(1. - sine * sine);
      const double height = slope.top(at) - (y - R * cosine);
      if (height <= 0.) continue;
      const double W = weight * height * b;
      resists += (s.cohesion * b + W * tangent) / (cosine + sine * tangent / F);
      drives += W * sine;
    }
    if (drives <= 1e-6 * weight * H * H) return HUGE_VAL;
    F = resists / drives;
  }
  return F;
}

/// The least F of circles within the ground.
double worst_circle(const Slope& slope, const Strength& s) {
  double least = HUGE_VAL;
  for (double x = -0.5 * H; x <= slope.run + 0.5 * H; x += 0.1 * H)
    for (double y = 1.05 * H; y <= 4. * H; y += 0.1 * H)
      for (double deep = std::max(-slope.below, -2. * H); deep <= 0.5 * H; deep += 0.05 * H)
        least = std::min(least, bishop(slope, s, x, y, y - deep));
  return least;
}

double middle(const SafetyFactor& F) {
  EXPECT_TRUE(F.lower && F.upper && *F.upper - *F.lower <= 0.01 * *F.lower) << F.why;
  EXPECT_EQ(F.why, "");
  return F.lower && F.upper ? 0.5 * (*F.lower + *F.upper) : NAN;
}

/// Cells of a fifth of the height are too stiff to fail along a narrow band.
void expect_slightly_above(double F, double circle) {
  EXPECT_GT(F, 0.985 * circle);
  EXPECT_LT(F, 1.08 * circle);
}

TEST(LimitState, SlopesFailByTheWorstCircleWhateverTheirMesh) {
  double before = 0.;
  unsigned seed = 1;
  for (const double angle : {18., 20., 22., 25.}) {
    const Strength soil{angle, 0.05 * weight * H, 0., 0.};
    Slope slope;
    slope.size = 2.;
    slope.uneven = 0.25;
    slope.seed = seed++;
    const double F = middle(safety_factor(slope_scene(soil), *slope.mesh(), {}));
    expect_slightly_above(F, worst_circle(slope, soil));
    EXPECT_GT(F, before + 0.02);
    before = F;
  }
}

/// Clay that bears tension keeps its volume as it fails, for which cells with nine points each are too stiff: finer
/// ones come down to the circle.
TEST(LimitState, UndrainedSlopesComeDownToTheWorstCircle) {
  for (const double run : {H, 2. * H}) {
    const Strength clay{0., 0.25 * weight * H, 0., 1e12};
    double before = HUGE_VAL;
    for (const double size : {2., 1.}) {
      Slope slope;
      slope.run = run;
      slope.size = size;
      const SafetyFactor F = safety_factor(slope_scene(clay), *slope.mesh(), {});
      ASSERT_TRUE(F.lower && F.upper);
      EXPECT_LT(*F.upper, 1.03 * *F.lower) << F.why;
      EXPECT_LT(*F.upper, before);
      EXPECT_GT(*F.lower, 0.985 * worst_circle(slope, clay));
      EXPECT_LT(*F.lower, (size < 2. ? 1.1 : 1.2) * worst_circle(slope, clay));
      before = *F.lower;
    }
  }
}

/// Dry sand slides along its slope: F = tan phi' / tan beta.
TEST(LimitState, DrySandSlidesAlongItsSlope) {
  Slope slope;
  slope.size = 2.;
  const SafetyFactor F = safety_factor(slope_scene({35., 0., 0., 0.}), *slope.mesh(), {});
  EXPECT_NEAR(middle(F) / (std::tan(35. * pi / 180.) / 0.5), 1., 0.05);
}

/// Prandtl (1920): the mean pressure of a strip on clay without weight, or with, is (2 + pi) c.
TEST(LimitState, AStripOnClayBearsPrandtlsPressure) {
  Slope level;
  level.run = 0.;
  level.below = 0.;
  level.size = 1.;
  level.behind = level.before = 14.;
  Scene scene = slope_scene({0., 20e3, 0., 0.});
  scene.initial->surcharge["load"] = {"surface", 50e3, -3., 3.};
  const double exact = (2. + pi) * 20e3 / 50e3;
  const SafetyFactor F = safety_factor(scene, *level.mesh(), {});
  EXPECT_GT(middle(F), 0.995 * exact);
  EXPECT_LT(middle(F), 1.06 * exact);
  EXPECT_EQ(F.fails_at.rfind("region 'soil' at ", 0), 0u) << F.fails_at;
}

void expect_rest_between(double size, const std::vector<Strength>& soils) {
  Slope slope;
  slope.size = size;
  slope.uneven = 0.2;
  for (const Strength& soil : soils) {
    const auto mesh = slope.mesh();
    const SafetyFactor F = safety_factor(slope_scene(soil), *mesh, {});
    ASSERT_TRUE(F.lower && F.upper);
    const auto at = [&](double factor) {
      Strength weaker = soil;
      for (double* angle : {&weaker.friction_angle, &weaker.dilatancy_angle})
        *angle = std::atan(std::tan(*angle * pi / 180.) / factor) * 180. / pi;
      weaker.cohesion /= factor;
      return rest_state(slope_scene(weaker), *mesh, {});
    };
    const RestState rests = at(*F.lower), falls = at(*F.upper);
    EXPECT_TRUE(rests.found) << soil.friction_angle;
    EXPECT_LE(rests.report.residual, 1e-6);
    EXPECT_FALSE(falls.found) << soil.friction_angle;
    EXPECT_TRUE(falls.none);
  }
}

TEST(LimitState, RestsAtTheLowerFactorAndIsShownNotToAtTheUpper) {
  expect_rest_between(4., {{20., 10e3, 0., 0.}});
}

TEST(LimitState, RestsAtTheLowerFactorAndIsShownNotToAtTheUpperAtLength) {
  expect_rest_between(2., {{20., 10e3, 0., 0.}, {0., 50e3, 0., 0.}, {38., 1e3, 8., 0.}});
}

/// The soil of a slope with associated laws of the given strength. Its committed stress is that of level ground, with
/// a share of the vertical stress as horizontal one: not in equilibrium on a slope.
struct Searched {
  Slope slope;
  std::unique_ptr<Mesh> mesh;
  Scene scene;
  Ground ground;
  StaticSoil soil;
  Vector load;
  Searched(const Strength& s, double share)
      : slope{2. * H, 0.5 * H, 2.5, 0.2},
        mesh(slope.mesh()),
        scene(at_rest(slope_scene(s))),
        ground(scene, *mesh, {}),
        soil(ground.space(), ground.unknowns()),
        load(ground.weights(-1e3)) {
    soil.follow(StaticLaws(
        mesh->triangulation.n_active_cells(),
        std::make_shared<const MohrCoulombLaw>(
            elastic_law(4e7, 0.3), MohrCoulombStrength{s.friction_angle, s.cohesion, s.friction_angle, s.tension})));
    PointStresses stresses;
    for (const auto& cell : mesh->triangulation.active_cell_iterators()) {
      const double vertical = weight * (cell->center()[1] - slope.top(cell->center()[0]));
      stresses.emplace_back(9, PlaneStress{share * vertical, vertical, 0., share * vertical});
    }
    soil.start_from(stresses);
  }
};

TEST(LimitState, ARestIsWithinTheStrengthAndInEquilibriumWhateverTheStressAtTheStart) {
  for (const double share : {0.4, 1.}) {
    Searched ground({20., 9e3, 0., 0.}, share);
    const LimitAnswer rest = seek_rest(ground.soil, ground.load);
    ASSERT_EQ(rest.found, RestFound::rest);
    ground.soil.start_from(rest.stresses);
    EXPECT_LE(ground.soil.largest_excess(), 1.);  // Pa
    Vector force;
    ground.soil.exert(Vector::Zero(ground.load.size()), force);
    EXPECT_LE((force - ground.load).norm(), 2e-6 * ground.load.norm());
    Searched weak({12., 4e3, 0., 0.}, share);
    const LimitAnswer none = seek_rest(weak.soil, weak.load);
    ASSERT_EQ(none.found, RestFound::none);
    EXPECT_GT(none.factor, 0.3);
    EXPECT_LT(none.factor, 1.);
  }
}

/// Of a box on rollers under its weight the elastic stress and all others in equilibrium have sigma_yy = -gamma depth;
/// with sigma_xx = -K gamma depth they are borne where K is at least Rankine's tan^2(45 - phi'/2).
TEST(LimitState, GroundBetweenSmoothWallsRestsHoweverLittleFrictionItHas) {
  for (const double angle : {0., 1., 10., 30.}) {
    Slope level;
    level.run = level.below = 0.;
    level.size = 2.5;
    level.behind = level.before = 5.;
    const SafetyFactor F = safety_factor(slope_scene({angle, 1e3, 0., 0.}), *level.mesh(), {});
    EXPECT_EQ(F.lower, FactorSearch::largest) << angle;
    EXPECT_FALSE(F.upper) << angle;
  }
}

/// Two points of the cone, one of them close to its surface.
TEST(Cone, ScalingMakesTwoPointsOneAndProductsAreUndone) {
  using namespace cone;
  const cone::Point s(2., 0.3, -1.2), z(0.5, -0.3, 0.3999), r(0.3, -2., 0.7);
  const Scaling scaling(s, z);
  EXPECT_LT((scaling.W * z - scaling.inverse * s).norm(), 1e-12);
  EXPECT_LT((scaling.W * scaling.inverse - Eigen::Matrix3d::Identity()).norm(), 1e-10);
  EXPECT_LT((product(s, divided(r, s)) - r).norm(), 1e-14);
  EXPECT_NEAR(determinant(product(s, s)), determinant(s) * determinant(s), 1e-12);
  for (const cone::Point& d : {cone::Point(-1., 0., 0.), cone::Point(0., 1., 2.), cone::Point(0.1, -3., 0.)}) {
    const double t = farthest(s, d, 1e3);
    EXPECT_NEAR(determinant(s + t * d), 0., 1e-12) << d.transpose();
    EXPECT_GT(determinant(s + 0.999 * t * d), 0.);
  }
  EXPECT_EQ(farthest(s, s, 7.), 7.);
}

/// A ground that fails at a factor, with a stretch of factors at which no search ends.
LimitAnswer answer_of(double F, double fails, double open_from, double open_to) {
  LimitAnswer answer;
  answer.found = F > open_from && F < open_to ? RestFound::open : F < fails ? RestFound::rest : RestFound::none;
  if (answer.found == RestFound::none) answer.factor = std::max(0.2, std::pow(fails / F, 0.97));
  return answer;
}

TEST(FactorSearch, FindsTheFactorInFewSearchesAndMakesNoBoundOfOneWithoutAnswer) {
  for (const double fails : {0.08, 0.7, 0.999, 1.001, 1.37, 2.9, 17.}) {
    FactorSearch search;
    int n = 0;
    for (; n < 100 && search.next(); ++n) search.take(*search.next(), answer_of(*search.next(), fails, 0., 0.));
    EXPECT_LE(n, 16) << fails;
    ASSERT_TRUE(search.lower() && search.upper()) << fails;
    EXPECT_LE(*search.lower(), fails);
    EXPECT_GE(*search.upper(), fails);
    EXPECT_LE(*search.upper() - *search.lower(), FactorSearch::closeness * *search.lower());
    EXPECT_EQ(search.why(), "");
    FactorSearch hindered;
    for (n = 0; n < 100 && hindered.next(); ++n)
      hindered.take(*hindered.next(), answer_of(*hindered.next(), fails, 0.97 * fails, 1.1 * fails));
    EXPECT_LT(n, 100);
    EXPECT_LE(hindered.lower().value_or(0.), 0.97 * fails);
    EXPECT_GE(hindered.upper().value_or(HUGE_VAL), 1.1 * fails);
    EXPECT_NE(hindered.why(), "") << fails;
  }
  FactorSearch strong, nothing;
  while (strong.next()) strong.take(*strong.next(), answer_of(*strong.next(), 1e3, 0., 0.));
  EXPECT_EQ(*strong.lower(), FactorSearch::largest);
  EXPECT_FALSE(strong.upper());
  while (nothing.next()) nothing.take(*nothing.next(), {});
  EXPECT_FALSE(nothing.lower() || nothing.upper());
  EXPECT_NE(nothing.why(), "");
}

}  // namespace limit_state_test
}  // namespace upbead::test
