// The times of two histories, merged: pieces on which both are linear.
#pragma once

#include <vector>

#include "upbead/base/history.h"

namespace upbead {

/// A quantity that is linear over a piece.
struct Line {
  double begin = 0., end = 0.;
  double at(double fraction) const { return (1. - fraction) * begin + fraction * end; }
};

/// Two histories over a piece.
struct LinearPiece {
  double start = 0., length = 0.;  ///< s
  Line first, second;
  /// The part of it after `passed` seconds.
  LinearPiece after(double passed) const;
};

/// Pieces from the first to the last of all times, ascending; both are zero before and after their points. Throws
/// std::invalid_argument as slide() does.
std::vector<LinearPiece> linear_pieces(const History& first, const History& second);

/// The same for a force and a resistance; the resistance keeps its first and last value beyond its points.
std::vector<LinearPiece> force_pieces(const History& force, const History& resistance);

}  // namespace upbead
