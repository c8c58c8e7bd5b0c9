// The contact law at all nodes of an interface at once, for one stage of a time scheme.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "algebra/dense_factors.h"
#include "dynamics/contact.h"

namespace upbead::detail {

/// Motion q = (slip, opening) of all nodes (2n; in any unit that D shares), and the forces that belong to it.
struct ContactPoint {
  Vector motion;
  InterfaceForces forces;
};

/// n nodes whose forces depend linearly on their motion: (-T, N) = (-T_0, N_0) + D (q - q_0), D symmetric and
/// positive definite. Finds q with
///
///     q_n >= 0,  N >= 0,  q_n N = 0,   |T| <= mu N,  T = mu N sgn(q_t) where q_t is not 0
///
/// by an active set, which is Newton's method on the law written with projections [Alart and Curnier 1991; Hueber and
/// Wohlmuth 2005]: each node gets a status, one dense solve gives the motion of the nodes that are free to move, and
/// the result gives the next status. Where the statuses repeat in a cycle, sweeps over the nodes find better ones
/// (ContactSweeps).
class ContactProblem {
 public:
  /// stiffness: D, 2n x 2n; friction: mu.
  ContactProblem(Eigen::MatrixXd stiffness, double friction);

  /// Goes from a point (q_0, T_0, N_0) of this linear relation to the point of it that obeys the law. `status` is a
  /// first guess on entry, and the solution's on return. Forces count as zero below 1e-10 times the largest of the
  /// point or `scale` (N/m). Motions that the law forbids are exactly zero. Throws NumericsError where no solution is
  /// found.
  ContactPoint solve(const ContactPoint& point, double scale, std::vector<ContactState>& status);
  /// Another mu, of the same linear relation.
  void set_friction(double friction);
  const Eigen::MatrixXd& stiffness() const { return D_; }
  /// Number of times that sweeps were needed so far.
  int n_fallbacks() const { return n_fallbacks_; }
  /// Whether the forces obey the law while all nodes stick; `scale` as above.
  static bool holds(const InterfaceForces& forces, double friction, double scale);

 private:
  bool iterate(const ContactPoint& point, double tolerance, std::vector<ContactState>& status, ContactPoint& found);
  void release(const ContactPoint& point, const std::vector<ContactState>& status, ContactPoint& found);
  void factorise(const std::vector<ContactState>& status);
  std::vector<ContactState> judge(const ContactPoint& point, const std::vector<ContactState>& status,
                                  double tolerance) const;

  Eigen::MatrixXd D_;
  double friction_;
  int n_;
  std::vector<ContactState> factorised_;  ///< status for which the matrix is factorised
  std::vector<Eigen::Index> released_;    ///< unknowns that move in that status
  DenseFactors factors_;
  Eigen::MatrixXd compliance_;  ///< D^-1, once sweeps need it
  int n_fallbacks_ = 0;
};

/// Contact by sweeps over the nodes, for problems in which the active set cycles. Nonlinear Gauss-Seidel on the
/// compliance W = D^-1 [Jean 1999; Moreau 1999]: one node after the other gets the forces that obey the law while the
/// forces of all other nodes stay. It converges slowly but hardly ever fails; only its statuses are used.
class ContactSweeps {
 public:
  /// `point`: some motion with its forces.
  ContactSweeps(const Eigen::MatrixXd& W, double friction, const ContactPoint& point);
  void sweep();
  const std::vector<ContactState>& status() const { return status_; }

 private:
  const Eigen::MatrixXd& W_;
  double friction_;
  Eigen::Index n_;
  Vector motion_;           ///< under the present forces
  Eigen::MatrixX2d force_;  ///< (-T, N) of each node
  std::vector<ContactState> status_;
};

}  // namespace upbead::detail
