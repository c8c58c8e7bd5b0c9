// Claims: cycles of one amplitude follow Byrne's recursion, and with C2 = 0.4/C1 stay near the four constants of
// Martin, Finn and Seed; the count of cycles does not depend on the axes, the volume or the length of steps, and
// small loops within a large one count separately; a point at constant volume loses K eps_v of its mean stress, never
// more than all, and regains it when it is compressed; no path releases energy, and work is the sum of energy stored
// and energy taken.
#include "material/densification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "law_paths.h"
#include "material/hysteretic_law.h"

namespace upbead {
namespace densification_test {

using testing::in_turned_axes;
using testing::random_strain;
using testing::work;

const ShearCompaction medium{0.8, 0.5, 0.};

PlaneStrain shear(double gamma) {
  return {0., 0., 0.5 * gamma};
}

/// Along straight lines from strain to strain, each in `steps` steps.
ShearCycles counted(const std::vector<PlaneStrain>& corners, int steps, const ShearCompaction& law = medium) {
  ShearCycles cycles(law);
  PlaneStrain last;
  for (const PlaneStrain& corner : corners) {
    for (int i = 1; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      cycles.add({last.xx + share * (corner.xx - last.xx), last.yy + share * (corner.yy - last.yy),
                  last.xy + share * (corner.xy - last.xy)});
    }
    last = corner;
  }
  return cycles;
}

std::vector<PlaneStrain> shears(const std::vector<double>& gammas) {
  std::vector<PlaneStrain> corners;
  for (const double gamma : gammas) corners.push_back(shear(gamma));
  return corners;
}

TEST(ShearCycles, OfOneAmplitudeFollowTheRecursion) {
  const double gamma = 2e-3;
  std::vector<double> corners;
  double by_hand = 0.;
  for (int half = 0; half < 60; ++half) {
    corners.push_back(half % 2 == 0 ? gamma : -gamma);
    const double amplitude = half == 0 ? 0.5 * gamma : gamma;  // the first half cycle starts at zero
    by_hand += 0.5 * amplitude * 0.8 * std::exp(-0.5 * by_hand / amplitude);
    EXPECT_NEAR(counted(shears(corners), 7).compaction(), by_hand, 1e-12 * by_hand) << half;
  }
  EXPECT_EQ(counted(shears(corners), 7).reversals(), 59);
  EXPECT_NEAR(counted(shears(corners), 7).largest_amplitude(), gamma, 1e-15);
}

/// Martin, Finn and Seed (1975), their eq. for a cycle and the constants of crystal silica sand at D_r = 45 %, strains
/// in per cent: C1 (gamma - C2 eps) + C3 eps^2/(gamma + C4 eps).
double martin_finn_seed(double gamma, int cycles) {
  double sum = 0.;
  for (int i = 0; i < cycles; ++i) sum += 0.8 * (gamma - 0.79 * sum) + 0.45 * sum * sum / (gamma + 0.73 * sum);
  return sum;
}

TEST(ShearCycles, StayNearTheFourConstantsOfMartinFinnAndSeed) {
  for (const double percent : {0.1, 0.2, 0.3})
    for (const int cycles : {1, 5, 10, 30}) {
      const ShearCompaction law{0.8, 0.4 / 0.8, 0.};
      double sum = 0.;
      for (int half = 0; half < 2 * cycles; ++half) sum += law.of_half_cycle(0.01 * percent, sum);
      EXPECT_NEAR(100. * sum, martin_finn_seed(percent, cycles), 0.15 * martin_finn_seed(percent, cycles))
          << percent << " %, cycles " << cycles;
    }
}

TEST(ShearCycles, KnowNoAxesAndNoVolume) {
  std::mt19937 random(5);
  std::vector<PlaneStrain> path, turned, swollen;
  for (int i = 0; i < 200; ++i) {
    path.push_back(random_strain(random, 1e-3));
    turned.push_back(in_turned_axes(path.back(), 0.7));
    const double volume = random_strain(random, 1e-3).xx;
    swollen.push_back({path.back().xx + volume, path.back().yy + volume, path.back().xy});
  }
  const double found = counted(path, 3).compaction();
  EXPECT_GT(found, 1e-3);
  EXPECT_NEAR(counted(turned, 3).compaction(), found, 1e-12 * found);
  EXPECT_NEAR(counted(swollen, 1).compaction(), counted(path, 1).compaction(), 1e-12 * found);
  EXPECT_EQ(counted({{1e-3, 1e-3, 0.}, {-1e-3, -1e-3, 0.}, {}}, 4).compaction(), 0.);
  EXPECT_EQ(ShearCycles(medium).compaction(), 0.);
}

TEST(ShearCycles, KnowNoLengthOfSteps) {
  const std::vector<PlaneStrain> path = shears({1e-3, -4e-4, 2e-3, 1.5e-3, 1.8e-3, -1e-3, 0.});
  const double coarse = counted(path, 1).compaction();
  for (const int steps : {2, 10, 1000}) EXPECT_NEAR(counted(path, steps).compaction(), coarse, 1e-9 * coarse);
}

TEST(ShearCycles, LoopsOnTheWayCountForThemselvesAndTheWayAsOne) {
  const double way = counted(shears({2e-3}), 1).compaction();
  const double interrupted = counted(shears({1e-3, 0.9e-3, 2e-3}), 20).compaction();
  double loop = way;  // the half cycles of the small loop, at the compaction at which they begin
  const double before = counted(shears({1e-3}), 1).compaction();
  double small = before;
  for (int half = 0; half < 2; ++half) small += medium.of_half_cycle(0.5e-4, small);
  loop += small - before;
  EXPECT_NEAR(interrupted, loop, 1e-12 * loop);
  // tiny reversals within a half cycle neither split it nor add much
  std::vector<double> shivering;
  for (int i = 1; i <= 100; ++i) shivering.insert(shivering.end(), {2e-5 * i, 2e-5 * i - 1e-8});
  EXPECT_NEAR(counted(shears(shivering), 1).compaction(), way, 2e-3 * way);
}

/// A return of less than a thousandth of the half cycle is no reversal (least_return of densification.cc).
TEST(ShearCycles, ReverseAtAReturnOfAThousandth) {
  EXPECT_EQ(counted(shears({1e-3, 0.9991e-3}), 1).reversals(), 0);
  EXPECT_EQ(counted(shears({1e-3, 0.9989e-3}), 1).reversals(), 1);
}

TEST(ShearCycles, ShearThatOnlyTurnsItsDirectionCountsHalfTurns) {
  const double radius = 1e-3;
  ShearCycles cycles(medium);
  for (int i = 0; i <= 3600; ++i) {  // the direction of shear turns five times round
    const double angle = 10. * std::acos(-1.) * i / 3600.;
    cycles.add({0.5 * radius * std::cos(angle), -0.5 * radius * std::cos(angle), 0.5 * radius * std::sin(angle)});
  }
  EXPECT_NEAR(cycles.reversals(), 10, 1);
  double by_hand = medium.of_half_cycle(0.5 * radius, 0.);
  for (int half = 0; half < 10; ++half) by_hand += medium.of_half_cycle(radius, by_hand);
  EXPECT_NEAR(cycles.compaction(), by_hand, 0.02 * by_hand);
}

TEST(ShearCycles, BelowTheThresholdAddNothing) {
  const ShearCompaction law{0.8, 0.5, 1e-4};
  EXPECT_EQ(counted(shears({1e-4, -9e-5, 1e-4, -9e-5}), 5, law).compaction(), 0.);
  const double above = counted(shears({2e-3, -2e-3}), 5, law).compaction();
  EXPECT_NEAR(above, counted(shears({2e-3, -2e-3}), 5).compaction(), 1e-12 * above);
}

const ElasticLaw elastic = elastic_law(50e6, 0.3);
const double bulk = elastic.lambda + 2. / 3. * elastic.G;
constexpr double rest = 100e3;

std::unique_ptr<CompactingPoint> on_overlay(double mean = rest) {
  const auto law = std::make_shared<const HystereticLaw>(
      elastic, backbone(
                   elastic.G, [](double g) { return 1. / (1. + g / 1e-3); }, 1e-5, 3e-2, 8));
  return hysteretic_row.compacting(hysteretic_points(law)(0), elastic, medium, mean);
}

std::unique_ptr<CompactingPoint> on_mohr_coulomb(double cohesion = 0., double tension = 0.) {
  const auto law = std::make_shared<const MohrCoulombLaw>(elastic, MohrCoulombStrength{35., cohesion, 0., tension});
  return mohr_coulomb_row.compacting(mohr_coulomb_points(law, {{-rest, -rest, 0., -rest}})(0), elastic, medium, rest);
}

PlaneStress stress(const SoilPoint& point, const PlaneStrain& strain) {
  PlaneStress correction;
  point.correct(strain, correction);
  return difference(elastic.stress(strain), correction);
}

double commit(SoilPoint& point, const PlaneStrain& strain) {
  double dissipated = 0.;
  point.commit(strain, dissipated);
  return dissipated;
}

double stored(const SoilPoint& point, const PlaneStrain& strain) {
  double energy = 0.;
  point.stored_beside_elastic(strain, energy);
  return energy + 0.5 * work(elastic.stress(strain), strain);
}

double mean_change(const PlaneStress& s) {
  return (s.xx + s.yy + s.zz) / 3.;
}

TEST(CompactingPoint, LosesKTimesTheVolumetricStrainButNeverMoreThanAll) {
  const double gamma = 4e-4;
  for (const bool plastic : {false, true}) {
    const auto point = plastic ? on_mohr_coulomb(1e6, 1e6) : on_overlay();
    for (int half = 0; half < 400; ++half) {
      commit(*point, shear(half % 2 == 0 ? gamma : -gamma));
      const double lost = bulk * point->cycles().compaction();
      EXPECT_NEAR(mean_change(stress(*point, shear(0.))), std::min(lost, rest), 1e-9 * rest) << half;
      EXPECT_NEAR(point->mean(), std::max(rest - lost, 0.), 1e-9 * rest);
    }
    EXPECT_GT(bulk * point->cycles().compaction(), 1.2 * rest);
    EXPECT_NEAR(point->least_mean(), 0., 1e-9 * rest);
    const PlaneStress deviator = stress(*point, shear(0.));
    EXPECT_NEAR(deviator.xx, deviator.zz, 1e-9 * rest) << "isotropic";
  }
}

TEST(CompactingPoint, WhatNoStressWasLeftForIsUsedWhenGrainsPressAgain) {
  const auto point = on_overlay();
  for (int half = 0; half < 400; ++half) commit(*point, shear(half % 2 == 0 ? 4e-4 : -4e-4));
  const double eps = point->cycles().compaction();
  const auto at_volume = [&](double volume) { return stress(*point, {-0.5 * volume, -0.5 * volume, 0.}); };
  EXPECT_NEAR(mean_change(at_volume(eps)), 0., 1e-9 * rest) << "shrunk by all of eps_v it presses as at rest";
  const double half_way = 0.5 * (eps - rest / bulk);
  EXPECT_NEAR(mean_change(at_volume(half_way)), rest, 1e-9 * rest) << "grains do not press yet";
  EXPECT_NEAR(mean_change(at_volume(-1e-3)), rest + bulk * 1e-3 - rest, 1e-9 * rest) << "pulled as without compaction";
}

/// Settlement over eps_v of sand between walls under a constant vertical stress, sheared to and fro.
double settled_share(CompactingPoint& point, double gamma) {
  double settled = 0.;
  for (int half = 0; half < 40; ++half)
    for (int i = 1; i <= 20; ++i) {
      const double way = 0.1 * i - 1.;
      const auto strain = [&] { return PlaneStrain{0., -settled, 0.5 * gamma * (half % 2 == 0 ? way : -way)}; };
      for (int k = 0; k < 60; ++k) settled += stress(point, strain()).yy / elastic.constrained_modulus();
      commit(point, strain());
    }
  return settled / point.cycles().compaction();
}

TEST(CompactingPoint, BetweenWallsSandSettlesByKOverMWhileElasticAndByNearlyAllWhereItYields) {
  const double share = bulk / elastic.constrained_modulus();
  EXPECT_NEAR(settled_share(*on_overlay(1e9), 5e-6), share, 0.01);
  EXPECT_NEAR(settled_share(*on_overlay(1e9), 5e-3), 1., 0.05);
}

TEST(CompactingPoint, MohrCoulombSoilKeepsWithinTheStrengthThatIsLeft) {
  const auto point = on_mohr_coulomb();
  const MohrCoulombLaw law(elastic, {35., 0., 0., 0.});
  double strength = 1e300;
  for (int half = 0; half < 60; ++half) {
    const PlaneStrain strain = shear(half % 2 == 0 ? 2e-3 : -2e-3);
    commit(*point, strain);
    const PlaneStress s = stress(*point, strain);
    EXPECT_LT(law.excess({s.xx - rest, s.yy - rest, s.xy, s.zz - rest}), 1e-6 * rest);
    if (half % 20 == 19) {
      EXPECT_LT(std::abs(s.xy), strength);
      strength = std::abs(s.xy) + 1e-9 * rest;
    }
  }
  EXPECT_LT(strength, 0.1 * rest);
}

/// Along a random path: work of the average stress less the energy stored and the energy taken, over the sum of
/// |work|.
double energy_left(CompactingPoint& point, double size, int steps, double& least) {
  std::mt19937 random(11);
  PlaneStrain last;
  double worked = 0., sum = 0., taken = 0.;
  for (int i = 0; i < steps; ++i) {
    const PlaneStrain more = random_strain(random, size);
    const PlaneStrain next{0.9 * last.xx + more.xx, 0.9 * last.yy + more.yy, 0.9 * last.xy + more.xy};
    const PlaneStrain step{next.xx - last.xx, next.yy - last.yy, next.xy - last.xy};
    const double w = 0.5 * (work(stress(point, last), step) + work(stress(point, next), step));
    const double lost = commit(point, next);
    least = std::min(least, lost);
    worked += w;
    sum += std::abs(w);
    taken += lost;
    last = next;
  }
  EXPECT_LE(point.taken(), taken);
  EXPECT_GT(point.taken(), 0.);
  return std::abs(worked - stored(point, last) - taken) / sum;
}

TEST(CompactingPoint, EnergyClosesAndNothingIsGivenBack) {
  double least = 0.;
  const auto deep = on_overlay(1e9);  // its mean stress never falls to zero
  EXPECT_LT(energy_left(*deep, 2e-4, 2000, least), 1e-11);
  const auto shallow = on_overlay(2e3);
  energy_left(*shallow, 2e-4, 100000, least);
  energy_left(*on_mohr_coulomb(), 2e-4, 100000, least);
  energy_left(*on_mohr_coulomb(20e3), 2e-4, 100000, least);
  EXPECT_GT(least, -1e-12) << "rounding, of some J/m3";
}

}  // namespace densification_test
}  // namespace upbead
