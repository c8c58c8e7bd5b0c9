// Eight cells with soil that yields, side by side: their strains, and the nodal forces of their soil's stresses.
#pragma once

#include <deal.II/fe/fe_values.h>

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "fem/space.h"
#include "fem/unknowns.h"
#include "material/soil.h"
#include "upbead/algebra/sparse.h"

namespace upbead {

/// Components of a vector, a lane for each cell.
struct PackVector {
  detail::Lanes x{}, y{};
};

struct PackNumber {
  detail::Lanes value{};
};

/// A cell's degrees of freedom, and its shape functions at its points of quadrature.
struct CellShapes {
  int cell;                                                   ///< active cell index
  ElasticLaw elastic;                                         ///< D
  std::vector<std::array<int, 2>> dofs;                       ///< of u at each node: x, y
  std::vector<std::vector<dealii::Tensor<1, dim>>> gradient;  ///< by points, then by nodes (1/m)
  std::vector<double> area;                                   ///< area of each point, its weight of quadrature (m2)
  std::vector<dealii::Point<dim>> at;                         ///< position of each point (m)
};
/// At the points of quadrature of the cell's stiffness.
CellShapes shapes_of(const Space& space, const Cell& cell);

/// Strain at a point of quadrature per unit of each unknown, ascending, and the area of the point.
struct PointStrain {
  double area = 0.;  ///< m2
  std::map<int, PlaneStrain> strain;
};
std::vector<PointStrain> strains_by_unknown(const CellShapes& cell, const Unknowns& unknowns);

/// Lanes without a cell have zero shape functions, and take their displacement from entry `nowhere`.
class CellPack {
 public:
  /// All cells have the same number of nodes, and of points.
  CellPack(const std::vector<CellShapes>& cells, std::vector<std::unique_ptr<SoilPack>> soil, int nowhere);

  int n_cells() const { return static_cast<int>(cell_.size()); }
  int n_points() const { return static_cast<int>(area_.size()); }
  int cell(int lane) const { return cell_[static_cast<std::size_t>(lane)]; }
  SoilPack& soil(int point) const { return *soil_[static_cast<std::size_t>(point)]; }
  const detail::Lanes& area(int point) const { return area_[static_cast<std::size_t>(point)].value; }

  /// Takes the cells' displacements from `u`.
  void take(const Vector& u);
  PackTensor strain(int point) const;
  /// D strain.
  PackStress elastic_stress(const PackTensor& strain) const;
  /// Adds the nodal forces of a stress at a point over its area; clear_forces() sets the forces to zero.
  void clear_forces();
  void add_force(int point, const PackStress& stress);
  /// Adds the nodal forces to F, at the places from which u was taken.
  void give(Vector& F) const;

  /// Call at a commit: stores the present displacements and forces. As long as the norm of the strain changes by less
  /// than `margin` in each cell, the forces stay the same.
  void settle(const PackNumber& margin);
  /// Whether the present displacements are surely within that margin; if so, sets the forces to those of the last
  /// commit.
  bool rests();
  /// For checkpoints: writes and reads what settle() stores and the soil's history, as SoilAt does.
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
  std::vector<std::unique_ptr<SoilPack>> soil_;  ///< by points
};

}  // namespace upbead
