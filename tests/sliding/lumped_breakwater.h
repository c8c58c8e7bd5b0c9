// A breakwater of masses, springs and pores, of the size of a reduced model.
#pragma once

#include "dynamics/slip_model.h"

namespace upbead::test {

/// A caisson (x, y, rotation) on two columns of saturated soil that carry it at its edges, and one that takes its
/// shear force, each of several layers; the landward column is stiffer, so that rocking changes N'. It slips by s.
/// The load "impact" is P, above the centre of gravity.
struct LumpedBreakwater {
  int layers = 20;
  double mass = 7.5e5;           ///< of the caisson (kg/m)
  double weight = 4.3e6;         ///< W' (N/m)
  double damping_time = 1.5e-3;  ///< of stiffness-proportional damping (s)

  System system() const;
  /// The slip model, whose normal force is that of the block less the uplift of the pores; x and x' are readings.
  SlipModel model(double friction) const;
};

/// Indices of the readings of the model.
enum LumpedReading : int { lumped_normal, lumped_uplift, lumped_x, lumped_velocity };

}  // namespace upbead::test
