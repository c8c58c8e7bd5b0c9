// Does halving the step bring the answer closer?
#pragma once

#include <string>
#include <vector>

#include "upbead/dynamics/march.h"

namespace upbead::test {

/// One reading of marches with steps h, h/2, h/4, ...
struct Halving {
  std::string reading;
  double scale = 0.;               ///< largest value of the reading
  std::vector<double> difference;  ///< largest |y_(h/2^(k+1)) - y_(h/2^k)| at the ends of the steps h, over the scale
  std::vector<double> largest;     ///< largest |y| with steps h/2^k, over the scale
  bool closer = false;             ///< the last difference is smaller than the one before it, or is round-off
};

/// Marches a system with ever smaller steps until the last difference is smaller than the one before it, at most
/// `most` times. `h` is the step of the case.
Halving halve(const System& system, SchemeKind kind, double end, double h, int most);

}  // namespace upbead::test
