#include "expected/k_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <stdexcept>
#include <unsupported/Eigen/NonLinearOptimization>

namespace upbead {

namespace {

constexpr double least = 1e-3, largest_a = 10., largest_b = 100.;
constexpr double near_edge = 1.01;
constexpr double worst_condition = 1e4;

using Points = std::vector<DurationPoint>;

double sum_of_squares(const Points& points, const DurationFactor& factor) {
  double sum = 0.;
  for (const DurationPoint& point : points) sum += std::pow(factor(point.alpha_star) - point.k, 2);
  return sum;
}

/// Derivatives of k by (a, b): with s = alpha*^a, -b k s ln(alpha*) / (1 + s) and -k ln(1 + s); at alpha* = 0 k is 1
/// whatever a and b.
Eigen::RowVector2d gradient(const DurationFactor& factor, double alpha_star) {
  if (alpha_star <= 0.) return Eigen::RowVector2d::Zero();
  const double s = std::pow(alpha_star, factor.a), k = factor(alpha_star);
  return {-factor.b * k * s * std::log(alpha_star) / (1. + s), -k * std::log1p(s)};
}

Eigen::MatrixX2d jacobian(const Points& points, const DurationFactor& factor) {
  Eigen::MatrixX2d J(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    J.row(static_cast<Eigen::Index>(i)) = gradient(factor, points[i].alpha_star);
  return J;
}

DurationFactor from_logarithms(const Eigen::VectorXd& p) {
  return {std::clamp(std::exp(p[0]), least, largest_a), std::clamp(std::exp(p[1]), least, largest_b)};
}

/// The interface that Eigen's LevenbergMarquardt needs. The unknowns are ln a and ln b, so a and b stay positive.
struct Deviations {
  const Points& points;
  int inputs() const { return 2; }
  int values() const { return static_cast<int>(points.size()); }
  int operator()(const Eigen::VectorXd& p, Eigen::VectorXd& out) const {
    const DurationFactor factor = from_logarithms(p);
    for (std::size_t i = 0; i < points.size(); ++i)
      out[static_cast<Eigen::Index>(i)] = factor(points[i].alpha_star) - points[i].k;
    return 0;
  }
  int df(const Eigen::VectorXd& p, Eigen::MatrixXd& out) const {
    const DurationFactor factor = from_logarithms(p);
    out = jacobian(points, factor) * Eigen::Vector2d(factor.a, factor.b).asDiagonal();
    return 0;
  }
};

/// The best point of a coarse grid: the sum of squares has a long valley where alpha* spans little.
Eigen::VectorXd start(const Points& points) {
  DurationFactor best;
  for (double a = 0.02; a < largest_a; a *= 1.6)
    for (double b = 0.02; b < largest_b; b *= 1.6)
      if (sum_of_squares(points, {a, b}) < sum_of_squares(points, best)) best = {a, b};
  return Eigen::Vector2d(std::log(best.a), std::log(best.b));
}

bool at_edge(double value, double largest) {
  return value < least * near_edge || value > largest / near_edge;
}

/// Condition number of the Jacobian with columns of length 1: its square is (1 + |c|)/(1 - |c|), c the cosine between
/// them.
double condition(const Eigen::MatrixX2d& J) {
  const double lengths = J.col(0).norm() * J.col(1).norm();
  if (lengths == 0.) return 0.;
  const double c = std::min(std::abs(J.col(0).dot(J.col(1))) / lengths, 1.);
  return c < 1. ? std::sqrt((1. + c) / (1. - c)) : HUGE_VAL;
}

/// Whether the confidence ellipse, which reaches from a_best - sqrt(q C_aa) to a_best + sqrt(q C_aa), reaches a or b
/// = 0.
bool reaches_zero(const DurationFit& fit) {
  const double q = ellipse_size(fit);
  return fit.best.a * fit.best.a <= q * fit.covariance(0, 0) || fit.best.b * fit.best.b <= q * fit.covariance(1, 1);
}

void set_certainty(const Points& points, DurationFit& fit) {
  const Eigen::MatrixX2d J = jacobian(points, fit.best);
  const double freedom = static_cast<double>(points.size()) - 2.;
  fit.residual_deviation = std::sqrt(sum_of_squares(points, fit.best) / freedom);
  fit.condition = condition(J);
  fit.covariance.setZero();
  if (at_edge(fit.best.a, largest_a) || at_edge(fit.best.b, largest_b)) {
    fit.doubt = FitDoubt::edge;
  } else if (fit.condition == 0. || fit.condition > worst_condition) {
    fit.doubt = FitDoubt::ill_conditioned;
  } else {
    fit.covariance = std::pow(fit.residual_deviation, 2) * (J.transpose() * J).inverse();
    if (reaches_zero(fit)) fit.doubt = FitDoubt::reaches_zero;
  }
}

void require_sound(const Points& points) {
  for (const DurationPoint& point : points)
    if (!(std::isfinite(point.alpha_star) && std::isfinite(point.k) && point.alpha_star >= 0. && point.k >= 0.))
      throw std::invalid_argument("alpha* and k of a fit must be finite and not negative");
}

bool all_alike(const Points& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](const DurationPoint& point) { return point.alpha_star == points.front().alpha_star; });
}

}  // namespace

const char* word(FitDoubt doubt) {
  switch (doubt) {
    case FitDoubt::edge:
      return "edge";
    case FitDoubt::ill_conditioned:
      return "ill_conditioned";
    case FitDoubt::reaches_zero:
      return "reaches_zero";
    case FitDoubt::none:
      break;
  }
  return "none";
}

std::optional<DurationFit> fit_duration_factor(const Points& points) {
  constexpr std::size_t fewest = 4;
  require_sound(points);
  if (points.size() < fewest || all_alike(points)) return std::nullopt;
  Deviations deviations{points};
  Eigen::LevenbergMarquardt<Deviations> solver(deviations);
  solver.parameters.ftol = solver.parameters.xtol = 1e-14;
  Eigen::VectorXd p = start(points);
  solver.minimize(p);
  DurationFit fit;
  fit.n = points.size();
  fit.best = from_logarithms(p);
  fit.quality = quality(points, fit.best);
  set_certainty(points, fit);
  return fit;
}

FitQuality quality(const Points& points, const DurationFactor& factor) {
  const double n = static_cast<double>(points.size());
  double mean = 0., bias = 0., about_mean = 0.;
  for (const DurationPoint& point : points) {
    mean += point.k / n;
    bias += (factor(point.alpha_star) - point.k) / n;
  }
  for (const DurationPoint& point : points) about_mean += std::pow(point.k - mean, 2);
  const double sum = sum_of_squares(points, factor);
  return {std::sqrt(sum / n), bias, about_mean > 0. ? 1. - sum / about_mean : 0.};
}

double ellipse_size(const DurationFit& fit, double level) {
  const boost::math::fisher_f distribution(2., static_cast<double>(fit.n) - 2.);
  return 2. * boost::math::quantile(distribution, level);
}

bool in_ellipse(const DurationFit& fit, const DurationFactor& factor, double level) {
  if (!fit.has_covariance()) return false;
  const Eigen::Vector2d away(factor.a - fit.best.a, factor.b - fit.best.b);
  return away.dot(fit.covariance.inverse() * away) <= ellipse_size(fit, level);
}

}  // namespace upbead
