#include "upbead/fem/surplus.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/hp/fe_values.h>

#include <array>

#include "upbead/fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

using Dense = Eigen::MatrixXd;

Dense dense(const FullMatrix<double>& A) {
  Dense B(A.m(), A.n());
  for (unsigned i = 0; i < A.m(); ++i)
    for (unsigned j = 0; j < A.n(); ++j) B(i, j) = A(i, j);
  return B;
}

/// From the nodes of `element` to themselves: the L2 projection to degree `low` on the unit cell; 0 below degree 0.
Dense projection(const FiniteElement<dim>& element, int low) {
  const unsigned n = element.n_dofs_per_cell();
  if (low < 0) return Dense::Zero(n, n);
  const FE_DGQ<dim> lower(static_cast<unsigned>(low));
  FullMatrix<double> down(lower.n_dofs_per_cell(), n), up(n, lower.n_dofs_per_cell());
  FETools::get_projection_matrix(element, lower, down);
  FETools::get_interpolation_matrix(lower, element, up);
  return dense(up) * dense(down);
}

/// The fields u, W and phi: first component and the one after the last, and the sign of their part of the energy.
struct FieldRange {
  unsigned first, last;
  double sign;
};
constexpr std::array<FieldRange, 3> fields{{{0, dim, 1.}, {dim, 2 * dim, 1.}, {2 * dim, n_components, -1.}}};

/// By field, from a cell's degrees of freedom to themselves: the part of the highest degree, and that of the next one.
struct Parts {
  std::array<std::array<Dense, 2>, fields.size()> part;
  std::array<int, fields.size()> degree{};  ///< 0: absent
};

/// M, C and K of one cell.
struct CellParts {
  Dense M, C, K;
};

Parts parts_of(const FiniteElement<dim>& fe) {
  const unsigned n = fe.n_dofs_per_cell();
  Parts parts;
  for (std::size_t field = 0; field < fields.size(); ++field) {
    for (Dense& part : parts.part[field]) part = Dense::Zero(n, n);
    const FiniteElement<dim>& base = fe.base_element(fe.component_to_base_index(fields[field].first).first);
    if (base.n_dofs_per_cell() == 0) continue;
    const int k = parts.degree[field] = static_cast<int>(base.tensor_degree());
    const Dense below = projection(base, k - 1), twice_below = projection(base, k - 2);
    const Dense one = Dense::Identity(below.rows(), below.cols());
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; j < n; ++j) {
        const auto [row, row_node] = fe.system_to_component_index(i);
        const auto [column, column_node] = fe.system_to_component_index(j);
        if (row != column || row < fields[field].first || row >= fields[field].last) continue;
        parts.part[field][0](i, j) = (one - below)(row_node, column_node);
        parts.part[field][1](i, j) = (below - twice_below)(row_node, column_node);
      }
  }
  return parts;
}

/// Energies of the columns of D at the sizes |s|: the real and imaginary parts of solution j are the columns 2 j, 2 j
/// + 1.
Eigen::ArrayXd energies(const CellParts& cell, const Dense& D, const Eigen::ArrayXd& size) {
  const auto form = [&](const Dense& A) -> Eigen::ArrayXd {
    const Eigen::ArrayXd of_column = (D.array() * (A * D).array()).colwise().sum();
    return Eigen::Map<const Eigen::ArrayXXd>(of_column.data(), 2, of_column.size() / 2).colwise().sum();
  };
  return size.square() * form(cell.M) + size * form(cell.C) + form(cell.K);
}

/// Squares of the errors of all solutions on one cell, whose real and imaginary parts are the columns of X.
Eigen::ArrayXd squares_of_errors(const Parts& parts, const CellParts& cell, const Dense& X,
                                 const Eigen::ArrayXd& size) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(size.size()), decay = Eigen::ArrayXd::Ones(size.size());
  for (std::size_t field = 0; field < fields.size(); ++field) {
    if (parts.degree[field] == 0) continue;
    const Eigen::ArrayXd highest = fields[field].sign * energies(cell, parts.part[field][0] * X, size);
    if (parts.degree[field] > 1) {
      const Eigen::ArrayXd next = fields[field].sign * energies(cell, parts.part[field][1] * X, size);
      decay = (highest >= 0. && next > highest).select(highest / next, 1.);
    }
    sum += highest.max(0.) * decay;
  }
  return sum;
}

}  // namespace

Eigen::MatrixXd cell_errors(const Scene& scene, const Space& space, const Unknowns& unknowns, const Eigen::MatrixXcd& X,
                            const std::vector<std::complex<double>>& s) {
  std::vector<Parts> parts;
  for (unsigned kind = 0; kind < space.dofs().get_fe_collection().size(); ++kind)
    parts.push_back(parts_of(space.dofs().get_fe_collection()[kind]));
  const hp::QCollection<dim> quadrature(QGauss<dim>(static_cast<unsigned>(space.degree()) + 1));
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), quadrature,
                              update_values | update_gradients | update_JxW_values);
  Eigen::MatrixXd errors = Eigen::MatrixXd::Zero(space.mesh().triangulation.n_active_cells(), X.cols());
  Eigen::MatrixXd values(X.rows(), 2 * X.cols());
  Eigen::ArrayXd size(X.cols());
  for (Eigen::Index j = 0; j < X.cols(); ++j) {
    values.col(2 * j) = X.col(j).real();
    values.col(2 * j + 1) = X.col(j).imag();
    size[j] = std::abs(s[static_cast<std::size_t>(j)]);
  }
  CellMatrices matrices;
  std::vector<types::global_dof_index> dofs;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    const Region& region = space.region(cell);
    if (region.kind == RegionKind::rigid || space.kind(cell) == CellKind::absent) continue;
    hp_values.reinit(cell);
    assemble_cell(hp_values.get_present_fe_values(), material(region, scene.fluid, scene.gravity), space.kind(cell),
                  scene.time.inertia, matrices);
    dofs.resize(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    Dense local = Dense::Zero(static_cast<Eigen::Index>(dofs.size()), values.cols());
    for (std::size_t i = 0; i < dofs.size(); ++i)
      for (const auto& [j, weight] : unknowns.expansion(static_cast<unsigned>(dofs[i])))
        local.row(static_cast<Eigen::Index>(i)) += weight * values.row(j);
    const CellParts cell_parts{dense(matrices.M), dense(matrices.C), dense(matrices.K)};
    errors.row(cell->active_cell_index()) =
        squares_of_errors(parts[static_cast<unsigned>(space.kind(cell))], cell_parts, local, size);
  }
  return errors;
}

}  // namespace upbead
