#include "fem/error_indicator.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/hp/fe_values.h>

#include <array>

#include "fem/kernels.h"

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

/// L2 projection to degree `low` on the unit cell, from nodal values of `element` to nodal values; 0 below degree 0.
Dense projection(const FiniteElement<dim>& element, int low) {
  const unsigned n = element.n_dofs_per_cell();
  if (low < 0) return Dense::Zero(n, n);
  const FE_DGQ<dim> lower(static_cast<unsigned>(low));
  FullMatrix<double> down(lower.n_dofs_per_cell(), n), up(n, lower.n_dofs_per_cell());
  FETools::get_projection_matrix(element, lower, down);
  FETools::get_interpolation_matrix(lower, element, up);
  return dense(up) * dense(down);
}

/// A field (u, W, phi): its first component, the one after its last, and the sign of its part of the energy.
struct FieldRange {
  unsigned first, last;
  double sign;
};
constexpr std::array<FieldRange, 3> fields{{{0, dim, 1.}, {dim, 2 * dim, 1.}, {2 * dim, n_components, -1.}}};

/// One field on cells of one kind. The matrices take nodal values to nodal values.
struct Part {
  std::vector<unsigned> dofs;  ///< of the field in a cell; empty where the field is absent
  int degree = 0;
  double sign = 1.;  ///< of its part of the energy
  Dense highest;     ///< the part that only the highest degree can hold
  Dense next;        ///< the same part for the next lower degree
};
using Parts = std::array<Part, fields.size()>;

Part part_of(const FiniteElement<dim>& fe, const FieldRange& field) {
  Part part;
  const FiniteElement<dim>& base = fe.base_element(fe.component_to_base_index(field.first).first);
  if (base.n_dofs_per_cell() == 0) return part;
  std::vector<std::pair<unsigned, unsigned>> places;  // component and node
  for (unsigned i = 0; i < fe.n_dofs_per_cell(); ++i) {
    const auto place = fe.system_to_component_index(i);
    if (place.first < field.first || place.first >= field.last) continue;
    part.dofs.push_back(i);
    places.push_back(place);
  }
  part.degree = static_cast<int>(base.tensor_degree());
  part.sign = field.sign;
  const Dense below = projection(base, part.degree - 1), twice_below = projection(base, part.degree - 2);
  const Dense one = Dense::Identity(below.rows(), below.cols());
  part.highest = part.next = Dense::Zero(places.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = 0; j < places.size(); ++j) {
      if (places[i].first != places[j].first) continue;
      part.highest(i, j) = (one - below)(places[i].second, places[j].second);
      part.next(i, j) = (below - twice_below)(places[i].second, places[j].second);
    }
  return part;
}

Parts parts_of(const FiniteElement<dim>& fe) {
  Parts parts;
  for (std::size_t field = 0; field < fields.size(); ++field) parts[field] = part_of(fe, fields[field]);
  return parts;
}

/// The block of a cell's matrix that belongs to some degrees of freedom.
Dense block(const FullMatrix<double>& A, const std::vector<unsigned>& dofs) {
  Dense B(dofs.size(), dofs.size());
  for (unsigned i = 0; i < dofs.size(); ++i)
    for (unsigned j = 0; j < dofs.size(); ++j) B(i, j) = A(dofs[i], dofs[j]);
  return B;
}

/// M, C and K of one field on one cell.
struct FieldMatrices {
  Dense M, C, K;
};

/// Energies of the columns of D for each |s|; the real and imaginary parts of a solution are adjacent columns.
Eigen::ArrayXd energies(const FieldMatrices& cell, const Dense& D, const Eigen::ArrayXd& size) {
  const auto form = [&](const Dense& A) -> Eigen::ArrayXd {
    const Eigen::ArrayXd of_column = (D.array() * (A * D).array()).colwise().sum();
    return Eigen::Map<const Eigen::ArrayXXd>(of_column.data(), 2, of_column.size() / 2).colwise().sum();
  };
  return size.square() * form(cell.M) + size * form(cell.C) + form(cell.K);
}

/// Squares of the errors of all solutions on one cell; the columns of X are their real and imaginary parts.
Eigen::ArrayXd squares_of_errors(const Parts& parts, const CellMatrices& cell, const Dense& X,
                                 const Eigen::ArrayXd& size) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(size.size()), decay = Eigen::ArrayXd::Ones(size.size());
  for (const Part& part : parts) {
    if (part.dofs.empty()) continue;
    const FieldMatrices field{block(cell.M, part.dofs), block(cell.C, part.dofs), block(cell.K, part.dofs)};
    const Dense x = X(part.dofs, Eigen::all);
    const Eigen::ArrayXd highest = part.sign * energies(field, part.highest * x, size);
    if (part.degree > 1) {
      const Eigen::ArrayXd next = part.sign * energies(field, part.next * x, size);
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
    size[j] = std::abs(s[j]);
  }
  CellMatrices matrices;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.has_matrices(cell)) continue;
    hp_values.reinit(cell);
    assemble_cell(hp_values.get_present_fe_values(), space.material(cell), space.kind(cell), scene.time.inertia,
                  matrices);
    const Dofs dofs = dofs_of(cell);
    Dense local = Dense::Zero(static_cast<Eigen::Index>(dofs.size()), values.cols());
    for (std::size_t i = 0; i < dofs.size(); ++i)
      for (const auto& [j, weight] : unknowns.expansion(dofs[i]))
        local.row(static_cast<Eigen::Index>(i)) += weight * values.row(j);
    errors.row(cell->active_cell_index()) =
        squares_of_errors(parts[static_cast<unsigned>(space.kind(cell))], matrices, local, size);
  }
  return errors;
}

}  // namespace upbead
