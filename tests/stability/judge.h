// Runs one case and measures whether its numbers can be trusted.
#pragma once

#include <string>

#include "halving.h"

namespace upbead::test {

/// What must hold of every scene that is not refused.
struct Bounds {
  static constexpr double reaction = 1e-7;   ///< both routes to F_T
  static constexpr double energy = 1e-6;     ///< work and what became of it
  static constexpr double told = 1e-4;       ///< either, where the run warns of it (balance_loose)
  static constexpr double growth = 1e-9;     ///< rise of the stored energy without loads, beyond twice the noise
  static constexpr double kept = 1.1;        ///< of the energy stored with loads, some hundred steps after them
  static constexpr double residual = 1e-10;  ///< of a solve, in equilibrated variables
};

struct Measures {
  int unknowns = 0, steps = 0;
  std::string scheme;
  bool finite = false;
  bool told_loose = false, only_round_off = false;  ///< warned of; energies within 1e-10 of what the loads could do
  /// |work - what became of it| at the end over the largest work, or, where the loads do none but round-off, over 1e-10
  /// of what they would do alone.
  double energy = 0.;
  double noise = 0.;  ///< the same, the largest of all times
  /// Largest rise of the stored energy in a step after the loads, over the largest work. By von Neumann's theorem an
  /// A-stable Runge-Kutta scheme never lets it rise (Hairer and Wanner, Solving ODEs II, IV.11).
  double growth = 0.;
  /// generalised-alpha only: stored energy 400 steps after the end, over the largest while loads acted. It overshoots
  /// in steps much longer than a period (Hilber and Hughes, Earthq. Eng. Struct. Dyn. 6 (1978) 99), and must lose that.
  double kept = 0.;
  bool loads_end = false;  ///< whether there are steps without loads
  double reaction = 0.;    ///< difference of both routes to F_T; 0 without a caisson
  int negative = 0;        ///< pivots of the effective matrix
  int expected = 0;        ///< unknowns of phi, which these must be
  double residual = 0.;    ///< see SolveError
  double plain_residual = 0.;
  Halving halving;
};

struct Verdict {
  /// Contradictory: refused as input, for what the case says. Refused: the numerics cannot answer it.
  enum class Kind { passed, contradictory, refused, failed } kind = Kind::passed;
  std::string why;  ///< message of a refusal; names of the measures that failed
  Measures measures;
};

/// As a person runs the case at that path. Throws what is neither an InputError nor a NumericsError.
Verdict judge(const std::string& path);

}  // namespace upbead::test
