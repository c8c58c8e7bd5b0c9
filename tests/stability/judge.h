// Runs one case and measures whether its numbers can be trusted.
#pragma once

#include <string>

#include "halving.h"

namespace upbead::test {

/// Bounds that every scene must meet that is not refused.
struct Bounds {
  static constexpr double reaction = 1e-7;  ///< both routes to F_T
  static constexpr double energy = 1e-6;    ///< work minus the sum of all energies stored and taken
  static constexpr double told = 1e-4;      ///< for both of these, if the run warns about them (balance_loose)
  static constexpr double growth = 1e-9;    ///< rise of the stored energy without loads, beyond twice the noise
  /// Stored energy some hundred steps after the loads, over the largest stored while they acted
  static constexpr double kept = 1.1;
  static constexpr double residual = 1e-10;  ///< of a solve, in equilibrated variables
};

struct Measures {
  int unknowns = 0, steps = 0;
  std::string scheme;
  bool finite = false;
  /// The run warns (balance_loose); energies are below 1e-10 of the possible work of the loads
  bool told_loose = false, only_round_off = false;
  /// |work - sum of all energies stored and taken| at the end, over the largest work or, if that is only round-off,
  /// over 1e-10 of the possible work of the loads.
  double energy = 0.;
  double noise = 0.;  ///< the same, largest over all times
  /// Largest rise of the stored energy in a step after the loads, over the largest work. By von Neumann's theorem an
  /// A-stable Runge-Kutta scheme never lets it rise (Hairer and Wanner, Solving ODEs II, IV.11).
  double growth = 0.;
  /// generalised-alpha only: stored energy 400 steps after the end, over the largest while loads acted. With steps
  /// much longer than a period the scheme overshoots (Hilber and Hughes, Earthq. Eng. Struct. Dyn. 6 (1978) 99), and
  /// must dissipate that energy.
  double kept = 0.;
  bool loads_end = false;  ///< whether there are steps without loads
  double reaction = 0.;    ///< difference of both routes to F_T; 0 without a caisson
  int negative = 0;        ///< pivots of the effective matrix
  int expected = 0;        ///< number of unknowns of phi, which `negative` must equal
  double residual = 0.;    ///< see SolveError
  double plain_residual = 0.;
  Halving halving;
};

struct Verdict {
  /// Contradictory: the case is refused as input. Refused: the numerics cannot solve it.
  enum class Kind { passed, contradictory, refused, failed } kind = Kind::passed;
  std::string why;  ///< message of a refusal; names of the measures that failed
  Measures measures;
};

/// Runs the case at that path as a user would. Exceptions other than InputError and NumericsError are not caught.
Verdict judge(const std::string& path);

}  // namespace upbead::test
