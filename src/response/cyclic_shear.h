// The amplitude of the shear stress of a wave in each cell whose soil builds pore pressure under cycles.
#pragma once

#include <array>
#include <vector>

#include "response/monitors.h"

namespace upbead {

/// A state of stress is the point ((s_x - s_y)/2, tau): the amplitude is half of the largest distance of two states of
/// a cell, rest included, which is tau where the path is tau on level planes alone, and never less than half the range
/// of that tau. Told by the farthest states in 16 directions: less than 0.5 % below it, and exact where the path is
/// straight along one of them, as that of simple shear.
class CyclicShear : public MarchObserver {
 public:
  CyclicShear(const Space& space, const Unknowns& unknowns);
  void see(const State& state, int step, int n_steps) override;
  bool wants(double) const override { return false; }
  /// Evaluates the response of a reduced model to these loads, at about 64 times in `duration` (s).
  void see(const StateModel& model, const SampledLoads& loads, double duration);
  bool has_seen() const { return has_seen_; }
  /// By active cell index (Pa); NaN where no soil builds pressure.
  std::vector<double> amplitude() const;

  std::vector<double> memory() const override;
  void recall(const std::vector<double>& memory) override;

 private:
  static constexpr std::size_t n_directions = 16;
  using Point = std::array<double, 2>;
  /// The farthest states of a cell both ways along each direction.
  struct Farthest {
    std::array<Point, 2 * n_directions> points{};
  };
  void take(std::size_t cell, const PlaneStrain& strain);

  MiddleStrains strains_;
  std::vector<double> modulus_;  ///< G of the cells (Pa)
  std::vector<Farthest> cells_;
  std::size_t n_active_;
  bool has_seen_ = false;
};

}  // namespace upbead
