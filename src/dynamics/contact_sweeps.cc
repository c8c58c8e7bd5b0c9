#include "contact_sweeps.h"

#include <Eigen/LU>
#include <cmath>

namespace upbead::detail {

namespace {

struct NodeSolution {
  ContactState contact;
  Eigen::Vector2d force;  ///< (-T, N)
};

/// The law at one node that moves by `free` + W force. With mu W_nt < W_nn, W_tt the cases exclude each other; else the
/// first that fits is taken.
NodeSolution solve_node(const Eigen::Matrix2d& W, const Eigen::Vector2d& free, double friction) {
  if (free[1] >= 0.) return {ContactState::open, Eigen::Vector2d::Zero()};
  const Eigen::Vector2d stick = -W.inverse() * free;
  if (stick[1] >= 0. && std::abs(stick[0]) <= friction * stick[1]) return {ContactState::stick, stick};
  for (const ContactState contact : {ContactState::slip_landward, ContactState::slip_seaward}) {
    const double sigma = direction(contact);
    const double N = -free[1] / (W(1, 1) - friction * sigma * W(1, 0));
    const Eigen::Vector2d force(-friction * sigma * N, N);
    if (N >= 0. && sigma * (free[0] + W.row(0) * force) >= 0.) return {contact, force};
  }
  return {ContactState::stick, {0., std::max(stick[1], 0.)}};
}

}  // namespace

/// Starts where no node carries a force.
ContactSweeps::ContactSweeps(const Eigen::MatrixXd& W, double friction, const ContactPoint& point)
    : W_(W),
      friction_(friction),
      n_(W.rows() / 2),
      force_(Eigen::MatrixX2d::Zero(n_, 2)),
      status_(static_cast<std::size_t>(n_), ContactState::open) {
  Vector force(2 * n_);
  force << -point.forces.shear, point.forces.normal;
  motion_ = point.motion - W * force;
}

void ContactSweeps::sweep() {
  for (Eigen::Index i = 0; i < n_; ++i) {
    Eigen::Matrix2d W;
    W << W_(i, i), W_(i, n_ + i), W_(n_ + i, i), W_(n_ + i, n_ + i);
    const Eigen::Vector2d before = force_.row(i);
    const Eigen::Vector2d free = Eigen::Vector2d(motion_[i], motion_[n_ + i]) - W * before;
    const NodeSolution node = solve_node(W, free, friction_);
    const Eigen::Vector2d change = node.force - before;
    motion_ += change[0] * W_.col(i) + change[1] * W_.col(n_ + i);
    force_.row(i) = node.force;
    status_[static_cast<std::size_t>(i)] = node.contact;
  }
}

}  // namespace upbead::detail
