// Sand packs denser under cycles of shear: by how much, from the path of its strain alone.
#pragma once

#include <vector>

#include "upbead/material/elastic_law.h"

namespace upbead {

/// Byrne (1991), after Martin, Finn and Seed (1975): a half cycle of amplitude gamma adds
///   gamma C1 exp(-C2 eps_v / gamma) / 2
/// to the volumetric strain eps_v, that at its beginning in the exponent.
struct ShearCompaction {
  double c1 = 0., c2 = 0.;
  double threshold = 0.;  ///< amplitude up to which nothing is added
  double of_half_cycle(double amplitude, double so_far) const;
};

/// Counts half cycles of shear strain in the plane. Its point is (eps_xx - eps_yy, gamma_xy): the distance of two
/// points is the largest shear strain from one state to the other (the diameter of Mohr's circle), in whatever axes. A
/// half cycle leads from a reversal to the farthest point from it, its amplitude is half of that way; it reverses where
/// the point comes back along that way. As it goes on it counts with the amplitude that it has reached. What turns back
/// on the way and then goes on counts as cycles of its own, and the way as one (as Masing's loops, and rainflow
/// counting in fatigue).
class ShearCycles {
 public:
  explicit ShearCycles(const ShearCompaction& law) : law_(law) {}
  /// Strains in the order of time, from rest (zero) on.
  void add(const PlaneStrain& strain);
  double compaction() const { return compaction_; }  ///< eps_v so far, 0 or more
  double largest_amplitude() const { return largest_; }
  int reversals() const { return reversals_; }

 private:
  struct Point {
    double difference = 0., gamma = 0.;
  };
  struct HalfCycle {
    Point from, farthest;
    double reached = 0.;  ///< distance of both
    double before = 0.;   ///< eps_v at its beginning
  };

  static double distance(const Point& a, const Point& b);
  /// How far a point lies along the way of a half cycle.
  static double along(const HalfCycle& half, const Point& now);
  void reach(const Point& now, double distance);
  void close_loop();

  ShearCompaction law_;
  std::vector<HalfCycle> open_{HalfCycle{}};  ///< each within that two before it
  double compaction_ = 0., largest_ = 0.;
  int reversals_ = 0;
};

}  // namespace upbead
