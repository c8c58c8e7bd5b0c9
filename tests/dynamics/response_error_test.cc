// Claims: ResponseError is the difference between the responses of a model and of larger models to a wave, also where
// vibrations outlast the record; the larger models of nested_models are more accurate than their model for pulses
// much shorter and records much longer, and the bound computed from them holds.
// Source: the exact recurrence of every mode; a chain of masses and springs, its modes in closed form.
#include "dynamics/answer_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "modal_models.h"
#include "reduction_tools.h"
#include "spring_chain.h"

namespace upbead::test {
namespace response_error_test {

constexpr double step = 0.5;

/// Response to loads that are straight between samples and zero before; the last sample is zero.
Eigen::RowVectorXd exact_answer(const ModalModel& model, int reading, const WaveSamples& loads) {
  SampledLoads sampled;
  for (Eigen::Index n = 0; n < loads.cols(); ++n) sampled.time.push_back(static_cast<double>(n) * step);
  sampled.begin = loads.leftCols(loads.cols() - 1);
  sampled.end = loads.rightCols(loads.cols() - 1);
  return respond(model, sampled).reading.row(reading);
}

/// A triangle of that duration, `n` samples long.
WaveSamples triangle(double duration, int n) {
  WaveSamples f = WaveSamples::Zero(1, n);
  for (int i = 0; i < n; ++i) f(0, i) = std::max(0., 1. - std::abs(2. * i * step / duration - 1.));
  return f;
}

/// The model with only that reading.
ModalModel only(ModalModel model, int reading) {
  model.reading = Eigen::MatrixXcd(model.reading.row(reading));
  model.feedthrough = Eigen::MatrixXd(model.feedthrough.row(reading));
  model.impulse = Eigen::MatrixXd(model.impulse.row(reading));
  return model;
}

TEST(ResponseError, IsTheDifferenceOfTheModelsAnswers) {
  const ModalModel model = random_model(12, 2, 3, step);
  NestedModels nested{only(random_model(7, 2, 3, step), 1), only(random_model(9, 2, 3, step), 1)};
  constexpr int n = 700;
  WaveSamples loads = WaveSamples::Random(2, n);
  loads.leftCols(1).setZero();
  loads.rightCols(n / 3).setZero();
  const Eigen::RowVectorXd reference = exact_answer(nested.reference, 0, loads);
  const Eigen::RowVectorXd of_model = reference - exact_answer(model, 1, loads),
                           of_middle = reference - exact_answer(nested.middle, 0, loads);
  for (const auto& [n_waves, tolerance] : {std::pair{1, 1e-12}, {1000, 1e-3}}) {
    const ResponseDifference found = ResponseError(model, 1, nested, step, n, n_waves).of(loads);
    EXPECT_LT((found.of_model.transpose() - of_model).cwiseAbs().maxCoeff(),
              tolerance * of_model.cwiseAbs().maxCoeff());
    EXPECT_LT((found.of_middle.transpose() - of_middle).cwiseAbs().maxCoeff(),
              tolerance * of_middle.cwiseAbs().maxCoeff());
  }
}

// A first sample other than zero is reached along a line, with few waves as with many.
TEST(ResponseError, OfFewWavesIsThatOfMany) {
  const ModalModel model = random_model(12, 2, 1, step);
  const NestedModels nested{random_model(7, 2, 1, step), random_model(9, 2, 1, step)};
  WaveSamples loads = WaveSamples::Random(2, 300);
  const ResponseDifference few = ResponseError(model, 0, nested, step, 300, 2).of(loads),
                           many = ResponseError(model, 0, nested, step, 300, 1000).of(loads);
  EXPECT_LT((few.of_model - many.of_model).cwiseAbs().maxCoeff(), 1e-3 * many.of_model.cwiseAbs().maxCoeff());
  EXPECT_NEAR(few.bound(), many.bound(), 1e-3 * many.bound());
}

TEST(ResponseError, OfLoadsThatDoNotFit) {
  const ModalModel model = random_model(4, 2, 1, step);
  for (const int n_waves : {1, 1000}) {
    const ResponseError error(model, 0, {model, model}, step, 10, n_waves);
    EXPECT_THROW(error.of(WaveSamples::Zero(1, 10)), std::invalid_argument);
    EXPECT_THROW(error.of(WaveSamples::Zero(2, 9)), std::invalid_argument);
  }
}

TEST(ResponseError, BoundsTheErrorOfShorterPulsesAndLongerRecords) {
  const SpringChain chain;
  const System system = chain.system(hat());
  const double shift = 1.25 * 2. * std::acos(-1.) / 40.;  // of a triangle of 40
  constexpr int vectors = 30;
  const ModalModel model = modes_of(reduced(system, shift, vectors)), exact = chain.exact();
  const NestedModels nested = nested_models(system, {shift, vectors, {}}, {0});
  EXPECT_EQ(nested.reference.n_readings(), 1);
  int improved = 0;
  for (const double duration : {6., 12., 40., 200.})
    for (const int n : {200, 1000, 3000}) {
      const WaveSamples f = triangle(duration, n);
      const Eigen::RowVectorXd truth = exact_answer(exact, 0, f);
      const double error = (exact_answer(model, 0, f) - truth).cwiseAbs().maxCoeff();
      const double rest = (exact_answer(nested.reference, 0, f) - truth).cwiseAbs().maxCoeff();
      const double bound = ResponseError(model, 0, nested, step, n, 1000).of(f).bound();
      EXPECT_GE(bound + 1e-9 * truth.cwiseAbs().maxCoeff(), error) << duration << " " << n;
      EXPECT_LE(bound, 4. * error + 1e-9 * truth.cwiseAbs().maxCoeff()) << duration << " " << n;
      if (rest < 0.5 * error) ++improved;
    }
  EXPECT_GE(improved, 9) << "of 12";
}

}  // namespace response_error_test
}  // namespace upbead::test
