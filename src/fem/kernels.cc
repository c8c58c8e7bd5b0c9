#include "upbead/fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

/// Local degrees of freedom of one part (u, W or phi).
template <typename Extractor>
std::vector<unsigned> part_dofs(const FEValues<dim>& fe, const Extractor& part) {
  std::vector<unsigned> list;
  const ComponentMask mask = fe.get_fe().component_mask(part);
  for (unsigned i = 0; i < fe.dofs_per_cell; ++i)
    if (mask[fe.get_fe().system_to_component_index(i).first]) list.push_back(i);
  return list;
}

/// Adds the integral of f(i, j, q) to matrix(i, j) for i in rows and j in columns; with `transpose` to (j, i) as well.
template <typename Integrand>
void integrate(const FEValues<dim>& fe, const std::vector<unsigned>& rows, const std::vector<unsigned>& columns,
               FullMatrix<double>& matrix, bool transpose, const Integrand& f) {
  for (const unsigned i : rows)
    for (const unsigned j : columns) {
      double sum = 0.;
      for (unsigned q = 0; q < fe.n_quadrature_points; ++q) sum += f(i, j, q) * fe.JxW(q);
      matrix(i, j) += sum;
      if (transpose) matrix(j, i) += sum;
    }
}

}  // namespace

void uu_M(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto u = part_dofs(fe, u_part);
  integrate(fe, u, u, cell.M, false, [&](unsigned i, unsigned j, unsigned q) {
    return material.rho * (fe[u_part].value(i, q) * fe[u_part].value(j, q));
  });
}

void uu_K(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto u = part_dofs(fe, u_part);
  integrate(fe, u, u, cell.K, false, [&](unsigned i, unsigned j, unsigned q) {
    return 2. * material.G * (fe[u_part].symmetric_gradient(i, q) * fe[u_part].symmetric_gradient(j, q)) +
           material.lambda * fe[u_part].divergence(i, q) * fe[u_part].divergence(j, q);
  });
}

void uu_C(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto u = part_dofs(fe, u_part);
  for (const unsigned i : u)
    for (const unsigned j : u)
      cell.C(i, j) += material.mass_damping * cell.M(i, j) + material.stiffness_damping * cell.K(i, j);
}

void up_C(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  integrate(fe, part_dofs(fe, u_part), part_dofs(fe, phi_part), cell.C, true, [&](unsigned i, unsigned j, unsigned q) {
    return -material.alpha * fe[u_part].divergence(i, q) * fe[phi_part].value(j, q);
  });
}

void pp_M(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto phi = part_dofs(fe, phi_part);
  integrate(fe, phi, phi, cell.M, false, [&](unsigned i, unsigned j, unsigned q) {
    return -material.storage * fe[phi_part].value(i, q) * fe[phi_part].value(j, q);
  });
}

void pp_C(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto phi = part_dofs(fe, phi_part);
  integrate(fe, phi, phi, cell.C, false, [&](unsigned i, unsigned j, unsigned q) {
    return -(fe[phi_part].gradient(i, q) * fe[phi_part].gradient(j, q)) / material.b;
  });
}

void pp_K(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto phi = part_dofs(fe, phi_part);
  integrate(fe, phi, phi, cell.K, false, [&](unsigned i, unsigned j, unsigned q) {
    return -(fe[phi_part].gradient(i, q) * fe[phi_part].gradient(j, q)) / material.rho_f;
  });
}

void W_M(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto u = part_dofs(fe, u_part), W = part_dofs(fe, W_part);
  integrate(fe, u, W, cell.M, true, [&](unsigned i, unsigned j, unsigned q) {
    return material.rho_f * (fe[u_part].value(i, q) * fe[W_part].value(j, q));
  });
  integrate(fe, W, W, cell.M, false, [&](unsigned i, unsigned j, unsigned q) {
    return material.a * (fe[W_part].value(i, q) * fe[W_part].value(j, q));
  });
}

void W_C(const FEValues<dim>& fe, const Material& material, CellMatrices& cell) {
  const auto W = part_dofs(fe, W_part);
  integrate(fe, W, W, cell.C, false, [&](unsigned i, unsigned j, unsigned q) {
    return material.b * (fe[W_part].value(i, q) * fe[W_part].value(j, q));
  });
  integrate(fe, W, part_dofs(fe, phi_part), cell.C, true,
            [&](unsigned i, unsigned j, unsigned q) { return fe[W_part].value(i, q) * fe[phi_part].gradient(j, q); });
}

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
