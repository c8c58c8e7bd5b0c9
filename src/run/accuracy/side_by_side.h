// Two systems reduced side by side: how far their answers lie apart is known long before the answers are.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "dynamics/growing_model.h"

namespace upbead {

/// Numbers that a model answers, by what they are of: each list is judged by its own largest.
using Answers = std::vector<Eigen::VectorXd>;

/// Reads a model as it is; throws NumericsError where it is too small to be read.
using ReadModel = std::function<Answers(const GrowingModel&)>;

struct SideBySide {
  Answers coarse, finer;  ///< by models of as many vectors
};

/// Grows the models of two meshes with the same loads, readings and shift look by look, until from one look to the next
/// the difference of each list of answers moves by less than a twentieth of its largest, or by `enough` of the largest
/// answer, or until both have converged by themselves. V vectors match the first V moments of both transfer functions
/// about the shift [Bai and Su 2005], and so of their difference, which they tell as well, relative to itself, as
/// either answer: what both lack is about the same and falls out. None where they grow no more before. Throws
/// NumericsError as GrowingModel::grow() does.
std::optional<SideBySide> grow_side_by_side(GrowingModel& coarse, GrowingModel& finer, const ReadModel& read,
                                            double enough);

}  // namespace upbead
