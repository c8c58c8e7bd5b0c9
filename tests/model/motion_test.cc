#include "model/motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead {
namespace motion_test {

const double pi = std::acos(-1.);

Pulse pulse_of(PulseShape shape, double duration) {
  Pulse pulse;
  pulse.shape = shape;
  pulse.peak = 0.2;
  pulse.duration = duration;
  pulse.start = 0.1;
  return pulse;
}

/// The integral of a velocity is the displacement from which the velocity was derived.
TEST(Motion, VelocityIntegratesToTheDisplacement) {
  Pulse roof = pulse_of(PulseShape::church_roof, 0.4);
  roof.rise = 0.1;
  roof.plateau = 0.3;
  roof.plateau_duration = 1.;
  Pulse ramp = pulse_of(PulseShape::step, 0.);
  ramp.duration.reset();
  ramp.rise = 0.3;
  Pulse harmonic = pulse_of(PulseShape::harmonic, 0.);
  harmonic.duration.reset();
  harmonic.frequency = 1.7;
  for (const Pulse& pulse :
       {pulse_of(PulseShape::triangle, 0.5), pulse_of(PulseShape::half_sine, 0.5), roof, ramp, harmonic}) {
    const TimeFunction x = time_function(pulse), v = velocity(LoadKind::displacement, pulse);
    for (const double t : {0.05, 0.15, 0.33, 0.62, 0.97, 1.4}) EXPECT_NEAR(integral(v, 0., t), x(t), 1e-12);
  }
}

TEST(Motion, VelocityIsTheIntegralOfTheAcceleration) {
  for (const PulseShape shape : {PulseShape::triangle, PulseShape::half_sine}) {
    const Pulse pulse = pulse_of(shape, 0.5);
    const TimeFunction a = time_function(pulse), v = velocity(LoadKind::acceleration, pulse);
    for (const double t : {0.05, 0.1, 0.15, 0.33, 0.62, 0.97}) EXPECT_NEAR(v(t), integral(a, 0., t), 1e-13);
  }
  Pulse harmonic = pulse_of(PulseShape::harmonic, 0.);
  harmonic.duration.reset();
  harmonic.frequency = 1.7;
  const TimeFunction v = velocity(LoadKind::acceleration, harmonic);
  const double omega = 2. * pi * 1.7;
  for (const double t : {0.2, 1.3, 40.}) EXPECT_NEAR(v(t), 0.2 / omega * (1. - std::cos(omega * (t - 0.1))), 1e-11);
  EXPECT_EQ(v(0.05), 0.);
}

TEST(Motion, SamplesOfAnAccelerationAreIntegratedExactly) {
  const std::vector<double> t{0., 0.1, 0.3, 0.35}, a{0., 2., -1., 0.};
  const TimeFunction v = integral_of_samples(t, a);
  EXPECT_NEAR(v(0.05), 0.5 * 0.05 * 1., 1e-15);
  EXPECT_NEAR(v(0.1), 0.1, 1e-15);
  EXPECT_NEAR(v(0.2), 0.1 + 0.5 * (2. + 0.5) * 0.1, 1e-15);
  const double last = 0.1 + 0.5 * (2. - 1.) * 0.2 - 0.5 * 0.05;
  EXPECT_NEAR(v(0.35), last, 1e-15);
  EXPECT_NEAR(v(7.), last, 1e-15) << "it keeps the velocity that it has";
  EXPECT_EQ(v.kinks(), (std::vector<double>{0., 0.35})) << "smooth between its ends";
}

TEST(Motion, SamplesOfADisplacementGiveAContinuousVelocity) {
  std::vector<double> t, x;
  for (int i = 0; i <= 100; ++i) {
    t.push_back(0.01 * i);
    x.push_back(0.5 + 0.1 * std::sin(pi * t.back()));  // a constant offset, which gives no velocity
  }
  const TimeFunction v = rate_of_samples(t, x);
  for (const double at : {0.123, 0.25, 0.501, 0.77}) {
    EXPECT_NEAR(v(at), 0.1 * pi * std::cos(pi * at), 2e-3);
    EXPECT_NEAR(v(at - 1e-9), v(at + 1e-9), 1e-6);
  }
  EXPECT_NEAR(integral(v, 0., 0.5), 0.1, 1e-12);
  EXPECT_EQ(v(2.), 0.);
}

TEST(Motion, OnlyADisplacementWithoutJumpsHasAVelocity) {
  Pulse pulse = pulse_of(PulseShape::triangle, 0.5);
  EXPECT_FALSE(jumps(pulse));
  pulse.rise = 0.;
  EXPECT_TRUE(jumps(pulse));
  pulse.rise = 0.5;
  EXPECT_TRUE(jumps(pulse));
  Pulse step = pulse_of(PulseShape::step, 0.);
  step.duration.reset();
  EXPECT_TRUE(jumps(step));
  step.rise = 0.1;
  EXPECT_FALSE(jumps(step));
}

TEST(Motion, LastsAsLongAsItsDisplacement) {
  EXPECT_DOUBLE_EQ(*motion_duration(LoadKind::displacement, pulse_of(PulseShape::triangle, 0.5)), 0.5);
  EXPECT_DOUBLE_EQ(*motion_duration(LoadKind::displacement, pulse_of(PulseShape::half_sine, 0.5)), 0.5);
  EXPECT_FALSE(motion_duration(LoadKind::velocity, pulse_of(PulseShape::triangle, 0.5)));
}

TEST(Intensity, RunsAlongACurve) {
  Load load;
  load.along_curve = true;
  load.course = {{{0., 0.}, {3., 4.}, {3., 10.}}};
  load.shape = {{{2., 1.}, {8., 4.}}};
  EXPECT_DOUBLE_EQ(shape_coordinate(load, 1.5, 2.), 2.5);
  EXPECT_DOUBLE_EQ(shape_coordinate(load, 3., 7.), 8.);
  EXPECT_DOUBLE_EQ(intensity(load, 3., 4.), 2.5);
  EXPECT_DOUBLE_EQ(intensity(load, 3., 9.), 0.) << "beyond the shape";
}

}  // namespace motion_test
}  // namespace upbead
