// Least squares of k(alpha*) = 1 / (alpha*^a + 1)^b, eq. (9) of Shimosako and Takahashi (1994), and how sure a and b
// are.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "upbead/waves/goda.h"

namespace upbead {

/// k = tau_0 / tau_0F of one wave.
struct DurationPoint {
  double alpha_star = 0.;
  double k = 0.;
};

/// How well given a and b agree with the points.
struct FitQuality {
  double deviation = 0.;  ///< root mean square of k - k(alpha*)
  double bias = 0.;       ///< mean of k(alpha*) - k; positive: the formula gives longer durations
  double r_squared = 0.;  ///< 1 - sum of squares / sum of squares about the mean of k; below 0: worse than a constant
};

/// Why the points do not determine a and b.
enum class FitDoubt {
  none,
  edge,             ///< the best a or b is at an end of its range, [0.001, 10] and [0.001, 100]
  ill_conditioned,  ///< a and b cannot be distinguished: condition number above 1e4
  reaches_zero,     ///< the confidence ellipse reaches a = 0 or b = 0
};

/// The word for it in files.
const char* word(FitDoubt doubt);

struct DurationFit {
  std::size_t n = 0;  ///< number of points
  DurationFactor best;
  FitQuality quality;
  double residual_deviation = 0.;  ///< s = sqrt(sum of squares / (n - 2))
  double condition = 0.;           ///< of the Jacobian with columns of length 1; 0 where one of them vanishes
  Eigen::Matrix2d covariance;      ///< of (a, b), s^2 (J^T J)^-1; meaningful unless edge or ill_conditioned
  FitDoubt doubt = FitDoubt::none;
  bool has_covariance() const { return doubt == FitDoubt::none || doubt == FitDoubt::reaches_zero; }
};

/// The fit by Levenberg and Marquardt's method (Eigen) in ln a and ln b, from the best point of a grid; none with fewer
/// than 4 points or where all alpha* are equal. Throws std::invalid_argument where a number is not finite or negative.
std::optional<DurationFit> fit_duration_factor(const std::vector<DurationPoint>& points);

FitQuality quality(const std::vector<DurationPoint>& points, const DurationFactor& factor);

/// q in (p - p_best)^T C^-1 (p - p_best) <= q, the joint confidence region of a and b: 2 F(2, n - 2) at that level
/// [Draper and Smith 1998, linear approximation]. Deviations are assumed independent and normal with one variance.
double ellipse_size(const DurationFit& fit, double level = 0.95);

/// Whether a and b of the factor lie in the region.
bool in_ellipse(const DurationFit& fit, const DurationFactor& factor, double level = 0.95);

}  // namespace upbead
