// How much of a soil's Mohr-Coulomb strength static plus dynamic stresses take.
#pragma once

#include <string>
#include <vector>

#include "fem/static_stage.h"
#include "fem/unknowns.h"
#include "upbead/dynamics/march.h"
#include "upbead/response/findings.h"

namespace upbead {

/// Follows the stresses of all cells of regions with a strength.
class Mobilisation : public MarchObserver {
 public:
  /// `rest`: the static state; `k0`: s'_x = K_0 s'_y of it, where that is given. Keeps what it needs of all.
  Mobilisation(const Space& space, const Unknowns& unknowns, const EffectiveStress& rest,
               const std::optional<double>& k0);
  void see(const State& state, int step, int n_steps) override;
  bool has_seen() const { return has_seen_; }
  std::vector<MobilisedStrength> found() const;

  /// All that it remembers of the states it has seen, and back.
  std::vector<double> memory() const override;
  void recall(const std::vector<double>& memory) override;

 private:
  struct Soil {
    dealii::Point<dim> middle;
    std::size_t region = 0;
    double area = 0.;
    double middle_stress = 0., half_difference = 0., shear = 0.;  ///< at rest: s, (s'_x - s'_y)/2, tau (Pa)
    double sine = 0., apex = 0.;                                  ///< sin phi, c cos phi (Pa)
    bool counts = true;

    double mobilisation(double s, double difference, double tau) const;
  };

  void leave_out_free_surfaces();

  std::vector<std::string> regions_;
  std::vector<Soil> cells_;
  SparseMatrix sum_, difference_, shear_;  ///< changes of s, (s'_x - s'_y)/2, tau over the unknowns
  std::vector<double> largest_, time_;     ///< by cell
  bool has_seen_ = false;
};

}  // namespace upbead
