// Claims: points of soil in lanes have the stress, state, lost and stored energy that each has by its SoilPoint,
// along random paths: overlays from rest and from stresses that they bear, of different numbers of elements;
// Mohr-Coulomb on planes, edges and corners; packs that are not full. Where nothing yields they are elastic to the last
// bit. Laws that lanes do not support are computed point by point. No strain within the margin yields.

#include "material/soil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "law_paths.h"
#include "material/hysteretic_law.h"

namespace upbead {
namespace soil_pack_test {

using testing::random_strain;

constexpr std::size_t n_points = 3;
constexpr double G = 60e6;

SoilPoints cell_of(const PointMaker& soil) {
  SoilPoints cell;
  for (unsigned n = 0; n < n_points; ++n) cell.push_back(soil(n));
  return cell;
}

PointMaker overlay(double strength, int n_elements, const PlaneStress& at_rest) {
  const auto ratio = [=](double gamma) { return 1. / (1. + G * gamma / strength); };
  const auto law = std::make_shared<const HystereticLaw>(
      elastic_law(G, 0.3), backbone(G, ratio, 0.01 * strength / G, 30. * strength / G, n_elements));
  return hysteretic_points(law, law->bearing(at_rest));
}

/// At rest one element of the overlay is strained nearly to its limit, the others are not: it slides before those
/// that are weaker.
PointMaker strained_in_one_element() {
  const auto law = std::make_shared<const HystereticLaw>(
      elastic_law(G, 0.3), backbone(
                               G, [](double gamma) { return 1. / (1. + 3e3 * gamma); }, 3e-6, 1e-2, 12));
  std::vector<PlaneStrain> plastic(12);
  const HystereticLaw::Element& element = law->elements()[5];
  plastic[5].xy = -0.9999 * element.y / (2. * element.h);
  return hysteretic_points(law, plastic);
}

PointMaker mohr_coulomb(const MohrCoulombStrength& strength, const PlaneStress& at_rest) {
  return mohr_coulomb_points(std::make_shared<const MohrCoulombLaw>(elastic_law(G, 0.3), strength), {at_rest});
}

/// Strains of all lanes; zero in lanes without a cell.
PackTensor next_strain(std::mt19937& random, const PackTensor& before, int n_cells, double size) {
  PackTensor strain = before;
  for (int lane = 0; lane < n_cells; ++lane) {
    const PlaneStrain more = random_strain(random, size * (1 + lane % 3));
    strain.xx[lane] += more.xx;
    strain.yy[lane] += more.yy;
    strain.xy[lane] += more.xy;
  }
  return strain;
}

/// Largest difference over the largest value.
struct Difference {
  double worst = 0., largest = 0.;
  void add(const detail::Lanes& a, const detail::Lanes& b) {
    for (int lane = 0; lane < detail::lanes; ++lane) {
      worst = std::max(worst, std::abs(a[lane] - b[lane]));
      largest = std::max(largest, std::abs(b[lane]));
      if (!std::isfinite(a[lane])) worst = HUGE_VAL;
    }
  }
  double relative() const { return largest > 0. ? worst / largest : worst; }
};

/// Compares lanes and single points along one random path of every point.
void expect_same(const std::vector<PointMaker>& soils, double size) {
  std::vector<SoilPoints> one, other;
  for (const PointMaker& soil : soils) {
    one.push_back(cell_of(soil));
    other.push_back(cell_of(soil));
  }
  EXPECT_EQ(one[0][0]->in_lanes(one).size(), n_points);
  const int n_cells = static_cast<int>(soils.size());
  const auto packs = side_by_side(std::move(one)), points = side_by_side(std::move(other), true);
  std::mt19937 random(7);
  Difference stress, lost, stored;
  PackTensor strain[n_points];
  PackStress a, b;
  for (PackStress* left_over : {&a, &b}) left_over->xx += 1e9;  // every lane is written, those without a cell too
  for (int step = 0; step < 200; ++step)
    for (std::size_t n = 0; n < n_points; ++n) {
      const PackTensor tried = next_strain(random, strain[n], n_cells, 3. * size);
      packs[n]->correct(tried, a);
      points[n]->correct(tried, b);
      for (const auto part : {&PackStress::xx, &PackStress::yy, &PackStress::xy, &PackStress::zz})
        stress.add(a.*part, b.*part);
      strain[n] = next_strain(random, strain[n], n_cells, size);
      detail::Lanes lost_a{}, lost_b{}, stored_a{}, stored_b{};
      packs[n]->commit(strain[n], lost_a);
      points[n]->commit(strain[n], lost_b);
      lost.add(lost_a, lost_b);
      packs[n]->stored_beside_elastic(strain[n], stored_a);
      points[n]->stored_beside_elastic(strain[n], stored_b);
      stored.add(stored_a, stored_b);
    }
  EXPECT_LT(stress.relative(), 1e-11);
  EXPECT_LT(lost.relative(), 1e-10);
  EXPECT_LT(stored.relative(), 1e-10);
  EXPECT_GT(lost.largest, 0.);
}

TEST(SoilPack, OverlaysFromRestAndFromWhatTheyBear) {
  const PlaneStress bears{-20e3, -50e3, 6e3, -20e3};
  expect_same(std::vector<PointMaker>(8, overlay(20e3, 12, {})), 1e-4);
  expect_same(std::vector<PointMaker>(8, overlay(20e3, 12, bears)), 1e-4);
  std::vector<PointMaker> mixed;
  for (int i = 0; i < 5; ++i) mixed.push_back(overlay(10e3 * (1 + i), 4 + 3 * i, i % 2 ? bears : PlaneStress{}));
  expect_same(mixed, 3e-5);
  expect_same({overlay(20e3, 12, bears)}, 1e-3);
}

TEST(SoilPack, OverlaysOfAnyStateAtRest) {
  expect_same(std::vector<PointMaker>(3, strained_in_one_element()), 2e-7);
}

TEST(SoilPack, MohrCoulombOnPlanesEdgesAndCorners) {
  std::vector<PointMaker> soils;
  for (int i = 0; i < 7; ++i) {
    const double phi = 6. * i;
    soils.push_back(
        mohr_coulomb({phi, i % 2 ? 20e3 : 2e3, i % 3 ? 0. : 0.5 * phi, i % 2 ? 4e3 : 0.}, {-40e3, -80e3, 5e3, -45e3}));
  }
  expect_same(soils, 2e-4);
  expect_same(soils, 2e-5);
  expect_same({mohr_coulomb({35., 0., 0., 0.}, {})}, 1e-4);
}

/// Soil that can be pulled up to its apex: all three principal stresses lie near the strength, of either sign.
TEST(SoilPack, MohrCoulombUnderTension) {
  const std::vector<PointMaker> soils{mohr_coulomb({30., 100e3, 0., 1e9}, {}), mohr_coulomb({30., 100e3, 30., 1e9}, {}),
                                      mohr_coulomb({10., 50e3, 5., 1e9}, {40e3, 10e3, 5e3, 20e3})};
  expect_same(soils, 3e-4);
  expect_same(soils, 2e-3);
}

/// The soil is nearly incompressible, where a change of strain changes the stress most.
TEST(SoilPack, NoStrainWithinTheMarginYields) {
  const ElasticLaw elastic = elastic_law(G, 0.47);
  const auto law = std::make_shared<const MohrCoulombLaw>(elastic, MohrCoulombStrength{30., 5e3, 0., 1e9});
  std::vector<SoilPoints> cells(1);
  cells[0].push_back(mohr_coulomb_points(law, {{-50e3, -50e3, 0., -50e3}})(0));
  const auto packs = side_by_side(std::move(cells));
  const SoilPack& pack = *packs[0];
  detail::Lanes margin{};
  pack.margin({}, margin);
  ASSERT_GT(margin[0], 0.);
  const auto yields = [&](const PlaneStrain& direction, double length) {
    const double norm = std::sqrt(testing::work({direction.xx, direction.yy, direction.xy}, direction));
    PackTensor strain;
    strain.xx[0] = direction.xx * length / norm;
    strain.yy[0] = direction.yy * length / norm;
    strain.xy[0] = direction.xy * length / norm;
    PackStress c;
    pack.correct(strain, c);
    return c.xx[0] != 0. || c.yy[0] != 0. || c.xy[0] != 0. || c.zz[0] != 0.;
  };
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(yields(random_strain(random, 1.), margin[0]));
  EXPECT_TRUE(yields({1., 1., 0.}, 4.2 * margin[0])) << "the margin is a quarter of the least strain that yields";
}

TEST(SoilPack, IsElasticToTheLastBitBelowYield) {
  const auto zero = [](const detail::Lanes& a) {
    for (int lane = 0; lane < detail::lanes; ++lane) EXPECT_EQ(a[lane], 0.);
  };
  std::mt19937 random(3);
  for (const PointMaker& soil : {overlay(20e3, 12, {}), mohr_coulomb({30., 5e3, 0., 0.}, {-4e4, -8e4, 3e3, -5e4})}) {
    std::vector<SoilPoints> cells(4);
    for (SoilPoints& cell : cells) cell = cell_of(soil);
    const auto packs = side_by_side(std::move(cells));
    for (int i = 0; i < 50; ++i) {
      const PackTensor strain = next_strain(random, {}, 4, 1e-7);
      PackStress c;
      detail::Lanes lost{}, stored{};
      packs[0]->correct(strain, c);
      packs[0]->commit(strain, lost);
      packs[0]->stored_beside_elastic(strain, stored);
      for (const detail::Lanes& value : {c.xx, c.yy, c.xy, c.zz, lost, stored}) zero(value);
    }
  }
}

/// Soil of half the stiffness, by a law that lanes do not support.
class HalfElastic : public SoilPoint {
 public:
  void correct(const PlaneStrain& strain, PlaneStress& c) const override {
    c = elastic_law(0.5 * G, 0.3).stress(strain);
  }
  void commit(const PlaneStrain&, double& dissipated) override { dissipated += 2.; }
  void stored_beside_elastic(const PlaneStrain&, double& energy) const override { energy = 3.; }
  double mobilised(int, const PlaneStress&) const override { return 0.5; }
};

TEST(SoilPack, LeavesOtherSoilToItsPoints) {
  std::vector<SoilPoints> cells;
  cells.push_back(cell_of([](unsigned) { return std::make_unique<HalfElastic>(); }));
  cells.push_back(cell_of(overlay(20e3, 12, {})));
  cells.back()[1] = overlay(20e3, 12, {})(1);  // differs from the law of the other points
  EXPECT_TRUE(cells[0][0]->in_lanes(cells).empty());
  EXPECT_TRUE(cells[1][0]->in_lanes(cells).empty());
  const auto packs = side_by_side(std::move(cells));
  PackTensor strain;
  strain.xy[0] = 1e-4;
  PackStress c;
  packs[0]->correct(strain, c);
  EXPECT_NEAR(c.xy[0], G * 1e-4, 1e-9 * G * 1e-4);
  EXPECT_EQ(c.xy[1], 0.);
  detail::Lanes lost{};
  packs[0]->commit(strain, lost);
  EXPECT_EQ(lost[0], 2.);
}

}  // namespace soil_pack_test
}  // namespace upbead
