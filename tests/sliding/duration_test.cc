// Claim: tau_0 of a history is that of the triangle with the same sliding distance; tau_0 of a triangle is its own by
// every exact measure.

#include "upbead/sliding/history_sliding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "upbead/sliding/pulse.h"

namespace upbead {
namespace duration_test {

constexpr double mass = 6e5;

TEST(HistoryDuration, OfATriangleIsItsOwn) {
  const History triangle = history({3e6, 0.4});
  for (const double r : {1.05, 1.2, 1.5, 2.}) {
    const HistoryDuration d = history_duration(mass, triangle, r);
    EXPECT_NEAR(*d.by_exact, 0.4, 1e-12) << r;
    EXPECT_NEAR(*d.by_excess, 0.4, 1e-12) << r;
    EXPECT_NEAR(*d.by_impulse, 0.4, 1e-12) << r;
    const TriangularPulse pulse{3e6, 0.4};
    const double exact = sliding_distance_exact(mass, 3e6 / r, pulse),
                 paper = sliding_distance_paper(mass, 3e6 / r, pulse);
    EXPECT_NEAR(*d.by_paper, 0.4 * std::sqrt(exact / paper), 1e-12) << r;
  }
}

TEST(HistoryDuration, ScalesWithTime) {
  History h{{0., 0.1, 0.15, 0.3, 0.5, 0.7}, {0., 2e6, 1.5e6, 3e6, -1e6, 0.}};
  const HistoryDuration once = history_duration(mass, h, 1.4);
  for (double& t : h.time) t *= 3.;
  const HistoryDuration thrice = history_duration(mass, h, 1.4);
  EXPECT_NEAR(*thrice.by_exact, 3. * *once.by_exact, 1e-12);
  EXPECT_NEAR(*thrice.by_paper, 3. * *once.by_paper, 1e-12);
  EXPECT_NEAR(*thrice.by_excess, 3. * *once.by_excess, 1e-12);
  EXPECT_NEAR(*thrice.by_impulse, 3. * *once.by_impulse, 1e-12);
}

TEST(HistoryDuration, PulseOfThatDurationSlidesAsFar) {
  const History h{{0., 0.1, 0.15, 0.3, 0.5, 0.7}, {0., 2e6, 1.5e6, 3e6, -1e6, 0.}};
  const HistoryDuration d = history_duration(mass, h, 1.4);
  EXPECT_NEAR(sliding_distance_exact(mass, 3e6 / 1.4, {3e6, *d.by_exact}), d.sliding, 1e-13);
  EXPECT_NEAR(sliding_distance_paper(mass, 3e6 / 1.4, {3e6, *d.by_paper}), d.sliding, 1e-13);
}

TEST(HistoryDuration, TakesTheImpulseOfTheLobeWithThePeakOnly) {
  const History h{{0., 1., 2., 3., 4., 5., 6.}, {0., 1., -1., 1., 3., -1., 2.}};
  // from 2.5 (zero) over 1 at 3 and 3 at 4 to 4.75 (zero)
  EXPECT_NEAR(*history_duration(1., h, 1.5).by_impulse, 2. * (0.25 + 2. + 1.125) / 3., 1e-14);
}

TEST(HistoryDuration, HasNoAnswerWhereNothingSlides) {
  const HistoryDuration d = history_duration(mass, history({3e6, 0.4}), 1.);
  EXPECT_FALSE(d.by_paper);
  EXPECT_FALSE(d.by_exact);
  EXPECT_FALSE(d.by_excess);
  EXPECT_THROW(history_duration(mass, {{0., 1.}, {0., -1.}}, 1.5), std::invalid_argument);
  EXPECT_THROW(history_duration(mass, history({3e6, 0.4}), 0.), std::invalid_argument);
}

}  // namespace duration_test
}  // namespace upbead
