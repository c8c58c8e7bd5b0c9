// The times of two histories, merged: pieces on which both are linear.
#pragma once

#include <vector>

#include "upbead/sliding/block.h"

namespace upbead::detail {

/// A quantity that is linear over a piece.
struct Line {
  double begin = 0., end = 0.;
  double at(double fraction) const { return (1. - fraction) * begin + fraction * end; }
};

struct ForcePiece {
  double start = 0., length = 0.;  ///< s
  Line force, resistance;          ///< N/m
  /// What is left of it past `passed` seconds.
  ForcePiece after(double passed) const;
};

/// Two histories over a piece.
struct TwoLines {
  double start = 0., length = 0.;  ///< s
  Line first, second;
};

/// Pieces from the first to the last of all times, ascending; both are zero before and after their points.
std::vector<TwoLines> two_lines(const ForceHistory& first, const ForceHistory& second);

/// Pieces from the first to the last of all times, ascending. Throws std::invalid_argument as slide() does.
std::vector<ForcePiece> force_pieces(const ForceHistory& force, const ForceHistory& resistance);

}  // namespace upbead::detail
