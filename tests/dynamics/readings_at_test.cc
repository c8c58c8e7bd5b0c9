// Claim: readings at a few times are those of the whole response at these times: of waves on equal steps, also where
// they jump at the beginning, and of loads at any times, with integrals of loads among the readings.
#include "dynamics/readings_at.h"

#include <gtest/gtest.h>

#include <cmath>

namespace upbead::test {
namespace readings_at_test {

/// Three modes of which two swing, two loads, four readings, one with an integral.
ModalModel model_of_all_kinds() {
  ModalModel model;
  model.pole = Eigen::Vector3cd({-2., 31.}, {-9., 140.}, {-4., 0.});
  model.load = Eigen::MatrixXcd::Random(3, 2);
  model.reading = Eigen::MatrixXcd::Random(4, 3);
  model.feedthrough = Eigen::MatrixXd::Random(4, 2);
  model.impulse = Eigen::MatrixXd::Zero(4, 2);
  model.impulse.row(2) << 0.7, -0.3;
  model.load_name = {"a", "b"};
  model.reading_label.assign(4, {});
  return model;
}

WaveSamples wave(Eigen::Index n, double first) {
  WaveSamples loads(2, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = static_cast<double>(i);
    loads(0, i) = first + std::sin(0.1 * t);
    loads(1, i) = i > 100 ? 0. : 0.01 * t;
  }
  return loads;
}

SampledLoads sampled(const WaveSamples& loads, const std::vector<double>& time) {
  const Eigen::Index n = loads.cols() - 1;
  return {time, loads.leftCols(n), loads.rightCols(n)};
}

TEST(ReadingsAt, AreThoseOfTheWholeResponse) {
  const ModalModel model = model_of_all_kinds();
  const double step = 2e-3;
  const std::vector<std::size_t> times{0, 3, 64, 65, 200, 399};
  for (const double first : {0., 0.8}) {
    const WaveSamples loads = wave(400, first);
    std::vector<double> time;
    for (int i = 0; i < 400; ++i) time.push_back(i * step);
    const Eigen::MatrixXd whole = respond(model, sampled(loads, time)).reading;
    const Eigen::MatrixXd some = ReadingsAt(model, step).of(loads, times);
    const Eigen::MatrixXd others = respond_at(model, sampled(loads, time), times);
    for (std::size_t c = 0; c < times.size(); ++c) {
      const auto column = static_cast<Eigen::Index>(c), at = static_cast<Eigen::Index>(times[c]);
      EXPECT_LT((others.col(column) - whole.col(at)).norm(), 1e-12 * whole.norm()) << times[c];
      if (times[c] == 0) continue;  // at a jump: before it there, after it here
      EXPECT_LT((some.col(column) - whole.col(at)).norm(), 1e-12 * whole.norm()) << times[c];
    }
  }
}

TEST(ReadingsAt, AreTheSameOnUnequalSteps) {
  const ModalModel model = model_of_all_kinds();
  const WaveSamples loads = wave(50, 0.3);
  std::vector<double> time;
  for (int i = 0; i < 50; ++i) time.push_back(1e-3 * i + 2e-5 * i * i);
  const std::vector<std::size_t> times{1, 7, 49};
  const Eigen::MatrixXd whole = respond(model, sampled(loads, time)).reading;
  const Eigen::MatrixXd some = respond_at(model, sampled(loads, time), times);
  for (Eigen::Index c = 0; c < 3; ++c)
    EXPECT_LT((some.col(c) - whole.col(static_cast<Eigen::Index>(times[static_cast<std::size_t>(c)]))).norm(),
              1e-12 * whole.norm());
}

TEST(ReadingsAt, RefuseTimesThatAreNotThere) {
  const ReadingsAt at(model_of_all_kinds(), 1e-2);
  EXPECT_THROW(at.of(wave(10, 0.), {10}), std::invalid_argument);
  EXPECT_THROW(at.of(wave(10, 0.), {3, 2}), std::invalid_argument);
  EXPECT_THROW(at.of(WaveSamples::Zero(1, 10), {3}), std::invalid_argument);
}

}  // namespace readings_at_test
}  // namespace upbead::test
