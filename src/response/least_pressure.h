// How near the water of a scene comes to boiling.
#pragma once

#include <vector>

#include "fem/unknowns.h"
#include "upbead/dynamics/march.h"
#include "upbead/dynamics/reduce.h"

namespace upbead {

/// Vapour pressure of water at 20 C, absolute: 2339 Pa (Wagner and Pruss 2002, IAPWS-95), and a standard atmosphere.
constexpr double vapour_pressure = 2339., atmosphere = 101325.;

/// Where and when a scene's water had its least absolute pressure: atmosphere + rho_f g (level - y) + excess. Only
/// water below the still water level counts: what stands above holds air.
class LeastPressure : public MarchObserver {
 public:
  /// `level`: of still water (m), from water_level(); where it is -infinity nothing is watched.
  LeastPressure(const Space& space, const Unknowns& unknowns, const Scene& scene, double level);
  bool watches() const { return !nodes_.empty(); }
  bool has_seen() const { return has_seen_; }
  /// Takes in a state of a march.
  void see(const State& state, int step, int n_steps) override;
  /// Takes in what a reduced model answers to these loads, at about 16 times in `duration` (s).
  void see(const PressureModel& model, const SampledLoads& loads, double duration);

  /// All that it remembers of what it has seen, and back.
  std::vector<double> memory() const override;
  void recall(const std::vector<double>& memory) override;

  double value() const { return least_; }  ///< Pa, absolute; negative where the linear answer pulls at the water
  double time() const { return time_; }    ///< s
  const dealii::Point<dim>& place() const { return nodes_[node_].at; }
  const std::string& region() const { return nodes_[node_].region; }

 private:
  struct Node {
    dealii::Point<dim> at;
    std::string region;
    double still = 0.;  ///< absolute pressure at rest (Pa)
  };

  void take(const Eigen::Ref<const Vector>& excess, double time);

  std::vector<Node> nodes_;
  SparseMatrix rows_;  ///< excess pressure of the nodes over x'
  double least_ = 0., time_ = 0.;
  std::size_t node_ = 0;
  bool has_seen_ = false;
};

}  // namespace upbead
