// Claim: a function of smooth pieces keeps each piece's own limit at a kink, through sums and scales.
#include "upbead/base/time_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/run_end.h"

namespace upbead {
namespace time_function_test {

const TimeFunction ramp({0., 1.}, {[](double) { return 0.; }, [](double t) { return t; }, [](double) { return 5.; }});

TEST(TimeFunction, HasALimitFromEachSide) {
  EXPECT_EQ(ramp(1.), 5.);
  EXPECT_EQ(ramp(1., 0.5), 1.);
  EXPECT_EQ(ramp(1., 1.5), 5.);
  EXPECT_EQ(ramp(-1.), 0.);
  EXPECT_EQ(TimeFunction()(3.), 0.);
}

TEST(TimeFunction, ARecordThatEndsWithTheRunActsTillThen) {
  const TimeFunction record = piecewise_linear({0., 1., 3.}, {0., 2., 2.});
  EXPECT_EQ(record(3.), 0.);
  EXPECT_NEAR(until_end(record, 3., 3.), 2., 1e-12);
  EXPECT_EQ(until_end(record, 0.5, 3.), 1.);
  EXPECT_EQ(until_end(ramp, 1., 2.), 5.) << "a kink on the way";
}

TEST(TimeFunction, AddsAndScales) {
  const TimeFunction f = sum(ramp, scaled(piecewise_linear({0.5, 1., 2.}, {0., 2., 0.}), -2.));
  EXPECT_EQ(f.kinks(), (std::vector<double>{0., 0.5, 1., 2.}));
  EXPECT_DOUBLE_EQ(f(0.75), 0.75 - 2.);
  EXPECT_DOUBLE_EQ(f(1., 0.9), 1. - 4.);
  EXPECT_DOUBLE_EQ(f(1.), 5. - 4.);
  EXPECT_DOUBLE_EQ(f(3.), 5.);
}

TEST(PiecewiseLinear, HasKinksAtMarkedCornersOnly) {
  EXPECT_EQ(piecewise_linear({0., 1., 2., 3.}, {0., 1., 2., 0.}).kinks(), (std::vector<double>{0., 2., 3.}));
  std::vector<double> time, value;
  for (int i = 0; i <= 200; ++i) {
    time.push_back(0.01 * i);
    value.push_back(std::sin(M_PI * 0.005 * i));
  }
  const TimeFunction smooth = piecewise_linear(time, value);
  EXPECT_EQ(smooth.kinks(), (std::vector<double>{time.front(), time.back()}));
  EXPECT_NEAR(integral(smooth, -1., 3.), 4. / M_PI, 1e-4);
}

TEST(PiecewiseLinear, JumpsBetweenTwoSamplesAtOneTime) {
  const TimeFunction f = piecewise_linear({0., 1., 1., 2., 2.}, {0., 2., 5., 4., 1.});
  EXPECT_EQ(f.kinks(), (std::vector<double>{0., 1., 2.}));
  EXPECT_EQ(f(1., 0.5), 2.);
  EXPECT_EQ(f(1.), 5.);
  EXPECT_EQ(f(0.5), 1.);
  EXPECT_EQ(f(1.5), 4.5);
  EXPECT_EQ(f(2., 1.5), 4.);
  EXPECT_EQ(f(2.5), 0.);
  EXPECT_NEAR(integral(f, -1., 3.), 1. + 4.5, 1e-12);
  EXPECT_EQ(extremum(f, 0., 3., 1).value, 5.);
  EXPECT_EQ(piecewise_linear({3., 3., 4.}, {0., 7., 0.})(3.), 7.) << "at the beginning";
  std::vector<double> time, value;  // a jump within a smooth record
  for (int i = 0; i <= 200; ++i) {
    time.push_back(0.01 * i);
    value.push_back(std::sin(0.005 * M_PI * i) + (i > 120 ? 3. : 0.));
    if (i != 120) continue;
    time.push_back(time.back());
    value.push_back(value.back() + 3.);
  }
  EXPECT_EQ(piecewise_linear(time, value).kinks(), (std::vector<double>{0., time[120], 2.}));
  EXPECT_FALSE(is_rough(piecewise_linear(time, value)));
}

/// A record of `n` rows, one per millisecond, with a kink at nearly every row; the largest value is 1.5, at row n /
/// 3.
TimeFunction noisy_record(int n) {
  std::vector<double> time, value;
  unsigned random = 1;
  for (int i = 0; i < n; ++i) {
    random = 1664525u * random + 1013904223u;
    time.push_back(1e-3 * i);
    value.push_back(i == n / 3 ? 1.5 : random / 4294967296.);
  }
  return piecewise_linear(time, value);
}

TEST(PiecewiseLinear, OfANoisyRecordHasItsEndsAsOnlyKinks) {
  const TimeFunction few = noisy_record(40), many = noisy_record(400);
  EXPECT_GT(few.kinks().size(), 30u);
  EXPECT_EQ(many.kinks(), (std::vector<double>{0., 1e-3 * 399}));
  const Extremum top = extremum(many, 0., 1., 1);
  EXPECT_DOUBLE_EQ(top.value, 1.5);
  EXPECT_DOUBLE_EQ(top.time, 1e-3 * 133);
  double by_trapezia = 0.;
  for (int i = 0; i + 1 < 400; ++i) by_trapezia += 1e-3 * many(1e-3 * (i + 0.5));
  EXPECT_NEAR(integral(many, 0., 1.), by_trapezia, 1e-12);
}

TEST(TimeFunction, SharesALongRecordAmongSumsAndMultiples) {
  const int n = 10000;
  const TimeFunction record = noisy_record(n), triangle = piecewise_linear({0., 1., 3.}, {0., 2., 0.});
  TimeFunction total = sum(scaled(record, -3.), triangle);
  for (int i = 0; i < 10; ++i) total = sum(total, scaled(record, 0.25));
  EXPECT_EQ(total.kinks(), (std::vector<double>{0., 1., 3., 1e-3 * (n - 1)}));
  for (int i = 0; i + 1 < n; ++i) {
    const double t = 1e-3 * (i + 0.4);
    ASSERT_NEAR(total(t), -0.5 * record(t) + triangle(t), 1e-14) << t;
  }
  EXPECT_NEAR(integral(total, 0., 20.), -0.5 * integral(record, 0., 20.) + 3., 1e-9);
  EXPECT_EQ(total(20.), 0.);
}

TEST(Extremum, IsSigned) {
  const auto wave = [](double t) { return std::sin(4. * t) + 0.5 * t; };
  const auto slope = [](double t) { return 4. * std::cos(4. * t) + 0.5; };
  const TimeFunction f({0., 2.}, {[](double) { return 0.; }, wave, [](double) { return 0.; }});
  const Extremum top = extremum(f, 0., 3., 1), bottom = extremum(f, 0., 3., -1);
  EXPECT_NEAR(slope(top.time), 0., 1e-5);
  EXPECT_NEAR(top.value, wave(top.time), 1e-12);
  EXPECT_GT(top.value, wave(2.));
  EXPECT_NEAR(slope(bottom.time), 0., 1e-5);
  EXPECT_LT(bottom.value, -0.4);
}

TEST(Extremum, IsFoundAtAJump) {
  const TimeFunction f({0., 2.}, {[](double) { return 0.; }, [](double t) { return t; }, [](double) { return 0.; }});
  EXPECT_EQ(extremum(f, 0., 3., 1).value, 2.);
  EXPECT_EQ(extremum(f, 0., 3., 1).time, 2.);
}

TEST(Repeated, IsTheFunctionAgainEachPeriod) {
  const TimeFunction pulse = piecewise_linear({0.1, 0.3, 0.7}, {0., 2., 0.});
  const TimeFunction row = repeated(pulse, 3, 0.8);
  for (int k = 0; k < 3; ++k)
    for (const double t : {0.05, 0.1, 0.2, 0.3, 0.5, 0.69}) EXPECT_NEAR(row(t + 0.8 * k), pulse(t), 1e-14);
  EXPECT_EQ(row(3.), 0.);
  EXPECT_EQ(row.kinks().size(), 9U);
  EXPECT_NEAR(integral(row, 0., 3.), 3. * integral(pulse, 0., 1.), 1e-12);
  EXPECT_EQ(extremum(row, 0., 3., 1).time, 0.3) << "the first of equal peaks is the largest, to the last digit";
  EXPECT_EQ(extremum(row, 0., 3., 1).value, 2.);
  const TimeFunction close = repeated(pulse, 2, 0.6);
  EXPECT_NEAR(close(0.75), pulse(0.15), 1e-14) << "pulses that touch";
  EXPECT_THROW(repeated(pulse, 2, 0.5), std::invalid_argument);
}

TEST(IsRough, TellsANoisyRecordFromADrawnOrSmoothOne) {
  std::vector<double> time, smooth, noisy;
  for (int i = 0; i <= 400; ++i) {
    time.push_back(i / 400.);
    smooth.push_back(std::sin(3. * time.back()));
    noisy.push_back(smooth.back() + (i % 2 == 0 ? 0.01 : -0.01));
  }
  EXPECT_FALSE(is_rough(piecewise_linear({0., 0.5, 1.}, {0., 1., 0.})));
  EXPECT_FALSE(is_rough(piecewise_linear(time, smooth)));
  EXPECT_TRUE(is_rough(piecewise_linear(time, noisy)));
  EXPECT_FALSE(is_rough(TimeFunction()));
}

}  // namespace time_function_test
}  // namespace upbead
