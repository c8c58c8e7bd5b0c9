// A reduced system as a set of first-order equations whose energy is half the square of its state, and its modes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "upbead/dynamics/reduced_system.h"

namespace upbead {

/// s' = A s + B f(t), y = C s + D f + int_0^t (E s + F f), with N states and A + A^T <= 0: the energy s.s/2 (J/m) never
/// grows without load.
struct StateSpace {
  Eigen::MatrixXd A, B;
  Eigen::MatrixXd C, D;
  Eigen::MatrixXd E, F;  ///< of readings of a position that no strain determines, as where only absorbing sides hold it
};

/// Energy coordinates: with K~ = L L^T and M~ = R^T R of the matrices whose rows of phi are multiplied by -1, the
/// states are e = L^T q and w = R q',
///
///     e' = L^T R^-1 w,   w' = R^-T (b f - L e - C~ R^-1 w),
///
/// skew but for -R^-T sym(C~) R^-1. Coordinates that K~ does not see (the displacement W of the fluid, phi in soils)
/// have no state e; in companion form they would be poles at zero that round-off moves. A prescribed velocity q'_p =
/// f enters by v = R^-1 w - M^-1 M_p f, so that no derivative of f is needed. Where an incompressible fluid leaves M~
/// singular in phi, phi is given storage 1e-9 and damping 1e-6, relative to T(s_0): the response changes by 1e-6 of
/// itself, at frequencies about the shift. Throws NumericsError where M~ is singular beyond phi, and where a reading
/// needs the acceleration of what a load prescribes.
StateSpace state_space(const ReducedSystem& reduced);

/// The same in modes, s = X z with A X = X diag(pole). Throws NumericsError where the modes do not reproduce A B to
/// 1e-8, as A cannot be diagonalised.
ModalModel modal_model(const StateSpace& space, const ReducedSystem& labels);

}  // namespace upbead

namespace upbead::detail {

/// A X = X diag(pole), with both poles of a conjugate pair.
struct Modes {
  Eigen::VectorXcd pole;
  Eigen::MatrixXcd X;
  Eigen::MatrixXcd load;  ///< X^-1 B

  /// The modes that make a real sum: one of each pair of conjugates.
  std::vector<int> kept() const;
  /// Rows R X of the kept modes, doubled for pairs: R s = Re (row z).
  Eigen::MatrixXcd reading(const Eigen::MatrixXcd& rows_X, const std::vector<int>& modes) const;
};

/// Throws NumericsError where X diag(pole) X^-1 B differs from A B by more than 1e-8.
Modes diagonalise(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace upbead::detail
