// Claim: the motion of a block with linear drag satisfies its equation, and without drag is that of the block.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "upbead/sliding/block.h"
#include "upbead/sliding/pulse.h"

namespace upbead {
namespace drag_test {

constexpr double mass = 6e5, resistance = 1.9e6;
const History loads{{0., 0.1, 0.2, 0.35, 0.5, 0.9, 1.2}, {0., 3.5e6, 1e6, 3e6, -2.5e6, -3e6, 0.}};

struct End {
  double x = 0., largest = 0.;
};

/// Velocity by midpoint steps; stops and starts within a step.
End by_small_steps(double drag) {
  const double step = 2.5e-7;
  double x = 0., v = 0.;
  End end;
  std::size_t i = 1;
  for (double t = 0.5 * step; t < 3.; t += step) {
    while (i + 1 < loads.time.size() && t > loads.time[i]) ++i;
    const double f = t > loads.time.back()
                         ? 0.
                         : loads.value[i - 1] + (loads.value[i] - loads.value[i - 1]) * (t - loads.time[i - 1]) /
                                                    (loads.time[i] - loads.time[i - 1]);
    const double push = f - drag * v;
    if (v == 0. && std::abs(f) <= resistance) continue;
    const double s = v != 0. ? std::copysign(1., v) : std::copysign(1., f);
    const double next = v + step * (push - s * resistance) / mass;
    v = next * s < 0. ? 0. : next;
    x += step * v;
    if (std::abs(x) > std::abs(end.largest)) end.largest = x;
  }
  end.x = x;
  return end;
}

TEST(Drag, AgreesWithManySmallStepsBothWays) {
  for (const double drag : {1e5, 2e6, 3e7}) {
    const Sliding s = slide(mass, loads, resistance, drag);
    const End expected = by_small_steps(drag);
    EXPECT_NEAR(s.residual, expected.x, 1e-6 * std::abs(expected.largest)) << drag;
    EXPECT_NEAR(s.largest, expected.largest, 1e-6 * std::abs(expected.largest)) << drag;
    EXPECT_GT(std::abs(expected.largest), 1e-4);
  }
}

TEST(Drag, VanishesContinuously) {
  const Sliding without = slide(mass, loads, resistance);
  EXPECT_NEAR(slide(mass, loads, resistance, 1e-3).residual, without.residual, 1e-8 * std::abs(without.largest));
  EXPECT_NEAR(slide(mass, loads, resistance, 1e-9).residual, without.residual, 1e-13);
}

TEST(Drag, TakesWhatMomentumSays) {
  // impulse of net force = drag x distance, from rest to rest
  const double drag = 4e6, T = 0.4;
  const Sliding s = slide(mass, history({3e6, T}), resistance, drag);
  ASSERT_EQ(s.slips.size(), 1U);
  const Slip& slip = s.slips[0];
  double impulse = 0.;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double t = slip.start + (slip.stop - slip.start) * (i + 0.5) / n;
    impulse += (t < T ? 3e6 * (1. - std::abs(2. * t / T - 1.)) : 0.) - resistance;
  }
  impulse *= (slip.stop - slip.start) / n;
  EXPECT_NEAR(drag * slip.distance, impulse, 1e-6 * drag * slip.distance);
}

TEST(Drag, IsNeverNegative) {
  EXPECT_THROW(slide(mass, loads, resistance, -1.), std::invalid_argument);
}

}  // namespace drag_test
}  // namespace upbead
