#include "fem/pore_diffusion.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

namespace upbead {

using namespace dealii;

namespace {

using FlowEntries = std::vector<Eigen::Triplet<double>>;
using NodeRow = std::vector<std::pair<int, double>>;

SparseMatrix flow_matrix(const FlowEntries& entries, std::size_t rows, std::size_t columns) {
  SparseMatrix matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

bool keeps_no_pressure(const Region& region) {
  return region.kind == RegionKind::water || (region.kind == RegionKind::porous && region.flow == Flow::drained);
}

/// Whether the pressure is 0 on a side of a cell.
bool is_drained(const Space& space, const Scene& scene, const Cell& cell, unsigned f) {
  if (!cell->at_boundary(f)) return keeps_no_pressure(space.region(cell->neighbor(f)));
  const auto side = scene.boundaries.find(space.mesh().curve_of(cell->face(f)));
  if (side == scene.boundaries.end() || !side->second.pressure) return false;
  return *side->second.pressure == PressureCondition::open ||
         *side->second.pressure == PressureCondition::surface_waves;
}

class FlowAssembly {
 public:
  FlowAssembly(const Space& space, const Scene& scene)
      : space_(space), scene_(scene), dofs_(space.mesh().triangulation) {
    dofs_.distribute_dofs(fe_);
    DoFTools::make_hanging_node_constraints(dofs_, hanging_);
    hanging_.close();
    place_.assign(space.mesh().triangulation.n_active_cells(), -1);
    number_.assign(dofs_.n_dofs(), -1);
  }

  PoreFlow make() {
    each_cell([this](const Cell& cell, const Cell& own) { add_cell(cell, own); });
    each_cell([this](const Cell& cell, const Cell& own) { add_sides(cell, own); });
    const std::size_t nodes = flow_.node.size(), cells = flow_.cells.size();
    flow_.conductance = flow_matrix(conductance_, nodes, nodes);
    flow_.node_area = flow_matrix(node_area_, nodes, cells);
    flow_.at_middle = flow_matrix(at_middle_, cells, nodes);
    flow_.to_nodes = flow_matrix(to_nodes_, nodes, cells);
    flow_.storage = flow_.node_area * Eigen::Map<const Vector>(flow_.cell_storage.data(), static_cast<int>(cells));
    return std::move(flow_);
  }

 private:
  /// Of cells with pore water: the cell of the space, and the same of the flow's own degrees of freedom.
  template <class Visit>
  void each_cell(const Visit& visit) {
    for (const auto& cell : space_.dofs().active_cell_iterators())
      if (space_.has_pores(cell)) visit(cell, Cell(&space_.mesh().triangulation, cell->level(), cell->index(), &dofs_));
  }

  int node_of(types::global_dof_index dof) {
    if (number_[dof] < 0) {
      number_[dof] = static_cast<int>(flow_.node.size());
      flow_.node.emplace_back();
      flow_.drained.push_back(false);
    }
    return number_[dof];
  }

  /// A value as a sum over nodes; a node that hangs between two others is their mean.
  NodeRow row_of(types::global_dof_index dof) {
    if (!hanging_.is_constrained(dof)) return {{node_of(dof), 1.}};
    NodeRow row;
    for (const auto& [master, weight] : *hanging_.get_constraint_entries(dof))
      row.emplace_back(node_of(master), weight);
    return row;
  }

  std::vector<NodeRow> rows_of(const Cell& own) {
    std::vector<types::global_dof_index> dofs(fe_.n_dofs_per_cell());
    own->get_dof_indices(dofs);
    std::vector<NodeRow> rows;
    for (unsigned v = 0; v < dofs.size(); ++v) {
      rows.push_back(row_of(dofs[v]));
      if (!hanging_.is_constrained(dofs[v]))
        flow_.node[static_cast<std::size_t>(rows.back()[0].first)] = own->vertex(v);
    }
    return rows;
  }

  void add_cell(const Cell& cell, const Cell& own) {
    const int c = static_cast<int>(flow_.cells.size());
    place_[cell->active_cell_index()] = c;
    const Material& m = space_.material(cell);
    flow_.cells.push_back(cell->active_cell_index());
    flow_.area.push_back(area_of(cell));
    flow_.middle.push_back(cell->center());
    flow_.region.push_back(cell->material_id());
    flow_.cell_storage.push_back(m.alpha * m.alpha / m.constrained_modulus() + m.storage);
    values_.reinit(own);
    const std::vector<NodeRow> rows = rows_of(own);
    for (unsigned i = 0; i < rows.size(); ++i) {
      double part = 0.;
      for (const unsigned q : values_.quadrature_point_indices()) part += values_.shape_value(i, q) * values_.JxW(q);
      for (const auto& [node, weight] : rows[i]) {
        node_area_.emplace_back(node, c, weight * part);
        at_middle_.emplace_back(c, node, weight / static_cast<double>(rows.size()));
        if (weight == 1.) to_nodes_.emplace_back(node, c, 1.);
      }
    }
    add_conductance(rows, m);
  }

  void add_conductance(const std::vector<NodeRow>& rows, const Material& m) {
    for (unsigned i = 0; i < rows.size(); ++i)
      for (unsigned j = 0; j < rows.size(); ++j) {
        double sum = 0.;
        for (const unsigned q : values_.quadrature_point_indices()) {
          Tensor<1, dim> gradient = values_.shape_grad(j, q);
          gradient[1] *= m.vertical_flow;
          sum += values_.shape_grad(i, q) * gradient * values_.JxW(q);
        }
        for (const auto& [row, a] : rows[i])
          for (const auto& [column, b] : rows[j]) conductance_.emplace_back(row, column, a * b * m.mobility * sum);
      }
  }

  void add_sides(const Cell& cell, const Cell& own) {
    flow_.beside.emplace_back();
    std::vector<types::global_dof_index> dofs(fe_.n_dofs_per_face());
    for (const unsigned f : cell->face_indices()) {
      if (is_drained(space_, scene_, cell, f)) {
        own->face(f)->get_dof_indices(dofs);
        for (const auto dof : dofs)
          for (const auto& [node, weight] : row_of(dof)) flow_.drained[static_cast<std::size_t>(node)] = true;
      }
      if (cell->at_boundary(f) || !cell->neighbor(f)->is_active()) continue;
      const int other = place_[cell->neighbor(f)->active_cell_index()];
      if (other >= 0 && cell->neighbor(f)->material_id() == cell->material_id()) flow_.beside.back().push_back(other);
    }
  }

  const Space& space_;
  const Scene& scene_;
  FE_Q<dim> fe_{1};
  DoFHandler<dim> dofs_;
  AffineConstraints<double> hanging_;
  FEValues<dim> values_{fe_, QGauss<dim>(2), update_values | update_gradients | update_JxW_values};
  std::vector<int> place_, number_;
  FlowEntries conductance_, node_area_, at_middle_, to_nodes_;
  PoreFlow flow_;
};

/// Least-squares gradient over the cells beside a cell; none of it across directions in which there is none.
Eigen::Vector2d slope_of(const PoreFlow& flow, const std::vector<double>& value, const std::vector<bool>& counts,
                         std::size_t c) {
  std::vector<int> others;
  for (const int other : flow.beside[c])
    if (counts[static_cast<std::size_t>(other)]) others.push_back(other);
  if (others.empty()) return Eigen::Vector2d::Zero();
  Eigen::MatrixXd distance(others.size(), 2);
  Eigen::VectorXd difference(others.size());
  for (std::size_t i = 0; i < others.size(); ++i) {
    const auto other = static_cast<std::size_t>(others[i]);
    const auto d = flow.middle[other] - flow.middle[c];
    distance.row(static_cast<Eigen::Index>(i)) << d[0], d[1];
    difference[static_cast<Eigen::Index>(i)] = value[other] - value[c];
  }
  return distance.completeOrthogonalDecomposition().solve(difference);
}

}  // namespace

PoreFlow pore_flow(const Space& space, const Scene& scene) {
  return FlowAssembly(space, scene).make();
}

namespace {

std::vector<Eigen::Vector2d> slopes_of(const PoreFlow& flow, const std::vector<double>& value,
                                       const std::vector<bool>& counts) {
  std::vector<Eigen::Vector2d> slopes(flow.cells.size(), Eigen::Vector2d::Zero());
  for (std::size_t c = 0; c < slopes.size(); ++c)
    if (counts[c]) slopes[c] = slope_of(flow, value, counts, c);
  return slopes;
}

/// From the middle of a cell to a node, along its slope.
double rise(const PoreFlow& flow, const Eigen::Vector2d& slope, std::size_t cell, std::size_t node) {
  const auto d = flow.node[node] - flow.middle[cell];
  return slope[0] * d[0] + slope[1] * d[1];
}

}  // namespace

Vector at_nodes(const PoreFlow& flow, const std::vector<double>& value, const std::vector<bool>& counts) {
  const auto nodes = static_cast<Eigen::Index>(flow.node.size());
  const std::vector<Eigen::Vector2d> slope = slopes_of(flow, value, counts);
  Vector least = Vector::Constant(nodes, HUGE_VAL);
  for (Eigen::Index n = 0; n < nodes; ++n) {
    std::map<unsigned, std::pair<double, double>> of_regions;  // sum and weight
    for (SparseMatrix::InnerIterator it(flow.to_nodes, n); it; ++it) {
      const auto c = static_cast<std::size_t>(it.col());
      if (!counts[c]) continue;
      auto& [sum, weight] = of_regions[flow.region[c]];
      sum += flow.area[c] * (value[c] + rise(flow, slope[c], c, static_cast<std::size_t>(n)));
      weight += flow.area[c];
    }
    for (const auto& [region, mean] : of_regions) least[n] = std::min(least[n], mean.first / mean.second);
  }
  return least;
}

SparseMatrix spread_to_nodes(const PoreFlow& flow, const std::vector<double>& value, const std::vector<bool>& counts) {
  const std::vector<Eigen::Vector2d> slope = slopes_of(flow, value, counts);
  FlowEntries entries;
  for (Eigen::Index n = 0; n < flow.node_area.rows(); ++n)
    for (SparseMatrix::InnerIterator it(flow.node_area, n); it; ++it)
      if (const auto c = static_cast<std::size_t>(it.col()); counts[c])
        entries.emplace_back(
            n, it.col(), it.value() * std::max(value[c] + rise(flow, slope[c], c, static_cast<std::size_t>(n)), 0.));
  return flow_matrix(entries, flow.node.size(), flow.cells.size());
}

}  // namespace upbead
