#include "respond/wave_grid.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr double most_times = 1e7;

void require_room(double n, double step, double end) {
  if (n > most_times)
    throw InputError(Place(),
                     "answers up to t = " + significant(end) + " s in steps of " + significant(step) + " s are " +
                         significant(n) + " times, more than " + significant(most_times),
                     "lower --end");
}

/// The step of times 0, step, 2 step, ..., within the accuracy of a file with six digits.
std::optional<double> equal_step(const std::vector<double>& time) {
  const double step = time.back() / static_cast<double>(time.size() - 1);
  for (std::size_t n = 0; n < time.size(); ++n)
    if (!(std::abs(time[n] - static_cast<double>(n) * step) <= 1e-6 * step)) return {};
  return step;
}

/// Continues from the last time to `to` in equal parts.
void append_parts(std::vector<double>& time, double to, double longest) {
  const double from = time.back(), n = std::ceil((to - from) / longest * (1. - 1e-9));
  require_room(n + static_cast<double>(time.size()), longest, to);
  for (double i = 1.; i < n; ++i) time.push_back(from + (to - from) * i / n);
  time.push_back(to);
}

std::vector<double> equal_times_until(double step, double end) {
  const double n = std::ceil(end / step * (1. - 1e-9));
  require_room(n, step, end);
  std::vector<double> time;
  for (double i = 0.; i <= n; ++i) time.push_back(i * step);
  return time;
}

std::size_t index_of(double t, const std::vector<double>& time) {
  return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
}

/// When the last load of all waves is over (s): what is left then is less than a thousandth of the largest. 0 where the
/// file is cut off under load: more than a twentieth of the largest is left.
double end_of_loads(const WaveFile& file) {
  const double largest = file.value.cwiseAbs().maxCoeff(), least = 1e-3 * largest;
  if (file.value.rightCols(1).cwiseAbs().maxCoeff() > 0.05 * largest) return 0.;
  for (std::size_t n = file.time.size(); n-- > 0;)
    if (file.value.col(static_cast<Eigen::Index>(n)).cwiseAbs().maxCoeff() > least)
      return file.time[std::min(n + 1, file.time.size() - 1)];
  return 0.;
}

}  // namespace

double end_of_answer(const WaveFile& file, double end, double echo) {
  const double last = file.time.back(), longer = std::max(last, end);
  const double wanted = file.rings_down ? 0. : end_of_loads(file) + echo;
  if (wanted <= longer * (1. + 1e-9)) return longer;
  const std::optional<double> own = equal_step(file.time);  // whole steps, so that all stay equal
  return own ? last + *own * std::ceil((wanted - last) / *own * (1. - 1e-9)) : wanted;
}

WaveGrid make_wave_grid(const std::vector<double>& time, double longest_step, double end) {
  WaveGrid grid;
  if (const std::optional<double> own = equal_step(time)) {
    const double parts = std::max(1., std::ceil(*own / longest_step * (1. - 1e-9)));
    const double step = *own / parts, n = end / step;
    if (parts == 1. || std::abs(n - std::round(n)) <= 1e-6) grid.equal = step;
    const std::size_t last = (time.size() - 1) * static_cast<std::size_t>(parts);
    if (grid.equal) grid.time = equal_times_until(step, end);
    if (grid.equal && grid.time.size() > last + 1) grid.last = last;
    if (grid.equal) return grid;
  }
  grid.time = {0.};
  for (const double t : time)
    if (t > 0. && t < end) append_parts(grid.time, t, longest_step);
  if (time.back() < end) grid.last = grid.time.size() - 1;
  append_parts(grid.time, end, longest_step);
  if (time.front() <= end) grid.first = index_of(time.front(), grid.time);
  return grid;
}

WaveSamples on_grid(const WaveFile& file, int wave, const std::vector<double>& time) {
  const auto values = file.wave(wave);
  const std::vector<double>& own = file.time;
  const double round_off = 1e-6 * (own[1] - own[0]);  // by so much equal times may differ from those of the file
  WaveSamples samples = WaveSamples::Zero(file.n_loads, static_cast<Eigen::Index>(time.size()));
  const auto agree = [round_off](double a, double b) { return std::abs(a - b) <= round_off; };
  if (own.size() <= time.size() && std::equal(own.begin(), own.end(), time.begin(), agree)) {
    samples.leftCols(values.cols()) = values;
    return samples;
  }
  std::size_t left = 0;
  for (std::size_t n = 0; n < time.size(); ++n) {
    const double t = std::clamp(time[n], own.front(), own.back());
    if (std::abs(t - time[n]) > round_off) continue;
    while (left + 2 < own.size() && own[left + 1] <= t) ++left;
    const double right = (t - own[left]) / (own[left + 1] - own[left]);
    const auto l = static_cast<Eigen::Index>(left);
    samples.col(static_cast<Eigen::Index>(n)) = (1. - right) * values.col(l) + right * values.col(l + 1);
  }
  return samples;
}

SampledLoads with_jumps(const WaveSamples& samples, const WaveGrid& grid) {
  SampledLoads loads;
  loads.time = grid.time;
  const Eigen::Index n = samples.cols() - 1;
  loads.begin = samples.leftCols(n);
  loads.end = samples.rightCols(n);
  if (grid.first > 0) loads.end.col(static_cast<Eigen::Index>(grid.first) - 1).setZero();
  if (grid.last) loads.begin.col(static_cast<Eigen::Index>(*grid.last)).setZero();
  return loads;
}

std::vector<double> equal_times(const WaveGrid& grid, double longest_step, double until) {
  if (grid.equal) return equal_times_until(*grid.equal, until);
  double shortest = longest_step;
  for (std::size_t n = 1; n < grid.time.size(); ++n) shortest = std::min(shortest, grid.time[n] - grid.time[n - 1]);
  return equal_times_until(std::max(shortest, longest_step / 10.), until);
}

}  // namespace upbead
