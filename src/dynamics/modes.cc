#include <Eigen/LU>

#include "upbead/algebra/eigenpairs.h"
#include "upbead/base/error.h"
#include "upbead/base/text.h"
#include "upbead/dynamics/state_space.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;

/// Largest difference of X diag(pole) X^-1 B and A B that is tolerable, beside A B.
constexpr double diagonalisable = 1e-8;

struct Modes {
  Eigen::VectorXcd pole;
  Eigen::MatrixXcd X;
  Eigen::MatrixXcd load;  ///< X^-1 B
};

Modes diagonalise(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigenpairs pairs = eigenpairs(A);
  Modes modes{std::move(pairs.value), std::move(pairs.vector), {}};
  modes.load = modes.X.partialPivLu().solve(B.cast<Complex>());
  const Eigen::MatrixXd AB = A * B;
  const double difference = ((modes.X * (modes.pole.asDiagonal() * modes.load)) - AB).norm() / AB.norm();
  if (!(difference <= diagonalisable))
    throw NumericsError("the reduced model cannot be diagonalised (its modes give it back to " +
                        significant(difference) + "); march this scene");
  // A + A^T <= 0 leaves no pole with a positive real part (Bendixson); what there is of it is round-off.
  modes.pole.real() = modes.pole.real().cwiseMin(0.);
  return modes;
}

/// y += int (E s + F f): in modes, int z = (z - load int f) / pole.
void add_drift(const StateSpace& space, const Modes& modes, Eigen::MatrixXcd& reading, Eigen::MatrixXd& impulse) {
  impulse = space.F;
  if (space.E.isZero(0.)) return;
  const Eigen::MatrixXcd drift = space.E * modes.X * modes.pole.cwiseInverse().asDiagonal();
  if (!drift.allFinite()) throw NumericsError("nothing holds the scene: a mode with a reading has a pole at zero");
  reading += drift;
  impulse -= (drift * modes.load).real();
}

}  // namespace

ModalModel modal_model(const StateSpace& space, const ReducedSystem& labels) {
  const Modes modes = diagonalise(space.A, space.B);
  Eigen::MatrixXcd reading = space.C * modes.X;
  ModalModel model;
  add_drift(space, modes, reading, model.impulse);
  std::vector<int> kept;
  for (int m = 0; m < modes.pole.size(); ++m) {
    if (modes.pole[m].imag() < 0.) continue;
    if (modes.pole[m].imag() > 0.) reading.col(m) *= 2.;
    kept.push_back(m);
  }
  model.pole = modes.pole(kept);
  model.load = modes.load(kept, Eigen::all);
  model.reading = reading(Eigen::all, kept);
  model.feedthrough = space.D;
  model.load_name = labels.load_name;
  model.reading_label = labels.reading_label;
  return model;
}

}  // namespace upbead
