// The finite-element space of a scene: the unknowns of each cell.
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values_extractors.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/hp/fe_collection.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fem/cell_kind.h"
#include "fem/impedance.h"
#include "upbead/fem/soil_state.h"
#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// Components of every element of the collection: u (2), W (2), phi (1).
constexpr int n_components = 2 * dim + 1;
constexpr int phi_component = 2 * dim;
inline const dealii::FEValuesExtractors::Vector u_part{0};
inline const dealii::FEValuesExtractors::Vector W_part{dim};
inline const dealii::FEValuesExtractors::Scalar phi_part{phi_component};

using Cell = dealii::DoFHandler<dim>::active_cell_iterator;
using Dofs = std::vector<dealii::types::global_dof_index>;
/// All degrees of freedom of a cell, in its own order.
Dofs dofs_of(const Cell& cell);

/// u in Q(k) where something moves, phi in Q(k-1) where there is pore water and in Q(k) in free water, W in DGQ(k-1)
/// where the pore water has inertia; absent fields are FE_Nothing. Inf-sup stable (Taylor and Hood); measured orders
/// of convergence in docs/theory.md.
class Space {
 public:
  /// All choices in the scene's regions must be made. Cells that are `absent` (by active cell index; empty: none)
  /// have no unknowns, and the mesh ends at their sides. The values of `soil` for a cell are in its material. The
  /// mesh must outlive the space.
  Space(const Mesh& mesh, const Scene& scene, const std::vector<bool>& absent = {}, const SoilState& soil = {});

  /// The same unknowns with other constants, one set for each surface of the mesh.
  Space with(const std::vector<RegionConstants>& constants) const;
  /// The same unknowns with the regions of another scene, whose choices are the same.
  Space with(const Scene& scene) const;

  const Mesh& mesh() const { return *mesh_; }
  const dealii::DoFHandler<dim>& dofs() const { return *dofs_; }
  const dealii::MappingQ1<dim>& mapping() const { return mapping_; }
  int degree() const { return degree_; }
  using MeshCell = dealii::Triangulation<dim>::cell_iterator;
  const Region& region(const MeshCell& cell) const { return regions_[cell->material_id()]; }
  /// Material of a cell, with its own stiffness and damping.
  const Material& material(const MeshCell& cell) const {
    return materials_[by_cell_ ? cell->active_cell_index() : cell->material_id()];
  }
  /// Of a side of that cell; `open`: it absorbs pressure, too.
  Impedance impedance(const Cell& cell, bool open) const;
  CellKind kind(const Cell& cell) const { return static_cast<CellKind>(cell->active_fe_index()); }
  /// Whether the cell has matrices of its own: neither absent nor part of a rigid body.
  bool has_matrices(const Cell& cell) const {
    return region(cell).kind != RegionKind::rigid && kind(cell) != CellKind::absent;
  }
  /// Whether the cell has phi, of pore water or of free water.
  bool has_pressure(const Cell& cell) const { return has_pores(cell) || kind(cell) == CellKind::water; }
  /// Whether the cell has pore water.
  bool has_pores(const Cell& cell) const { return kind(cell) == CellKind::darcy || kind(cell) == CellKind::inertial; }

 private:
  const Mesh* mesh_;
  int degree_;
  std::vector<Region> regions_;      ///< by material_id
  std::vector<Material> materials_;  ///< by material_id; by active cell index where soil differs by cell
  bool by_cell_;
  std::vector<RegionConstants> constants_;  ///< by material_id, where they are given; else made of the materials
  dealii::MappingQ1<dim> mapping_;
  std::shared_ptr<const dealii::DoFHandler<dim>> dofs_;
};

/// The component of a cell's i-th degree of freedom, and the point of its node.
struct DofNode {
  unsigned component;
  dealii::Point<dim> at;
};
DofNode node_of(const Space& space, const Cell& cell, unsigned i);

}  // namespace upbead
