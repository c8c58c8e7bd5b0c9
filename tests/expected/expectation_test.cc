// Claim: quadrature gives the expectation of a sum over many waves, and that of an independent computation to its
// digits.
#include "upbead/expected/sliding_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "caissons.h"

namespace upbead::test {

namespace expectation_test {

/// Of 600 waves cut at 12 m.
Expectation of_storm(Law law, double significant_height) {
  const SeaState sea = storm(significant_height);
  return expected_distance(*formula_law(law, medium_caisson(), sea),
                           RayleighHeights(significant_height, 12. / significant_height), sea.waves);
}

/// A law with a jump, a gap and a kink; its threshold is a lower bound.
class OddLaw : public SlidingLaw {
 public:
  double distance(double H, const WaveFactors&) const override {
    return H < 8.123 || (H > 9. && H < 9.5) ? 0. : 0.1 + std::abs(H - 8.7);
  }
  double threshold(const WaveFactors&) const override { return 4.; }
};

double trapezoids(const SlidingLaw& law, const RayleighHeights& heights, double from, double to) {
  const int n = 2000000;
  double sum = 0.;
  for (int i = 0; i < n; ++i) {
    const double H = from + (to - from) * (i + 0.5) / n;
    sum += law.distance(H) * heights.density(H) * (to - from) / n;
  }
  return sum;
}

/// The sum over waves of equal share, each with its Rayleigh height, broken to the limit; without density or
/// quadrature.
double wave_by_wave(const SlidingLaw& law, double significant_height, double limit) {
  const int n = 4000000;
  double sum = 0.;
  for (int i = 0; i < n; ++i)
    sum += law.distance(std::min(significant_height * std::sqrt(-0.5 * std::log((i + 0.5) / n)), limit), {}) / n;
  return sum;
}

TEST(Expectation, OfWavesThatBreakIsThatOfASumOverWaves) {
  const auto exact = formula_law(Law::exact, medium_caisson(), storm(6.));
  for (const double limit : {10.2, 11., 12.5}) {
    const Expectation found = expected_distance(*exact, RayleighHeights(6., RayleighHeights::no_cut, limit), 600.);
    const double sum = 600. * wave_by_wave(*exact, 6., limit);
    EXPECT_GT(sum, 0.);
    EXPECT_NEAR(found.distance, sum, 2e-6 * sum) << limit;
    const double share = std::exp(-2. * limit * limit / 36.);
    EXPECT_NEAR(found.broken, 600. * share * exact->distance(limit), 1e-12 * found.broken) << limit;
    EXPECT_LT(found.distance, expected_distance(*exact, RayleighHeights(6.), 600.).distance);
    EXPECT_GT(found.distance, expected_distance(*exact, RayleighHeights(6., limit / 6.), 600.).distance)
        << "waves that break still come";
  }
  const OddLaw odd;
  for (const double limit : {8.2, 9.2, 10.}) {
    const Expectation found = expected_distance(odd, RayleighHeights(6., RayleighHeights::no_cut, limit), 600.);
    EXPECT_NEAR(found.distance, 600. * wave_by_wave(odd, 6., limit), 1e-4 * found.distance) << limit;
  }
}

TEST(Expectation, OfALimitFarAwayIsThatWithoutOne) {
  const auto exact = formula_law(Law::exact, medium_caisson(), storm(6.));
  const double without = expected_distance(*exact, RayleighHeights(6.), 600.).distance;
  EXPECT_EQ(expected_distance(*exact, RayleighHeights(6., RayleighHeights::no_cut, 60.), 600.).distance, without);
}

TEST(Expectation, OfALimitBelowTheThresholdIsZero) {
  const auto exact = formula_law(Law::exact, medium_caisson(), storm(6.));
  const Expectation found = expected_distance(*exact, RayleighHeights(6., RayleighHeights::no_cut, 5.), 600.);
  EXPECT_EQ(found.distance, 0.);
  EXPECT_EQ(found.broken, 0.);
  EXPECT_EQ(found.sliding_waves, 0.);
}

TEST(Expectation, OfAStormAgreesWithAnIndependentQuadrature) {
  const struct {
    double significant_height, paper, exact;
  } rows[] = {{5.5, 0.0073844, 0.0129053}, {6., 0.0241136, 0.0419895}, {6.5, 0.0596064, 0.1035070}};
  for (const auto& row : rows) {
    EXPECT_NEAR(of_storm(Law::paper, row.significant_height).distance, row.paper, 5e-8);
    EXPECT_NEAR(of_storm(Law::exact, row.significant_height).distance, row.exact, 5e-8);
  }
}

TEST(Expectation, AgreesWithBruteForce) {
  const SeaState sea = storm(6.);
  for (const Law law : {Law::paper, Law::exact}) {
    const auto of = formula_law(law, medium_caisson(), sea);
    const Expectation found = expected_distance(*of, RayleighHeights(6.), 600.);
    const double brute = 600. * trapezoids(*of, RayleighHeights(6.), found.threshold, 40.);
    EXPECT_NEAR(found.distance, brute, 1e-8 * brute);
    EXPECT_LT(found.error, 1e-7 * found.distance);
  }
}

TEST(Expectation, FindsWhereSlidingBeginsByItself) {
  const OddLaw law;
  const RayleighHeights heights(6.);
  const Expectation found = expected_distance(law, heights, 1000.);
  EXPECT_NEAR(found.threshold, 8.123, 1e-6);
  EXPECT_NEAR(found.distance, 1000. * trapezoids(law, heights, 8., 40.), 1e-5 * found.distance);
  EXPECT_NEAR(found.sliding_waves, 1000. * heights.exceedance(8.123), 1e-4);
}

TEST(Expectation, OfWavesThatNeverSlideIsZero) {
  const auto law = formula_law(Law::exact, medium_caisson(), storm(6.));
  const Expectation low = expected_distance(*law, RayleighHeights(0.2), 3e7);
  EXPECT_EQ(low.distance, 0.);
  EXPECT_EQ(low.sliding_waves, 0.);
  EXPECT_EQ(expected_distance(*law, RayleighHeights(6., 1.2), 600.).distance, 0.) << "cut below the threshold";
}

TEST(Expectation, GrowsWithTheNumberOfWaves) {
  const auto law = formula_law(Law::exact, medium_caisson(), storm(6.));
  const double one = expected_distance(*law, RayleighHeights(6.), 1.).distance;
  EXPECT_NEAR(expected_distance(*law, RayleighHeights(6.), 600.).distance, 600. * one, 1e-12);
}

}  // namespace expectation_test
}  // namespace upbead::test
