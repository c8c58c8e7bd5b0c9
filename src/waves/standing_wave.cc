#include "upbead/waves/standing_wave.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "base/numbers.h"
#include "base/text.h"
#include "require_positive.h"
#include "standing_series.h"
#include "upbead/base/error.h"
#include "upbead/waves/wave_heights.h"

namespace upbead {

namespace {

constexpr int most_harmonics = 16;
constexpr double residual_wanted = 1e-4, residual_allowed = 1e-3;

/// Largest kH over tanh kh, with k of small waves: a higher wave breaks before the wall, H > 0.142 L tanh kh (Miche
/// 1944).
constexpr double highest_that_comes = 0.142 * two_pi;

/// In units of g: crests fall no faster. The steepest wave of deep water has kH = 0.62 (Schwartz and Whitney, J.
/// Fluid Mech. 107 (1981) 147-171); this limit gives 0.60. The series also converge for waves that do not exist.
constexpr double fastest_crest = 0.8;

[[noreturn]] void refuse(const StandingWaveGiven& given) {
  throw NumericsError("no standing wave of H = " + significant(given.height, 4) +
                      " m and T = " + significant(given.period, 4) + " s is found in " + significant(given.depth, 4) +
                      " m of water: it breaks, or the water is too shallow for its series");
}

}  // namespace

StandingWave::StandingWave(const StandingWaveGiven& given, const Water& water, const StandingWave* lower)
    : given_(given), water_(water) {
  const std::string whose = "a standing wave needs";
  require_positive(given.depth, "depth", whose);
  require_positive(given.height, "height", whose);
  require_positive(given.period, "period", whose);
  require_positive(water.density, "density", whose);
  require_positive(water.gravity, "gravity", whose);
  const double kh = relative_wave_number(given.period, given.depth, water.gravity);
  if (kh * given.height / given.depth > highest_that_comes * std::tanh(kh)) refuse(given);
  const bool serves = lower && lower->given_.depth == given.depth && lower->given_.period == given.period &&
                      lower->given_.height <= given.height && lower->water_.gravity == water.gravity;
  if (serves && lower->given_.height == given.height) {
    series_ = lower->series_;
    return;
  }
  const auto found = solve_standing(given.height / given.depth, kh, residual_wanted, most_harmonics,
                                    serves ? lower->series_.get() : nullptr);
  if (!found || found->residual > residual_allowed || found->at(0.).downward_acceleration() > fastest_crest)
    refuse(given);
  series_ = std::make_shared<const StandingSeries>(*found);
}

double StandingWave::wavelength() const {
  return two_pi * given_.depth / series_->K;
}

int StandingWave::harmonics() const {
  return series_->n;
}

double StandingWave::residual() const {
  return series_->residual;
}

StandingMoment StandingWave::at(double time) const {
  return {*series_, given_.depth, two_pi * time / given_.period, water_.density * water_.gravity};
}

StandingMoment::StandingMoment(const StandingSeries& series, double depth, double tau, double unit_weight)
    : instant_(std::make_shared<const StandingInstant>(series.at(tau))),
      k_(series.K / depth),
      unit_weight_(unit_weight),
      at_wall_(instant_->surface(0.) / k_) {}

double StandingMoment::surface(double x) const {
  return x == 0. ? at_wall_ : instant_->surface(k_ * x) / k_;
}

double StandingMoment::pressure(double y, double x) const {
  const double still = unit_weight_ * std::max(-y, 0.);
  return y >= surface(x) ? -still : unit_weight_ * instant_->pressure(k_ * x, k_ * y) / k_ - still;
}

namespace {

using Rule = boost::math::quadrature::gauss<double, 10>;

/// Integral of a function that has kinks only at still water and at the surface.
template <class Function>
double integral_over_wall(const Function& f, double from, double to, double surface) {
  std::vector<double> ends{from};
  for (const double kink : {std::min(surface, 0.), std::max(surface, 0.)})
    if (kink > ends.back() && kink < to) ends.push_back(kink);
  ends.push_back(to);
  double sum = 0.;
  for (std::size_t i = 1; i < ends.size(); ++i) sum += Rule::integrate(f, ends[i - 1], ends[i]);
  return sum;
}

/// Integral of f(p(y), y) over the caisson's front.
template <class Function>
double integral_over_front(const StandingMoment& moment, const Section& section, const Function& f) {
  const double surface = moment.surface(), top = std::max(std::min(section.crest, surface), 0.);
  return integral_over_wall([&](double y) { return f(moment.pressure(y), y); }, -section.foundation_depth, top,
                            surface);
}

double force_at(const StandingWave& wave, const Section& section, double time) {
  return integral_over_front(wave.at(time), section, [](double p, double) { return p; });
}

}  // namespace

WallPressure wall_pressure(const StandingWave& wave, const Section& section, double time) {
  const StandingMoment moment = wave.at(time);
  WallPressure at;
  at.time = time;
  at.surface = moment.surface();
  const double bottom = -section.foundation_depth;
  at.force = integral_over_front(moment, section, [](double p, double) { return p; });
  at.force_moment = integral_over_front(moment, section, [&](double p, double y) { return p * (y - bottom); });
  at.edge_pressure = moment.pressure(bottom);
  at.uplift = 0.5 * section.width * std::max(at.edge_pressure, 0.);
  return at;
}

namespace {

/// Time in a period at which f is least: between the neighbours of the least of the samples.
double least_at(const std::function<double(double)>& f, const std::vector<double>& samples, double dt) {
  const auto least = std::min_element(samples.begin(), samples.end()) - samples.begin();
  const int bits = std::numeric_limits<double>::digits / 2;
  const double at = static_cast<double>(least) * dt;
  return boost::math::tools::brent_find_minima(f, at - dt, at + dt, bits).first;
}

}  // namespace

StandingExtremes standing_extremes(const StandingWave& wave, const Section& section) {
  constexpr int samples = 32;  // of half a period: P is symmetric about the crest
  const double dt = 0.5 * wave.period() / samples;
  const auto force = [&](double t) { return force_at(wave, section, t); };
  const auto less = [&](double t) { return -force(t); };
  std::vector<double> forces, turned;
  for (int i = 0; i <= samples; ++i) {
    forces.push_back(force(i * dt));
    turned.push_back(-forces.back());
  }
  StandingExtremes found;
  found.landward = wall_pressure(wave, section, least_at(less, turned, dt));
  found.seaward = wall_pressure(wave, section, least_at(force, forces, dt));
  found.crest = wave.surface(0.);
  found.trough = wave.surface(0.5 * wave.period());
  return found;
}

std::vector<double> wall_heights(const StandingWave& wave, const Section& section) {
  constexpr int below = 8, above = 4;
  std::vector<double> heights;
  for (int i = 0; i <= below; ++i) heights.push_back(-section.foundation_depth * (below - i) / below);
  const double top = std::min(section.crest, wave.surface(0.));
  for (int i = 1; i <= above && top > 0.; ++i) heights.push_back(top * i / above);
  return heights;
}

std::vector<double> wall_pressures(const StandingWave& wave, const std::vector<double>& heights, double time) {
  // projection on functions that are linear between the heights; it keeps the force and the moment (test functions 1
  // and y)
  const auto n = static_cast<Eigen::Index>(heights.size());
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(n);
  const StandingMoment moment = wave.at(time);
  const double surface = moment.surface();
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    const double from = heights[static_cast<std::size_t>(i)], to = heights[static_cast<std::size_t>(i) + 1];
    const double length = to - from;
    mass.block<2, 2>(i, i) += length / 6. * (Eigen::Matrix2d() << 2., 1., 1., 2.).finished();
    const auto p = [&](double y) { return moment.pressure(y); };
    load[i] += integral_over_wall([&](double y) { return p(y) * (to - y) / length; }, from, to, surface);
    load[i + 1] += integral_over_wall([&](double y) { return p(y) * (y - from) / length; }, from, to, surface);
  }
  const Eigen::VectorXd value = mass.ldlt().solve(load);
  return {value.begin(), value.end()};
}

}  // namespace upbead
