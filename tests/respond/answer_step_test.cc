// Claims: a reading deviates from straight lines between its values by at most the bound of LineMisses, also with
// free vibrations, jumps and fast modes; the chosen step keeps the deviation below the tolerance and is not
// needlessly short; peaks of responses on it are those of a fine grid, and S by eq. (4) is accurate to a fifth of the
// model's tolerance. Source: the exact response at fifty times as many times.
#include "respond/answer_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../dynamics/modal_models.h"
#include "../output/sample_model.h"
#include "respond/respond_waves.h"
#include "respond/wave_grid.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead::test {

namespace answer_step_test {

constexpr int parts = 50;

WaveFile file_of(const std::vector<double>& time, int n_loads, double last) {
  WaveFile file{"w", time, WaveSamples::Zero(n_loads, static_cast<Eigen::Index>(time.size())), n_loads, {}};
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> number(-1., 1.);
  for (int k = 0; k < n_loads; ++k)
    for (Eigen::Index n = 0; n < file.value.cols(); ++n) file.value(k, n) = number(generator);
  file.value.rightCols(1) *= last;
  return file;
}

/// Largest deviation of the first reading from the straight lines between its values at times h apart.
double largest_miss(const ModalModel& model, const WaveFile& file, double h, double end) {
  const WaveGrid coarse = make_wave_grid(file.time, h, end), fine = make_wave_grid(coarse.time, h / parts, end);
  WaveGrid grid = fine;
  const auto index = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(fine.time.begin(), fine.time.end(), t - 1e-9) - fine.time.begin());
  };
  grid.first = index(file.time.front());
  grid.last.reset();
  if (file.time.back() < end - 1e-9) grid.last = index(file.time.back());
  const Eigen::RowVectorXd y = respond(model, with_jumps(on_grid(file, 0, grid.time), grid)).reading.row(0);
  double largest = 0.;
  for (std::size_t n = 1; n < coarse.time.size(); ++n) {
    const std::size_t a = index(coarse.time[n - 1]), b = index(coarse.time[n]);
    for (std::size_t i = a + 1; i < b; ++i) {
      const double right = (fine.time[i] - fine.time[a]) / (fine.time[b] - fine.time[a]);
      const auto at = [&y](std::size_t j) { return y[static_cast<Eigen::Index>(j)]; };
      largest = std::max(largest, std::abs(at(i) - (1. - right) * at(a) - right * at(b)));
    }
  }
  return largest;
}

/// A reading with feedthrough jumps with the load at a time of the grid, so it is no straight line there.
ModalModel without_feedthrough(ModalModel model) {
  model.feedthrough.setZero();
  return model;
}

TEST(LineMisses, AreNeverMoreThanTold) {
  const std::vector<double> equal{0., 0.1, 0.2, 0.3, 0.4, 0.5}, uneven{0.05, 0.08, 0.3, 0.31, 0.5};
  for (const auto& time : {equal, uneven})
    for (const double last : {0., 1.})
      for (const ModalModel& model : {single_mode({0., 30.}), single_mode({-0.2, 4.}), single_mode({-400., 3000.}),
                                      single_mode(-25.), without_feedthrough(random_model(12, 2, 1, 0.01))}) {
        const WaveFile file = file_of(time, model.n_loads(), last);
        for (const double h : {0.05, 0.01, 1e-3}) {
          const double told = LineMisses(model, file, 0).at(h), found = largest_miss(model, file, h, 1.);
          EXPECT_LE(found, told * (1. + 1e-9) + 1e-14) << model.pole[0] << ", step " << h;
        }
      }
}

// One slow mode: the bound equals the deviation where the curvature is largest.
TEST(LineMisses, AreToldNearly) {
  const ModalModel model = single_mode({0., 4.});
  const WaveFile file{"w", {0., 0.25, 3.}, (WaveSamples(1, 3) << 0., 1., 0.).finished(), 1, {}};
  const double told = LineMisses(model, file, 0).at(0.01);
  EXPECT_GT(largest_miss(model, file, 0.01, 3.), 0.3 * told);
}

TEST(AnswerStep, KeepsTheToleranceAndIsNotShortForNothing) {
  const WaveFile file{"w", {0., 0.1, 0.3, 1.}, (WaveSamples(1, 4) << 0., 1., 0.3, 0.).finished(), 1, {}};
  constexpr double tolerance = 1e-4, shortest = 1e-5, longest = 0.05;
  for (const ModalModel& model : {single_mode({0., 12.}), single_mode({-2., 12.}), single_mode({-30., 300.})}) {
    const double h = answer_step({{&model, tolerance}}, file, shortest, longest);
    double top = 0.;
    const WaveGrid grid = make_wave_grid(file.time, 1e-4, 1.);
    top = respond(model, with_jumps(on_grid(file, 0, grid.time), grid)).reading.cwiseAbs().maxCoeff();
    EXPECT_LE(largest_miss(model, file, h, 1.), tolerance * top);
    EXPECT_GT(largest_miss(model, file, 6. * h, 1.), tolerance * top) << model.pole[0];
  }
}

TEST(AnswerStep, IsTheShortestWhereNothingWillDoAndTheLongestWhereNothingBends) {
  const ModalModel ringing = single_mode({0., 1e5});
  WaveFile file{"w", {0., 1., 2.}, (WaveSamples(1, 3) << 0., 1., 0.).finished(), 1, {}};
  EXPECT_NEAR(answer_step({{&ringing, 1e-12}}, file, 1e-4, 0.1), 1e-4, 1e-6);
  file.value.setZero();
  EXPECT_EQ(answer_step({{&ringing, 1e-12}}, file, 1e-4, 0.1), 0.1);
}

// Two very different models: the oscillator, checked to frequencies far above its own; and undamped, with a second
// mode of high frequency.
TEST(AnswerStep, PeaksOfAnswersAreThoseOfAFineGrid) {
  ReducedModelFile checked = oscillator();
  checked.highest_frequency = 5000.;
  ReducedModelFile undamped = checked;
  undamped.modes.pole[0].real(0.);
  undamped.modes.pole[1] = {0., 900.};
  for (const ReducedModelFile& model : {checked, undamped}) {
    const WaveFile coarse{"w", {0., 0.05, 0.1, 0.15, 0.2}, WaveSamples::Zero(2, 5), 2, {}};
    WaveFile wave = coarse;
    wave.value.row(0) << 0., 1.6e6, 4e5, 4e5, 0.;
    RespondOptions options;
    options.sliding = ModelSliding{0.6, 1e6};
    const WaveResponses found = respond_to_waves(model, {wave}, options).front();
    WaveFile fine = wave;
    fine.time.clear();
    for (int n = 0; n <= 20000; ++n) fine.time.push_back(1e-5 * n);
    fine.value = on_grid(wave, 0, fine.time);
    const WaveResponses exact = respond_to_waves(model, {fine}, options).front();
    const double peak = exact.waves[0].peak_shear;
    EXPECT_NEAR(found.waves[0].peak_shear, peak, 1e-5 * peak);
    EXPECT_NEAR(found.waves[0].peak_shear_seaward, exact.waves[0].peak_shear_seaward, 1e-5 * peak);
    ASSERT_GT(*exact.waves[0].sliding, 1e-3);
    EXPECT_NEAR(*found.waves[0].sliding, *exact.waves[0].sliding, 2e-3 * *exact.waves[0].sliding);
    EXPECT_LT(found.time.size(), exact.time.size() / 4);
  }
}

}  // namespace answer_step_test

}  // namespace upbead::test
