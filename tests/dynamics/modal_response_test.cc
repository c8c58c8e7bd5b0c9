// Claims: the response of a reduced model is exact for loads that are straight between their samples, whatever the
// steps and the poles, also where loads jump; a reading at a jump is that before the jump, and at t = 0 that without
// load.
// Source: closed forms and Duhamel's integral by adaptive quadrature (1e-13).
// Tolerance 1e-11 of the peak: some hundred steps of round-off, and that of the quadrature.
#include "upbead/dynamics/modal_response.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "modal_models.h"

namespace modal_response_test {

using namespace upbead;
using namespace upbead::test;

/// int_0^t h(t - s) f(s) ds, piece by piece.
double duhamel(const std::function<double(double)>& h, const TimeFunction& f, double t) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  std::vector<double> ends{0.};
  for (const double kink : f.kinks())
    if (kink > 0. && kink < t) ends.push_back(kink);
  ends.push_back(t);
  double sum = 0.;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const auto& piece = f.piece(0.5 * (ends[i] + ends[i + 1]));
    sum += Rule::integrate([&](double s) { return h(t - s) * piece(s); }, ends[i], ends[i + 1], 12, 1e-13);
  }
  return sum;
}

TimeFunction constant_from(double start, double value) {
  return TimeFunction({start}, {[](double) { return 0.; }, [value](double) { return value; }});
}

std::vector<double> even_times(double step, int n) {
  std::vector<double> time;
  for (int i = 0; i <= n; ++i) time.push_back(i * step);
  return time;
}

/// Uneven and even steps over 3 s that meet 0.3, 0.7 and 1.
std::vector<double> mixed_times() {
  std::vector<double> time{0., 0.01, 0.1, 0.25, 0.3, 0.52, 0.7, 0.703, 0.9, 1.};
  for (int i = 1; i <= 100; ++i) time.push_back(1. + 0.02 * i);
  return time;
}

void expect_equal(const Eigen::RowVectorXd& y, const std::function<double(double)>& exact,
                  const std::vector<double>& time) {
  double largest = 0.;
  for (const double t : time) largest = std::max(largest, std::abs(exact(t)));
  ASSERT_EQ(y.size(), static_cast<Eigen::Index>(time.size()));
  EXPECT_EQ(y[0], 0.);
  for (std::size_t n = 1; n < time.size(); ++n) EXPECT_NEAR(y[n], exact(time[n]), 1e-11 * largest) << time[n];
}

TEST(ModalResponse, OscillatorUnderATriangle) {
  const Oscillator oscillator;
  const TimeFunction triangle = piecewise_linear({0., 0.3, 1.}, {0., 5., 0.});
  const std::vector<double> time = mixed_times();
  const Series series = respond(oscillator.model(), sample({triangle}, time));
  const auto x = [&](double t) {
    return duhamel([&](double s) { return oscillator.impulse_response(s); }, triangle, t);
  };
  EXPECT_EQ(series.time, time);
  expect_equal(series.reading.row(0), x, time);
  expect_equal(
      series.load.row(0), [&](double t) { return triangle(t); }, time);
  for (Eigen::Index n = 0; n < series.load.cols(); ++n) {
    const auto y = series.reading.col(n);
    const double force = oscillator.m * y[2] + oscillator.c * y[1] + oscillator.k * y[0];
    EXPECT_NEAR(force, series.load(0, n), 1e-11 * 5.) << "the equation of motion";
  }
}

TEST(ModalResponse, JumpAtTheStart) {
  const Oscillator oscillator;
  const std::vector<double> time = mixed_times();
  const Series series = respond(oscillator.model(), sample({constant_from(0., 3.)}, time));
  expect_equal(
      series.reading.row(0), [&](double t) { return 3. * oscillator.step_response(t); }, time);
  EXPECT_EQ(series.reading(2, 0), 0.) << "no load counts at t = 0 yet";
  EXPECT_EQ(series.load(0, 0), 0.);
  EXPECT_EQ(series.load(0, 1), 3.);
}

TEST(ModalResponse, JumpLater) {
  const Oscillator oscillator;
  const std::vector<double> time = mixed_times();
  const TimeFunction load = sum(constant_from(0., 1.), constant_from(0.7, 2.));
  const Series series = respond(oscillator.model(), sample({load}, time));
  const auto exact = [&](double t) {
    return oscillator.step_response(t) + (t > 0.7 ? 2. * oscillator.step_response(t - 0.7) : 0.);
  };
  expect_equal(series.reading.row(0), exact, time);
  EXPECT_EQ(series.load(0, 6), 1.) << "at 0.7 s, before the jump";
  const double without_load = oscillator.c * series.reading(1, 6) + oscillator.k * series.reading(0, 6);
  EXPECT_NEAR(oscillator.m * series.reading(2, 6) + without_load, 1., 1e-11);
}

TEST(ModalResponse, PoleAtZeroIntegrates) {
  const TimeFunction triangle = piecewise_linear({0., 0.3, 1.}, {0., 5., 0.});
  const std::vector<double> time = mixed_times();
  const Series series = respond(single_mode(0.), sample({triangle}, time));
  ModalModel without_modes = single_mode(0.);
  without_modes.load(0, 0) = 0.;
  without_modes.impulse(0, 0) = 1.;
  const auto exact = [&](double t) { return t > 0. ? integral(triangle, 0., t) : 0.; };
  expect_equal(series.reading.row(0), exact, time);
  expect_equal(respond(without_modes, sample({triangle}, time)).reading.row(0), exact, time);
}

/// r times the response of z' = -r z + t, which is t - (1 - exp(-r t))/r; for small r t by its power series.
double ramp_response(double rate, double t) {
  const double x = rate * t;
  if (x > 1.) return t + std::expm1(-x) / rate;
  double sum = 0.;
  for (int k = 20; k >= 2; --k) sum = (1. - sum) * x / k;
  return t * sum;
}

// Poles from so slow that a step hardly changes the mode to so fast that the exponential underflows.
TEST(ModalResponse, RealPolesOfEverySpeed) {
  const TimeFunction ramp = piecewise_linear({0., 1., 2.}, {0., 1., 0.});
  const std::vector<double> time = even_times(1e-3, 900);
  for (const double rate : {1e-9, 1e-3, 1., 900., 1100., 1e5, 1e9}) {
    ModalModel model = single_mode(-rate);
    model.reading(0, 0) = rate;
    const auto exact = [&](double t) { return ramp_response(rate, t); };
    const Eigen::RowVectorXd y = respond(model, sample({ramp}, time)).reading.row(0);
    for (std::size_t n = 1; n < time.size(); ++n) EXPECT_NEAR(y[n], exact(time[n]), 1e-11 * exact(time.back())) << rate;
  }
}

// A quasi-static mode follows a jump within a step.
TEST(ModalResponse, QuasiStaticLimit) {
  ModalModel model = single_mode(-1e9);
  model.reading(0, 0) = 1e9;
  const Series series = respond(model, sample({constant_from(0., 1.)}, even_times(1e-3, 10)));
  for (int n = 1; n <= 10; ++n) EXPECT_NEAR(series.reading(0, n), 1., 1e-14);
}

TEST(ModalResponse, AddsLoads) {
  const ModalModel model = random_model(20, 3, 4, 0.02);
  const std::vector<double> time = mixed_times();
  const std::vector<TimeFunction> loads{piecewise_linear({0., 0.3, 1.}, {0., 5., 0.}), constant_from(0., 1.),
                                        constant_from(0.7, -2.)};
  const Eigen::MatrixXd all = respond(model, sample(loads, time)).reading;
  Eigen::MatrixXd total = Eigen::MatrixXd::Zero(all.rows(), all.cols());
  for (std::size_t k = 0; k < loads.size(); ++k) {
    std::vector<TimeFunction> one(3);
    one[k] = loads[k];
    total += respond(model, sample(one, time)).reading;
  }
  EXPECT_GT(all.cwiseAbs().maxCoeff(), 1.);
  EXPECT_LT((all - total).cwiseAbs().maxCoeff(), 1e-12 * all.cwiseAbs().maxCoeff());
}

// Steps of nearly the same size are treated as equal. If all are longer than the first by nearly 1e-9 of it, the
// errors must not add up; steps that differ by more are not equal. Tolerance 1e-9: ten times the error of phase by
// 1e-9 of a step.
TEST(ModalResponse, NearlyEqualStepsDoNotDrift) {
  Oscillator oscillator;
  oscillator.c = 0.;
  for (const double excess : {0.9e-9, 1e-6}) {
    std::vector<double> time{0., 0.01};
    for (int i = 1; i <= 5000; ++i) time.push_back(0.01 + i * 0.01 * (1. + excess));
    const Series series = respond(oscillator.model(), sample({constant_from(0., 1.)}, time));
    double error = 0.;
    for (std::size_t n = 0; n < time.size(); ++n)
      error = std::max(error, std::abs(series.reading(0, n) - oscillator.step_response(time[n])));
    EXPECT_LT(error * oscillator.k, 1e-9) << excess;
  }
}

// If a step is longer than the last by less than 1e-8 of it, the coefficients of the last step are corrected, not
// computed again.
TEST(ModalResponse, StretchedStepsAreExact) {
  Oscillator oscillator;
  oscillator.c = 0.;
  std::vector<double> time{0.};
  for (double step = 0.01; time.size() <= 5000; step *= 1. + 5e-9) time.push_back(time.back() + step);
  const Series series = respond(oscillator.model(), sample({constant_from(0., 1.)}, time));
  double error = 0.;
  for (std::size_t n = 0; n < time.size(); ++n)
    error = std::max(error, std::abs(series.reading(0, n) - oscillator.step_response(time[n])));
  EXPECT_LT(error * oscillator.k, 1e-10);
}

// 1e6 s without damping: 3e6 periods at 20 rad/s. The phase is good to 1e-9 at best, the amplitude stays.
TEST(ModalResponse, FreeVibrationLasts) {
  Oscillator oscillator;
  oscillator.c = 0.;
  std::vector<double> time = even_times(0.05, 20);
  for (int i = 1; i <= 10000; ++i) time.push_back(1. + 100. * i);
  const TimeFunction triangle = piecewise_linear({0., 0.05, 0.1}, {0., 1., 0.});
  const Series series = respond(oscillator.model(), sample({triangle}, time));
  const auto energy = [&](Eigen::Index n) {
    return oscillator.k * std::pow(series.reading(0, n), 2) + oscillator.m * std::pow(series.reading(1, n), 2);
  };
  ASSERT_GT(energy(2), 0.);
  for (Eigen::Index n = 3; n < series.reading.cols(); ++n) ASSERT_NEAR(energy(n) / energy(2), 1., 1e-10) << n;
}

TEST(ModalResponse, SamplesOnBothSidesOfAJump) {
  const SampledLoads loads = sample({sum(constant_from(0., 1.), constant_from(0.5 + 1e-12, 2.))}, {0., 0.5, 0.75});
  EXPECT_EQ(loads.begin(0, 0), 1.);
  EXPECT_EQ(loads.end(0, 0), 1.);
  EXPECT_EQ(loads.begin(0, 1), 3.) << "a kink is met up to round-off";
  EXPECT_EQ(loads.end(0, 1), 3.);
}

TEST(ModalResponse, RefusesWhatDoesNotFit) {
  const SampledLoads one = sample({TimeFunction()}, {0., 1.});
  EXPECT_THROW(respond(random_model(4, 2, 1, 1.), one), std::invalid_argument);
  SampledLoads short_of_time = one;
  short_of_time.time = {0.};
  EXPECT_THROW(respond(single_mode(0.), short_of_time), std::invalid_argument);
}

}  // namespace modal_response_test
