// Rows of what can be read at one point.
#pragma once

#include <deal.II/fe/fe_values.h>

#include <map>
#include <vector>

#include "fem/kernels.h"
#include "fem/probes.h"

namespace upbead {

/// Rows of point values at one location.
class PointRows {
 public:
  PointRows(const Space& space, const Unknowns& unknowns, const Location& location)
      : unknowns_(unknowns),
        values_(space.mapping(), location.cell->get_fe(), dealii::Quadrature<dim>(location.unit),
                dealii::update_values | dealii::update_gradients),
        dofs_(location.cell->get_fe().n_dofs_per_cell()) {
    values_.reinit(typename dealii::Triangulation<dim>::cell_iterator(location.cell));
    location.cell->get_dof_indices(dofs_);
  }

  Row value(unsigned component) const {
    return row([&](unsigned i) { return values_.shape_value_component(i, 0, component); });
  }
  /// `factor` times a component of grad phi.
  Row phi_gradient(unsigned d, double factor) const {
    return row([&](unsigned i) { return factor * values_[phi_part].gradient(i, 0)[d]; });
  }
  /// Strain component, tension positive.
  Row strain(unsigned a, unsigned b) const {
    return row([&](unsigned i) { return values_[u_part].symmetric_gradient(i, 0)[a][b]; });
  }
  /// Stress component of plane strain: 2 G eps_ab + lambda div u delta_ab; a = b = 2 is the one out of plane.
  Row stress(const Material& material, unsigned a, unsigned b) const {
    return row([&](unsigned i) {
      const double shear = a < dim && b < dim ? 2. * material.G * values_[u_part].symmetric_gradient(i, 0)[a][b] : 0.;
      return shear + (a == b ? material.lambda * values_[u_part].divergence(i, 0) : 0.);
    });
  }

 private:
  template <typename Value>
  Row row(const Value& value) const {
    std::map<int, double> entries;
    for (unsigned i = 0; i < dofs_.size(); ++i)
      if (const double v = value(i); v != 0.) unknowns_.add_to(entries, static_cast<unsigned>(dofs_[i]), v);
    return to_row(entries);
  }

  const Unknowns& unknowns_;
  dealii::FEValues<dim> values_;
  std::vector<dealii::types::global_dof_index> dofs_;
};

}  // namespace upbead
