#include "fem/pore_forces.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <vector>

#include "fem/faces.h"

namespace upbead {

using namespace dealii;

namespace {

/// A cell of one mesh in two spaces, with what is added to its nodal forces.
class PoreCell {
 public:
  PoreCell(const Ground& ground, const Space& pores, const Cell& wet, const Vector& pressure)
      : space_(ground.space()),
        pores_(pores),
        wet_(wet),
        cell_(&space_.mesh().triangulation, wet->level(), wet->index(), &space_.dofs()),
        pressure_(pressure),
        force_(cell_->get_fe().n_dofs_per_cell(), 0.) {
    add_inside();
    for (const unsigned f : cell_->face_indices())
      if (ends_at(f)) add_face(f);
  }

  void add_to(Vector& f, const Unknowns& unknowns) const {
    const Dofs dofs = dofs_of(cell_);
    for (std::size_t i = 0; i < dofs.size(); ++i)
      for (const auto& [unknown, weight] : unknowns.expansion(dofs[i])) f[unknown] += weight * force_[i];
  }

 private:
  std::vector<double> pressures(const FEValuesBase<dim>& phi) const {
    const Dofs dofs = dofs_of(wet_);
    std::vector<double> p(phi.n_quadrature_points, 0.);
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      if (wet_->get_fe().system_to_component_index(static_cast<unsigned>(i)).first != phi_component) continue;
      for (unsigned q = 0; q < p.size(); ++q)
        p[q] += pressure_[static_cast<Eigen::Index>(dofs[i])] * phi[phi_part].value(static_cast<unsigned>(i), q);
    }
    return p;
  }

  void add_inside() {
    const QGauss<dim> points(static_cast<unsigned>(space_.degree()) + 1);
    FEValues<dim> u(space_.mapping(), cell_->get_fe(), points, update_gradients | update_JxW_values);
    FEValues<dim> phi(pores_.mapping(), wet_->get_fe(), points, update_values);
    u.reinit(cell_);
    phi.reinit(wet_);
    const std::vector<double> p = pressures(phi);
    for (unsigned i = 0; i < force_.size(); ++i)
      for (unsigned q = 0; q < p.size(); ++q) force_[i] += p[q] * u[u_part].divergence(i, q) * u.JxW(q);
  }

  bool ends_at(unsigned f) const {
    if (cell_->at_boundary(f)) return true;
    const auto beyond = cell_->neighbor(f);
    return space_.region(beyond).kind == RegionKind::water || space_.mesh().surface_of(beyond) == caisson_name;
  }

  void add_face(unsigned f) {
    const QGauss<dim - 1> points(static_cast<unsigned>(space_.degree()) + 1);
    FEFaceValues<dim> u(space_.mapping(), cell_->get_fe(), points,
                        update_values | update_normal_vectors | update_JxW_values);
    FEFaceValues<dim> phi(pores_.mapping(), wet_->get_fe(), points, update_values);
    u.reinit(cell_, f);
    phi.reinit(wet_, f);
    const std::vector<double> p = pressures(phi);
    for (unsigned i = 0; i < force_.size(); ++i)
      for (unsigned q = 0; q < p.size(); ++q)
        force_[i] -= p[q] * (u[u_part].value(i, q) * u.normal_vector(q)) * u.JxW(q);
  }

  const Space& space_;
  const Space& pores_;
  Cell wet_, cell_;
  const Vector& pressure_;
  std::vector<double> force_;
};

}  // namespace

Vector pore_forces(const Ground& ground, const Space& pores, const Vector& pressure) {
  Vector f = Vector::Zero(ground.unknowns().size());
  for (const Cell& wet : pores.dofs().active_cell_iterators())
    if (pores.has_pores(wet)) PoreCell(ground, pores, wet, pressure).add_to(f, ground.unknowns());
  return f;
}

}  // namespace upbead
