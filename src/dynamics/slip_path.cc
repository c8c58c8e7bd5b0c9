#include "dynamics/slip_path.h"

#include <cmath>

namespace upbead {

using Complex = std::complex<double>;

namespace {

/// The start of z' = p z + a + b t.
struct ModeStart {
  Complex z, a, b;
};

/// Calls visit(k, Re, Im) for the terms z^(k)(0) t^k / k! of z(t), for abs(p t) <= 1: z' = p z + a, z'' = p z' + b,
/// and each later derivative is p times the one before. For abs(p t) > 1, z = e^(pt) (z_0 + a/p + b/p^2) - (a + b
/// t)/p - b/p^2.
template <class Visit>
void for_each_term(const ModeStart& start, const Complex& p, double t, const Visit& visit) {
  const Complex first = t * (p * start.z + start.a), second = 0.5 * t * (p * first + t * start.b);
  visit(0, start.z.real(), start.z.imag());
  visit(1, first.real(), first.imag());
  double re = second.real(), im = second.imag();
  const double x_re = p.real() * t, x_im = p.imag() * t;  // products of std::complex check each term for infinities
  const double negligible = 1e-18 * (std::abs(re) + std::abs(im));
  for (int k = 2; k < SlipCurve::n_terms; ++k) {
    visit(k, re, im);
    const double next = (re * x_re - im * x_im) / (k + 1);
    im = (re * x_im + im * x_re) / (k + 1);
    re = next;
    if (std::abs(re) + std::abs(im) <= negligible) return;
  }
}

}  // namespace

ModalState modal_state(const SlipPhase& phase, const Eigen::VectorXd& state) {
  const Eigen::Index M = phase.modes.n_modes();
  const Eigen::VectorXd z = phase.from_state * state;
  return detail::padded(z.head(M) + Complex(0., 1.) * z.tail(M));
}

Eigen::VectorXd energy_state(const SlipPhase& phase, const ModalState& z) {
  const Eigen::Index M = phase.modes.n_modes();
  return phase.to_state.leftCols(M) * z.re.head(M).matrix() + phase.to_state.rightCols(M) * z.im.head(M).matrix();
}

double SlipCurve::operator()(double t) const {
  const double part = t / length_;
  double y = 0.;
  for (int k = n_terms - 1; k >= 0; --k) y = y * part + taylor_[k];
  for (std::size_t m = 0; m < pole_.size(); ++m) {
    const double angle = pole_[m].imag() * t;
    y += std::exp(pole_[m].real() * t) *
         (amplitude_[m].real() * std::cos(angle) - amplitude_[m].imag() * std::sin(angle));
  }
  return y;
}

SlipPath::SlipPath(const SlipPhase& phase, const ModalState& start, const Eigen::VectorXd& load,
                   const Eigen::VectorXd& slope, double length)
    : phase_(phase),
      z_(phase.modes.n_modes()),
      whole_(phase.modes.load * load),
      rise_(phase.modes.load * slope),
      load_(load),
      slope_(slope),
      length_(length) {
  z_.real() = start.re.head(z_.size()).matrix();
  z_.imag() = start.im.head(z_.size()).matrix();
}

SlipCurve SlipPath::reading(int row) const {
  SlipCurve curve;
  curve.length_ = length_;
  curve.taylor_[0] = phase_.modes.feedthrough.row(row).dot(load_);
  curve.taylor_[1] = phase_.modes.feedthrough.row(row).dot(slope_) * length_;
  for (Eigen::Index m = 0; m < z_.size(); ++m) {
    const Complex c = phase_.modes.reading(row, m), p = phase_.modes.pole[m];
    if (c == 0.) continue;
    if (std::abs(p) * length_ <= 1.) {
      for_each_term({z_[m], whole_[m], rise_[m]}, p, length_,
                    [&](int k, double re, double im) { curve.taylor_[k] += c.real() * re - c.imag() * im; });
      continue;
    }
    const Complex line = whole_[m] / p, bend = rise_[m] / (p * p);
    curve.taylor_[0] -= (c * (line + bend)).real();
    curve.taylor_[1] -= (c * rise_[m] / p).real() * length_;
    curve.pole_.push_back(p);
    curve.amplitude_.push_back(c * (z_[m] + line + bend));
  }
  return curve;
}

SlipPath::Place SlipPath::at(double t) const {
  Eigen::VectorXcd z(z_.size());
  double distance = 0.;
  for (Eigen::Index m = 0; m < z_.size(); ++m) {
    const Complex p = phase_.modes.pole[m];
    Complex integral;
    if (std::abs(p) * t <= 1.) {
      double re = 0., im = 0., sum_re = 0., sum_im = 0.;
      for_each_term({z_[m], whole_[m], rise_[m]}, p, t, [&](int k, double term_re, double term_im) {
        re += term_re;
        im += term_im;
        sum_re += term_re / (k + 1);
        sum_im += term_im / (k + 1);
      });
      z[m] = {re, im};
      integral = t * Complex(sum_re, sum_im);
    } else {
      const Complex line = whole_[m] / p, bend = rise_[m] / (p * p);
      z[m] = std::exp(p * t) * (z_[m] + line + bend) - line - bend - t * rise_[m] / p;
      integral = (z[m] - z_[m] - t * (whole_[m] + 0.5 * t * rise_[m])) / p;
    }
    distance += (phase_.modes.reading(row_velocity, m) * integral).real();
  }
  return {detail::padded(z), distance};
}

}  // namespace upbead
