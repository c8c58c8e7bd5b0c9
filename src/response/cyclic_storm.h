// Residual pore pressure over a storm: cycles of shear press water out of the soil, which flows through the ground.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algebra/factorisation.h"
#include "fem/pore_diffusion.h"
#include "material/cyclic_soil.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Pressure of pore water whose soil bears no more than `cap`: S p' + K p = F - r, where r >= 0 and p <= cap, and r = 0
/// where p < cap. r is what liquefied soil does not press out, as it bears nothing. In time by the L-stable SDIRK
/// scheme of order 2 (Alexander 1977); in each stage the nodes with p = cap by the primal-dual active set
/// (Hintermueller, Ito and Kunisch 2003).
class CappedFlow {
 public:
  /// `cap`: at the nodes (Pa), may be infinite. `flow` must outlive this.
  CappedFlow(const PoreFlow& flow, const Vector& cap);

  /// Takes a step with these sources at the nodes (m2/s), which keep their values. Throws NumericsError.
  void step(const Vector& source, double dt);
  const Vector& pressure() const { return p_; }  ///< at the nodes (Pa)
  double stored() const;                         ///< m2
  double outflow() const { return outflow_; }    ///< through drained nodes since the beginning (m2)
  const Vector& shed() const { return shed_; }   ///< time integral of r at the nodes (m2)

 private:
  struct Stage {
    Vector p, r;
    double outflow = 0.;  ///< m2/s
  };
  Stage solve(const Vector& known, const Vector& source, double implicit);
  Vector solve_with(const std::vector<bool>& held, const Vector& right, double implicit);
  SparseMatrix matrix(const std::vector<bool>& held, double implicit) const;

  const PoreFlow& flow_;
  Vector cap_, p_, shed_;
  double rounding_ = 0.;  ///< by which p may pass its cap (Pa)
  double outflow_ = 0.;
  std::vector<bool> at_cap_;
  std::vector<bool> factored_held_;
  double factored_for_ = 0.;
  std::shared_ptr<const Factorisation> factors_;
};

/// A cell of the ground in a storm.
struct StormCell {
  bool counts = false;                     ///< whether its effective stress is large enough to speak of
  double effective_stress = 0.;            ///< sigma'_0, mean at rest (Pa)
  double shear = 0.;                       ///< amplitude in the run's wave (Pa)
  double modulus = 0.;                     ///< G (Pa)
  std::optional<CyclicStrength> strength;  ///< none: cycles build no pressure
  std::optional<ShearCompaction> compaction;
};

/// What a storm left in the ground; lists are by active cell index, NaN where there is nothing.
struct StormFound {
  std::vector<double> pressure;       ///< when the storm ends (Pa)
  std::vector<double> largest_ratio;  ///< p/sigma'_0 of cells that count
  std::vector<double> ratio_time;     ///< when that was (s)
  std::vector<double> liquefied_at;   ///< when p came to sigma'_0 (s); NaN: never
  std::vector<double> compaction;     ///< volumetric strain by cycles of shear
  std::vector<double> drained;        ///< volumetric strain by the water that the soil pressed out
  std::vector<double> time, ratio;    ///< history: largest p/sigma'_0 at the ends of the steps
  double duration = 0., calm = 0.;    ///< s
  double source = 0., stored = 0., outflow = 0., shed = 0.;  ///< m2
};

/// `cells`: by active cell index. A part of the storm ends in steps of its duration over `steps`, and begins in steps
/// of a 32nd of these, which double after every steps/4; in the calm they go on doubling.
StormFound run_storm(const PoreFlow& flow, const Cycles& cycles, const std::vector<StormCell>& cells, int steps = 64);

/// From p = liquefied sigma'_0 on soil counts as liquefied: the cap is met at nodes, ratios are of the middles of
/// cells.
constexpr double liquefied_ratio = 0.99;

}  // namespace upbead
