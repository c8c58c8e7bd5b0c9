#include "fem/cell_pack.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace upbead {

using namespace dealii;

namespace {

using detail::Lanes;

UPBEAD_CLONES void strain_at(const PackVector* gradient, const PackVector* u, std::size_t n_nodes, PackTensor& strain) {
  Lanes xx{}, yy{}, gamma{};
  for (std::size_t i = 0; i < n_nodes; ++i) {
    xx += gradient[i].x * u[i].x;
    yy += gradient[i].y * u[i].y;
    gamma += gradient[i].y * u[i].x + gradient[i].x * u[i].y;
  }
  strain.xx = xx;
  strain.yy = yy;
  strain.xy = 0.5 * gamma;
}

UPBEAD_CLONES void add_forces(const PackVector* gradient, const PackStress& s, const Lanes& area, std::size_t n_nodes,
                              PackVector* force) {
  const Lanes xx = area * s.xx, yy = area * s.yy, xy = area * s.xy;
  for (std::size_t i = 0; i < n_nodes; ++i) {
    force[i].x += xx * gradient[i].x + xy * gradient[i].y;
    force[i].y += yy * gradient[i].y + xy * gradient[i].x;
  }
}

UPBEAD_CLONES void elastic_of(const Lanes& G, const Lanes& lambda, const PackTensor& strain, PackStress& stress) {
  const Lanes mean = lambda * (strain.xx + strain.yy);
  stress.xx = 2. * G * strain.xx + mean;
  stress.yy = 2. * G * strain.yy + mean;
  stress.xy = 2. * G * strain.xy;
  stress.zz = mean;
}

/// Bounds the norm of the change of strain: it is at most the sum over the nodes of the norm of the gradient times
/// the displacement, where one displacement may be subtracted from all (here the mean).
UPBEAD_CLONES bool is_within(const PackVector* u, const PackVector* settled, const PackNumber* steepest,
                             std::size_t n_nodes, const Lanes& margin) {
  Lanes mean_x{}, mean_y{}, most{};
  for (std::size_t i = 0; i < n_nodes; ++i) {
    mean_x += u[i].x - settled[i].x;
    mean_y += u[i].y - settled[i].y;
  }
  mean_x /= static_cast<double>(n_nodes);
  mean_y /= static_cast<double>(n_nodes);
  for (std::size_t i = 0; i < n_nodes; ++i) {
    const Lanes x = u[i].x - settled[i].x - mean_x, y = u[i].y - settled[i].y - mean_y;
    most += steepest[i].value * ((x < Lanes{} ? -x : x) + (y < Lanes{} ? -y : y));
  }
  const auto within = most <= margin;
  long long all = -1;
  for (int lane = 0; lane < detail::lanes; ++lane) all &= within[lane];
  return all != 0;
}

}  // namespace

CellShapes shapes_of(const Space& space, const Cell& cell) {
  const FiniteElement<dim>& fe = cell->get_fe();
  FEValues<dim> values(space.mapping(), fe, QGauss<dim>(static_cast<unsigned>(space.degree()) + 1),
                       update_gradients | update_quadrature_points | update_JxW_values);
  values.reinit(typename Triangulation<dim>::cell_iterator(cell));
  const Dofs dofs = dofs_of(cell);
  CellShapes shapes{
      static_cast<int>(cell->active_cell_index()), space.material(cell), {}, {}, {}, values.get_quadrature_points()};
  std::vector<unsigned> of_x;
  for (unsigned i = 0; i < dofs.size(); ++i) {
    const auto [component, node] = fe.system_to_component_index(i);
    if (component >= dim) continue;
    if (shapes.dofs.size() <= node) shapes.dofs.resize(node + 1), of_x.resize(node + 1);
    shapes.dofs[node][component] = static_cast<int>(dofs[i]);
    if (component == 0) of_x[node] = i;
  }
  for (unsigned q = 0; q < values.n_quadrature_points; ++q) {
    shapes.area.push_back(values.JxW(q));
    shapes.gradient.emplace_back();
    for (const unsigned i : of_x) shapes.gradient.back().push_back(values.shape_grad_component(i, q, 0));
  }
  return shapes;
}

std::vector<PointStrain> strains_by_unknown(const CellShapes& cell, const Unknowns& unknowns) {
  std::vector<PointStrain> points;
  for (std::size_t q = 0; q < cell.area.size(); ++q) {
    PointStrain& point = points.emplace_back(PointStrain{cell.area[q], {}});
    for (std::size_t node = 0; node < cell.dofs.size(); ++node)
      for (std::size_t c = 0; c < dim; ++c)
        for (const auto& [unknown, weight] : unknowns.expansion(static_cast<unsigned>(cell.dofs[node][c]))) {
          const Tensor<1, dim> gradient = weight * cell.gradient[q][node];
          PlaneStrain& of = point.strain[unknown];
          (c == 0 ? of.xx : of.yy) += gradient[c];
          of.xy += 0.5 * gradient[1 - c];
        }
  }
  return points;
}

CellPack::CellPack(const std::vector<CellShapes>& cells, std::vector<std::unique_ptr<SoilPack>> soil, int nowhere)
    : soil_(std::move(soil)) {
  const std::size_t n_nodes = cells.front().dofs.size(), n_points = cells.front().area.size();
  dof_.assign(2 * n_nodes * detail::lanes, nowhere);
  gradient_.resize(n_points * n_nodes);
  area_.resize(n_points);
  for (auto* nodes : {&u_, &force_, &settled_u_, &settled_force_}) nodes->resize(n_nodes);
  steepest_.resize(n_nodes);
  margin_.value += std::numeric_limits<double>::max();  // lanes without a cell are always at rest
  for (std::size_t lane = 0; lane < cells.size(); ++lane) {
    const CellShapes& shapes = cells[lane];
    cell_.push_back(shapes.cell);
    margin_.value[lane] = 0.;
    G_.value[lane] = shapes.elastic.G;
    lambda_.value[lane] = shapes.elastic.lambda;
    for (std::size_t i = 0; i < n_nodes; ++i)
      for (std::size_t c = 0; c < 2; ++c) dof_[(2 * i + c) * detail::lanes + lane] = shapes.dofs[i][c];
    for (std::size_t q = 0; q < n_points; ++q) {
      area_[q].value[lane] = shapes.area[q];
      for (std::size_t i = 0; i < n_nodes; ++i) {
        gradient_[q * n_nodes + i].x[lane] = shapes.gradient[q][i][0];
        gradient_[q * n_nodes + i].y[lane] = shapes.gradient[q][i][1];
        steepest_[i].value[lane] = std::max(steepest_[i].value[lane], shapes.gradient[q][i].norm());
      }
    }
  }
}

void CellPack::take(const upbead::Vector& u) {
  const int* dof = dof_.data();
  for (PackVector& node : u_)
    for (Lanes* part : {&node.x, &node.y})
      for (int lane = 0; lane < detail::lanes; ++lane) (*part)[lane] = u[*dof++];
}

PackTensor CellPack::strain(int point) const {
  PackTensor strain;
  strain_at(&gradient_[at(point)], u_.data(), u_.size(), strain);
  return strain;
}

PackStress CellPack::elastic_stress(const PackTensor& strain) const {
  PackStress stress;
  elastic_of(G_.value, lambda_.value, strain, stress);
  return stress;
}

void CellPack::clear_forces() {
  for (PackVector& force : force_) force = {};
}

void CellPack::add_force(int point, const PackStress& stress) {
  add_forces(&gradient_[at(point)], stress, area(point), u_.size(), force_.data());
}

void CellPack::give(upbead::Vector& F) const {
  const int* dof = dof_.data();
  for (const PackVector& node : force_)
    for (const Lanes* part : {&node.x, &node.y})
      for (int lane = 0; lane < detail::lanes; ++lane) F[*dof++] += (*part)[lane];
}

void CellPack::settle(const PackNumber& margin) {
  constexpr double beside_round_off = 1. - 1e-6;
  settled_u_ = u_;
  settled_force_ = force_;
  for (int lane = 0; lane < n_cells(); ++lane) margin_.value[lane] = beside_round_off * margin.value[lane];
}

bool CellPack::rests() {
  if (!is_within(u_.data(), settled_u_.data(), steepest_.data(), u_.size(), margin_.value)) return false;
  force_ = settled_force_;
  return true;
}

void CellPack::remember(std::vector<double>& memory) const {
  for (const auto* nodes : {&settled_u_, &settled_force_})
    for (const PackVector& node : *nodes) remember_numbers(node, memory);
  remember_numbers(margin_, memory);
  for (const auto& soil : soil_) soil->remember(memory);
}

const double* CellPack::recall(const double* memory) {
  for (auto* nodes : {&settled_u_, &settled_force_})
    for (PackVector& node : *nodes) memory = recall_numbers(memory, node);
  memory = recall_numbers(memory, margin_);
  for (const auto& soil : soil_) memory = soil->recall(memory);
  return memory;
}

}  // namespace upbead
