// Sources of a manufactured solution as loads of the semi-discrete system, and its state at a time.
#pragma once

#include <vector>

#include "mms.h"

namespace upbead::test {

/// F(t): the integrals of du.f, dW.h and -dphi g over the cells, and of du.(sigma n) and dphi q.n over the sides, q the
/// flux density. From the equations tested with (du, dW, -dphi), see docs/theory.md.
Vector source(const Compiled& compiled, const Manufactured& mms, double t);

/// F(t) as one load per function of time.
std::vector<SystemLoad> source_loads(const Compiled& compiled, const Manufactured& mms);

/// x, x', x'' at time t, interpolated at the nodes; phi(0) = 0.
State exact_state(const Compiled& compiled, const Manufactured& mms, double t);

/// A scene compiled on a mesh with the sources as its only loads.
struct Problem {
  Problem(const Manufactured& mms, const Mesh& mesh);
  const Manufactured& mms;
  Compiled compiled;
};

/// The state at `end` (s) after `steps` steps from the exact state at t = 0.
State marched(const Problem& problem, double end, int steps, SchemeKind scheme = SchemeKind::sdirk4);

/// The larger of two errors; NaN where either is.
double worse(double a, double b);

/// Largest over the fields (u, W, phi) of |part| over the largest of |wholes| among the rows of that field: the rows of
/// different fields have different units.
double largest_ratio(const System& system, const Vector& part, const std::vector<Vector>& wholes);

}  // namespace upbead::test
