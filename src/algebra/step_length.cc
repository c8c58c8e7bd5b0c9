#include "algebra/step_length.h"

#include "algebra/slope_bracket.h"

namespace upbead {

namespace {

/// The search ends after `most_tries` with the last length. No length beyond `farthest` is tried.
constexpr double farthest = 1e3;
constexpr int most_tries = 12;

}  // namespace

PetscErrorCode step_to_least(SNESLineSearch search, void*) {
  SNES snes = nullptr;
  Vec x = nullptr, r = nullptr, y = nullptr, tried = nullptr, there = nullptr;
  PetscCall(SNESLineSearchGetSNES(search, &snes));
  PetscCall(SNESLineSearchGetVecs(search, &x, &r, &y, &tried, &there));
  PetscReal start = 0., slope = 0.;
  PetscCall(VecDot(r, y, &start));
  SlopeBracket bracket(start);
  double length = 1., taken = 1.;
  for (int i = 0; i < most_tries && length <= farthest; ++i) {
    taken = length;
    PetscCall(VecWAXPY(tried, -taken, y, x));
    PetscCall(SNESComputeFunction(snes, tried, there));
    PetscBool outside = PETSC_FALSE;
    PetscCall(SNESGetFunctionDomainError(snes, &outside));
    if (outside) return SNESLineSearchSetReason(search, SNES_LINESEARCH_FAILED_DOMAIN);
    PetscCall(VecDot(there, y, &slope));
    if (bracket.is_little(slope)) break;
    length = bracket.after(taken, slope);
  }
  PetscCall(VecCopy(tried, x));
  PetscCall(VecCopy(there, r));
  PetscCall(SNESLineSearchSetLambda(search, taken));
  PetscCall(SNESLineSearchComputeNorms(search));
  return SNESLineSearchSetReason(search, SNES_LINESEARCH_SUCCEEDED);
}

}  // namespace upbead
