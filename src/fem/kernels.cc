#include "fem/kernels.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace upbead {

using namespace dealii;

PlaneStrain strain_of(const FEValues<dim>& fe, unsigned i, unsigned q) {
  const SymmetricTensor<2, dim> strain = fe[u_part].symmetric_gradient(i, q);
  return {strain[0][0], strain[1][1], strain[0][1]};
}

namespace {

/// Local degrees of freedom of one field (u, W or phi).
template <typename Extractor>
std::vector<unsigned> part_dofs(const FEValues<dim>& fe, const Extractor& part) {
  std::vector<unsigned> list;
  const ComponentMask mask = fe.get_fe().component_mask(part);
  for (unsigned i = 0; i < fe.dofs_per_cell; ++i)
    if (mask[fe.get_fe().system_to_component_index(i).first]) list.push_back(i);
  return list;
}

/// Values of each degree of freedom to be integrated: one row each, `n_values` columns per quadrature point, each
/// value times the square root of the point's weight. So the integral of a product of two is the product of their
/// tables.
using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// `values(i, q, out)` writes the values of degree of freedom i at point q.
template <typename Values>
Table tabulate(const FEValues<dim>& fe, const std::vector<unsigned>& dofs, unsigned n_values, const Values& values) {
  Table table(dofs.size(), n_values * fe.n_quadrature_points);
  for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
    const double root = std::sqrt(fe.JxW(q));
    for (unsigned row = 0; row < dofs.size(); ++row) {
      double* out = &table(row, n_values * q);
      values(dofs[row], q, out);
      for (unsigned k = 0; k < n_values; ++k) out[k] *= root;
    }
  }
  return table;
}

/// Tables of the values of u or W, of their divergence, and of the values and gradients of phi; vertical components
/// times a factor.
Table values_of(const FEValues<dim>& fe, const FEValuesExtractors::Vector& part, double of_vertical = 1.) {
  return tabulate(fe, part_dofs(fe, part), dim, [&](unsigned i, unsigned q, double* out) {
    const Tensor<1, dim> value = fe[part].value(i, q);
    out[0] = value[0];
    out[1] = of_vertical * value[1];
  });
}

Table values_of_phi(const FEValues<dim>& fe) {
  return tabulate(fe, part_dofs(fe, phi_part), 1,
                  [&](unsigned i, unsigned q, double* out) { *out = fe[phi_part].value(i, q); });
}

Table gradients_of_phi(const FEValues<dim>& fe, double of_vertical = 1.) {
  return tabulate(fe, part_dofs(fe, phi_part), dim, [&](unsigned i, unsigned q, double* out) {
    const Tensor<1, dim> gradient = fe[phi_part].gradient(i, q);
    out[0] = gradient[0];
    out[1] = of_vertical * gradient[1];
  });
}

/// Adds factor * table table^T, made exactly symmetric.
void add_square(const std::vector<unsigned>& dofs, double factor, const Table& table, FullMatrix<double>& matrix) {
  const Eigen::MatrixXd product = table * table.transpose();
  for (unsigned i = 0; i < dofs.size(); ++i)
    for (unsigned j = 0; j < dofs.size(); ++j)
      matrix(dofs[i], dofs[j]) += factor * product(std::max(i, j), std::min(i, j));
}

/// Adds factor * left right^T and its transpose.
void add_pair(const std::vector<unsigned>& rows, const std::vector<unsigned>& columns, double factor, const Table& left,
              const Table& right, FullMatrix<double>& matrix) {
  const Eigen::MatrixXd product = factor * (left * right.transpose());
  for (unsigned i = 0; i < rows.size(); ++i)
    for (unsigned j = 0; j < columns.size(); ++j) {
      matrix(rows[i], columns[j]) += product(i, j);
      matrix(columns[j], rows[i]) += product(i, j);
    }
}

/// uu_M: +rho du.u
void uu_M(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  add_square(part_dofs(fe, u_part), material.rho, values_of(fe, u_part), cell.M);
}

/// uu_K: +eps(du) : D : eps(u), plane strain
void uu_K(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const ElasticRoot root(material);
  const auto u = part_dofs(fe, u_part);
  const Table strains = tabulate(fe, u, ElasticRoot::n_values,
                                 [&](unsigned i, unsigned q, double* out) { root.write(strain_of(fe, i, q), out); });
  add_square(u, 1., strains, cell.K);
}

/// uu_C: Rayleigh damping, from the uu blocks of M and K that are in `cell` already
void uu_C(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto u = part_dofs(fe, u_part);
  for (const unsigned i : u)
    for (const unsigned j : u)
      cell.C(i, j) += material.mass_damping * cell.M(i, j) + material.stiffness_damping * cell.K(i, j);
}

/// up_C and pu_C: -alpha (div du) phi and its transpose
void up_C(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto u = part_dofs(fe, u_part);
  const Table divergence =
      tabulate(fe, u, 1, [&](unsigned i, unsigned q, double* out) { *out = fe[u_part].divergence(i, q); });
  add_pair(u, part_dofs(fe, phi_part), -material.alpha, divergence, values_of_phi(fe), cell.C);
}

/// pp_M: -1/Q dphi phi
void pp_M(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  add_square(part_dofs(fe, phi_part), -material.storage, values_of_phi(fe), cell.M);
}

/// pp_C, darcy: -(1/b) grad dphi . diag(1, r) grad phi, r = k_y/k_x
void pp_C(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  add_square(part_dofs(fe, phi_part), -material.mobility, gradients_of_phi(fe, std::sqrt(material.vertical_flow)),
             cell.C);
}

/// pp_K, water: -(1/rho_f) grad dphi . grad phi
void pp_K(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  add_square(part_dofs(fe, phi_part), -1. / material.rho_f, gradients_of_phi(fe), cell.K);
}

/// uW_M and Wu_M: +rho_f du.W and its transpose; WW_M: +a dW.W
void W_M(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto W = part_dofs(fe, W_part);
  const Table values = values_of(fe, W_part);
  add_pair(part_dofs(fe, u_part), W, material.rho_f, values_of(fe, u_part), values, cell.M);
  add_square(W, material.a, values, cell.M);
}

/// WW_C: +b dW.diag(1, 1/r) W, r = k_y/k_x; Wp_C and pW_C: +dW.grad phi and its transpose
void W_C(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto W = part_dofs(fe, W_part);
  add_square(W, material.b, values_of(fe, W_part, 1. / std::sqrt(material.vertical_flow)), cell.C);
  add_pair(W, part_dofs(fe, phi_part), 1., values_of(fe, W_part), gradients_of_phi(fe), cell.C);
}

}  // namespace

void assemble_cell(const FEValues<dim>& fe, const Material& material, CellKind kind, bool inertia, CellMatrices& cell) {
  cell.reinit(fe.dofs_per_cell);
  if (kind == CellKind::water) {
    if (material.storage > 0.) pp_M(fe, material, cell);
    pp_K(fe, material, cell);
    return;
  }
  if (inertia) uu_M(fe, material, cell);
  uu_K(fe, material, cell);
  uu_C(fe, material, cell);
  if (kind == CellKind::solid) return;
  up_C(fe, material, cell);
  pp_M(fe, material, cell);
  if (kind == CellKind::darcy) {
    pp_C(fe, material, cell);
  } else {
    W_M(fe, material, cell);
    W_C(fe, material, cell);
  }
}

}  // namespace upbead
