#include "modes.h"

#include <Eigen/LU>
#include <cmath>

#include "algebra/eigenpairs.h"
#include "base/text.h"
#include "dynamics/state_space.h"
#include "upbead/base/error.h"

namespace upbead {

namespace detail {

namespace {

using Complex = std::complex<double>;

/// Largest difference of X diag(pole) X^-1 B and A B that is tolerable, beside A B.
constexpr double diagonalisable = 1e-8;

}  // namespace

std::vector<int> Modes::kept() const {
  std::vector<int> modes;
  for (int m = 0; m < pole.size(); ++m)
    if (pole[m].imag() >= 0.) modes.push_back(m);
  return modes;
}

Eigen::MatrixXcd Modes::reading(const Eigen::MatrixXcd& rows_X, const std::vector<int>& modes) const {
  Eigen::MatrixXcd reading = rows_X(Eigen::all, modes);
  for (std::size_t j = 0; j < modes.size(); ++j)
    if (pole[modes[j]].imag() > 0.) reading.col(static_cast<Eigen::Index>(j)) *= 2.;
  return reading;
}

Modes diagonalise(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigenpairs pairs = eigenpairs(A);
  Modes modes{std::move(pairs.value), std::move(pairs.vector), {}};
  modes.load = modes.X.partialPivLu().solve(B.cast<Complex>());
  const Eigen::MatrixXd AB = A * B;
  const double difference = ((modes.X * (modes.pole.asDiagonal() * modes.load)) - AB).norm() / AB.norm();
  if (!(difference <= diagonalisable) && !AB.isZero(0.))
    throw NumericsError("the reduced model cannot be diagonalised (its modes give it back to " +
                        significant(difference) + "); march this scene");
  return modes;
}

}  // namespace detail

namespace {

/// Poles below this part of the largest are zero, and so is what a drift sees of a mode below that part of both.
constexpr double no_pole = 1e-13, no_part = 1e-6;
/// Pole over s_0 of what floats free: in 1,000/s_0 a velocity loses a millionth, and a place is known to 1e-7 after
/// 1/s_0.
constexpr double pole_of_free = 1e-9;

/// y += int (E s + F f): in modes, int z = (z - load int f) / pole. A mode with its pole at zero that has no drift to
/// be seen is the pressure of closed water; one that has is a body that nothing holds.
void add_drift(const StateSpace& space, double shift, detail::Modes& modes, Eigen::MatrixXcd& reading,
               Eigen::MatrixXd& impulse) {
  impulse = space.F;
  if (space.E.isZero(0.)) return;
  Eigen::MatrixXcd drift = space.E * modes.X;
  const double largest = modes.pole.cwiseAbs().maxCoeff(), size = space.E.norm();
  for (Eigen::Index m = 0; m < drift.cols(); ++m) {
    const bool is_free = std::abs(modes.pole[m]) <= no_pole * largest;
    if (is_free && drift.col(m).norm() <= no_part * size * modes.X.col(m).norm()) {
      drift.col(m).setZero();
      continue;
    }
    if (is_free) modes.pole[m] = -pole_of_free * shift;
    drift.col(m) /= modes.pole[m];
  }
  if (!drift.allFinite()) throw NumericsError("the drift of the reduced model is not finite");
  reading += drift;
  impulse -= (drift * modes.load).real();
}

}  // namespace

ModalModel modal_model(const StateSpace& space, const ReducedSystem& labels) {
  detail::Modes modes = detail::diagonalise(space.A, space.B);
  // A + A^T <= 0 leaves no pole with a positive real part (Bendixson); what there is of it is round-off.
  modes.pole.real() = modes.pole.real().cwiseMin(0.);
  Eigen::MatrixXcd reading = space.C * modes.X;
  ModalModel model;
  add_drift(space, labels.shift, modes, reading, model.impulse);
  const std::vector<int> kept = modes.kept();
  model.pole = modes.pole(kept);
  model.load = modes.load(kept, Eigen::all);
  model.reading = modes.reading(reading, kept);
  model.feedthrough = space.D;
  model.load_name = labels.load_name;
  model.reading_label = labels.reading_label;
  return model;
}

}  // namespace upbead
