#include "standing_series.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "base/lanes.h"
#include "base/numbers.h"
#include "dense_products.h"

namespace upbead {

namespace {

using Harmonics = OfHarmonics;

/// cos and sin of the multiples of an angle, by one evaluation.
struct Multiples {
  Harmonics cos, sin;
  Multiples(int n, double angle) : cos(Harmonics::Ones(n + 1)), sin(Harmonics::Zero(n + 1)) {
    if (angle == 0.) return;  // the wall, where most are asked for
    const std::complex<double> once = std::polar(1., angle);
    std::complex<double> of_j = 1.;
    for (int j = 0; j <= n; ++j, of_j *= once) {
      cos[j] = of_j.real();
      sin[j] = of_j.imag();
    }
  }
};

/// exp(j y) for each harmonic j, by one evaluation.
Harmonics exponentials(Eigen::Index size, double y) {
  Harmonics of(size);
  of[0] = 1.;
  if (size > 1) of[1] = std::exp(y);
  for (Eigen::Index j = 2; j < size; ++j) of[j] = of[j / 2] * of[j - j / 2];
  return of;
}

/// cosh j(y + K) / cosh jK and sinh j(y + K) / cosh jK for each harmonic j, in a form that does not overflow in deep
/// water.
struct Depths {
  Harmonics cosh, sinh;
  Depths(const StandingInstant& s, double y) {
    const Harmonics up = exponentials(s.j.size(), y), down = exponentials(s.j.size(), -(y + 2. * s.K));
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
constexpr int most_iterations = 60;  ///< a step by a new matrix counts twice
/// The last step changes the coefficients by no more: as the method squares its error, about 1e-13 is left.
constexpr double same_coefficients = 1e-7;
constexpr double small_step = 1e-4;       ///< Conditions::improve()
constexpr double start_for_more = 1e-3;   ///< after such a step the residual is known well enough
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

/// Where the conditions at the places of a time, and their derivatives but for the harmonics in time, stand in the
/// vector of a place. By the harmonics in time the columns of an unknown are multiplied: -i sin(i tau) and cos(i tau)
/// for a, sin(i tau) and i cos(i tau) for b, in four blocks with one for each j. The kinematic condition is without the
/// last block and c, the dynamic one without the first block.
struct Layout {
  explicit Layout(int n) : m(n + 1) {}
  Eigen::Index m;
  Eigen::Index a_sin() const { return 0; }
  Eigen::Index K() const { return m; }
  Eigen::Index left() const { return m + 1; }  ///< the conditions themselves
  Eigen::Index a_cos() const { return m + 2; }
  Eigen::Index b_sin() const { return 2 * m + 2; }
  Eigen::Index b_cos() const { return 3 * m + 2; }
  Eigen::Index c() const { return 4 * m + 2; }
  Eigen::Index of_kinematic() const { return 3 * m + 2; }
  Eigen::Index of_dynamic() const { return 3 * m + 3; }
  Eigen::Index all() const { return m + padded(of_dynamic()); }
};

/// The conditions at all places of one time as Layout says, a column for each; the rows of the dynamic one from K on.
struct AtTime {
  Eigen::MatrixXd kinematic, dynamic;
};

void set_conditions(const StandingInstant& t, const std::vector<Multiples>& places, AtTime& at) {
  const Layout of(static_cast<int>(t.j.size()) - 1);
  const Eigen::Index m = of.m;
  // derivative with respect to K: cosh j(y + K)/cosh jK = cosh jy + tanh jK sinh jy
  const Harmonics by_K = 2. * t.j * t.decay / (1. + t.decay).square(), j2 = t.j.square();
  const double omega_K = -0.5 * t.omega / t.K;
  Eigen::Index place = 0;
  for (const Multiples& x : places) {
    const AtSurface p(t, x);
    const double u_y = -(j2 * t.phi * p.sinh_sin).sum(), v_y = (j2 * t.phi * p.cosh_cos).sum();
    const double phi_tau_y = (t.j * t.phi_tau * p.sinh_cos).sum();
    const Harmonics up = exponentials(m, p.eta), down = exponentials(m, -p.eta);
    const Harmonics C_K = by_K * (up - down), S_K = by_K * (up + down);
    const double u_K = -(t.j * t.phi * C_K * x.sin).sum(), v_K = (t.j * t.phi * S_K * x.cos).sum();
    const double phi_tau_K = (t.phi_tau * C_K * x.cos).sum();
    const SurfaceConditions left = p.left(t);
    auto k = at.kinematic.col(place).array();
    k.segment(of.a_sin(), m) = t.omega * x.cos;
    k[of.K()] = omega_K * p.eta_tau + u_K * p.eta_x - v_K;
    k[of.left()] = left.kinematic;
    k.segment(of.a_cos(), m) = (u_y * p.eta_x - v_y) * x.cos - p.u * t.j * x.sin;
    k.segment(of.b_sin(), m) = -t.j * (p.eta_x * p.cosh_sin + p.sinh_cos);
    auto d = at.dynamic.col(place++).array();
    d[of.K() - m] = omega_K * p.phi_tau + t.omega * phi_tau_K + p.u * u_K + p.v * v_K;
    d[of.left() - m] = left.dynamic;
    d.segment(of.a_cos() - m, m) = (t.omega * phi_tau_y + p.u * u_y + p.v * v_y + 1.) * x.cos;
    d.segment(of.b_sin() - m, m) = t.j * (p.v * p.sinh_cos - p.u * p.cosh_sin);
    d.segment(of.b_cos() - m, m) = t.omega * p.cosh_cos;
    d[of.c() - m] = -1.;
  }
}

/// An unknown's derivative is this of two rows of AtTime.
struct Column {
  Eigen::Index first, second;
  double by_first, by_second;
};

std::vector<Column> columns_at(double tau, int n, const std::vector<Unknown>& of_a, const std::vector<Unknown>& of_b) {
  const Multiples t(n, tau);
  const Layout of(n);
  std::vector<Column> columns;
  for (const auto [i, j] : of_a) columns.push_back({of.a_sin() + j, of.a_cos() + j, -i * t.sin[i], t.cos[i]});
  for (const auto [i, j] : of_b) columns.push_back({of.b_sin() + j, of.b_cos() + j, t.sin[i], i * t.cos[i]});
  for (const Eigen::Index k : {of.c(), of.K(), of.left()}) columns.push_back({k, k, 1., 0.});
  return columns;
}

/// sum += T' M T for the columns of T; its lower triangle alone. TM: memory to work in.
UPBEAD_CLONES void add_squares(const Column* columns, Eigen::Index size, const Eigen::MatrixXd& of,
                               Eigen::MatrixXd& work, Eigen::MatrixXd& into) {
  const Eigen::Index rows = of.rows(), stride = into.rows();
  const double* M = of.data();
  double *TM = work.data(), *sum = into.data();
  for (Eigen::Index p = 0; p < size; ++p) {
    const double *first = M + columns[p].first * rows, *second = M + columns[p].second * rows;
    const double by_first = columns[p].by_first, by_second = columns[p].by_second;
    for (Eigen::Index r = 0; r < rows; ++r) TM[r * stride + p] = by_first * first[r] + by_second * second[r];
  }
  for (Eigen::Index p = 0; p < size; ++p) {
    const double *first = TM + columns[p].first * stride, *second = TM + columns[p].second * stride;
    const double by_first = columns[p].by_first, by_second = columns[p].by_second;
    double* to = sum + p * stride;
    for (Eigen::Index q = p; q < size; ++q) to[q] += by_first * first[q] + by_second * second[q];
  }
}

/// The conditions at all places of a series with n harmonics.
class Conditions {
 public:
  explicit Conditions(int n)
      : layout_(n), places_{n + 2, 0.5}, of_a_(unknowns_of(n, 0, 1)), of_b_(unknowns_of(n, 1, 0)) {
    for (int l = 0; l < places_.of_space(); ++l) x_.emplace_back(n, places_.at(l));
    for (int k = 0; k < places_.of_time; ++k) columns_.push_back(columns_at(places_.at(k), n, of_a_, of_b_));
    const Eigen::Index size = padded(static_cast<Eigen::Index>(columns_.front().size()));
    at_.kinematic.setZero(padded(layout_.of_kinematic()), places_.of_space());
    at_.dynamic.setZero(padded(layout_.of_dynamic()), places_.of_space());
    M_.resize(layout_.all(), layout_.all());
    TM_.resize(size, layout_.all());
    normal_.resize(size, size);
  }

  /// One Gauss-Newton step; returns its largest change of a coefficient. By the normal equations, many times faster
  /// than by Householder reflections; the next step corrects their loss of digits. After a small step the matrix is so
  /// near the one of the solution that it serves as long as the steps become smaller.
  double improve(StandingSeries& s) {
    const double small = near_ ? last_ : small_step;
    const Eigen::VectorXd step = near_ ? -by_factor(gradient(s)) : newton_step(s);
    add(step, s);
    last_ = step.lpNorm<Eigen::Infinity>();
    near_ = has_factor_ && last_ < small;
    return last_;
  }
  bool near() const { return near_; }

  /// Sets how the coefficients of a solved series change with the height.
  void set_slope(StandingSeries& s) const {
    s.slope.resize(0);
    if (near_) s.slope = 2. * s.K * weight_of_height * weight_of_height * by_factor(height_row(s));
  }

  /// Follows that slope to another height.
  void raise(StandingSeries& s, double relative_height) const {
    add((relative_height - s.relative_height) * s.slope, s);
    s.relative_height = relative_height;
  }

 private:
  Eigen::VectorXd newton_step(const StandingSeries& s) {
    const auto n = static_cast<Eigen::Index>(of_a_.size() + of_b_.size() + 2);
    set_normal_equations(s);
    const Eigen::VectorXd step = solve_positive(normal_, n);
    has_factor_ = step.size() > 0;
    if (has_factor_) return step;
    set_normal_equations(s);
    return normal_.topLeftCorner(n, n).selfadjointView<Eigen::Lower>().ldlt().solve(
        -normal_.row(n).head(n).transpose());
  }

  void add(const Eigen::VectorXd& step, StandingSeries& s) const {
    Eigen::Index p = 0;
    for (const auto [i, j] : of_a_) s.a(i, j) += step[p++];
    for (const auto [i, j] : of_b_) s.b(i, j) += step[p++];
    s.c += step[p++];
    s.K += step[p];
  }

  /// By the factor L in the normal matrix.
  Eigen::VectorXd by_factor(const Eigen::VectorXd& g) const {
    const Eigen::Index n = g.size() - 1;
    const auto L = normal_.topLeftCorner(n, n).triangularView<Eigen::Lower>();
    return L.transpose().solve(L.solve(g.head(n)));
  }

  /// The squares of the conditions and of their derivatives with respect to a, b, c and K, summed over all places: the
  /// normal matrix, and as its last row the gradient. As the harmonics in time are the same at all places of a time,
  /// this takes a fraction of the work of the product of the whole matrix of derivatives with itself.
  void set_normal_equations(const StandingSeries& s) {
    const auto size = static_cast<Eigen::Index>(columns_.front().size());
    normal_.setZero();
    for (int k = 0; k < places_.of_time; ++k) {
      set_conditions(s.at(places_.at(k)), x_, at_);
      M_.setZero();
      add_products(at_.kinematic, 0, M_);
      add_products(at_.dynamic, layout_.m, M_);
      M_.triangularView<Eigen::StrictlyUpper>() = M_.transpose();
      add_squares(columns_[static_cast<std::size_t>(k)].data(), size, M_, TM_, normal_);
    }
    normal_.topLeftCorner(size, size)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(height_row(s), weight_of_height * weight_of_height);
  }

  /// The last row of the normal equations alone, in a small part of the time.
  Eigen::VectorXd gradient(const StandingSeries& s) {
    const Eigen::Index k0 = layout_.of_kinematic(), d0 = layout_.of_dynamic(), m = layout_.m;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns_.front().size())), g(layout_.all());
    for (int k = 0; k < places_.of_time; ++k) {
      set_conditions(s.at(places_.at(k)), x_, at_);
      g.setZero();
      g.head(k0) = at_.kinematic.topRows(k0) * at_.kinematic.row(layout_.left()).transpose();
      g.segment(m, d0) += at_.dynamic.topRows(d0) * at_.dynamic.row(layout_.left() - m).transpose();
      Eigen::Index p = 0;
      for (const Column& c : columns_[static_cast<std::size_t>(k)])
        sum[p++] += c.by_first * g[c.first] + c.by_second * g[c.second];
    }
    const Eigen::VectorXd row = height_row(s);
    return sum + weight_of_height * weight_of_height * row[row.size() - 1] * row;
  }

  /// The equation of the height: its derivatives and itself.
  Eigen::VectorXd height_row(const StandingSeries& s) const {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns_.front().size()));
    Eigen::Index p = 0;
    for (const auto [i, j] : of_a_) row[p++] = j % 2 == 0 ? 0. : 2.;
    row.tail(2) << -2. * s.relative_height, s.swing() - 2. * s.relative_height * s.K;
    return row;
  }

  Layout layout_;
  Places places_;
  std::vector<Unknown> of_a_, of_b_;
  std::vector<Multiples> x_;
  std::vector<std::vector<Column>> columns_;
  AtTime at_;
  Eigen::MatrixXd M_, TM_, normal_;
  bool has_factor_ = false;  ///< in normal_
  bool near_ = false;
  double last_ = 0.;
};

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

/// A series whose residual stays above `enough` is only the start of one with more harmonics, and is improved no
/// further. None where the method diverges, or does not converge in most_iterations steps.
std::optional<StandingSeries> converged(StandingSeries s, double enough) {
  const double before = s.K;
  Conditions conditions(s.n);
  for (int k = 0; k < most_iterations; k += conditions.near() ? 1 : 2) {
    const double kH = s.K * s.relative_height, change = conditions.improve(s) / std::max(1., kH);
    if (!std::isfinite(change) || s.K < 0.3 * before || s.K > 3. * before) return std::nullopt;
    const bool same = change < same_coefficients * (conditions.near() ? std::clamp(0.3 * kH, 1e-3, 0.1) : 1.);
    if (!same && change > start_for_more) continue;
    s.residual = residual_of(s);
    if (!same && s.residual < std::max(1.3 * enough, 3. * change)) continue;
    conditions.set_slope(s);
    return s;
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

StandingSeries higher(StandingSeries s, double relative_height) {
  Conditions(s.n).raise(s, relative_height);
  return s;
}

/// Solves from the small wave up, in `parts` equal steps of the height.
std::optional<StandingSeries> grown(const StandingSeries& small, int parts, double enough) {
  std::optional<StandingSeries> s = with_harmonics(raised(small, 1. / parts), first_harmonics);
  for (int part = 1; s; ++part) {
    s = converged(*s, enough);
    if (part == parts) break;
    if (s) s = raised(*s, (part + 1.) / part);
  }
  return s;
}

}  // namespace

std::optional<StandingSeries> solve_standing(double relative_height, double small_K, double residual,
                                             int most_harmonics, const StandingSeries* lower) {
  constexpr double all = std::numeric_limits<double>::infinity();
  const auto enough = [&](int n) { return n < most_harmonics ? residual : all; };
  const StandingSeries small = small_wave(relative_height, small_K);
  std::optional<StandingSeries> best;
  if (lower && lower->slope.size() > 0) best = converged(higher(*lower, relative_height), enough(lower->n));
  for (int parts = 1; parts <= 16 && !best; parts *= 4) best = grown(small, parts, residual);
  while (best && best->n < most_harmonics && best->residual > residual) {
    const int n = std::min(most_harmonics, best->n + 4);
    const auto next = converged(with_harmonics(*best, n), enough(n));
    if (!next || next->residual > 0.9 * best->residual) best = converged(*best, all);
    if (!best) return next ? converged(*next, all) : std::nullopt;
    if (!next || next->residual >= best->residual) return best;
    best = next;
  }
  return best;
}

}  // namespace upbead
