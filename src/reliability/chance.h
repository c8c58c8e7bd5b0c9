// Probabilities and indices.
#pragma once

#include <optional>

namespace upbead {

/// beta = -Phi^-1(p); none at 0 and 1, where it is infinite.
std::optional<double> index_of(double probability);

/// 1 - (1 - p)^n, of independent occasions, to the last digits of a small p.
double of_occasions(double probability, double occasions);

}  // namespace upbead
