// One stage of a diagonally implicit scheme.
#pragma once

#include "effective_matrix.h"

namespace upbead::detail {

/// A stage on its way: with g = h gamma, v = v_predicted + g a and x = x_explicit + g v.
struct DirkStage {
  Vector v_predicted;
  Vector x_explicit;  ///< of the prescribed unknowns
  Vector x;           ///< x_explicit + g v_predicted, until move()
  Vector v;           ///< from move() on
  Vector a;           ///< prescribed unknowns (tail): given; free ones: those of the last stage, until solved
  Vector rhs;         ///< f - C v_predicted - K x before move(), so that E a = rhs

  /// x and v that belong to a.
  void move(double g) {
    v = v_predicted + g * a;
    x += g * g * a;
  }
};

/// What decides on the prescribed unknowns of a stage that no load moves.
class StageLaw {
 public:
  virtual ~StageLaw() = default;
  /// Solves the stage and moves it. False: the step shall not go on.
  virtual bool solve(const EffectiveMatrix& E, double g, DirkStage& stage) = 0;
};

}  // namespace upbead::detail
