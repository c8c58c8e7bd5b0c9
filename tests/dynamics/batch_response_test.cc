// Claims: a batch gives each wave the response of respond(), for any number of loads, modes and samples; the part of
// the response beyond a frequency is nearly zero for a slow wave, the whole for a fast one, and for a kink that of
// its spectrum. Tolerance 1e-12 of the peak: both sum some ten modes over some hundred steps.
#include "dynamics/batch_response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "../../src/dynamics/lanes.h"
#include "dynamics/answer_error.h"
#include "modal_models.h"
#include "upbead/dynamics/modal_response.h"

namespace batch_response_test {

using namespace upbead;
using namespace upbead::test;

constexpr double pi = 3.14159265358979323846;

WaveSamples random_wave(int n_loads, int n) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> number(-1., 1.);
  return WaveSamples::NullaryExpr(n_loads, n, [&] { return number(generator); });
}

/// respond() to a wave, all readings; at t = 0 the value after the jump, which is the feedthrough alone.
Eigen::MatrixXd one_by_one(const ModalModel& model, const WaveSamples& wave, double step) {
  SampledLoads loads;
  for (Eigen::Index n = 0; n < wave.cols(); ++n) loads.time.push_back(static_cast<double>(n) * step);
  loads.begin = wave.leftCols(wave.cols() - 1);
  loads.end = wave.rightCols(wave.cols() - 1);
  Eigen::MatrixXd y = respond(model, loads).reading;
  y.col(0) = model.feedthrough * wave.col(0);
  return y;
}

Eigen::RowVectorXd batch(const ModalModel& model, int reading, const WaveSamples& wave, double step) {
  Eigen::RowVectorXd y(wave.cols());
  BatchResponse(model, reading, step).respond(wave, y);
  return y;
}

void expect_as_one_by_one(const ModalModel& model, const WaveSamples& wave, double step) {
  const Eigen::MatrixXd expected = one_by_one(model, wave, step);
  for (int i = 0; i < model.n_readings(); ++i) {
    const double peak = expected.row(i).cwiseAbs().maxCoeff();
    EXPECT_GT(peak, 0.);
    EXPECT_LT((batch(model, i, wave, step) - expected.row(i)).cwiseAbs().maxCoeff(), 1e-12 * peak);
  }
}

TEST(BatchResponse, IsThatOfEachWave) {
  for (const int n_loads : {1, 3})
    for (const int n_modes : {1, 7, 8, 30})
      for (const int n : {1, 5, 400}) {
        SCOPED_TRACE(std::to_string(n_loads) + " loads, " + std::to_string(n_modes) + " modes, " + std::to_string(n));
        expect_as_one_by_one(random_model(n_modes, n_loads, 2, 0.01), random_wave(n_loads, n), 0.01);
      }
}

TEST(BatchResponse, WithoutImpulse) {
  ModalModel model = random_model(12, 2, 2, 0.01);
  model.impulse.setZero();
  expect_as_one_by_one(model, random_wave(2, 300), 0.01);
}

// Only values that have decayed below the smallest numbers are dropped.
TEST(BatchResponse, AWaveThatEnds) {
  ModalModel model = single_mode({-100., 30.});
  WaveSamples wave = WaveSamples::Zero(1, 1500);
  wave.leftCols(20) = random_wave(1, 20);
  const Eigen::RowVectorXd y = batch(model, 0, wave, 0.01), expected = one_by_one(model, wave, 0.01).row(0);
  EXPECT_LT((y - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
  EXPECT_NEAR(y[500] / expected[500], 1., 1e-9) << "some 1e-200 of the peak";
  EXPECT_EQ(y[1499], 0.);
}

// In rounding, 0.9 times the smallest number is the smallest number: a decayed mode would stay there, and such
// numbers are slow to compute with, so it is set to zero.
TEST(BatchResponse, QuietModesEndAtZero) {
  constexpr int n = 64 * detail::samples_at_a_time;
  const Eigen::ArrayXd factor = Eigen::ArrayXd::Constant(detail::lanes, 0.9), zero = 0. * factor;
  const Eigen::RowVectorXd f = Eigen::RowVectorXd::Zero(n);
  Eigen::RowVectorXd y = f;
  detail::SplitArray w{factor, 1e-240 * factor};
  detail::add_mode_sum({factor, zero}, {factor, zero}, f.data(), n, w, y.data());
  EXPECT_NEAR(w.re[0], std::pow(0.9, n + 1), 1e-12 * std::pow(0.9, n + 1));
  EXPECT_EQ(w.im[0], 0.);
}

TEST(BatchResponse, WhatIsNoNumberIsNotLost) {
  WaveSamples wave = random_wave(1, 500);
  wave(0, 100) = std::nan("");
  const Eigen::RowVectorXd y = batch(single_mode({-1., 30.}), 0, wave, 0.01);
  EXPECT_FALSE(std::isnan(y[99]));
  EXPECT_TRUE(std::isnan(y[499]));
}

TEST(BatchResponse, RefusesWhatDoesNotFit) {
  const BatchResponse responder(single_mode(0.), 0, 1.);
  Eigen::RowVectorXd y(5);
  EXPECT_THROW(responder.respond(WaveSamples::Zero(2, 5), y), std::invalid_argument);
  EXPECT_THROW(responder.respond(WaveSamples::Zero(1, 6), y), std::invalid_argument);
  EXPECT_THROW(BandCheck(single_mode(-1.), 0, 1., 6, 1.).beyond(WaveSamples::Zero(1, 5)), std::invalid_argument);
}

WaveSamples sampled(double (*f)(double), double step, int n) {
  return WaveSamples::NullaryExpr(1, n, [&](Eigen::Index, Eigen::Index i) { return f(static_cast<double>(i) * step); });
}

double triangle(double t) {
  return std::max(0., 1. - std::abs(t / 0.5 - 1.));
}

/// 100 Hz for about a tenth of a second, with zero mean.
double burst(double t) {
  return std::exp(-std::pow((t - 0.3) / 0.05, 2)) * std::sin(2. * pi * 100. * (t - 0.3));
}

constexpr double step = 1e-3;
constexpr int n_samples = 2000;

TEST(BandCheck, ASlowTriangleHasNearlyNothingBeyond) {
  const ModalModel model = Oscillator().model();  // 3 Hz
  const WaveSamples wave = sampled(triangle, step, n_samples);
  const double peak = batch(model, 0, wave, step).cwiseAbs().maxCoeff();
  EXPECT_LT(BandCheck(model, 0, step, n_samples, 2. * pi * 50.).beyond(wave), 1e-4 * peak);
  EXPECT_GT(BandCheck(model, 0, step, n_samples, 2. * pi * 0.1).beyond(wave), 0.3 * peak);
}

// The top of a triangle, a kink of 4 /s, has 1/pi int 4/omega^2 d omega beyond a frequency, its ends half of that.
// 0.5 %: the resolution of the FFT, 0.25 Hz of 50 Hz. For samples 5 ms apart half of this lies beyond the band of the
// samples.
TEST(BandCheck, AKinkHasWhatItsSpectrumSays) {
  ModalModel model = single_mode(-1.);
  model.load(0, 0) = 0.;
  model.feedthrough(0, 0) = 1.;
  const double omega = 2. * pi * 50.125;
  for (const double h : {step, 5. * step}) {
    const WaveSamples wave = sampled(triangle, h, static_cast<int>(2. / h));
    EXPECT_NEAR(BandCheck(model, 0, h, static_cast<int>(wave.cols()), omega).beyond(wave) * pi * omega / 4., 1., 5e-3);
  }
}

// The same for samples too far apart for the frequency: content beyond the band of the samples counts only where it
// lies beyond the frequency. 2 %: coarse samples may miss the time of the largest value.
TEST(BandCheck, CoarseSamplesTellTheSame) {
  const ModalModel model = Oscillator().model();
  const WaveSamples fine = sampled(triangle, step, n_samples), coarse = sampled(triangle, 25. * step, n_samples / 25);
  for (const double frequency : {7., 50., 150.}) {
    const double expected = BandCheck(model, 2, step, n_samples, 2. * pi * frequency).beyond(fine);
    const double found = BandCheck(model, 2, 25. * step, n_samples / 25, 2. * pi * frequency).beyond(coarse);
    EXPECT_NEAR(found, expected, 0.02 * expected) << frequency;
  }
}

TEST(BandCheck, AFastBurstHasAllBeyond) {
  const ModalModel model = Oscillator().model();
  const WaveSamples wave = sampled(burst, step, n_samples);
  for (int i = 0; i < 3; ++i) {
    const double peak = batch(model, i, wave, step).cwiseAbs().maxCoeff();
    EXPECT_NEAR(BandCheck(model, i, step, n_samples, 2. * pi * 50.).beyond(wave), peak, 1e-3 * peak);
    EXPECT_LT(BandCheck(model, i, step, n_samples, 2. * pi * 200.).beyond(wave), 0.05 * peak);
  }
}

// If the response decays within the padding, the whole response to a wave of zero mean lies beyond a frequency close
// to zero.
TEST(BandCheck, BeyondZeroIsTheWholeResponse) {
  ModalModel model = random_model(24, 2, 1, 0.01);
  model.impulse.setZero();
  for (int m = 0; m < 24; ++m) model.pole[m] -= 10.;
  WaveSamples wave = random_wave(2, 900);
  wave.rightCols(600).setZero();
  for (int k = 0; k < 2; ++k) wave.row(k).head(300).array() -= wave.row(k).head(300).mean();
  wave.col(0).setZero();
  wave.col(1) -= wave.rowwise().sum();
  const double peak = batch(model, 0, wave, 0.01).cwiseAbs().maxCoeff();
  EXPECT_NEAR(BandCheck(model, 0, 0.01, 900, 1e-6).beyond(wave), peak, 1e-9 * peak);
}

}  // namespace batch_response_test
