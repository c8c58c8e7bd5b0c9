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
  Row strain(double PlaneStrain::*component) const {
    return row([&](unsigned i) { return strain_of(values_, i, 0).*component; });
  }
  Row stress(const ElasticLaw& law, double PlaneStress::*component) const {
    return row([&](unsigned i) { return law.stress(strain_of(values_, i, 0)).*component; });
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
