// Reference solutions in tests/reference, and comparing histories with them.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "upbead/model/scene.h"

namespace upbead::test {

using Json = nlohmann::json;

/// The file NAME.json of tests/reference.
Json reference(const std::string& name);

/// A porous region with the constants of a reference material (`mat`, `material_input`, ...): stiffness as Ey and nu, K
/// and mu, or lam and mu; k or kappa; rho or rho_s; n, rho_f, Ks, alpha, a_inf where they are given.
Region soil(const Json& material, Flow flow);
/// Its pore water: rho_f and Kf (infinite where none is given).
Fluid fluid(const Json& material);

/// Values of a history at given times, linear between its own times.
std::vector<double> sampled(const std::vector<double>& times, const Eigen::RowVectorXd& values,
                            const std::vector<double>& at);

/// Largest |computed - exact| over `scale`; over the largest |exact| where none is given.
double largest_error(const std::vector<double>& computed, const std::vector<double>& exact, double scale = 0.);

}  // namespace upbead::test
