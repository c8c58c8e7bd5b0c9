#include "uneven_flow.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/kernels.h"

namespace upbead::test {

namespace {

/// (eps_xx, eps_yy, sqrt(2) eps_xy) by point of quadrature.
Eigen::Matrix3Xd strains(const dealii::FEValues<dim>& values, const Dofs& dofs, const Vector& at_dofs) {
  Eigen::Matrix3Xd found = Eigen::Matrix3Xd::Zero(3, values.n_quadrature_points);
  for (unsigned q = 0; q < values.n_quadrature_points; ++q)
    for (unsigned i = 0; i < dofs.size(); ++i) {
      const PlaneStrain e = strain_of(values, i, q);
      found.col(q) += at_dofs[static_cast<Eigen::Index>(dofs[i])] * Eigen::Vector3d(e.xx, e.yy, std::sqrt(2.) * e.xy);
    }
  return found;
}

double uneven(const dealii::FEValues<dim>& values, const Eigen::Matrix3Xd& strain,
              const std::vector<PlaneStress>& stresses) {
  const auto& areas = values.get_JxW_values();
  const Eigen::Map<const Eigen::VectorXd> area(areas.data(), static_cast<Eigen::Index>(areas.size()));
  const Eigen::Vector3d mean = strain * area / area.sum();
  double sum = 0.;
  for (unsigned q = 0; q < areas.size(); ++q) {
    const PlaneStress& s = stresses[q];
    sum += area[q] * std::sqrt(s.xx * s.xx + s.yy * s.yy + 2. * s.xy * s.xy) * (strain.col(q) - mean).norm();
  }
  return sum;
}

}  // namespace

std::vector<double> uneven_flow(const Compiled& compiled, const Vector& moved, const PointStresses& stresses) {
  const Space& space = compiled.space;
  const Vector at_dofs = compiled.unknowns.expand(moved);
  std::vector<double> found;
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    dealii::FEValues<dim> values(space.mapping(), cell->get_fe(),
                                 dealii::QGauss<dim>(static_cast<unsigned>(space.degree()) + 1),
                                 dealii::update_gradients | dealii::update_JxW_values);
    values.reinit(typename dealii::Triangulation<dim>::cell_iterator(cell));
    found.push_back(uneven(values, strains(values, dofs_of(cell), at_dofs), stresses[cell->active_cell_index()]));
  }
  return found;
}

std::vector<bool> most_uneven(const std::vector<double>& uneven, double share) {
  std::vector<std::size_t> order(uneven.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return uneven[a] > uneven[b]; });
  const double all = std::accumulate(uneven.begin(), uneven.end(), 0.);
  std::vector<bool> chosen(uneven.size());
  double sum = 0.;
  for (const std::size_t i : order) {
    if (sum >= share * all) break;
    sum += uneven[i];
    chosen[i] = true;
  }
  return chosen;
}

}  // namespace upbead::test
