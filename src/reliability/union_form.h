// The probability of a union of half-spaces in standard space: FORM for systems in series.
#pragma once

#include <vector>

#include "reliability/methods.h"

namespace upbead {

/// P(alpha_i . u >= beta_i for any i), one point at least. Sum over i of the integral of the density over half-space i
/// over the number S(u) of half-spaces that u is in (Owen, Maximov and Chertkov 2019, Importance sampling the union of
/// rare events with an application to power systems analysis, Electron. J. Statist. 13(1), 231-254), along alpha_i in
/// closed form, as S changes only where the line crosses a plane, and across it by a Sobol sequence in the space that
/// all alpha span. No matrix is inverted: equal and opposite half-spaces are points like others. It lies between max
/// P_i and min(1, sum P_i).
double probability_of_any(const std::vector<DesignPoint>& points);

}  // namespace upbead
