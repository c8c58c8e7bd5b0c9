// Rows of a time and numbers, as CFD programs write them: one run, or several that follow each other.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

struct FlowRows {
  std::size_t width = 0;      ///< numbers of a row beside its time
  std::vector<double> time;   ///< s
  std::vector<double> value;  ///< row by row; not a number where a cell is blank

  std::size_t count() const { return time.size(); }
  double at(std::size_t row, std::size_t column) const { return value[row * width + column]; }
  std::vector<double> column(std::size_t c) const;
};

/// What was done on the way, for people: each a sentence without its full stop.
using FlowNotes = std::vector<std::string>;

/// The rows of one file in place: rows whose times repeat, as programs keep six digits, become one with their mean.
/// Throws InputError at `place` where times descend, and where there is no row.
void settle(FlowRows& rows, const Place& place, FlowNotes& notes);

/// One run of several.
struct FlowPiece {
  std::string folder;  ///< as it is called, the time of its start
  FlowRows rows;
};

/// Runs in the order of their starts, joined: the later one wins from its first time on.
FlowRows joined(std::vector<FlowPiece> pieces, FlowNotes& notes);

}  // namespace upbead
