// Claims: the error of a model truncated to a few modes never exceeds its bound, and for the worst load it reaches a
// third of the bound; with all modes the truncated model is the model; poles at 0 are kept.
#include "dynamics/truncate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dynamics/batch_response.h"
#include "modal_models.h"

namespace upbead::test {
namespace truncate_test {

constexpr double step = 0.01;
constexpr int n_samples = 600;

/// Random samples from 0 on, straight over `samples_per_corner` samples.
WaveSamples wave(unsigned seed, int samples_per_corner) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1., 1.);
  WaveSamples f = WaveSamples::Zero(1, n_samples);
  for (int i = 0; i + samples_per_corner < n_samples; i += samples_per_corner) {
    const double next = number(generator);
    for (int j = 1; j <= samples_per_corner; ++j) f(0, i + j) = f(0, i) + (next - f(0, i)) * j / samples_per_corner;
  }
  return f.leftCols((n_samples - 1) / samples_per_corner * samples_per_corner);
}

double largest_miss(const ModalModel& whole, const ModalModel& part, const WaveSamples& f) {
  Eigen::RowVectorXd a(f.cols()), b(f.cols());
  BatchResponse(whole, 0, step).respond(f, a);
  BatchResponse(part, 0, step).respond(f, b);
  return (a - b).cwiseAbs().maxCoeff();
}

/// Random modes, without the term of the loads' integrals, which is no mode.
ModalModel modes() {
  ModalModel model = random_model(40, 1, 1, step);
  model.impulse.setZero();
  return model;
}

TEST(Truncated, MissesByNoMoreThanItSays) {
  const ModalModel model = modes();
  double nearest = 0.;
  for (const int n : {0, 4, 8, 16, 32})
    for (const int corner : {1, 7, 50})
      for (unsigned seed = 1; seed <= 10; ++seed) {
        const TruncatedModel few = truncated(model, n);
        const WaveSamples f = wave(seed, corner);
        const double told = truncation_error(few, f.row(0), step);
        EXPECT_LE(largest_miss(model, few.model, f), told * (1. + 1e-9) + 1e-12) << n << " modes, corner " << corner;
        EXPECT_LE(few.model.n_modes(), n + 8) << "and those at 0";
      }
  // one mode that hardly decays, and a load in resonance with it
  ModalModel lone = single_mode({-1e-6, 2. * M_PI / (8. * step)});
  const TruncatedModel none = truncated(lone, 0);
  WaveSamples f = WaveSamples::Zero(1, n_samples);
  for (int i = 0; i < n_samples; ++i) f(0, i) = std::abs((i + 4) % 8 - 4) * 0.25;
  nearest = largest_miss(lone, none.model, f) / truncation_error(none, f.row(0), step);
  EXPECT_GT(nearest, 1. / 3.);
  EXPECT_LE(nearest, 1.);
}

TEST(Truncated, OfAllModesIsTheModel) {
  const ModalModel model = modes();
  const TruncatedModel all = truncated(model, model.n_modes());
  EXPECT_EQ(all.left_out, 0.);
  EXPECT_LT(largest_miss(model, all.model, wave(3, 5)), 1e-10);
}

TEST(Truncated, KeepsPolesAtZero) {
  const TruncatedModel none = truncated(single_mode({0., 0.}), 0);
  EXPECT_EQ(none.model.n_modes(), 1);
  EXPECT_EQ(none.left_out, 0.);
}

}  // namespace truncate_test
}  // namespace upbead::test
