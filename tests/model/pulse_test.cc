// Claim: every idealised pulse has the peak, impulse and kinks of its definition (in closed form; tolerances are those
// of the quadrature).
#include <gtest/gtest.h>

#include <cmath>

#include "upbead/model/load.h"

namespace upbead {

namespace pulse_test {

Pulse make(PulseShape shape, double peak, double start) {
  Pulse pulse;
  pulse.shape = shape;
  pulse.peak = peak;
  pulse.start = start;
  return pulse;
}

void expect_kinks(const TimeFunction& f, const std::vector<double>& kinks) {
  ASSERT_EQ(f.kinks().size(), kinks.size());
  for (std::size_t i = 0; i < kinks.size(); ++i) EXPECT_NEAR(f.kinks()[i], kinks[i], 1e-15);
}

void expect_peak_and_impulse(const TimeFunction& f, double peak, double time, double impulse) {
  const Extremum top = extremum(f, 0., 10., peak > 0. ? 1 : -1);
  EXPECT_NEAR(top.value, peak, 1e-8 * std::abs(peak));
  EXPECT_NEAR(top.time, time, 1e-6);
  EXPECT_NEAR(integral(f, 0., 10.), impulse, 1e-8 * std::abs(impulse));
}

TEST(PulseTest, Triangle) {
  Pulse pulse = make(PulseShape::triangle, 2e6, 0.5);
  pulse.rise = 0.02;
  pulse.duration = 0.1;
  const TimeFunction f = time_function(pulse);
  expect_kinks(f, {0.5, 0.52, 0.6});
  expect_peak_and_impulse(f, 2e6, 0.52, 1e5);
  EXPECT_NEAR(f(0.51), 1e6, 1e-3);
  EXPECT_NEAR(f(0.56), 1e6, 1e-3);
  EXPECT_EQ(f(0.49), 0.);
  EXPECT_EQ(f(0.61), 0.);
}

TEST(PulseTest, TriangleRisesHalfItsDurationByDefault) {
  Pulse pulse = make(PulseShape::triangle, -3., 0.);
  pulse.duration = 0.1;
  expect_kinks(time_function(pulse), {0., 0.05, 0.1});
  expect_peak_and_impulse(time_function(pulse), -3., 0.05, -0.15);
}

TEST(PulseTest, TriangleWithoutRiseJumps) {
  Pulse pulse = make(PulseShape::triangle, 2., 1.);
  pulse.duration = 0.5;
  pulse.rise = 0.;
  const TimeFunction f = time_function(pulse);
  expect_kinks(f, {1., 1.5});
  EXPECT_EQ(f(1., 0.), 0.);
  EXPECT_EQ(f(1.), 2.);
  EXPECT_EQ(f(1.5, 1.4), 0.);
}

TEST(PulseTest, StepJumpsOrRises) {
  Pulse pulse = make(PulseShape::step, 4., 1.);
  expect_kinks(time_function(pulse), {1.});
  EXPECT_EQ(time_function(pulse)(1., 0.), 0.);
  EXPECT_EQ(time_function(pulse)(1.), 4.);
  pulse.rise = 0.5;
  expect_kinks(time_function(pulse), {1., 1.5});
  expect_peak_and_impulse(time_function(pulse), 4., 1.5, 4. * (0.25 + 8.5));
}

TEST(PulseTest, HalfSine) {
  Pulse pulse = make(PulseShape::half_sine, 5., 1.);
  pulse.duration = 0.2;
  expect_kinks(time_function(pulse), {1., 1.2});
  expect_peak_and_impulse(time_function(pulse), 5., 1.1, 5. * 0.2 * 2. / M_PI);
}

TEST(PulseTest, ChurchRoof) {
  Pulse pulse = make(PulseShape::church_roof, 10., 1.);
  pulse.rise = 0.05;
  pulse.duration = 0.2;
  pulse.plateau = 0.3;
  pulse.plateau_duration = 3.;
  const TimeFunction f = time_function(pulse);
  expect_kinks(f, {1., 1.05, 1.2, 4.});
  // triangle of 7 over 0.2; slow part: ramp of 0.05, plateau of 0.15, fall of 2.8
  expect_peak_and_impulse(f, 10., 1.05, 0.5 * 7. * 0.2 + 3. * (0.5 * 0.05 + 0.15 + 0.5 * 2.8));
  EXPECT_NEAR(f(1.2), 3., 1e-12);
  EXPECT_NEAR(f(2.6), 1.5, 1e-12);
  EXPECT_EQ(f(4.1), 0.);
}

TEST(PulseTest, Harmonic) {
  Pulse pulse = make(PulseShape::harmonic, 2., 0.5);
  pulse.frequency = 0.5;
  const TimeFunction f = time_function(pulse);
  expect_kinks(f, {0.5});
  EXPECT_NEAR(f(1.), 2., 1e-12);
  EXPECT_NEAR(f(2.), -2., 1e-12);
  EXPECT_EQ(f(0.4), 0.);
}

TEST(PulseTest, SinesTellTheirDuration) {
  Pulse sine = make(PulseShape::half_sine, 1., 0.);
  sine.duration = 0.2;
  EXPECT_EQ(duration(sine), 0.2);
  Pulse harmonic = make(PulseShape::harmonic, 1., 0.);
  harmonic.frequency = 2.;
  EXPECT_EQ(duration(harmonic), 0.25);
  EXPECT_FALSE(duration(make(PulseShape::step, 1., 0.)));
}

TEST(PulseTest, ObjectsToWhatItsShapeDoesNotKnow) {
  Pulse pulse = make(PulseShape::harmonic, 0., 0.);
  pulse.duration = 1.;
  const std::vector<Diagnostic> list = diagnose(pulse).list();
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].what, "peak is zero, so there is no load");
  EXPECT_EQ(list[1].what, "'duration' does not belong to shape harmonic");
  EXPECT_EQ(list[2].what, "'frequency' is missing, which shape harmonic needs");
}

}  // namespace pulse_test
}  // namespace upbead
