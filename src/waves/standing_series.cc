#include "standing_series.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "base/numbers.h"

namespace upbead {

namespace {

using Harmonics = OfHarmonics;

/// cos and sin of the multiples of an angle, by one evaluation.
struct Multiples {
  Harmonics cos, sin;
  Multiples(int n, double angle) : cos(n + 1), sin(n + 1) {
    const std::complex<double> once = std::polar(1., angle);
    std::complex<double> of_j = 1.;
    for (int j = 0; j <= n; ++j, of_j *= once) {
      cos[j] = of_j.real();
      sin[j] = of_j.imag();
    }
  }
};

/// cosh j(y + K) / cosh jK and sinh j(y + K) / cosh jK for each harmonic j, in a form that does not overflow in deep
/// water.
struct Depths {
  Harmonics cosh, sinh;
  Depths(const StandingInstant& s, double y) {
    const Harmonics up = (s.j * y).exp(), down = (-s.j * (y + 2. * s.K)).exp();
    cosh = (up + down) / (1. + s.decay);
    sinh = (up - down) / (1. + s.decay);
  }
};

/// A place of the surface: what both conditions and their derivatives are made of.
struct AtSurface {
  double eta, eta_tau, eta_x, u, v, phi_tau;
  Harmonics cosh_cos, cosh_sin, sinh_cos, sinh_sin;  ///< over cosh jK, in y and x

  AtSurface(const StandingInstant& s, const Multiples& x)
      : eta((s.eta * x.cos).sum()), eta_tau((s.eta_tau * x.cos).sum()), eta_x(-(s.j * s.eta * x.sin).sum()) {
    const Depths y(s, eta);
    cosh_cos = y.cosh * x.cos;
    cosh_sin = y.cosh * x.sin;
    sinh_cos = y.sinh * x.cos;
    sinh_sin = y.sinh * x.sin;
    u = -(s.j * s.phi * cosh_sin).sum();
    v = (s.j * s.phi * sinh_cos).sum();
    phi_tau = (s.phi_tau * cosh_cos).sum();
  }
  SurfaceConditions left(const StandingInstant& s) const {
    return {s.omega * eta_tau + u * eta_x - v, s.omega * phi_tau + 0.5 * (u * u + v * v) + eta - s.c};
  }
};

Harmonics counted(int n) {
  return Harmonics::LinSpaced(n + 1, 0., n);
}

}  // namespace

double StandingInstant::surface(double x) const {
  return (eta * Multiples(static_cast<int>(j.size()) - 1, x).cos).sum();
}

double StandingInstant::pressure(double x, double y) const {
  const Multiples at(static_cast<int>(j.size()) - 1, x);
  const Depths of_y(*this, y);
  const double u = -(j * phi * of_y.cosh * at.sin).sum(), v = (j * phi * of_y.sinh * at.cos).sum();
  return c - omega * (phi_tau * of_y.cosh * at.cos).sum() - 0.5 * (u * u + v * v) - y;
}

double StandingInstant::downward_acceleration() const {
  return -omega * (j * phi_tau * Depths(*this, surface(0.)).sinh).sum();
}

double StandingSeries::frequency() const {
  return deep_frequency / std::sqrt(K);
}

double StandingSeries::swing() const {
  const StandingInstant crest = at(0.);
  return crest.surface(0.) - crest.surface(pi);
}

StandingInstant StandingSeries::at(double tau) const {
  const Multiples t(n, tau);
  StandingInstant s;
  s.j = counted(n);
  s.decay = (-2. * K * s.j).exp();
  s.eta = (a.transpose() * t.cos.matrix()).array();
  s.eta_tau = -(a.transpose() * (s.j * t.sin).matrix()).array();
  s.phi = (b.transpose() * t.sin.matrix()).array();
  s.phi_tau = (b.transpose() * (s.j * t.cos).matrix()).array();
  s.K = K;
  s.omega = frequency();
  s.c = c;
  return s;
}

SurfaceConditions surface_conditions(const StandingInstant& instant, double x) {
  return AtSurface(instant, Multiples(static_cast<int>(instant.j.size()) - 1, x)).left(instant);
}

namespace {

constexpr int first_harmonics = 6;
constexpr int most_iterations = 30;
/// The last step changes the coefficients by no more: as the method squares its error, about 1e-13 is left.
constexpr double same_coefficients = 1e-7;
constexpr double weight_of_height = 1e3;  ///< this equation is met closely, all others by least squares

/// A coefficient that is sought: of the harmonic i in time and j in space.
struct Unknown {
  int i, j;
};

/// Those of a (from row 0 and column 1 on) or of b (from row 1 and column 0 on).
std::vector<Unknown> unknowns_of(int n, int first_i, int first_j) {
  std::vector<Unknown> list;
  for (int j = first_j; j <= n; ++j)
    for (int i = first_i; i <= n; ++i)
      if ((i + j) % 2 == 0) list.push_back({i, j});
  return list;
}

StandingSeries with_harmonics(const StandingSeries& from, int n) {
  StandingSeries to = from;
  to.n = n;
  to.a = to.b = Eigen::MatrixXd::Zero(n + 1, n + 1);
  to.a.topLeftCorner(from.n + 1, from.n + 1) = from.a;
  to.b.topLeftCorner(from.n + 1, from.n + 1) = from.b;
  return to;
}

/// A small wave: omega^2 = tanh K.
StandingSeries small_wave(double relative_height, double K) {
  StandingSeries s;
  s.relative_height = relative_height;
  s.K = K;
  s.deep_frequency = std::sqrt(K * std::tanh(K));
  s.n = 1;
  s.a = s.b = Eigen::MatrixXd::Zero(2, 2);
  s.a(1, 1) = K * relative_height;
  s.b(1, 1) = -K * relative_height / s.frequency();
  return s;
}

/// Collocation points on the surface, over a quarter of the period and half the length; the rest follows by symmetry.
/// The conditions at these points are four times as many as the coefficients; so Newton's method converges up to the
/// steepest waves (with twice as many it does not).
struct Places {
  int of_time;    ///< how many times
  double offset;  ///< of the first one, in distances
  double at(int k) const { return (k + offset) * 0.5 * pi / of_time; }
  int of_space() const { return 2 * of_time; }
};

/// The conditions at all places of one time, and their derivatives but for the harmonics in time, by which the columns
/// of an unknown are multiplied: -i sin(i tau) and cos(i tau) for a, sin(i tau) and i cos(i tau) for b, in four blocks
/// of a column for each j. Then come those with respect to c and K, and the conditions themselves.
Eigen::MatrixXd rows_of_time(const StandingSeries& s, const StandingInstant& t, const std::vector<Multiples>& places) {
  const Eigen::Index m = s.n + 1;
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(places.size()), 4 * m + 3);
  // derivative with respect to K: cosh j(y + K)/cosh jK = cosh jy + tanh jK sinh jy
  const Harmonics by_K = 4. * t.j * t.decay / (1. + t.decay).square(), j2 = t.j.square();
  const double omega_K = -0.5 * t.omega / s.K;
  Eigen::Index row = 0;
  for (const Multiples& x : places) {
    const AtSurface p(t, x);
    const double u_y = -(j2 * t.phi * p.sinh_sin).sum(), v_y = (j2 * t.phi * p.cosh_cos).sum();
    const double phi_tau_y = (t.j * t.phi_tau * p.sinh_cos).sum();
    const Harmonics C_K = by_K * (t.j * p.eta).sinh(), S_K = by_K * (t.j * p.eta).cosh();
    const double u_K = -(t.j * t.phi * C_K * x.sin).sum(), v_K = (t.j * t.phi * S_K * x.cos).sum();
    const double phi_tau_K = (t.phi_tau * C_K * x.cos).sum();
    const SurfaceConditions left = p.left(t);
    X.row(row).segment(0, m) = (t.omega * x.cos).matrix();
    X.row(row).segment(m, m) = ((u_y * p.eta_x - v_y) * x.cos - p.u * t.j * x.sin).matrix();
    X.row(row).segment(2 * m, m) = (-t.j * (p.eta_x * p.cosh_sin + p.sinh_cos)).matrix();
    X.row(row++).tail(3) << 0., omega_K * p.eta_tau + u_K * p.eta_x - v_K, left.kinematic;
    X.row(row).segment(m, m) = ((t.omega * phi_tau_y + p.u * u_y + p.v * v_y + 1.) * x.cos).matrix();
    X.row(row).segment(2 * m, m) = (t.j * (p.v * p.sinh_cos - p.u * p.cosh_sin)).matrix();
    X.row(row).segment(3 * m, m) = (t.omega * p.cosh_cos).matrix();
    X.row(row++).tail(3) << -1., omega_K * p.phi_tau + t.omega * phi_tau_K + p.u * u_K + p.v * v_K, left.dynamic;
  }
  return X;
}

/// An unknown's derivative is this of two columns of rows_of_time().
struct Column {
  Eigen::Index first, second;
  double by_first, by_second;
};

std::vector<Column> columns_at(double tau, int n, const std::vector<Unknown>& of_a, const std::vector<Unknown>& of_b) {
  const Multiples t(n, tau);
  const Eigen::Index m = n + 1;
  std::vector<Column> columns;
  for (const auto [i, j] : of_a) columns.push_back({j, m + j, -i * t.sin[i], t.cos[i]});
  for (const auto [i, j] : of_b) columns.push_back({2 * m + j, 3 * m + j, t.sin[i], i * t.cos[i]});
  for (Eigen::Index k = 4 * m; k < 4 * m + 3; ++k) columns.push_back({k, k, 1., 0.});
  return columns;
}

/// sum += T' M T for the columns of T; its lower triangle alone.
void add_squares(const Eigen::MatrixXd& M, const std::vector<Column>& columns, Eigen::MatrixXd& sum) {
  const auto size = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd MT(M.rows(), size);
  Eigen::Index p = 0;
  for (const Column& k : columns) MT.col(p++) = k.by_first * M.col(k.first) + k.by_second * M.col(k.second);
  const Eigen::MatrixXd TM = MT.transpose();
  p = 0;
  for (const Column& k : columns) {
    const Eigen::Index below = size - p;
    sum.col(p++).tail(below) += k.by_first * TM.col(k.first).tail(below) + k.by_second * TM.col(k.second).tail(below);
  }
}

/// The squares of the conditions and of their derivatives with respect to a, b, c and K, summed over all places: the
/// normal matrix, and as its last row the gradient. As the harmonics in time are the same at all places of a time, this
/// takes a fraction of the work of the product of the whole matrix of derivatives with itself.
Eigen::MatrixXd normal_equations(const StandingSeries& s, const std::vector<Unknown>& of_a,
                                 const std::vector<Unknown>& of_b) {
  const Places places{s.n + 2, 0.5};
  std::vector<Multiples> x;
  for (int l = 0; l < places.of_space(); ++l) x.emplace_back(s.n, places.at(l));
  const auto size = static_cast<Eigen::Index>(of_a.size() + of_b.size() + 3);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  for (int k = 0; k < places.of_time; ++k) {
    const Eigen::MatrixXd X = rows_of_time(s, s.at(places.at(k)), x);
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(X.cols(), X.cols());
    M.selfadjointView<Eigen::Lower>().rankUpdate(X.transpose());
    add_squares(M.selfadjointView<Eigen::Lower>(), columns_at(places.at(k), s.n, of_a, of_b), normal);
  }
  // the equation of the height
  Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
  Eigen::Index p = 0;
  for (const auto [i, j] : of_a) row[p++] = j % 2 == 0 ? 0. : 2.;
  row.tail(2) << -2. * s.relative_height, s.swing() - 2. * s.relative_height * s.K;
  normal.selfadjointView<Eigen::Lower>().rankUpdate(row, weight_of_height * weight_of_height);
  return normal;
}

/// One Gauss-Newton step; returns its largest change of a coefficient. By the normal equations, many times faster than
/// by Householder reflections; the next step corrects their loss of digits.
double improve(StandingSeries& s) {
  const std::vector<Unknown> of_a = unknowns_of(s.n, 0, 1), of_b = unknowns_of(s.n, 1, 0);
  const Eigen::MatrixXd normal = normal_equations(s, of_a, of_b);
  const Eigen::Index size = normal.rows() - 1;
  const Eigen::VectorXd gradient = normal.row(size).head(size).transpose();
  const Eigen::VectorXd step = normal.topLeftCorner(size, size).selfadjointView<Eigen::Lower>().ldlt().solve(-gradient);
  Eigen::Index p = 0;
  for (const auto [i, j] : of_a) s.a(i, j) += step[p++];
  for (const auto [i, j] : of_b) s.b(i, j) += step[p++];
  s.c += step[p++];
  s.K += step[p];
  return step.lpNorm<Eigen::Infinity>();
}

/// StandingWave::residual.
double residual_of(const StandingSeries& s) {
  const Places places{s.n + 2, 0.};
  double kinematic = 0., dynamic = 0.;
  for (int k = 0; k < places.of_time; ++k) {
    const StandingInstant instant = s.at(places.at(k));
    for (int l = 0; l < places.of_space(); ++l) {
      const SurfaceConditions left = surface_conditions(instant, places.at(l));
      kinematic = std::max(kinematic, std::abs(left.kinematic));
      dynamic = std::max(dynamic, std::abs(left.dynamic));
    }
  }
  return std::max(kinematic / s.frequency(), dynamic) / s.swing();
}

/// None where the method diverges, or does not converge in most_iterations steps.
std::optional<StandingSeries> converged(StandingSeries s) {
  const double before = s.K;
  for (int k = 0; k < most_iterations; ++k) {
    const double change = improve(s);
    if (!std::isfinite(change) || s.K < 0.3 * before || s.K > 3. * before) return std::nullopt;
    if (change < same_coefficients * std::max(1., s.K * s.relative_height)) {
      s.residual = residual_of(s);
      return s;
    }
  }
  return std::nullopt;
}

/// A first guess for a wave `factor` times as high.
StandingSeries raised(StandingSeries s, double factor) {
  s.relative_height *= factor;
  s.a *= factor;
  s.b *= factor;
  return s;
}

/// Solves from the small wave up, in `parts` equal steps of the height.
std::optional<StandingSeries> grown(const StandingSeries& small, int parts) {
  std::optional<StandingSeries> s = with_harmonics(raised(small, 1. / parts), first_harmonics);
  for (int part = 1; s; ++part) {
    s = converged(*s);
    if (part == parts) break;
    if (s) s = raised(*s, (part + 1.) / part);
  }
  return s;
}

}  // namespace

std::optional<StandingSeries> solve_standing(double relative_height, double small_K, double residual,
                                             int most_harmonics) {
  const StandingSeries small = small_wave(relative_height, small_K);
  std::optional<StandingSeries> best;
  for (int parts = 1; parts <= 16 && !best; parts *= 4) best = grown(small, parts);
  while (best && best->n < most_harmonics && best->residual > residual) {
    const auto next = converged(with_harmonics(*best, std::min(most_harmonics, best->n + 4)));
    if (!next || next->residual >= best->residual) break;
    best = next;
  }
  return best;
}

}  // namespace upbead
