#include "standing_series.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.h"

namespace upbead {

namespace {

using Array = Eigen::ArrayXd;

/// cos and sin of the multiples of an angle up to n: far fewer evaluations than one per term.
struct Multiples {
  Array cos, sin;
  Multiples(int n, double angle) {
    const Array multiple = Array::LinSpaced(n + 1, 0., n) * angle;
    cos = multiple.cos();
    sin = multiple.sin();
  }
};

/// The value of each term, found by its harmonic.
Array picked(const Array& of_harmonic, const Array& harmonic) {
  return harmonic.unaryExpr([&](double j) { return of_harmonic[static_cast<Eigen::Index>(j)]; });
}

/// cosh j(y + K) / cosh jK and sinh j(y + K) / cosh jK for each harmonic j, in a form that does not overflow in deep
/// water.
struct Depths {
  Array cosh, sinh;
  Depths(int n, double y, double K) {
    const Array j = Array::LinSpaced(n + 1, 0., n);
    const Array up = (j * y).exp(), down = (-j * (y + 2. * K)).exp(), both = 1. + (-2. * K * j).exp();
    cosh = (up + down) / both;
    sinh = (up - down) / both;
  }
};

/// The factors of the terms of phi; cos_t includes the harmonic in time.
struct PotentialTerms {
  Array j, cos_x, sin_x, sin_t, cos_t, cosh, sinh;
  PotentialTerms(const StandingSeries& s, double tau, double x, double y) : j(s.bj) {
    const Multiples of_x(s.n, x), of_t(s.n, tau);
    const Depths of_y(s.n, y, s.K);
    cos_x = picked(of_x.cos, s.bj);
    sin_x = picked(of_x.sin, s.bj);
    sin_t = picked(of_t.sin, s.bi);
    cos_t = s.bi * picked(of_t.cos, s.bi);
    cosh = picked(of_y.cosh, s.bj);
    sinh = picked(of_y.sinh, s.bj);
  }
  Array phi_tau() const { return cosh * cos_x * cos_t; }
  Array phi_x() const { return -j * cosh * sin_x * sin_t; }
  Array phi_y() const { return j * sinh * cos_x * sin_t; }
};

double sum(const Array& terms, const Eigen::VectorXd& of) {
  return (terms * of.array()).sum();
}

}  // namespace

double StandingSeries::frequency() const {
  return deep_frequency / std::sqrt(K);
}

double StandingSeries::swing() const {
  return surface(0., 0.) - surface(0., pi);
}

double StandingSeries::surface(double tau, double x) const {
  return sum(picked(Multiples(n, tau).cos, ai) * picked(Multiples(n, x).cos, aj), a);
}

double StandingSeries::pressure(double tau, double x, double y) const {
  const PotentialTerms terms(*this, tau, x, y);
  const double u = sum(terms.phi_x(), b), v = sum(terms.phi_y(), b);
  return c - frequency() * sum(terms.phi_tau(), b) - 0.5 * (u * u + v * v) - y;
}

double StandingSeries::crest_acceleration() const {
  const PotentialTerms terms(*this, 0., 0., surface(0., 0.));
  return -frequency() * sum(terms.j * terms.sinh * terms.cos_t, b);
}

SurfaceConditions surface_conditions(const StandingSeries& s, double tau, double x, Eigen::RowVectorXd* kinematic_row,
                                     Eigen::RowVectorXd* dynamic_row) {
  const Multiples of_t(s.n, tau), of_x(s.n, x);
  const Array at = picked(of_t.cos, s.ai), ax = picked(of_x.cos, s.aj), eta_terms = at * ax;
  const Array eta_tau_terms = -s.ai * picked(of_t.sin, s.ai) * ax, eta_x_terms = -s.aj * at * picked(of_x.sin, s.aj);
  const double eta = sum(eta_terms, s.a), eta_tau = sum(eta_tau_terms, s.a), eta_x = sum(eta_x_terms, s.a);
  const PotentialTerms t(s, tau, x, eta);
  const Array Pt = t.phi_tau(), Px = t.phi_x(), Py = t.phi_y();
  const double w = s.frequency(), u = sum(Px, s.b), v = sum(Py, s.b), phi_tau = sum(Pt, s.b);
  if (kinematic_row) {
    const Array Pxy = -t.j.square() * t.sinh * t.sin_x * t.sin_t, Pyy = t.j.square() * t.cosh * t.cos_x * t.sin_t;
    const Array Pty = t.j * t.sinh * t.cos_x * t.cos_t;
    const double u_y = sum(Pxy, s.b), v_y = sum(Pyy, s.b), phi_tau_y = sum(Pty, s.b);
    // derivative with respect to K: cosh j(y + K)/cosh jK = cosh jy + tanh jK sinh jy
    const Array j = Array::LinSpaced(s.n + 1, 0., s.n), decay = (-2. * s.K * j).exp();
    const Array by_K = 4. * j * decay / (1. + decay).square();
    const Array C_K = picked(by_K * (j * eta).sinh(), s.bj), S_K = picked(by_K * (j * eta).cosh(), s.bj);
    const double u_K = sum(-t.j * C_K * t.sin_x * t.sin_t, s.b), v_K = sum(t.j * S_K * t.cos_x * t.sin_t, s.b);
    const double phi_tau_K = sum(C_K * t.cos_x * t.cos_t, s.b), w_K = -0.5 * w / s.K;
    *kinematic_row << (w * eta_tau_terms + u * eta_x_terms + (u_y * eta_x - v_y) * eta_terms).matrix().transpose(),
        (eta_x * Px - Py).matrix().transpose(), 0., w_K * eta_tau + u_K * eta_x - v_K;
    *dynamic_row << ((w * phi_tau_y + u * u_y + v * v_y + 1.) * eta_terms).matrix().transpose(),
        (w * Pt + u * Px + v * Py).matrix().transpose(), -1., w_K * phi_tau + w * phi_tau_K + u * u_K + v * v_K;
  }
  return {w * eta_tau + u * eta_x - v, w * phi_tau + 0.5 * (u * u + v * v) + eta - s.c};
}

namespace {

constexpr int first_harmonics = 6;
constexpr int most_iterations = 30;
/// The last step changes the coefficients by no more: as the method squares its error, about 1e-13 is left.
constexpr double same_coefficients = 1e-7;
constexpr double weight_of_height = 1e3;  ///< this equation is met closely, all others by least squares

/// Lists the harmonics (i, j) up to n, with i + j even, i >= i0 and j >= j0.
void list_harmonics(int n, int i0, int j0, Array& in_time, Array& in_space) {
  std::vector<double> I, J;
  for (int i = i0; i <= n; ++i)
    for (int j = j0; j <= n; ++j)
      if ((i + j) % 2 == 0) {
        I.push_back(i);
        J.push_back(j);
      }
  const auto size = static_cast<Eigen::Index>(I.size());
  in_time = Eigen::Map<Array>(I.data(), size);
  in_space = Eigen::Map<Array>(J.data(), size);
}

/// The coefficients of `from` at the harmonics (i, j); 0 where `from` does not have them.
Eigen::VectorXd taken_over(const Array& i, const Array& j, const Array& from_i, const Array& from_j,
                           const Eigen::VectorXd& from) {
  Eigen::VectorXd to = Eigen::VectorXd::Zero(i.size());
  for (Eigen::Index m = 0; m < i.size(); ++m)
    for (Eigen::Index l = 0; l < from.size(); ++l)
      if (from_i[l] == i[m] && from_j[l] == j[m]) to[m] = from[l];
  return to;
}

StandingSeries with_harmonics(const StandingSeries& from, int n) {
  StandingSeries to = from;
  to.n = n;
  list_harmonics(n, 0, 1, to.ai, to.aj);
  list_harmonics(n, 1, 0, to.bi, to.bj);
  to.a = taken_over(to.ai, to.aj, from.ai, from.aj, from.a);
  to.b = taken_over(to.bi, to.bj, from.bi, from.bj, from.b);
  return to;
}

/// A small wave: omega^2 = tanh K.
StandingSeries small_wave(double relative_height, double K) {
  StandingSeries s;
  s.relative_height = relative_height;
  s.K = K;
  s.deep_frequency = std::sqrt(K * std::tanh(K));
  s.n = 1;
  s.ai = s.aj = s.bi = s.bj = Array::Ones(1);
  s.a = Eigen::VectorXd::Constant(1, K * relative_height);
  s.b = Eigen::VectorXd::Constant(1, -K * relative_height / s.frequency());
  return s;
}

/// Collocation points on the surface, over a quarter of the period and half the length; the rest follows by symmetry.
/// The conditions at these points are four times as many as the coefficients; so Newton's method converges up to the
/// steepest waves (with twice as many it does not).
template <class Visit>
void for_places(int n, double offset, Visit visit) {
  const int count = n + 2;
  for (int m = 0; m < count; ++m)
    for (int l = 0; l < 2 * count; ++l) visit((m + offset) * 0.5 * pi / count, (l + offset) * 0.5 * pi / count);
}

/// By the normal equations, ten times faster than by Householder reflections; the next step corrects their loss of
/// digits.
Eigen::VectorXd step_of(const Eigen::MatrixXd& J, const Eigen::VectorXd& R) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(J.cols(), J.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(J.transpose());
  return gram.selfadjointView<Eigen::Lower>().ldlt().solve(-J.transpose() * R);
}

/// One Gauss-Newton step; returns its largest change of a coefficient.
double improve(StandingSeries& s) {
  const Eigen::Index na = s.a.size(), nb = s.b.size(), unknowns = na + nb + 2, places = 2 * (s.n + 2) * (s.n + 2);
  Eigen::MatrixXd J(2 * places + 1, unknowns);
  Eigen::VectorXd R(2 * places + 1);
  Eigen::RowVectorXd kinematic(unknowns), dynamic(unknowns);
  Eigen::Index row = 0;
  for_places(s.n, 0.5, [&](double tau, double x) {
    const SurfaceConditions left = surface_conditions(s, tau, x, &kinematic, &dynamic);
    R[row] = left.kinematic;
    J.row(row++) = kinematic;
    R[row] = left.dynamic;
    J.row(row++) = dynamic;
  });
  J.row(row) << (1. - (s.aj * pi).cos()).matrix().transpose(), Eigen::RowVectorXd::Zero(nb + 1),
      -2. * s.relative_height;
  R[row] = s.swing() - 2. * s.relative_height * s.K;
  J.row(row) *= weight_of_height;
  R[row] *= weight_of_height;
  const Eigen::VectorXd step = step_of(J, R);
  s.a += step.head(na);
  s.b += step.segment(na, nb);
  s.c += step[na + nb];
  s.K += step[na + nb + 1];
  return step.lpNorm<Eigen::Infinity>();
}

/// StandingWave::residual.
double residual_of(const StandingSeries& s) {
  double kinematic = 0., dynamic = 0.;
  for_places(s.n, 0., [&](double tau, double x) {
    const SurfaceConditions left = surface_conditions(s, tau, x);
    kinematic = std::max(kinematic, std::abs(left.kinematic));
    dynamic = std::max(dynamic, std::abs(left.dynamic));
  });
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
