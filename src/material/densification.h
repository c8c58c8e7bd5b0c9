// Sand compacts under cycles of shear: the amount, from the path of its strain alone.
#pragma once

#include <vector>

#include "upbead/material/elastic_law.h"

namespace upbead {

/// Byrne (1991), after Martin, Finn and Seed (1975): a half cycle of amplitude gamma adds
///   gamma C1 exp(-C2 eps_v / gamma) / 2
/// to the volumetric strain eps_v; eps_v in the exponent is that at the beginning of the half cycle.
struct ShearCompaction {
  double c1 = 0., c2 = 0.;
  double threshold = 0.;  ///< largest amplitude that adds nothing
  double of_half_cycle(double amplitude, double so_far) const;
};

/// Counts half cycles of shear strain in the plane. A state is the point (eps_xx - eps_yy, gamma_xy): the distance of
/// two points is the largest shear strain from one state to the other (the diameter of Mohr's circle), independent of
/// the axes. A half cycle leads from a reversal to the point farthest from it; its amplitude is half of that
/// distance. It reverses where the path comes back along it. Until then it counts with the amplitude reached so far.
/// A path that turns back and later goes on counts as cycles of its own, and the half cycle that it interrupted as
/// one (as Masing's loops, and rainflow counting in fatigue).
class ShearCycles {
 public:
  explicit ShearCycles(const ShearCompaction& law) : law_(law) {}
  /// Adds the next strain in time; the first comes after rest (zero).
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
    double reached = 0.;  ///< distance of `from` and `farthest`
    double before = 0.;   ///< eps_v at the beginning of the half cycle
  };

  static double distance(const Point& a, const Point& b);
  /// Position of a point along a half cycle, measured from its beginning.
  static double along(const HalfCycle& half, const Point& now);
  void reach(const Point& now, double distance);
  void close_loop();

  ShearCompaction law_;
  std::vector<HalfCycle> open_{HalfCycle{}};  ///< each lies within the one two before it
  double compaction_ = 0., largest_ = 0.;
  int reversals_ = 0;
};

}  // namespace upbead
