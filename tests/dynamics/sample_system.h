// A small random system in the block structure of a compiled scene, and helpers to measure on it.
#pragma once

#include <functional>
#include <vector>

#include "upbead/dynamics/march.h"

namespace upbead::test {

/// 6 u, 4 W in two cell blocks, 3 phi; M_uu, M_uW, M_WW, M_pp, C_uu, C_up, C_Wp, C_WW, C_pp, K_uu as in a porous scene,
/// of order 1, so that eigenfrequencies are of order 1 rad/s.
struct Sample {
  double storage = 1.;          ///< of M_pp; 0 is an incompressible fluid
  double darcy = 1.;            ///< of C_pp; 0 with storage 0 leaves phi to constraints on u and W (index 2)
  double resistance = 1.;       ///< of C_WW
  double damping = 0.1;         ///< of C_uu
  bool prescribed_u = false;    ///< one more u, prescribed
  bool prescribed_phi = false;  ///< one more phi, prescribed
};

/// The system without loads.
System sample_system(const Sample& sample);
/// A load on all free u (and a little on W).
SystemLoad sample_load(const System& system, TimeFunction history);
SystemLoad prescribed_load(const System& system, TimeFunction history);

/// sin^4(t) like pulse, smooth for t >= 0, with three zero derivatives at t = 0.
TimeFunction smooth();
/// cos(t) from t = 0 on: a jump.
TimeFunction jump();

/// State after `n` steps to `end`.
State state_at(const System& system, const SchemeOptions& options, double end, int n);

/// Slope of log(error) over log(1/n) by linear regression.
double order(const std::vector<int>& n, const std::vector<double>& error);

/// Relative errors of the u part of x at `end` against `reference`.
std::vector<double> errors(const System& system, const SchemeOptions& options, double end, const std::vector<int>& n,
                           const Vector& reference);

/// Consolidation of a column of n elements of linear u and phi, pushed at its draining top: c_v = 1, height 1, no mass;
/// u of n nodes from the top down, then phi of the n nodes below the top.
System consolidation(int n, TimeFunction push);

/// An oscillator m x'' + c x' + k x = f(t) with the reading "x".
System oscillator(double m, double c, double k, TimeFunction f);

}  // namespace upbead::test
