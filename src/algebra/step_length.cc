#include "algebra/step_length.h"

#include <algorithm>
#include <cmath>

namespace upbead {

namespace {

/// The search ends at a slope of at most `little` times that at the start, or with the last length after
/// `most_tries`. No length beyond `farthest` is tried.
constexpr double little = 0.3, farthest = 1e3;
constexpr int most_tries = 12;

/// Lengths before and behind the least value, with their slopes; `far_slope_` is 0 until a length behind it is known.
class Bracket {
 public:
  explicit Bracket(double slope) : start_(slope), near_slope_(slope) {}

  /// The length to be tried next. Until a length behind the least value is known, longer ones, by secants; then
  /// regula falsi, in which the slope of an end that stays is halved (Illinois).
  double after(double length, double slope) {
    if (slope > 0.) {
      near_ = length;
      near_slope_ = slope;
      if (far_slope_ == 0.) return length * std::clamp(start_ / std::max(start_ - slope, 1e-3 * start_), 2., 10.);
      far_slope_ *= 0.5;
    } else {
      if (far_slope_ < 0. || near_ > 0.) near_slope_ *= 0.5;
      far_ = length;
      far_slope_ = slope;
    }
    return near_ + (far_ - near_) * near_slope_ / (near_slope_ - far_slope_);
  }

 private:
  double start_, near_ = 0., near_slope_, far_ = 0., far_slope_ = 0.;
};

}  // namespace

PetscErrorCode step_to_least(SNESLineSearch search, void*) {
  SNES snes = nullptr;
  Vec x = nullptr, r = nullptr, y = nullptr, tried = nullptr, there = nullptr;
  PetscCall(SNESLineSearchGetSNES(search, &snes));
  PetscCall(SNESLineSearchGetVecs(search, &x, &r, &y, &tried, &there));
  PetscReal start = 0., slope = 0.;
  PetscCall(VecDot(r, y, &start));
  Bracket bracket(start);
  double length = 1., taken = 1.;
  for (int i = 0; i < most_tries && length <= farthest; ++i) {
    taken = length;
    PetscCall(VecWAXPY(tried, -taken, y, x));
    PetscCall(SNESComputeFunction(snes, tried, there));
    PetscBool outside = PETSC_FALSE;
    PetscCall(SNESGetFunctionDomainError(snes, &outside));
    if (outside) return SNESLineSearchSetReason(search, SNES_LINESEARCH_FAILED_DOMAIN);
    PetscCall(VecDot(there, y, &slope));
    if (std::abs(slope) <= little * std::abs(start)) break;
    length = bracket.after(taken, slope);
  }
  PetscCall(VecCopy(tried, x));
  PetscCall(VecCopy(there, r));
  PetscCall(SNESLineSearchSetLambda(search, taken));
  PetscCall(SNESLineSearchComputeNorms(search));
  return SNESLineSearchSetReason(search, SNES_LINESEARCH_SUCCEEDED);
}

}  // namespace upbead
