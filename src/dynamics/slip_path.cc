#include "upbead/dynamics/slip_path.h"

#include <cmath>

#include "lanes.h"
#include "phi_functions.h"

namespace upbead {

using Complex = std::complex<double>;

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
  for (int k = n_terms - 1; k >= 0; --k) y = y * part + taylor_[static_cast<std::size_t>(k)];
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

/// z' = p z + a + b t. Slow modes by z'' = p z' + b, z''' = p z'', ...; of a fast one, z = e^(pt) (z_0 + a/p + b/p^2)
/// - (a + b t)/p - b/p^2.
SlipCurve SlipPath::reading(int row) const {
  SlipCurve curve;
  curve.length_ = length_;
  curve.taylor_[0] = phase_.modes.feedthrough.row(row).dot(load_);
  curve.taylor_[1] = phase_.modes.feedthrough.row(row).dot(slope_) * length_;
  for (Eigen::Index m = 0; m < z_.size(); ++m) {
    const Complex c = phase_.modes.reading(row, m), p = phase_.modes.pole[m], x = p * length_;
    if (c == 0.) continue;
    if (std::abs(x) > 1.) {
      const Complex line = whole_[m] / p, bend = rise_[m] / (p * p);
      curve.taylor_[0] -= (c * (line + bend)).real();
      curve.taylor_[1] -= (c * rise_[m] / p).real() * length_;
      curve.pole_.push_back(p);
      curve.amplitude_.push_back(c * (z_[m] + line + bend));
      continue;
    }
    Complex term = c * z_[m];
    curve.taylor_[0] += term.real();
    term = term * x + c * whole_[m] * length_;
    curve.taylor_[1] += term.real();
    term = 0.5 * (term * x + c * rise_[m] * length_ * length_);
    for (int k = 2; k < SlipCurve::n_terms; ++k) {
      curve.taylor_[static_cast<std::size_t>(k)] += term.real();
      term *= x / static_cast<double>(k + 1);
    }
  }
  return curve;
}

SlipPath::Place SlipPath::at(double t) const {
  Eigen::VectorXcd z(z_.size());
  double sum = 0.;
  for (Eigen::Index m = 0; m < z_.size(); ++m) {
    const Complex x = phase_.modes.pole[m] * t;
    const detail::PhiFunctions phi = detail::phi_functions(x);
    z[m] = phi.exp * z_[m] + t * (phi.phi1 * whole_[m] + t * phi.phi2 * rise_[m]);
    const Complex integral = phi.phi1 * z_[m] + t * (phi.phi2 * whole_[m] + t * detail::phi3(x, phi.phi2) * rise_[m]);
    sum += (phase_.modes.reading(row_velocity, m) * integral).real();
  }
  return {detail::padded(z), t * sum};
}

}  // namespace upbead
