#include "respond/answer_step.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/progress.h"
#include "respond/wave_grid.h"

namespace upbead {

namespace {

/// By how much the loads of a wave jump, and change their slope, at the wave's times, K x N. The loads are straight
/// in between, and zero outside the wave.
struct Changes {
  Eigen::MatrixXd jump, bend;
};

Changes changes(const WaveFile& file, int wave) {
  const Eigen::MatrixXd f = file.wave(wave);
  const Eigen::Index n = f.cols();
  Changes c{Eigen::MatrixXd::Zero(f.rows(), n), Eigen::MatrixXd::Zero(f.rows(), n)};
  c.jump.col(0) = f.col(0);
  c.jump.col(n - 1) = -f.col(n - 1);
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    const Eigen::VectorXd slope = (f.col(i + 1) - f.col(i)) / (file.time[i + 1] - file.time[i]);
    c.bend.col(i) += slope;
    c.bend.col(i + 1) -= slope;
  }
  return c;
}

/// The largest value of the response at the wave's own times.
double largest_answer(const ModalModel& model, const WaveFile& file, int wave) {
  const WaveGrid grid = make_wave_grid(file.time, infinity, file.time.back());
  const Series answer = respond(model, with_jumps(on_grid(file, wave, grid.time), grid));
  return answer.reading.row(0).cwiseAbs().maxCoeff();
}

}  // namespace

LineMisses::LineMisses(const ModalModel& model, const WaveFile& file, int wave)
    : bend_(Eigen::ArrayXd::Zero(model.n_modes())), fast_(2. * model.pole.array().abs2().inverse()) {
  const Changes c = changes(file, wave);
  const Eigen::ArrayXXd load = model.load.array().abs(), size = model.pole.array().abs();
  const Eigen::ArrayXd decay = model.pole.array().real();
  Eigen::ArrayXd now = bend_, factor = Eigen::ArrayXd::Ones(now.size());
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(c.bend.rows());
  double step = 0.;
  for (Eigen::Index i = 0; i < c.bend.cols(); ++i) {
    const double since = i > 0 ? file.time[i] - file.time[i - 1] : 0.;
    if (std::abs(since - step) > 1e-6 * step) factor = (decay * (step = since)).exp();
    now = now * factor + (load.matrix() * c.bend.col(i).cwiseAbs()).array() +
          size.col(0) * (load.matrix() * c.jump.col(i).cwiseAbs()).array();
    bend_ = bend_.max(now);
    slope += c.bend.col(i);
    of_integral_ = std::max(of_integral_, model.impulse.row(0).cwiseAbs().dot(slope.cwiseAbs().transpose()));
  }
  bend_ *= model.reading.row(0).array().abs().transpose();
}

double LineMisses::at(double h) const {
  const double slow = h * h / 8.;
  return (bend_ * fast_.min(slow)).sum() + slow * of_integral_;
}

double answer_step(const std::vector<ResolvedReading>& readings, const WaveFile& file, double shortest,
                   double longest) {
  constexpr int halvings = 16;  // halvings of the logarithm of the range
  std::vector<double> steps(static_cast<std::size_t>(file.n_waves()), longest);
  in_parallel(steps.size(), "choosing steps", [&](std::size_t w) {
    const int wave = static_cast<int>(w);
    const double scale = largest_answer(*readings.front().model, file, wave);
    for (const ResolvedReading& reading : readings) {
      const LineMisses misses(*reading.model, file, wave);
      const auto resolved = [&](double h) { return misses.at(h) <= reading.tolerance * scale; };
      if (scale == 0. || resolved(steps[w])) continue;
      double low = std::log(shortest), high = std::log(steps[w]);
      for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (resolved(std::exp(middle)) ? low : high) = middle;
      }
      steps[w] = std::exp(low);
    }
  });
  return *std::min_element(steps.begin(), steps.end());
}

}  // namespace upbead
