// Claims: the standing wave of finite height satisfies the full equations; it has the frequencies and shapes of
// published expansions, and conserves mass, momentum and energy; small waves tend to linear waves; its pressures on a
// wall are given by pressures at heights without loss.

#include "upbead/waves/standing_wave.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "sections.h"
#include "upbead/base/error.h"
#include "upbead/waves/wave_heights.h"

namespace upbead {
namespace standing_wave_test {

constexpr double pi = 3.14159265358979323846;
const Water water{1000., 9.81};

/// T of a small wave of kh.
double period_of(double kh, double depth) {
  return 2. * pi / std::sqrt(water.gravity * kh / depth * std::tanh(kh));
}

/// In water of 10 m, by kh of the small wave and the height over the depth.
StandingWave wave_of(double kh, double height_over_depth) {
  return StandingWave({10., 10. * height_over_depth, period_of(kh, 10.)}, water);
}

/// Coefficient of cos(i tau) cos(j x) in k eta.
double harmonic(const StandingWave& wave, int i, int j) {
  constexpr int n = 64;
  double sum = 0.;
  for (int m = 0; m < n; ++m)
    for (int l = 0; l < n; ++l)
      sum += wave.surface(wave.period() * m / n, wave.wavelength() * l / n) * std::cos(2. * pi * i * m / n) *
             std::cos(2. * pi * j * l / n);
  return sum * (i > 0 ? 2. : 1.) * (j > 0 ? 2. : 1.) / (n * n) * 2. * pi / wave.wavelength();
}

/// Integral over half a wavelength.
template <class F>
double over_length(const StandingWave& wave, const F& f) {
  return boost::math::quadrature::gauss<double, 60>::integrate(f, 0., 0.5 * wave.wavelength());
}

TEST(StandingWave, HasTheFrequencyOfTadjbakhshAndKeller) {
  // J. Fluid Mech. 8 (1960) 442-451: omega/sqrt(g k) = w0 + (k H)^2/2 w2 + O(4), w0 = sqrt(tanh kh)
  for (const double kh : {0.6, 0.9, 1.5, 4., 50.}) {
    const auto left = [&](double steepness) {
      const StandingWave wave = wave_of(kh, steepness / kh);
      const double K = 2. * pi * 10. / wave.wavelength(), w0 = std::sqrt(std::tanh(K));
      const double w2 = (9. * std::pow(w0, -7) - 12. * std::pow(w0, -3) - 3. * w0 - 2. * std::pow(w0, 5)) / 32.;
      const double kH = K * steepness / kh, omega = 2. * pi / wave.period() / std::sqrt(water.gravity * K / 10.);
      return std::pair(omega - w0, 0.5 * kH * kH * w2);
    };
    const auto [change, expected] = left(0.02);
    EXPECT_NEAR(change / expected, 1., 0.02) << "kh " << kh;
    const auto [smaller, expected_smaller] = left(0.01);
    EXPECT_NEAR((change / expected - 1.) / (smaller / expected_smaller - 1.), 4., 0.1) << "kh " << kh;
  }
}

TEST(StandingWave, NeitherSlowsNorHastensAtTheDepthOfTadjbakhshAndKeller) {
  // w2 changes its sign at kh = 1.058
  const auto longer = [](double kh) { return 2. * pi * 10. / wave_of(kh, 0.02).wavelength() / kh - 1.; };
  EXPECT_LT(longer(1.03), 0.);
  EXPECT_GT(longer(1.09), 0.);
  EXPECT_LT(std::abs(longer(1.058)), 0.02 * longer(1.09));
}

TEST(StandingWave, HasTheShapeOfPenneyAndPriceInDeepWater) {
  // Phil. Trans. A 244 (1952) 254-284: omega^2 = g k (1 - A^2/4 - 13 A^4/128), and the surface to the third order in A
  const StandingWave wave = wave_of(40., 0.1 / 40.);
  const double k = 2. * pi / wave.wavelength();
  const double w2 = std::pow(2. * pi / wave.period(), 2) / (water.gravity * k);
  const double A = std::sqrt((-0.25 + std::sqrt(0.0625 + 4. * 13. / 128. * (1. - w2))) / (2. * 13. / 128.));
  const double A2 = A * A, A3 = A * A2, within = 3. * A2;
  EXPECT_NEAR((harmonic(wave, 1, 1) - A) / A3, 3. / 32., within * 3. / 32.);
  EXPECT_NEAR(harmonic(wave, 0, 2) / A2, 1. / 4., within / 4.);
  EXPECT_NEAR(harmonic(wave, 2, 2) / A2, 1. / 4., within / 4.);
  EXPECT_NEAR(harmonic(wave, 1, 3) / A3, 9. / 32., within * 9. / 32.);
  EXPECT_NEAR(harmonic(wave, 3, 3) / A3, 3. / 32., 2. * within * 3. / 32.);
  EXPECT_NEAR(harmonic(wave, 3, 1) / A3, -1. / 16., within / 16.);
}

TEST(StandingWave, RisesAboveStillWaterAsMicheSays) {
  // Ann. Ponts Chaussees 114 (1944), second order: crest and trough are higher than +-H by delta_0
  for (const double kh : {0.7, 1.2, 3.}) {
    const double H = 0.01 * 10.;
    const StandingWave wave = wave_of(kh, 0.01);
    const double K = 2. * pi * 10. / wave.wavelength(), s2 = std::pow(std::sinh(K), 2), c2 = std::pow(std::cosh(K), 2);
    const double delta = pi * H * H / wave.wavelength() / std::tanh(K) * (1. + 3. / (4. * s2) - 1. / (4. * c2));
    EXPECT_NEAR(0.5 * (wave.surface(0.) + wave.surface(0.5 * wave.period())) / delta, 1., 5e-3) << "kh " << kh;
    EXPECT_NEAR(wave.surface(0.) - wave.surface(0.5 * wave.period()), 2. * H, 1e-10);
  }
}

TEST(StandingWave, BecomesTheLinearOne) {
  const StandingWave wave = wave_of(1.2, 1e-5);
  const double H = 1e-4, k = 0.12, rho_g = water.density * water.gravity;
  EXPECT_NEAR(wave.wavelength() * k / (2. * pi), 1., 1e-9);
  for (const double t : {0., 0.1, 0.3, 0.5})
    for (const double y : {-10., -6., -1.}) {
      const double linear = rho_g * H * std::cosh(k * (y + 10.)) / std::cosh(1.2) * std::cos(2. * pi * t);
      EXPECT_NEAR(wave.pressure(y, t * wave.period()), linear, 3e-5 * rho_g * H) << "y " << y << ", t/T " << t;
    }
}

/// Waves (kh, H/h) of practical design: shallow and deep, low and steep.
const std::vector<std::pair<double, double>> waves{{0.5, 0.3}, {0.7, 0.45}, {1.06, 0.4}, {2., 0.25}, {6., 0.08}};

TEST(StandingWave, MeetsBothConditionsAtTheSurface) {
  for (const auto& [kh, height] : waves) {
    const StandingWave wave = wave_of(kh, height);
    EXPECT_LT(wave.residual(), 1e-3) << "kh " << kh;
    const double rho_gH = water.density * water.gravity * 10. * height;
    for (const double t : {0.03, 0.17, 0.31, 0.44})
      for (const double x : {0.01, 0.11, 0.26, 0.37, 0.49}) {
        const double eta = wave.surface(t * wave.period(), x * wave.wavelength());
        const double still = water.density * water.gravity * std::max(-eta, 0.);
        const double just_below = wave.pressure(eta - 1e-9, t * wave.period(), x * wave.wavelength()) + still;
        EXPECT_NEAR(just_below / rho_gH, 0., 2e-3) << "kh " << kh << ", t/T " << t << ", x/L " << x;
      }
  }
}

TEST(StandingWave, KeepsItsVolume) {
  for (const auto& [kh, height] : waves) {
    const StandingWave wave = wave_of(kh, height);
    for (const double t : {0., 0.1, 0.25, 0.4})
      EXPECT_NEAR(over_length(wave, [&](double x) { return wave.surface(t * wave.period(), x); }) /
                      (10. * height * wave.wavelength()),
                  0., 1e-12);
  }
}

TEST(StandingWave, PressesTheBedAsItsCentreOfGravityMoves) {
  // Longuet-Higgins, Phil. Trans. A 243 (1950): the mean pressure on the bed exceeds that of still water by rho
  // d2/dt2 of the mean of eta^2/2
  for (const auto& [kh, height] : waves) {
    const StandingWave wave = wave_of(kh, height);
    const double T = wave.period(), dt = 2e-3 * T;
    const auto lift = [&](double t) {
      return over_length(wave, [&](double x) { return 0.5 * std::pow(wave.surface(t, x), 2); });
    };
    const double scale = water.density * std::pow(2. * pi / T, 2) * lift(0.);
    for (const double t : {0., 0.13 * T, 0.25 * T, 0.41 * T}) {
      const double push = over_length(wave, [&](double x) { return wave.pressure(-10., t, x); });
      // differences of the fourth order
      const double expected =
          water.density *
          (16. * (lift(t + dt) + lift(t - dt)) - lift(t + 2. * dt) - lift(t - 2. * dt) - 30. * lift(t)) /
          (12. * dt * dt);
      EXPECT_NEAR((push - expected) / scale, 0., 2e-3) << "kh " << kh << ", t/T " << t / T;
    }
  }
}

TEST(StandingWave, IsTheSameInTheModelAsInThePrototype) {
  const StandingWave prototype({12., 3., 9.}, water), model({12. / 20., 3. / 20., 9. / std::sqrt(20.)}, water);
  for (const double t : {0., 0.2, 0.35})
    EXPECT_NEAR(20. * model.pressure(-5. / 20., t * model.period()) / prototype.pressure(-5., t * 9.), 1., 1e-9);
}

TEST(StandingWave, RefusesWhatBreaks) {
  EXPECT_THROW(wave_of(0.7, 0.8), NumericsError);         // H/L 0.09
  EXPECT_THROW(wave_of(40., 0.66 / 40.), NumericsError);  // kH = 0.62 is the steepest
  EXPECT_NO_THROW(wave_of(40., 0.54 / 40.));
  EXPECT_THROW(wave_of(0.05, 0.5), NumericsError);
  for (const double bad : {0., -1., HUGE_VAL}) {
    EXPECT_THROW(StandingWave({bad, 1., 8.}, water), std::invalid_argument);
    EXPECT_THROW(StandingWave({10., bad, 8.}, water), std::invalid_argument);
    EXPECT_THROW(StandingWave({10., 1., bad}, water), std::invalid_argument);
  }
}

/// The section of Goda's example with deeper water before it.
Section standing_section() {
  Section s = test::goda_section();
  s.water_depth = 14.;
  s.foundation_depth = 11.;
  return s;
}

TEST(StandingWave, PressesAWallAsItsPressuresDo) {
  const Section section = standing_section();
  const StandingWave wave({14., 3., 9.}, water);
  for (const double t : {0., 1.1, 2.9, 4.5}) {
    const WallPressure at = wall_pressure(wave, section, t);
    constexpr int n = 20000;
    const double from = -section.foundation_depth, dy = (section.crest - from) / n;
    double force = 0., moment = 0.;
    for (int i = 0; i < n; ++i) {
      const double y = from + (i + 0.5) * dy, p = wave.pressure(y, t);
      force += p * dy;
      moment += p * (y - from) * dy;
    }
    EXPECT_NEAR(at.force / force, 1., 1e-5);
    EXPECT_NEAR(at.force_moment / moment, 1., 1e-5);
    EXPECT_NEAR(at.uplift, 0.5 * section.width * std::max(wave.pressure(from, t), 0.), 1e-9 * std::abs(force));
  }
}

TEST(StandingWave, IsToldByHeightsWithoutLoss) {
  for (const double crest : {3.4, 0.8, 20.}) {
    Section section = standing_section();
    section.crest = crest;
    const StandingWave wave({14., 3., 9.}, water);
    const std::vector<double> y = wall_heights(wave, section);
    for (const double t : {0., 1.1, 2.9, 4.5}) {
      const std::vector<double> p = wall_pressures(wave, y, t);
      double force = 0., moment = 0.;
      for (std::size_t i = 0; i + 1 < y.size(); ++i) {
        const double l = y[i + 1] - y[i], a = y[i] - y[0];
        force += 0.5 * l * (p[i] + p[i + 1]);
        moment += l * (a * (p[i] + p[i + 1]) / 2. + l * (p[i] + 2. * p[i + 1]) / 6.);
      }
      const WallPressure at = wall_pressure(wave, section, t);
      EXPECT_NEAR(force / at.force, 1., 1e-9) << "crest " << crest << ", t " << t;
      EXPECT_NEAR(moment / at.force_moment, 1., 1e-9) << "crest " << crest << ", t " << t;
    }
  }
}

TEST(StandingWave, IsWorstWhereNoTimeIsWorse) {
  const Section section = standing_section();
  const StandingWave wave({14., 4.5, 12.}, water);  // so steep that P has two crests
  const StandingExtremes worst = standing_extremes(wave, section);
  for (int i = 0; i < 500; ++i) {
    const double P = wall_pressure(wave, section, i * wave.period() / 500).force;
    EXPECT_LE(P, worst.landward.force * (1. + 1e-12));
    EXPECT_GE(P, worst.seaward.force * (1. + 1e-12));
  }
  EXPECT_GT(worst.crest, -worst.trough);
  EXPECT_NEAR(worst.crest - worst.trough, 2. * 4.5, 1e-9);
}

TEST(StandingWave, IsTheSameFromALowerOne) {
  const Section section = standing_section();
  for (const auto& [H, lower_H] : {std::pair(6., 5.9), {4., 0.5}, {7., 6.5}}) {
    const StandingWave lower({15., lower_H, 12.}, water), from_lower({15., H, 12.}, water, &lower),
        alone({15., H, 12.}, water);
    EXPECT_EQ(from_lower.harmonics(), alone.harmonics()) << H;
    EXPECT_NEAR(from_lower.wavelength() / alone.wavelength(), 1., 1e-9) << H;
    const StandingExtremes a = standing_extremes(from_lower, section), b = standing_extremes(alone, section);
    EXPECT_NEAR(a.landward.force / b.landward.force, 1., 3e-8) << H;
    EXPECT_NEAR(a.seaward.force / b.seaward.force, 1., 3e-8) << H;
  }
}

TEST(StandingWave, IsNotSolvedTwice) {
  const StandingWave once({15., 5., 9.}, water), again({15., 5., 9.}, water, &once),
      higher({15., 5.1, 9.}, water, &once);
  EXPECT_EQ(again.wavelength(), once.wavelength());
  EXPECT_EQ(again.pressure(-3., 1.), once.pressure(-3., 1.));
  EXPECT_NE(higher.wavelength(), once.wavelength());
}

TEST(StandingWave, DoesNotStartFromAnotherSea) {
  const StandingWave alone({15., 5., 12.}, water);
  for (const StandingWaveGiven& other : {StandingWaveGiven{15., 5.1, 12.}, {14.9, 4.9, 12.}, {15., 4.9, 11.9}}) {
    const StandingWave before(other, water);
    EXPECT_EQ(StandingWave({15., 5., 12.}, water, &before).wavelength(), alone.wavelength());
  }
}

TEST(StandingWave, PullsInDeepWaterMoreThanItPushes) {
  // Goda (2000), 4.2.4: seaward forces exceed landward ones where h/L is larger than about 0.25
  Section section = standing_section();
  section.crest = 30.;
  section.foundation_depth = section.water_depth = 10.;
  const auto pull_over_push = [&](double kh, double height) {
    const StandingExtremes worst = standing_extremes(wave_of(kh, height), section);
    return -worst.seaward.force / worst.landward.force;
  };
  EXPECT_LT(pull_over_push(0.6, 0.2), 1.);
  EXPECT_GT(pull_over_push(2.5, 0.15), 1.);
}

}  // namespace standing_wave_test
}  // namespace upbead
