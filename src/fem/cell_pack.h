// Eight cells with soil that yields side by side: their strains, and the nodal forces of what their soil exerts.
#pragma once

#include <deal.II/fe/fe_values.h>

#include <array>
#include <memory>
#include <vector>

#include "fem/space.h"
#include "material/soil_pack.h"
#include "upbead/algebra/sparse.h"

namespace upbead {

/// Components of a vector, a lane for each cell.
struct PackVector {
  detail::Lanes x{}, y{};
};

struct PackNumber {
  detail::Lanes value{};
};

/// Where a cell's displacements stand, and what its shape functions make of them.
struct CellShapes {
  int cell;                                                   ///< active cell index
  ElasticLaw elastic;                                         ///< D
  std::vector<std::array<int, 2>> dofs;                       ///< of u at each node: x, y
  std::vector<std::vector<dealii::Tensor<1, dim>>> gradient;  ///< by points, then by nodes (1/m)
  std::vector<double> area;                                   ///< for which a point stands (m2)
  std::vector<dealii::Point<dim>> at;                         ///< of each point (m)
};
/// With as many points as the stiffness of the cell has.
CellShapes shapes_of(const Space& space, const Cell& cell);

/// Lanes without a cell have shapes of zero, and take the displacement `nowhere`.
class CellPack {
 public:
  /// Cells with as many nodes and points each.
  CellPack(const std::vector<CellShapes>& cells, std::unique_ptr<SoilPack> soil, int nowhere);

  int n_cells() const { return static_cast<int>(cell_.size()); }
  int n_points() const { return static_cast<int>(area_.size()); }
  int cell(int lane) const { return cell_[static_cast<std::size_t>(lane)]; }
  SoilPack& soil() { return *soil_; }
  const SoilPack& soil() const { return *soil_; }
  const detail::Lanes& area(int point) const { return area_[static_cast<std::size_t>(point)].value; }

  /// Takes the cells' displacements from `u`.
  void take(const Vector& u);
  PackTensor strain(int point) const;
  /// D strain.
  PackStress elastic_stress(const PackTensor& strain) const;
  /// The nodal forces of a stress at a point, over its area; they count from clear_forces() on.
  void clear_forces();
  void add_force(int point, const PackStress& stress);
  /// Adds them to F, where u was taken.
  void give(Vector& F) const;

  /// The present displacements and forces become those of the last commit; as long as the norm of the strain changes by
  /// less than `margin` in each cell, the forces stay.
  void settle(const PackNumber& margin);
  /// Whether that is sure of the present displacements; then the forces are those of the last commit.
  bool rests();
  /// What settle() keeps, for checkpoints, as of SoilPoint.
  void remember(std::vector<double>& memory) const;
  const double* recall(const double* memory);

 private:
  std::size_t at(int point) const { return static_cast<std::size_t>(point) * u_.size(); }

  std::vector<int> cell_;
  std::vector<int> dof_;              ///< by nodes, x and y, lanes
  std::vector<PackVector> gradient_;  ///< by points, nodes
  std::vector<PackNumber> area_;      ///< by points
  PackNumber G_, lambda_;             ///< of D
  std::vector<PackVector> u_, force_, settled_u_, settled_force_;
  std::vector<PackNumber> steepest_;  ///< largest norm of a node's gradient over the points (1/m)
  PackNumber margin_;
  std::unique_ptr<SoilPack> soil_;
};

}  // namespace upbead
