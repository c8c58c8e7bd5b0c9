#include "dynamics/step_interior.h"

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

}  // namespace

StepInterior::StepInterior(const System& system) : system_(system) {
  for (int i = 0; i < system.n_free(); ++i)  // pores keep their storage in M without inertia, too
    inertia_ = inertia_ || (system.field[i] == Field::displacement && system.M.coeff(i, i) != 0.);
  for (const SystemLoad& load : system.loads) prescribes_ = prescribes_ || load.prescribed >= 0;
}

std::vector<StepInterior::Part> StepInterior::parts_of(const State& state) const {
  std::vector<Part> parts;
  for (const Reading& r : system_.readings)
    parts.push_back({jet_of(r.position, state), jet_of(r.velocity, state), jet_of(r.acceleration, state)});
  return parts;
}

StepInterior::Course StepInterior::course(double h) const {
  Course course = inertia_ && !prescribes_ ? Course::quintic : Course::cubic;
  for (const SystemLoad& load : system_.loads) {
    const double left = last_step_ > 0. ? load.history(last_, last_ - 0.5 * last_step_) : 0.;
    const double right = load.history(last_, last_ + 0.5 * h);
    constexpr double round_off = 1e-9;
    if (std::abs(right - left) <= round_off * std::max(std::abs(right), std::abs(left))) continue;
    if (load.prescribed >= 0 || !inertia_) return Course::straight;
    if (course == Course::quintic) course = Course::quartic;
  }
  return course;
}

StepInterior::Values StepInterior::values(const Part& before, const Part& now, Course course, double h) {
  Values values;
  if (course == Course::straight) {
    const double begin = before.position.value + before.velocity.first + before.acceleration.second;
    const double end = now.position.value + now.velocity.first + now.acceleration.second;
    for (std::size_t j = 0; j < inside_places.size(); ++j) values[j] = begin + inside_places[j] * (end - begin);
    return values;
  }
  const auto polynomial = [&](Jet begin, Jet end) {
    if (course == Course::quartic) set_second_of_quartic(begin, end, h);
    if (course == Course::cubic) set_seconds_of_cubic(begin, end, h);
    return QuinticHermite(0., h, begin, end);
  };
  const QuinticHermite x = polynomial(before.position, now.position), v = polynomial(before.velocity, now.velocity),
                       a = polynomial(before.acceleration, now.acceleration);
  for (std::size_t j = 0; j < inside_places.size(); ++j) {
    const double t = inside_places[j] * h;
    values[j] = x(t).value + v(t).first + a(t).second;
  }
  return values;
}

void StepInterior::begin(const State& state, double last_step) {
  before_ = parts_of(state);
  last_ = state.time;
  last_step_ = last_step;
}

void StepInterior::add_step(const State& state, Series& inside) {
  const double h = state.time - last_;
  const Course by_loads = course(h), way = has_jumped_ ? Course::straight : by_loads;
  has_jumped_ = by_loads == Course::straight && !inertia_;
  const std::vector<Part> now = parts_of(state);
  const auto first = static_cast<Eigen::Index>(inside.time.size());
  constexpr auto n_places = static_cast<Eigen::Index>(inside_places.size());
  for (const double place : inside_places) inside.time.push_back(last_ + place * h);
  auto loads = inside.load.middleCols(first, n_places);
  for (std::size_t k = 0; k < system_.loads.size(); ++k)
    for (Eigen::Index j = 0; j < n_places; ++j)
      loads(static_cast<Eigen::Index>(k), j) =
          system_.loads[k].history(inside.time[static_cast<std::size_t>(first + j)], last_ + 0.5 * h);
  for (std::size_t i = 0; i < now.size(); ++i) {
    auto row = inside.reading.row(static_cast<Eigen::Index>(i)).segment(first, n_places);
    row = values(before_[i], now[i], way, h);
    const std::vector<double>& feedthrough = system_.readings[i].feedthrough;
    for (std::size_t k = 0; k < feedthrough.size(); ++k)
      row += feedthrough[k] * loads.row(static_cast<Eigen::Index>(k));
  }
  begin(state, h);
}

}  // namespace upbead
