// The ladder: ways to solve a scene in time, of which the first is taken whose answer holds.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "response/shear_response.h"
#include "solve.h"

namespace upbead {

/// One way.
struct Way {
  std::string name;  ///< as people are told it, in the summary too
  std::function<Run(const MarchOptions&)> solve;
  bool keeps_checkpoints = false;  ///< of all ways one may
};

/// What does not balance in an answer, see require_balance of response/shear_response.h. Throws NumericsError where it
/// stores more energy than the loads have brought.
std::optional<Mismatch> imbalance(const Simulation& simulation, const Run& run);

/// The answer of the first way that gives one and balances, with the ladder so far in its summary. Where none balances,
/// that which comes closest, as long as it is bearable: it is to be warned of. Else throws NumericsError with all
/// reasons.
Run climb(const Simulation& simulation, const std::vector<Way>& ways, const MarchOptions& marching);

/// With how much care marches are tried, one after the other: as usual, with refined solutions, and, where the case
/// leaves the scheme to us, in shorter steps too.
std::vector<Care> cares_of(const Scene& given);

/// "NAME", "NAME, refined solutions, steps divided by 4".
std::string name_of_way(const std::string& scheme, const Care& care);

/// The ways that a case allows: where it leaves the scheme to us a reduced model, if that is less work, then sdirk4
/// with more and more care; else the scheme that it names.
std::vector<Way> ways(const Simulation& simulation, const std::function<void(double)>& reducing);

/// What a person is told whose scheme has been refused: whether "auto" would answer, and how. Tries it.
std::string what_would_work(const Simulation& simulation, const std::function<void(double)>& reducing);

}  // namespace upbead
