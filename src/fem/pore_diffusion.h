// The flow of pore water by pressure alone, on the mesh of the ground: storage, conductance, and where it drains.
#pragma once

#include <vector>

#include "fem/space.h"
#include "upbead/algebra/sparse.h"

namespace upbead {

/// S p' = div (k/(rho_f g) grad p) + source, S = alpha^2/(lambda + 2 G) + 1/Q, in bilinear elements with lumped
/// storage: uncoupled consolidation, exact where strain is vertical alone. Per metre of breakwater.
struct PoreFlow {
  std::vector<unsigned> cells;             ///< that have pore water, by active cell index
  std::vector<double> area, cell_storage;  ///< of these (m2), and their S (1/Pa)
  std::vector<dealii::Point<dim>> middle;  ///< of these (m)
  std::vector<unsigned> region;            ///< of these, by material id
  std::vector<std::vector<int>> beside;  ///< cells of the same region that share a side with a cell; places in `cells`
  Vector storage;                        ///< of the nodes (m2/Pa)
  SparseMatrix conductance;              ///< flow out of a node by pressures (m2/(Pa s))
  SparseMatrix node_area;                ///< nodes x cells: part of a cell's area that belongs to a node (m2)
  SparseMatrix at_middle;                ///< cells x nodes: the value in the middle of a cell
  SparseMatrix to_nodes;                 ///< nodes x cells: 1 where a node is a corner of the cell
  std::vector<dealii::Point<dim>> node;  ///< m
  std::vector<bool> drained;             ///< nodes with pressure 0
};

/// Of cells with pore water. Pressure is 0 on open boundaries and levels, and beside free water and soil that is
/// drained; all other sides are sealed, also far ones, where nothing changes along the ground.
PoreFlow pore_flow(const Space& space, const Scene& scene);

/// Values of cells at the nodes, straight between middles and beyond them, mean over the cells of a region at a node,
/// and the least of its regions; only of cells that count (by place in `flow.cells`). Infinite at nodes without such a
/// cell.
Vector at_nodes(const PoreFlow& flow, const std::vector<double>& value, const std::vector<bool>& counts);

/// Values of cells that count, straight from their middles to their nodes and not below 0, times the area that belongs
/// to a node: nodes x cells.
SparseMatrix spread_to_nodes(const PoreFlow& flow, const std::vector<double>& value, const std::vector<bool>& counts);

}  // namespace upbead
