// Rows of a time and numbers, as CFD programs write them: one run, or several that follow each other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "upbead/base/error.h"

namespace upbead {

struct FlowRows {
  std::size_t width = 0;      ///< numbers of a row besides its time
  std::vector<double> time;   ///< s
  std::vector<double> value;  ///< row by row; NaN where a cell is blank

  std::size_t count() const { return time.size(); }
  /// Throws std::out_of_range where there is no such cell.
  double at(std::size_t row, std::size_t column) const {
    return value.at(column < width ? row * width + column : value.size());
  }
  std::vector<double> column(std::size_t c) const;
};

/// What was done while reading, for people: each a sentence without its full stop.
using FlowNotes = std::vector<std::string>;

/// Tidies the rows of one file in place: rows with the same time, as programs write six digits, become one row with
/// their mean. Throws InputError at `place` where times descend, and where there is no row.
void settle(FlowRows& rows, const Place& place, FlowNotes& notes);

/// One run of several.
struct FlowPiece {
  std::string name;  ///< for people: "the run from 0.8 s"
  FlowRows rows;
  std::optional<double> start = {};  ///< of a run in one folder or file with others (s)
};

class FlowLines;

/// Adds a run, whose head ends above the line at which `lines` stands; `width`: numbers of a row besides its time.
void begin_piece(const FlowLines& lines, std::size_t width, std::vector<FlowPiece>& pieces);

/// Joins runs in the order of their starts: from its first time on, a later run replaces the earlier ones.
FlowRows joined(std::vector<FlowPiece> pieces, FlowNotes& notes);

/// Of two runs with the same start, one must hold all rows of the other, and is kept. Throws InputError where they
/// differ: a person must say which of them counts.
std::vector<FlowPiece> without_repetitions(std::vector<FlowPiece> pieces, const Place& place, FlowNotes& notes);

/// The rows of a file in which a head may stand more than once, as where the files of several runs were put together.
/// Throws InputError where a run begins before the one above it.
FlowRows rows_of_file(std::vector<FlowPiece> runs, const Place& place, FlowNotes& notes);

}  // namespace upbead
