// Claim: waves have Goda's p_e and safety factors at the bottom; the worst value of a life is that of all its waves,
// however few of them are computed; the law dynamic uses N and M of the model together with U(t).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "caissons.h"
#include "expected/dynamic_law.h"
#include "upbead/expected/life.h"

namespace upbead::test {

namespace {

/// W' acts seaward or landward of the middle by an eighth of the width, or in the middle.
Breakwater leaning(double eighths) {
  Breakwater caisson = medium_caisson();
  caisson.section.centroid = (0.5 - 0.125 * eighths) * caisson.section.width;
  return caisson;
}

LifeSetup one_storm(double significant_height) {
  LifeSetup s;
  s.states = {storm(significant_height)};
  s.record_years = s.life_years = 1.;
  s.law = [](const SeaState& sea) { return formula_law(Law::exact, medium_caisson(), sea); };
  return s;
}

Distribution scatter_of(double cov, Per per) {
  Scatter s;
  s.cov = cov;
  s.low = 0.2;
  s.per = per;
  return {s, 1.};
}

std::vector<double> heel_pressures(const LifeSetup& setup, std::uint32_t lives) {
  const LifeSimulation simulation(setup);
  std::vector<double> list;
  for (std::uint32_t i = 0; i < lives; ++i) list.push_back(simulation.life(i).base->heel_pressure);
  return list;
}

}  // namespace

TEST(WaveBase, IsGodasHeelPressureAndSafetyFactor) {
  for (const double eighths : {-0.5, 0., 0.5})
    for (const double H : {0.5, 3., 5., 7., 9.}) {
      const WaveForces forces(leaning(eighths), storm(6.));
      const Section& s = forces.breakwater().section;
      const WavePressure p = forces.at(H, {});
      const Stability goda = stability(s, p);
      const WorstBase base = forces.base(H, {});
      const double W = s.submerged_weight, e_0 = eighths / 8. * s.width;
      const double at_rest = edge_pressures(W, W * e_0, s.width).landward.value();
      EXPECT_NEAR(base.heel_pressure, std::max(above_all(goda.heel_pressure), at_rest),
                  1e-12 * above_all(goda.heel_pressure))
          << H;
      EXPECT_NEAR(base.overturning_margin, goda.safety_overturning, 1e-12 * goda.safety_overturning) << H;
      const double M_U = p.uplift_moment - 0.5 * p.uplift * s.width;
      const WorstBase same = worst_of(base_extremes(
          {s.width, W, W * e_0, 0., 0., {p.uplift}, {M_U}, {W - p.uplift}, {W * e_0 + M_U + p.force_moment}}, {0.}));
      EXPECT_NEAR(base.heel_pressure, same.heel_pressure, 1e-12 * same.heel_pressure) << H;
      EXPECT_NEAR(base.toe_pressure, same.toe_pressure, 1e-12 * same.toe_pressure) << H;
      EXPECT_NEAR(base.eccentricity, same.eccentricity, 1e-12) << H;
    }
}

TEST(WaveBase, FactorsReachTheMoments) {
  const WaveForces forces(medium_caisson(), storm(6.));
  const WavePressure p = forces.at(9., {});
  const WavePressure q = forces.at(9., {1.2, 0.7, 1., 1.});
  EXPECT_DOUBLE_EQ(q.force_moment, 1.2 * p.force_moment);
  EXPECT_DOUBLE_EQ(q.uplift_moment, 0.7 * p.uplift_moment);
}

TEST(WaveBase, AResultantBesideTheBaseHasNoPressure) {
  const WaveForces forces(medium_caisson(), storm(6.));
  EXPECT_EQ(forces.base(9., {10., 1., 1., 1.}).heel_pressure, WorstBase::leaves);
  EXPECT_LT(forces.base(9., {10., 1., 1., 1.}).overturning_margin, 1.);
}

TEST(WaveBase, ALifeOfEqualWavesHasTheirs) {
  LifeSetup s = one_storm(200.);
  s.limit = [](const SeaState&) { return 7.5; };
  const WorstBase one = WaveForces(medium_caisson(), storm(200.)).base(7.5, {});
  for (const bool every : {false, true}) {
    s.every_wave = every;
    const Life life = LifeSimulation(s).life(3);
    EXPECT_EQ(life.base->heel_pressure, one.heel_pressure);
    EXPECT_EQ(life.base->overturning_margin, one.overturning_margin);
    EXPECT_EQ(life.base->eccentricity, one.eccentricity);
    EXPECT_EQ(life.most_tilting.height, 7.5);
  }
}

/// The highest of N waves stays below H in (1 - p(H))^N of the lives.
TEST(WaveBase, TheWorstOfALifeIsThatOfItsHighestWave) {
  const std::uint32_t n = 4000;
  for (const double significant_height : {3., 4.5})  // without and with sliding
    for (const double share : {0.1, 0.5, 0.9}) {
      const double H = RayleighHeights(significant_height).height(-std::expm1(std::log(share) / 600.));
      const double pressure = WaveForces(medium_caisson(), storm(significant_height)).base(H, {}).heel_pressure;
      for (const bool every : {false, true}) {
        LifeSetup s = one_storm(significant_height);
        s.every_wave = every;
        const std::vector<double> found = heel_pressures(s, every ? n / 4 : n);
        const auto lower = std::count_if(found.begin(), found.end(), [&](double p) { return p <= pressure; });
        const auto all = static_cast<double>(found.size());
        EXPECT_NEAR(static_cast<double>(lower) / all, share, 4. * std::sqrt(share * (1. - share) / all)) << every;
      }
    }
}

/// If the weight varies from wave to wave, even by 1e-13, every wave is computed.
TEST(WaveBase, WavesThatCannotBeWorseAreSkippedRightly) {
  LifeSetup s = one_storm(3.);
  s.uncertain.force = scatter_of(0.2, Per::wave);
  s.uncertain.uplift = scatter_of(0.3, Per::wave);
  LifeSetup all = s;
  all.uncertain.weight = scatter_of(1e-13, Per::wave);
  const std::vector<double> some = heel_pressures(s, 200), every = heel_pressures(all, 200);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_NEAR(some[i], every[i], 1e-9 * every[i]);
}

namespace {

/// A rigid caisson on rigid ground: F_T = P, N = 0.1 P, M = 4 m P.
ShearModel rigid(bool with_base) {
  ShearModel model;
  model.modes.pole = Eigen::VectorXcd::Constant(1, {-100., 100.});
  model.modes.load = Eigen::MatrixXcd::Constant(1, 1, 1.);
  model.modes.reading = Eigen::MatrixXcd::Zero(5, 1);
  model.modes.feedthrough = model.modes.impulse = Eigen::MatrixXd::Zero(5, 1);
  model.modes.feedthrough.col(0) << 1., 0.1, 4., 0., 0.;
  model.modes.load_name = {"impact"};
  for (const char* name : {"shear_force", "normal_force", "base_moment", "uplift", "uplift_moment"})
    model.modes.reading_label.push_back({name, "", ""});
  model.caisson_mass = medium_caisson().section.weight / 9.81;
  if (with_base) model.base = {1, 2, 3, 4};
  return model;
}

DynamicLaw law_of(const ShearModel& model) {
  ImpactAssumptions assumptions;
  assumptions.uplift = ImpactUplift::in_phase;
  return {medium_caisson(), storm(6.), assumptions, std::make_shared<const ShearAnswer>(model, 2e-3, 10.)};
}

}  // namespace

TEST(WaveBase, OwnDynamicsOfARigidCaissonAreStatics) {
  const DynamicLaw law = law_of(rigid(true));
  const DynamicWave wave = law.wave(8.);
  const Section s = medium_caisson().section;
  const double P = *std::max_element(wave.force.begin(), wave.force.end());
  const double U = wave.wave.uplift * P / std::max(wave.wave.peak, wave.wave.reduction * wave.wave.standing_force);
  const double N = s.submerged_weight + 0.1 * P - U, M = 4. * P + U * s.width / 6.;
  ASSERT_LT(M, 0.5 * s.width * N);
  const double heel = edge_pressures(N, M, s.width).landward.value();
  EXPECT_NEAR(law.base(8.)->heel_pressure, heel, 1e-9 * heel);
  EXPECT_NEAR(law.base(8.)->eccentricity, M / N, 1e-9);
  EXPECT_NEAR(law.base(8.)->toe_pressure, s.submerged_weight / s.width, 1e-6) << "at rest";
}

/// N'/B - 6 |M'|/(1.26 B^2), as a run tells it.
TEST(WaveBase, TheStressOfABondedEdgeIsToldInMotion) {
  const DynamicLaw law = law_of(rigid(true));
  const Section s = medium_caisson().section;
  const WorstBase low = *law.base(1.), high = *law.base(8.);
  EXPECT_GT(low.edge_stress, 0.);
  EXPECT_LT(low.edge_stress, s.submerged_weight / s.width);
  EXPECT_LT(high.edge_stress, low.edge_stress);
  EXPECT_EQ(worst_of(low, high).edge_stress, high.edge_stress);
}

TEST(WaveBase, AModelWithoutReadingsOfTheBaseTellsNothing) {
  EXPECT_FALSE(law_of(rigid(false)).base(8.));
}

}  // namespace upbead::test
