// Contact by sweeps over the nodes, for problems in which an active set runs in circles.
#pragma once

#include "contact_problem.h"

namespace upbead::detail {

/// Nonlinear Gauss-Seidel on the compliance W = D^-1 [Jean 1999; Moreau 1999]: one node after the other
/// gets the forces that obey the law while those of all others stay as they are. It converges slowly but hardly ever
/// fails; it is asked for statuses only.
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
