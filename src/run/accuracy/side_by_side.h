// Two systems reduced side by side: the difference of their responses is known long before the responses are.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "dynamics/growing_model.h"
#include "upbead/algebra/layout.h"

namespace upbead {

/// Numbers computed from a model, in lists: each list is judged by its own largest value.
using Answers = std::vector<Eigen::VectorXd>;

/// Computes them from a model; throws NumericsError where the model is still too small for that.
using ReadModel = std::function<Answers(const GrowingModel&)>;

struct SideBySide {
  Answers coarse, finer;  ///< by models with equally many vectors
};

/// Grows the models of two meshes with the same loads, readings and shift look by look, until from one look to the
/// next the difference of each list changes by less than a twentieth of its largest value, or by less than `enough`
/// of the list's largest value, or until both models have converged by themselves. V vectors match the first V
/// moments of both transfer functions about the shift [Bai and Su 2005], and so those of their difference. So the
/// difference has the same relative accuracy as either response: both models lack about the same, and that cancels.
/// None where the models cannot grow that far. Throws NumericsError as GrowingModel::grow() does.
///
/// `coarse` may be of a divided system, whose layout is `among`, and `finer` be made by each process for itself: then
/// the first process decides when to stop, as another that stops elsewhere by round-off would be waited for; and where
/// one fails, NumericsError is thrown on all.
std::optional<SideBySide> grow_side_by_side(GrowingModel& coarse, GrowingModel& finer, const ReadModel& read,
                                            double enough, const Layout& among = {});

/// Grows a model until it has converged, or can grow no more; the first process decides, likewise.
void grow_to_its_end(GrowingModel& model, const Layout& among);

}  // namespace upbead
