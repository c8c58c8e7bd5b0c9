// Claims: points of soil in lanes have the stress, state, lost and stored energy that each has by its SoilPoint,
// along random paths: overlays from rest and from stresses that they bear, of different numbers of elements;
// Mohr-Coulomb on planes, edges and corners; packs that are not full; an elastic D other than the law's. Where
// nothing yields they are elastic to the last bit. Laws that lanes do not support are computed point by point. No
// strain within the margin yields.

#include "material/soil_pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "law_paths.h"

namespace upbead {
namespace soil_pack_test {

using testing::random_strain;

constexpr int n_points = 3;
constexpr double G = 60e6;

using Soil = std::function<std::unique_ptr<SoilPoint>()>;

PackedCell cell_of(const ElasticLaw& elastic, const Soil& soil) {
  PackedCell cell{elastic, {}};
  for (int n = 0; n < n_points; ++n) cell.points.push_back(soil());
  return cell;
}

Soil overlay(double strength, int n_elements, const PlaneStress& at_rest, double stiffness = G) {
  const ElasticLaw elastic = elastic_law(stiffness, 0.3);
  const auto ratio = [=](double gamma) { return 1. / (1. + stiffness * gamma / strength); };
  const auto law = std::make_shared<const HystereticLaw>(
      elastic, backbone(stiffness, ratio, 0.01 * strength / stiffness, 30. * strength / stiffness, n_elements));
  const HystereticLaw::State state = law->bearing(at_rest);
  return [=] { return soil_point(law, state); };
}

/// At rest one element of the overlay is strained nearly to its limit, the others are not: it slides before those
/// that are weaker.
Soil strained_in_one_element() {
  const ElasticLaw elastic = elastic_law(G, 0.3);
  const auto law = std::make_shared<const HystereticLaw>(
      elastic, backbone(
                   G, [](double gamma) { return 1. / (1. + 3e3 * gamma); }, 3e-6, 1e-2, 12));
  HystereticLaw::State state = law->at_rest();
  const HystereticLaw::Element& element = law->elements()[5];
  state.plastic[5].xy = -0.9999 * element.y / (2. * element.h);
  return [=] { return soil_point(law, state); };
}

Soil mohr_coulomb(const MohrCoulombStrength& strength, const PlaneStress& at_rest) {
  const auto law = std::make_shared<const MohrCoulombLaw>(elastic_law(G, 0.3), strength);
  return [=] { return soil_point(law, at_rest); };
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
void expect_same(PackKind kind, const std::vector<Soil>& soils, double size, double stiffness = G) {
  const ElasticLaw elastic = elastic_law(stiffness, 0.3);
  std::vector<PackedCell> one, other;
  for (const Soil& soil : soils) {
    one.push_back(cell_of(elastic, soil));
    other.push_back(cell_of(elastic, soil));
    EXPECT_EQ(pack_kind(one.back()), kind);
  }
  const int n_cells = static_cast<int>(soils.size());
  const auto pack = soil_pack(kind, std::move(one)), points = soil_pack(PackKind::points, std::move(other));
  std::mt19937 random(7);
  Difference stress, lost, stored;
  PackTensor strain[n_points];
  PackStress a, b;
  for (PackStress* left_over : {&a, &b}) left_over->xx += 1e9;  // every lane is written, those without a cell too
  for (int step = 0; step < 200; ++step)
    for (int n = 0; n < n_points; ++n) {
      const PackTensor tried = next_strain(random, strain[n], n_cells, 3. * size);
      pack->correct(n, tried, a);
      points->correct(n, tried, b);
      for (const auto part : {&PackStress::xx, &PackStress::yy, &PackStress::xy, &PackStress::zz})
        stress.add(a.*part, b.*part);
      strain[n] = next_strain(random, strain[n], n_cells, size);
      detail::Lanes lost_a{}, lost_b{}, stored_a{}, stored_b{};
      pack->commit(n, strain[n], lost_a);
      points->commit(n, strain[n], lost_b);
      lost.add(lost_a, lost_b);
      pack->stored_beside_elastic(n, strain[n], stored_a);
      points->stored_beside_elastic(n, strain[n], stored_b);
      stored.add(stored_a, stored_b);
    }
  EXPECT_LT(stress.relative(), 1e-11);
  EXPECT_LT(lost.relative(), 1e-10);
  EXPECT_LT(stored.relative(), 1e-10);
  EXPECT_GT(lost.largest, 0.);
}

TEST(SoilPack, OverlaysFromRestAndFromWhatTheyBear) {
  const PlaneStress bears{-20e3, -50e3, 6e3, -20e3};
  expect_same(PackKind::hysteretic, std::vector<Soil>(8, overlay(20e3, 12, {})), 1e-4);
  expect_same(PackKind::hysteretic, std::vector<Soil>(8, overlay(20e3, 12, bears)), 1e-4);
  std::vector<Soil> mixed;
  for (int i = 0; i < 5; ++i) mixed.push_back(overlay(10e3 * (1 + i), 4 + 3 * i, i % 2 ? bears : PlaneStress{}));
  expect_same(PackKind::hysteretic, mixed, 3e-5);
  expect_same(PackKind::hysteretic, {overlay(20e3, 12, bears)}, 1e-3);
}

TEST(SoilPack, OverlaysOfAnyStateAtRest) {
  expect_same(PackKind::hysteretic, std::vector<Soil>(3, strained_in_one_element()), 2e-7);
}

TEST(SoilPack, MohrCoulombOnPlanesEdgesAndCorners) {
  std::vector<Soil> soils;
  for (int i = 0; i < 7; ++i) {
    const double phi = 6. * i;
    soils.push_back(
        mohr_coulomb({phi, i % 2 ? 20e3 : 2e3, i % 3 ? 0. : 0.5 * phi, i % 2 ? 4e3 : 0.}, {-40e3, -80e3, 5e3, -45e3}));
  }
  expect_same(PackKind::mohr_coulomb, soils, 2e-4);
  expect_same(PackKind::mohr_coulomb, soils, 2e-5);
  expect_same(PackKind::mohr_coulomb, {mohr_coulomb({35., 0., 0., 0.}, {})}, 1e-4);
}

/// Soil that can be pulled up to its apex: all three principal stresses lie near the strength, of either sign.
TEST(SoilPack, MohrCoulombUnderTension) {
  const std::vector<Soil> soils{mohr_coulomb({30., 100e3, 0., 1e9}, {}), mohr_coulomb({30., 100e3, 30., 1e9}, {}),
                                mohr_coulomb({10., 50e3, 5., 1e9}, {40e3, 10e3, 5e3, 20e3})};
  expect_same(PackKind::mohr_coulomb, soils, 3e-4);
  expect_same(PackKind::mohr_coulomb, soils, 2e-3);
}

/// The soil is nearly incompressible, where a change of strain changes the stress most.
TEST(SoilPack, NoStrainWithinTheMarginYields) {
  const ElasticLaw elastic = elastic_law(G, 0.47);
  const auto law = std::make_shared<const MohrCoulombLaw>(elastic, MohrCoulombStrength{30., 5e3, 0., 1e9});
  PackedCell cell{elastic, {}};
  cell.points.push_back(soil_point(law, PlaneStress{-50e3, -50e3, 0., -50e3}));
  std::vector<PackedCell> cells;
  cells.push_back(std::move(cell));
  const auto pack = soil_pack(PackKind::mohr_coulomb, std::move(cells));
  detail::Lanes margin{};
  pack->margin(0, {}, margin);
  ASSERT_GT(margin[0], 0.);
  const auto yields = [&](const PlaneStrain& direction, double length) {
    const double norm = std::sqrt(testing::work({direction.xx, direction.yy, direction.xy}, direction));
    PackTensor strain;
    strain.xx[0] = direction.xx * length / norm;
    strain.yy[0] = direction.yy * length / norm;
    strain.xy[0] = direction.xy * length / norm;
    PackStress c;
    pack->correct(0, strain, c);
    return c.xx[0] != 0. || c.yy[0] != 0. || c.xy[0] != 0. || c.zz[0] != 0.;
  };
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(yields(random_strain(random, 1.), margin[0]));
  EXPECT_TRUE(yields({1., 1., 0.}, 4.2 * margin[0])) << "the margin is a quarter of the least strain that yields";
}

TEST(SoilPack, AnotherElasticLawThanTheSoilsOwn) {
  expect_same(PackKind::hysteretic, std::vector<Soil>(3, overlay(20e3, 12, {-20e3, -50e3, 0., -20e3}, 0.5 * G)), 1e-4);
  expect_same(PackKind::mohr_coulomb, std::vector<Soil>(3, mohr_coulomb({30., 5e3, 0., 0.}, {-4e4, -8e4, 0., -5e4})),
              1e-4, 2. * G);
}

TEST(SoilPack, IsElasticToTheLastBitBelowYield) {
  const auto zero = [](const detail::Lanes& a) {
    for (int lane = 0; lane < detail::lanes; ++lane) EXPECT_EQ(a[lane], 0.);
  };
  std::mt19937 random(3);
  for (const Soil& soil : {overlay(20e3, 12, {}), mohr_coulomb({30., 5e3, 0., 0.}, {-4e4, -8e4, 3e3, -5e4})}) {
    std::vector<PackedCell> cells(4);
    for (PackedCell& cell : cells) cell = cell_of(elastic_law(G, 0.3), soil);
    const PackKind kind = pack_kind(cells.front());
    const auto pack = soil_pack(kind, std::move(cells));
    for (int i = 0; i < 50; ++i) {
      const PackTensor strain = next_strain(random, {}, 4, 1e-7);
      PackStress c;
      detail::Lanes lost{}, stored{};
      pack->correct(0, strain, c);
      pack->commit(0, strain, lost);
      pack->stored_beside_elastic(0, strain, stored);
      for (const detail::Lanes& value : {c.xx, c.yy, c.xy, c.zz, lost, stored}) zero(value);
    }
  }
}

/// Soil of half the stiffness, by a law that lanes do not support.
class HalfElastic : public SoilPoint {
 public:
  PlaneStress stress(const PlaneStrain& strain) override { return elastic_law(0.5 * G, 0.3).stress(strain); }
  double commit(const PlaneStrain&) override { return 2.; }
  double stored() const override { return 3.; }
  double mobilised(const PlaneStress&) const override { return 0.5; }
};

TEST(SoilPack, LeavesOtherSoilToItsPoints) {
  std::vector<PackedCell> cells;
  cells.push_back(cell_of(elastic_law(G, 0.3), [] { return std::make_unique<HalfElastic>(); }));
  cells.push_back(cell_of(elastic_law(G, 0.3), overlay(20e3, 12, {})));
  cells.back().points[1] = overlay(20e3, 12, {})();  // differs from the law of the other points
  for (const PackedCell& cell : cells) EXPECT_EQ(pack_kind(cell), PackKind::points);
  const auto pack = soil_pack(PackKind::points, std::move(cells));
  PackTensor strain;
  strain.xy[0] = 1e-4;
  PackStress c;
  pack->correct(0, strain, c);
  EXPECT_NEAR(c.xy[0], G * 1e-4, 1e-9 * G * 1e-4);
  EXPECT_EQ(c.xy[1], 0.);
  detail::Lanes lost{};
  pack->commit(0, strain, lost);
  EXPECT_EQ(lost[0], 2.);
}

}  // namespace soil_pack_test
}  // namespace upbead
