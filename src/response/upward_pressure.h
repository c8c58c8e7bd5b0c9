// The largest excess of the pore pressure below the surface of the ground over that on the surface above it.
#pragma once

#include <string>
#include <vector>

#include "fem/unknowns.h"
#include "upbead/dynamics/march.h"
#include "upbead/dynamics/reduce.h"

namespace upbead {

/// Points on verticals below the surface, where free water or the outside is above the pores.
class UpwardPressure : public MarchObserver {
 public:
  struct Point {
    double depth = 0., y = 0.;  ///< below the surface (m), and its height
    unsigned surface = 0;       ///< region there: an index of the mesh's surfaces
    double largest = 0.;        ///< p - p on the surface above, the largest at any time (Pa); 0 where never positive
    double time = 0.;           ///< when (s)
  };
  struct Vertical {
    double x = 0., top = 0.;    ///< m
    double cell = 0.;           ///< height of its uppermost cell (m)
    std::vector<Point> points;  ///< downwards, as far as there are pores
  };

  UpwardPressure(const Space& space, const Unknowns& unknowns);

  void see(const State& state, int step, int n_steps) override;
  bool wants(double) const override { return false; }
  /// Evaluates the response of a reduced model to these loads at all its times.
  void see(const PressureModel& model, const SampledLoads& loads);
  std::vector<double> memory() const override;
  void recall(const std::vector<double>& memory) override;

  bool has_seen() const { return has_seen_; }
  const std::vector<Vertical>& verticals() const { return verticals_; }

 private:
  void take(const Eigen::Ref<const Vector>& excess, double time);

  std::vector<Vertical> verticals_;
  SparseMatrix rows_;  ///< maps x' to the excess of one point after the other
  bool has_seen_ = false;
};

}  // namespace upbead
