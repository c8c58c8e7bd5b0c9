// Rows of a time and numbers, as CFD programs write them: one run, or several that follow each other.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

struct FlowRows {
  std::size_t width = 0;      ///< numbers of a row besides its time
  std::vector<double> time;   ///< s
  std::vector<double> value;  ///< row by row; NaN where a cell is blank

  std::size_t count() const { return time.size(); }
  double at(std::size_t row, std::size_t column) const { return value[row * width + column]; }
  std::vector<double> column(std::size_t c) const;
};

/// What was done while reading, for people: each a sentence without its full stop.
using FlowNotes = std::vector<std::string>;

/// Tidies the rows of one file in place: rows with the same time, as programs write six digits, become one row with
/// their mean. Throws InputError at `place` where times descend, and where there is no row.
void settle(FlowRows& rows, const Place& place, FlowNotes& notes);

/// One run of several.
struct FlowPiece {
  std::string folder;  ///< named after the time of its start
  FlowRows rows;
};

/// Joins runs in the order of their starts: from its first time on, a later run replaces the earlier ones.
FlowRows joined(std::vector<FlowPiece> pieces, FlowNotes& notes);

}  // namespace upbead
