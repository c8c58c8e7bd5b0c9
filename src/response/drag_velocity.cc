#include "response/drag_velocity.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include "fem/kernels.h"

namespace upbead {

using namespace dealii;

namespace {

/// What a shape function of phi or W adds to w = -(1/b) diag(1, r) grad phi', or W'.
Tensor<1, dim> flow_of(const FEValues<dim>& fe, unsigned i, const Material& material, CellKind kind) {
  if (kind == CellKind::inertial) return fe[W_part].value(i, 0);
  Tensor<1, dim> flow = -material.mobility * fe[phi_part].gradient(i, 0);
  flow[1] *= material.vertical_flow;
  return flow;
}

}  // namespace

DragVelocity::DragVelocity(const Space& space, const Unknowns& unknowns)
    : n_active_(space.mesh().triangulation.n_active_cells()) {
  std::vector<Eigen::Triplet<double>> x, y;
  const hp::QCollection<dim> middle{QMidpoint<dim>()};
  hp::FEValues<dim> hp_values(space.dofs().get_fe_collection(), middle, update_values | update_gradients);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    if (!space.region(cell).forchheimer || !space.has_pores(cell)) continue;
    hp_values.reinit(cell);
    const FEValues<dim>& fe = hp_values.get_present_fe_values();
    const Dofs dofs = dofs_of(cell);
    const int row = static_cast<int>(cells_.size());
    for (const unsigned i : fe.dof_indices()) {
      const Tensor<1, dim> flow = flow_of(fe, i, space.material(cell), space.kind(cell));
      if (flow.norm_square() == 0.) continue;
      for (const auto& [unknown, weight] : unknowns.expansion(dofs[i])) {
        x.emplace_back(row, unknown, weight * flow[0]);
        y.emplace_back(row, unknown, weight * flow[1]);
      }
    }
    cells_.push_back(cell->active_cell_index());
  }
  for (auto [matrix, entries] : {std::pair{&along_x_, &x}, {&along_y_, &y}}) {
    matrix->resize(static_cast<Eigen::Index>(cells_.size()), unknowns.size());
    matrix->setFromTriplets(entries->begin(), entries->end());
  }
}

void DragVelocity::see(const State& state, int step, int) {
  const Eigen::ArrayXd x = (along_x_ * state.v).array(), y = (along_y_ * state.v).array();
  const Eigen::ArrayXd speed = (x.square() + y.square()).sqrt();
  if (step == 0) {
    square_ = cube_ = Eigen::ArrayXd::Zero(speed.size());
  } else {
    const double half = 0.5 * (state.time - time_);
    square_ += half * (speed.square() + last_.square());
    cube_ += half * (speed.cube() + last_.cube());
  }
  last_ = speed;
  time_ = state.time;
}

std::vector<double> DragVelocity::found() const {
  std::vector<double> velocity(n_active_, 0.);
  for (std::size_t c = 0; c < cells_.size(); ++c)
    if (const auto i = static_cast<Eigen::Index>(c); square_[i] > 0.) velocity[cells_[c]] = cube_[i] / square_[i];
  return velocity;
}

}  // namespace upbead
