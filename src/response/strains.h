// Strains at the middle of all cells that deform, for what follows their largest values.
#pragma once

#include <vector>

#include "fem/unknowns.h"
#include "upbead/dynamics/march.h"

namespace upbead {

/// Largest shear strain of each cell over all states that it has seen.
class LargestStrains : public MarchObserver {
 public:
  /// `of_interest`: by active cell index; others stay 0.
  LargestStrains(const Space& space, const Unknowns& unknowns, const std::vector<bool>& of_interest);
  /// gamma = sqrt((e_x - e_y)^2 + (2 e_xy)^2), the diameter of Mohr's circle.
  void see(const State& state, int step, int n_steps) override;
  /// By active cell index.
  const std::vector<double>& shear() const { return largest_; }

 private:
  std::vector<std::size_t> cells_;
  SparseMatrix difference_, shear_;  ///< e_x - e_y and 2 e_xy of those cells over the unknowns
  std::vector<double> largest_;
};

}  // namespace upbead
