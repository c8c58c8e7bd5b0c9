// What lies between the ends of a step.
#pragma once

namespace upbead {

/// A quantity and its first two time derivatives at one time.
struct Jet {
  double value = 0.;
  double first = 0.;
  double second = 0.;
};

/// The polynomial of degree 5 that has the given value and derivatives at both ends of [t0, t0 + h] (s); its error is
/// O(h^6) for exact ends.
class QuinticHermite {
 public:
  QuinticHermite(double t0, double h, const Jet& begin, const Jet& end);
  /// Value and derivatives at t (s).
  Jet operator()(double t) const;

 private:
  double t0_, h_;
  double c_[6];  ///< coefficients of powers of (t - t0) / h
};

}  // namespace upbead
