#include "contact_systems.h"

#include <algorithm>

namespace upbead::test {

namespace {

/// Matrices of (x, y, rotation) and of the nodes' motions, horizontal ones first.
struct Parts {
  Eigen::MatrixXd M, C, K;
};

Parts parts(const BlockOnNodes& block, Eigen::Index n) {
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(3 + 2 * n, 3 + 2 * n);
  Parts parts{zero, zero, zero};
  parts.M.diagonal().head(3) << block.mass, block.mass, block.inertia;
  parts.M.diagonal().tail(2 * n).setConstant(block.node_mass);
  parts.C.diagonal().segment(3, n).setConstant(block.cx);
  parts.C.diagonal().tail(n).setConstant(block.cy);
  parts.K.diagonal().segment(3, n).setConstant(block.kx);
  parts.K.diagonal().tail(n).setConstant(block.ky);
  for (Eigen::Index first : {3 + Eigen::Index{0}, 3 + n})
    for (Eigen::Index i = first; i + 1 < first + n; ++i) {
      parts.K(i, i) += block.link;
      parts.K(i + 1, i + 1) += block.link;
      parts.K(i, i + 1) -= block.link;
      parts.K(i + 1, i) -= block.link;
    }
  return parts;
}

}  // namespace

System BlockOnNodes::system(const TimeFunction& P, const TimeFunction& V) const {
  const auto n = static_cast<Eigen::Index>(position.size());
  const Parts of_nodes = parts(*this, n);
  // motion of the nodes = that of the block's points - (slip, opening)
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(3 + 2 * n, 3 + 2 * n);
  T.bottomRightCorner(2 * n, 2 * n) *= -1.;
  for (Eigen::Index i = 0; i < n; ++i) {
    T.row(3 + i).head(3) << 1., 0., height;
    T.row(3 + n + i).head(3) << 0., 1., position[static_cast<std::size_t>(i)];
  }
  const auto transformed = [&](const Eigen::MatrixXd& A) {
    return SparseMatrix(Eigen::MatrixXd(T.transpose() * A * T).sparseView());
  };
  System system;
  system.M = transformed(of_nodes.M);
  system.C = transformed(of_nodes.C);
  system.K = transformed(of_nodes.K);
  system.field.assign(static_cast<std::size_t>(3 + 2 * n), Field::displacement);
  system.n_prescribed = static_cast<int>(2 * n);
  Interface interface;
  interface.position = position;
  interface.friction = friction;
  interface.normal_force = Vector::Constant(n, weight / static_cast<double>(n));
  if (!normal_force.empty()) interface.normal_force = Eigen::Map<const Vector>(normal_force.data(), n);
  system.interface = interface;
  Vector push = Vector::Zero(system.size()), lift = push;
  push.head(3) << 1., 0., -arm;
  lift[1] = 1.;
  system.loads = {{"push", push, P, -1}, {"lift", lift, V, -1}};
  return system;
}

TimeFunction triangle(double peak, double duration) {
  return piecewise_linear({0., 0.5 * duration, duration}, {0., peak, 0.});
}

double ContactMarch::mismatch() const {
  double largest = 0.;
  for (const EnergyAccount& account : energy) largest = std::max(largest, account.mismatch());
  return largest;
}

double ContactMarch::least_friction_step() const {
  double least = 0.;
  for (std::size_t i = 1; i < energy.size(); ++i) least = std::min(least, energy[i].friction - energy[i - 1].friction);
  return least / std::max(energy.back().largest_work, 1e-300);
}

ContactMarch march_contact(const System& system, double end, double step, int leap) {
  const auto scheme = make_contact_scheme(system);
  ContactMarch result;
  MarchOptions options;
  ObserverFunction note([&](const State& state, int, int) {
    result.states.push_back(state);
    result.forces.push_back(scheme->contact()->forces);
    result.moving_steps.push_back(scheme->contact()->slip_steps + scheme->contact()->open_steps);
  });
  options.observers = {&note};
  options.leap = leap;
  result.energy = march(system, *scheme, make_time_grid(kinks(system), end, step), options).energy;
  result.report = *scheme->contact();
  result.n_solves = scheme->n_solves();
  result.n_factorisations = scheme->n_factorisations();
  return result;
}

}  // namespace upbead::test
