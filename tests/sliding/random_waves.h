// Wave forces of every kind.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "upbead/sliding/block.h"

namespace upbead::test {

/// Church roofs, double pulses and noise, of 1 to 12 MN/m, within 1.2 s.
class RandomWaves {
 public:
  explicit RandomWaves(unsigned seed) : random_(seed) {}

  /// Its points lie on multiples of `step` (s).
  History next(double step) {
    History force{{0.}, {0.}};
    const double peak = 1e6 * std::pow(12., number());
    double t = 0.;
    const auto point = [&](double later, double value) {
      t = std::max(t + step, step * std::round((t + later) / step));
      force.time.push_back(t);
      force.value.push_back(value);
    };
    switch (kind_++ % 3) {
      case 0:
        point(0.01 + 0.1 * number(), peak);
        point(0.02 + 0.1 * number(), 0.4 * peak * number());
        point(0.5 * number(), 0.3 * peak * number());
        point(0.2, 0.);
        break;
      case 1:
        for (const double part : {1., number(), -number()}) {
          point(0.01 + 0.1 * number(), part * peak);
          point(0.02 + 0.1 * number(), 0.);
          point(0.1 * number(), 0.);
        }
        break;
      default:
        while (t < 0.8) point(0.01 + 0.05 * number(), peak * (2. * number() - 1.));
        point(0.02, 0.);
    }
    return force;
  }

 private:
  double number() { return std::uniform_real_distribution<double>(0., 1.)(random_); }

  std::mt19937 random_;
  int kind_ = 0;
};

}  // namespace upbead::test
