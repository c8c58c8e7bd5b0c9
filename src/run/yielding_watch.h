// Results for yielding soil besides forces: mobilised strength, largest strain, residual pore pressure.
#pragma once

#include <vector>

#include "fem/yielding_soil.h"
#include "response/monitors.h"
#include "upbead/output/ground_summary.h"

namespace upbead {

/// Follows all cells that may yield during the march.
class YieldingWatch : public MarchObserver {
 public:
  /// All arguments must outlive the object.
  YieldingWatch(const Space& space, const Unknowns& unknowns, YieldingSoil& soil);
  void see(const State& state, int step, int n_steps) override;
  bool wants(double) const override { return false; }
  std::vector<double> memory() const override;
  void recall(const std::vector<double>& memory) override;

  /// By region; a cell counts with the mean of its points, and as fully mobilised within 1e-6 of its strength.
  std::vector<MobilisedRegion> regions() const;
  PeakStrain peak_strain() const;

 private:
  struct Soil {
    dealii::DoFHandler<dim>::active_cell_iterator cell;
    double initial = 0., largest = 0., time = 0.;  ///< mobilised
  };
  double mean_beside(const Soil& soil) const;

  const Space& space_;
  YieldingSoil& soil_;
  std::vector<Soil> cells_;
  LargestStrains strains_;
};

/// The largest magnitude of excess pore pressure in a state, and where; none where there is no pore water.
std::optional<PorePressureLeft> pore_pressure_left(const Space& space, const Unknowns& unknowns, const State& state);

}  // namespace upbead
