// A landward force and its moment as two forces at two heights.
#pragma once

#include <vector>

#include "case/cfd/flow_source.h"

namespace upbead {

struct FlowPieces {
  std::vector<double> low, high;  ///< N/m
};

/// Forces at the heights `low` and `high` (m) whose sum and moment are those of the history.
FlowPieces pieces_of(const FlowHistory& history, double low, double high);

/// Sets Load::history and Load::duration of a force, with the load's factor, in a run until `end` (s).
void give_history(const FlowHistory& history, const std::vector<double>& force, double end, Load& load);

}  // namespace upbead
