// What contact on a reduced ground may be wrong by, from the answers of two nested models of it.
#pragma once

#include <string>

#include "upbead/dynamics/march.h"
#include "upbead/output/sliding_summary.h"

namespace upbead {

/// Differences of nested models, which are about the error of the smaller one, count so many times: see
/// docs/reference/methods.md.
constexpr double margin_of_ground = 5.;
/// Of the largest slip: what the patch around the base may cost, which all levels share; 0.12 % was seen.
constexpr double of_patch = 2e-3;
/// F_T(t) may be wrong by this multiple of what its peak may: where nodes come to rest a little later it differs more.
constexpr double of_history = 10.;

/// The largest difference of each reading at the times that both answers have: all but where one of them leapt. Throws
/// NumericsError where they share too few.
Eigen::VectorXd differences(const Series& fine, const Series& coarse);

/// What a model answers: F_T at the ends of its steps, and what the nodes do.
struct OfGround {
  Eigen::RowVectorXd shear;
  const NodeContact& contact;
};
/// Errors of S and F_T; `apart`: the largest difference of F_T at any time.
ContactGround ground_errors(const OfGround& fine, const OfGround& coarse, double apart);

/// Whether these errors are within the tolerance.
bool meets(const ContactGround& error, const NodeContact& contact, double tolerance);
/// Why an answer is not given.
std::string why_ground_misses(const ContactGround& error);

}  // namespace upbead
