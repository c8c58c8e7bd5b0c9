#include "contact_problem.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "upbead/base/error.h"

namespace upbead::detail {

namespace {

struct NodeSolution {
  ContactState contact;
  Eigen::Vector2d force;  ///< (-T, N)
};

/// Solves the law at one node whose motion is `free` + W force. With mu W_nt < W_nn, W_tt the cases exclude each
/// other; else the first that fits is taken.
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

/// Starts from nodes without forces, all of them open.
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
    status_[i] = node.contact;
  }
}

namespace {

constexpr double force_tolerance = 1e-10;
constexpr int most_iterations = 100;
constexpr int most_rounds = 40;

double largest_force(const InterfaceForces& forces) {
  return std::max(forces.shear.cwiseAbs().maxCoeff(), forces.normal.cwiseAbs().maxCoeff());
}

/// Sets motions that the law forbids, where only round-off is left of them, to zero.
void clean(const std::vector<ContactState>& status, Vector& motion) {
  const auto n = static_cast<Eigen::Index>(status.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const ContactState contact = status[i];
    double &slip = motion[i], &opening = motion[n + i];
    opening = contact == ContactState::open ? std::max(opening, 0.) : 0.;
    if (contact != ContactState::open && slip * direction(contact) <= 0.) slip = 0.;
  }
}

}  // namespace

ContactProblem::ContactProblem(Eigen::MatrixXd stiffness, double friction)
    : D_(std::move(stiffness)), friction_(friction), n_(static_cast<int>(D_.rows()) / 2) {}

void ContactProblem::set_friction(double friction) {
  if (friction == friction_) return;
  friction_ = friction;
  factorised_.clear();
}

bool ContactProblem::holds(const InterfaceForces& forces, double friction, double scale) {
  const double tolerance = force_tolerance * std::max(scale, largest_force(forces));
  return (forces.normal.array() >= -tolerance).all() &&
         (forces.shear.array().abs() <= friction * forces.normal.array() + tolerance).all();
}

ContactPoint ContactProblem::solve(const ContactPoint& point, double scale, std::vector<ContactState>& status) {
  const double tolerance = force_tolerance * std::max(scale, largest_force(point.forces));
  ContactPoint found;
  if (iterate(point, tolerance, status, found)) return found;
  ++n_fallbacks_;
  if (compliance_.size() == 0) compliance_ = D_.llt().solve(Eigen::MatrixXd::Identity(2 * n_, 2 * n_));
  ContactSweeps sweeps(compliance_, friction_, point);
  for (int round = 0, n_sweeps = 5; round < most_rounds; ++round, n_sweeps += n_sweeps / 4) {
    for (int i = 0; i < n_sweeps; ++i) sweeps.sweep();
    status = sweeps.status();
    if (iterate(point, tolerance, status, found)) return found;
  }
  throw NumericsError("no motion of the interface's " + std::to_string(n_) +
                      " nodes was found that obeys friction and contact with the coefficient " +
                      std::to_string(friction_));
}

bool ContactProblem::iterate(const ContactPoint& point, double tolerance, std::vector<ContactState>& status,
                             ContactPoint& found) {
  std::set<std::vector<ContactState>> seen;
  for (int i = 0; i < most_iterations && seen.insert(status).second; ++i) {
    release(point, status, found);
    if (!found.motion.allFinite()) return false;
    std::vector<ContactState> next = judge(found, status, tolerance);
    if (next == status) {
      clean(status, found.motion);
      return true;
    }
    status = std::move(next);
  }
  return false;
}

/// Factorises the rows of the unknowns that move: T - mu sigma N = 0 of a node that slips, T = 0 and N = 0 of an open
/// one.
void ContactProblem::factorise(const std::vector<ContactState>& status) {
  released_.clear();
  for (Eigen::Index i = 0; i < n_; ++i)
    if (status[i] != ContactState::stick) released_.push_back(i);
  for (Eigen::Index i = 0; i < n_; ++i)
    if (status[i] == ContactState::open) released_.push_back(n_ + i);
  Eigen::MatrixXd A = D_(released_, released_);
  for (std::size_t k = 0; k < released_.size() && released_[k] < n_; ++k)
    if (const double sigma = direction(status[released_[k]]); sigma != 0.)
      A.row(static_cast<Eigen::Index>(k)) += friction_ * sigma * D_.row(n_ + released_[k])(released_);
  if (!released_.empty()) factors_.compute(std::move(A));
  factorised_ = status;
}

/// Finds the point at which all nodes obey the equations of their status; the inequalities may be violated.
void ContactProblem::release(const ContactPoint& point, const std::vector<ContactState>& status, ContactPoint& found) {
  if (status != factorised_) factorise(status);
  Vector change = -point.motion;
  for (const Eigen::Index k : released_) change[k] = 0.;
  Vector force = Vector::Zero(2 * n_);
  if (!change.isZero(0.)) force = D_ * change;
  force.head(n_) -= point.forces.shear;
  force.tail(n_) += point.forces.normal;
  if (!released_.empty()) {
    Vector unbalanced = force(released_);
    for (std::size_t k = 0; k < released_.size() && released_[k] < n_; ++k)
      unbalanced[k] += friction_ * direction(status[released_[k]]) * force[n_ + released_[k]];
    const Vector moved = -factors_.solve(unbalanced);
    for (std::size_t k = 0; k < released_.size(); ++k) {
      change[released_[k]] = moved[k];
      force += change[released_[k]] * D_.col(released_[k]);
    }
  }
  found.motion = point.motion + change;
  found.forces = {-force.head(n_), force.tail(n_)};
}

/// The status that the projections of the law give each node at this point.
std::vector<ContactState> ContactProblem::judge(const ContactPoint& point, const std::vector<ContactState>& status,
                                                double tolerance) const {
  std::vector<ContactState> next = status;
  for (Eigen::Index i = 0; i < n_; ++i) {
    ContactState& contact = next[i];
    const double N = point.forces.normal[i], T = point.forces.shear[i];
    const double slip = D_(i, i) * point.motion[i], opening = D_(n_ + i, n_ + i) * point.motion[n_ + i];
    if (contact == ContactState::open) {
      if (opening >= -tolerance) continue;
      const double sliding = std::abs(slip) + friction_ * opening;
      contact = sliding <= 0. ? ContactState::stick
                : slip > 0.   ? ContactState::slip_landward
                              : ContactState::slip_seaward;
    } else if (N < -tolerance) {
      contact = ContactState::open;
    } else if (contact == ContactState::stick) {
      if (std::abs(T) > friction_ * N + tolerance)
        contact = T > 0. ? ContactState::slip_landward : ContactState::slip_seaward;
    } else if (slip * direction(contact) < -tolerance) {
      contact = ContactState::stick;
    }
  }
  return next;
}

}  // namespace upbead::detail
