// Functions of time made of smooth pieces: force pulses, measured histories.
#pragma once

#include <functional>
#include <vector>

namespace upbead {

/// A function of time f(t), smooth between its kinks (a jump or a change of slope). At a kink each piece has its own
/// limit. An integrator whose steps end at the kinks therefore sees a smooth load in every step. A measured record may
/// be rough between its kinks: integral() and extremum() then use its samples, the integrator does not.
class TimeFunction {
 public:
  using Piece = std::function<double(double)>;

  /// The zero function.
  TimeFunction();
  /// pieces[i] holds between kinks[i - 1] and kinks[i]; `kinks` ascending; there is one piece more than kinks.
  /// `samples`: ascending times between which the pieces are linear; empty where the pieces are smooth.
  TimeFunction(std::vector<double> kinks, std::vector<Piece> pieces, std::vector<double> samples = {});

  /// f(t) from the right at a kink.
  double operator()(double t) const;
  /// f(t) by the piece that holds the time `inside`, also at that piece's two ends.
  double operator()(double t, double inside) const;
  const std::vector<double>& kinks() const { return kinks_; }
  const std::vector<double>& samples() const { return samples_; }
  /// The piece that holds the time `inside`.
  const Piece& piece(double inside) const;

 private:
  std::vector<double> kinks_;
  std::vector<Piece> pieces_;
  std::vector<double> samples_;
};

/// Linear between (time[i], value[i]); zero before the first and after the last sample. `time` ascending, at least two;
/// two samples at one time make a jump, which is a kink.
/// Kinks are the ends and those samples where the slope changes by more than a twentieth of the largest slope; thus a
/// finely sampled smooth record stays smooth for the integrator. A record with more than 50 such corners is taken as
/// measured: its ends are its only kinks, and the integrator sees a rough but continuous load. A step that ends at a
/// corner costs a factorisation, too many for such a record.
TimeFunction piecewise_linear(const std::vector<double>& time, const std::vector<double>& value);

/// Whether f is a measured, noisy record: it has more corners between its kinks than piecewise_linear turns into kinks.
bool is_rough(const TimeFunction& f);

/// The sum a + b, with the kinks of both.
TimeFunction sum(const TimeFunction& a, const TimeFunction& b);

/// scale * f.
TimeFunction scaled(const TimeFunction& f, double scale);

/// f, and f again each `period` later, `n` times in all. f is zero outside its kinks, of which there are at least two;
/// throws std::invalid_argument where they lie farther apart than a period. Each time it is f to the last digit, but
/// for the times of its kinks.
TimeFunction repeated(const TimeFunction& f, int n, double period);

/// Integral of f from t0 to t1 by adaptive Gauss-Kronrod between all kinks and samples (relative error 1e-9).
double integral(const TimeFunction& f, double t0, double t1);

/// Where a function is largest (sign = 1) or smallest (sign = -1).
struct Extremum {
  double time = 0.;
  double value = 0.;
};

/// Largest (sign = 1) or smallest (sign = -1) value of f on [t0, t1], found piece by piece on `parts` equal
/// parts each and at the samples, and refined by Brent's method.
Extremum extremum(const TimeFunction& f, double t0, double t1, int sign, int parts = 64);

}  // namespace upbead
