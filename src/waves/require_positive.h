#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

namespace upbead {

/// Throws std::invalid_argument unless a value that `whose` formulas take is finite and above 0.
inline void require_positive(double value, const std::string& name, const std::string& whose) {
  if (!(value > 0. && std::isfinite(value))) throw std::invalid_argument(whose + " a finite " + name + " above 0");
}

}  // namespace upbead
