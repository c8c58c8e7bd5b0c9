#include "dynamics/dense_output.h"

#include <algorithm>
#include <cmath>

namespace upbead {

namespace {

double applied(const Row& row, const Vector& x) {
  double sum = 0.;
  for (const auto& [i, weight] : row) sum += weight * x[i];
  return sum;
}

Jet jet_of(const Row& row, const State& state) {
  return {applied(row, state.x), applied(row, state.v), applied(row, state.a)};
}

/// Sets x'' at both ends from x and x' there, so that the quintic becomes a cubic.
void set_seconds_of_cubic(Jet& begin, Jet& end, double h) {
  const double chord = 6. * (end.value - begin.value) / h;
  begin.second = (chord - 4. * begin.first - 2. * end.first) / h;
  end.second = (-chord + 2. * begin.first + 4. * end.first) / h;
}

/// Sets x'' at the beginning from all other values, so that the quintic becomes a quartic.
void set_second_of_quartic(Jet& begin, const Jet& end, double h) {
  const double value = end.value - begin.value - h * begin.first, slope = h * (end.first - begin.first);
  begin.second = (12. * value - 6. * slope + h * h * end.second) / (h * h);
}

Series empty_like(const Series& series, std::size_t n) {
  const auto columns = static_cast<Eigen::Index>(n);
  return {{}, Eigen::MatrixXd(series.reading.rows(), columns), Eigen::MatrixXd(series.load.rows(), columns)};
}

void append_column(double time, const Vector& reading, const Vector& load, Series& series) {
  const auto column = static_cast<Eigen::Index>(series.time.size());
  series.time.push_back(time);
  series.reading.col(column) = reading;
  series.load.col(column) = load;
}

void drop_unused_columns(Series& series) {
  const auto n = static_cast<Eigen::Index>(series.time.size());
  series.reading.conservativeResize(Eigen::NoChange, n);
  series.load.conservativeResize(Eigen::NoChange, n);
}

}  // namespace

DenseRecorder::DenseRecorder(const System& system, std::vector<double> times, bool inertia)
    : system_(system), times_(std::move(times)), inertia_(inertia), prescribes_(false) {
  for (const SystemLoad& load : system.loads) prescribes_ = prescribes_ || load.prescribed >= 0;
  series_.reading.resize(static_cast<Eigen::Index>(system.readings.size()), static_cast<Eigen::Index>(times_.size()));
  series_.load.resize(static_cast<Eigen::Index>(system.loads.size()), static_cast<Eigen::Index>(times_.size()));
}

std::vector<DenseRecorder::Part> DenseRecorder::parts_of(const State& state) const {
  std::vector<Part> parts;
  for (const Reading& r : system_.readings)
    parts.push_back({jet_of(r.position, state), jet_of(r.velocity, state), jet_of(r.acceleration, state)});
  return parts;
}

DenseRecorder::Course DenseRecorder::course(double begin, double h) const {
  Course course = inertia_ && !prescribes_ ? Course::quintic : Course::cubic;
  for (const SystemLoad& load : system_.loads) {
    const double left = last_step_ > 0. ? load.history(begin, begin - 0.5 * last_step_) : 0.;
    const double right = load.history(begin, begin + 0.5 * h);
    constexpr double round_off = 1e-9;
    if (std::abs(right - left) <= round_off * std::max(std::abs(right), std::abs(left))) continue;
    if (load.prescribed >= 0 || !inertia_) return Course::straight;
    if (course == Course::quintic) course = Course::quartic;
  }
  return course;
}

double DenseRecorder::between(const Part& before, const Part& now, Course course, double h, double t) const {
  if (course == Course::straight) {
    const double begin = before.position.value + before.velocity.first + before.acceleration.second;
    const double end = now.position.value + now.velocity.first + now.acceleration.second;
    return begin + t / h * (end - begin);
  }
  const auto polynomial = [&](Jet begin, Jet end) {
    if (course == Course::quartic) set_second_of_quartic(begin, end, h);
    if (course == Course::cubic) set_seconds_of_cubic(begin, end, h);
    return QuinticHermite(0., h, begin, end)(t);
  };
  return polynomial(before.position, now.position).value + polynomial(before.velocity, now.velocity).first +
         polynomial(before.acceleration, now.acceleration).second;
}

void DenseRecorder::record(double time, double inside, double h, Course course, const std::vector<Part>& now) {
  Vector load(system_.loads.size()), reading(system_.readings.size());
  for (std::size_t k = 0; k < system_.loads.size(); ++k) load[k] = system_.loads[k].history(time, inside);
  if (h == 0.) load.setZero();  // at rest no load counts
  for (std::size_t i = 0; i < system_.readings.size(); ++i) {
    reading[i] = h > 0. ? between(before_[i], now[i], course, h, std::min(time - last_, h))
                        : now[i].position.value + now[i].velocity.first + now[i].acceleration.second;
    const std::vector<double>& feedthrough = system_.readings[i].feedthrough;
    for (std::size_t k = 0; k < feedthrough.size(); ++k) reading[i] += feedthrough[k] * load[k];
  }
  append_column(time, reading, load, series_);
}

void DenseRecorder::see(const State& state, int step, int) {
  if (step == 0) {
    series_.time.clear();
    last_ = last_step_ = 0.;
  }
  const double h = state.time - last_;
  std::vector<Part> now = parts_of(state);
  const auto due = [&] {
    return series_.time.size() < times_.size() && times_[series_.time.size()] <= state.time + 1e-9 * h;
  };
  if (due()) {
    const Course way = h > 0. ? course(last_, h) : Course::straight;
    while (due()) record(times_[series_.time.size()], last_ + 0.5 * h, h, way, now);
  }
  before_ = std::move(now);
  last_step_ = h;
  last_ = state.time;
}

Series DenseRecorder::series() const {
  Series series = series_;
  drop_unused_columns(series);
  return series;
}

Series at_times(const Series& series, const std::vector<double>& times, double tolerance) {
  Series picked = empty_like(series, times.size());
  for (const double time : times) {
    const auto at = std::lower_bound(series.time.begin(), series.time.end(), time - tolerance);
    if (at == series.time.end() || *at > time + tolerance) continue;
    const auto column = static_cast<Eigen::Index>(at - series.time.begin());
    append_column(time, series.reading.col(column), series.load.col(column), picked);
  }
  drop_unused_columns(picked);
  return picked;
}

Series straight_between(const Series& series, const std::vector<double>& times) {
  Series dense = empty_like(series, times.size());
  for (const double time : times) {
    const auto after = std::lower_bound(series.time.begin(), series.time.end(), time);
    if (after == series.time.end()) break;
    const auto right = static_cast<Eigen::Index>(after - series.time.begin()),
               left = std::max<Eigen::Index>(right - 1, 0);
    const double h = series.time[right] - series.time[left], s = h > 0. ? (time - series.time[left]) / h : 1.;
    append_column(time, (1. - s) * series.reading.col(left) + s * series.reading.col(right),
                  (1. - s) * series.load.col(left) + s * series.load.col(right), dense);
  }
  drop_unused_columns(dense);
  return dense;
}

}  // namespace upbead
