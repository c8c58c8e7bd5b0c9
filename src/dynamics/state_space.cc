#include "dynamics/state_space.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "algebra/dense.h"
#include "algebra/eigenpairs.h"
#include "base/text.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Eigenvalues of K~ and M~ below these, relative to T(s_0) = 1, count as zero.
constexpr double no_stiffness = 1e-13, no_storage = 1e-9;
/// Damping of phi where it has no storage.
constexpr double relaxation = 1e-6;
/// Share of a reading's row that may be outside the range of K~, and count as round-off.
constexpr double no_drift = 1e-6;

/// The matrices with the rows of phi multiplied by -1, in units of time 1/s_0.
struct Dissipative {
  Eigen::MatrixXd M, C, K, b;
};

Dissipative dissipative(const ReducedSystem& r) {
  Eigen::VectorXd J(r.size());
  for (int i = 0; i < r.size(); ++i) J[i] = r.is_phi[i] ? -1. : 1.;
  Dissipative d{r.shift * r.shift * (J.asDiagonal() * r.M), r.shift * (J.asDiagonal() * r.C), J.asDiagonal() * r.K,
                J.asDiagonal() * r.load};
  return d;
}

/// Gives phi without storage a little of it, and damping; coordinates that are prescribed come first and stay.
void relax(const ReducedSystem& r, Dissipative& d) {
  std::vector<int> phi;
  for (int i = r.n_prescribed; i < r.size(); ++i)
    if (r.is_phi[i]) phi.push_back(i);
  if (phi.empty()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> storage(d.M(phi, phi), Eigen::EigenvaluesOnly);
  if (storage.eigenvalues().minCoeff() > no_storage) return;
  for (const int i : phi) {
    d.M(i, i) += no_storage;
    d.C(i, i) += relaxation;
  }
}

/// L of K~ = L L^T, all coordinates x rank.
struct Stiffness {
  Eigen::MatrixXd L;
  Eigen::MatrixXd L_inverse;  ///< L (L^T L)^-1: row . q = (L_inverse^T row) . e for rows in the range of L
};

Stiffness split(const Eigen::MatrixXd& K) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  Eigen::Index rank = 0;
  while (rank < values.size() && values[values.size() - 1 - rank] > no_stiffness) ++rank;
  const Eigen::MatrixXd U = eigen.eigenvectors().rightCols(rank);
  const Eigen::VectorXd root = values.tail(rank).cwiseSqrt();
  return {U * root.asDiagonal(), U * root.cwiseInverse().asDiagonal()};
}

/// Maps f_k to the velocities of the prescribed coordinates, in units of time 1/s_0.
Eigen::MatrixXd prescription(const ReducedSystem& r) {
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(r.n_prescribed, r.load.cols());
  for (std::size_t k = 0; k < r.prescribed.size(); ++k)
    if (r.prescribed[k] >= 0) S(r.prescribed[k], static_cast<Eigen::Index>(k)) = 1. / r.shift;
  return S;
}

/// Builds the equations in units of time 1/s_0.
class Builder {
 public:
  explicit Builder(const ReducedSystem& r) : r_(r), p_(r.n_prescribed), n_(r.size() - p_), S_(prescription(r)) {
    Dissipative d = dissipative(r);
    relax(r, d);
    stiffness_ = split(d.K);
    const Eigen::LLT<Eigen::MatrixXd> llt(d.M.bottomRightCorner(n_, n_));
    if (llt.info() != Eigen::Success)
      throw NumericsError("the reduced mass matrix is not positive: the scene has parts without mass");
    const Eigen::MatrixXd R = llt.matrixU();
    R_inverse_ = R.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(n_, n_));
    C_ = d.C;
    load_ = d.b.bottomRows(n_);
    prescribed_part_ = -llt.solve(d.M.bottomLeftCorner(n_, p_)) * S_;
  }

  StateSpace equations() const {
    const auto L = stiffness_.L.bottomRows(n_);
    const Eigen::Index N_e = L.cols(), N = N_e + n_;
    const Eigen::MatrixXd C = C_.bottomRightCorner(n_, n_);
    StateSpace s;
    s.A.setZero(N, N);
    s.A.topRightCorner(N_e, n_).noalias() = L.transpose() * R_inverse_;
    s.A.bottomLeftCorner(n_, N_e) = -s.A.topRightCorner(N_e, n_).transpose();
    s.A.bottomRightCorner(n_, n_).noalias() = -(R_inverse_.transpose() * C * R_inverse_);
    s.B.resize(N, load_.cols());
    s.B.topRows(N_e) = stiffness_.L.topRows(p_).transpose() * S_ + L.transpose() * prescribed_part_;
    s.B.bottomRows(n_) = R_inverse_.transpose() * (load_ - C_.bottomLeftCorner(n_, p_) * S_ - C * prescribed_part_);
    return s;
  }

  /// Adds the readings y = position q + velocity q' + acceleration q'' + feedthrough f, in the states of `s`.
  void add_readings(StateSpace& s) const {
    const Eigen::Index N = s.A.rows(), N_e = N - n_;
    const auto velocity = r_.shift * r_.velocity;
    const auto acceleration = r_.shift * r_.shift * r_.acceleration;
    s.C.setZero(r_.velocity.rows(), N);
    s.D = r_.feedthrough;
    s.C.leftCols(N_e).noalias() = r_.position * stiffness_.L_inverse;
    const Eigen::MatrixXd v = velocity.rightCols(n_), a = acceleration.rightCols(n_) * R_inverse_;
    s.C.rightCols(n_) += v * R_inverse_;
    s.D += v * prescribed_part_ + velocity.leftCols(p_) * S_;
    s.C += a * s.A.bottomRows(n_);
    s.D += a * s.B.bottomRows(n_);
    require_no_rates(acceleration.rightCols(n_) * prescribed_part_, acceleration.leftCols(p_) * S_);
    add_drift(s);
  }

 private:
  /// The acceleration of what a load prescribes is f', which is not given.
  void require_no_rates(const Eigen::MatrixXd& of_free, const Eigen::MatrixXd& of_prescribed) const {
    if (of_free.cwiseAbs().sum() + of_prescribed.cwiseAbs().sum() > 0.)
      throw NumericsError(
          "a reading needs the acceleration of what a load prescribes, which a reduced model does not have");
  }

  void add_drift(StateSpace& s) const {
    Eigen::MatrixXd rest = r_.position - (r_.position * stiffness_.L_inverse) * stiffness_.L.transpose();
    for (Eigen::Index i = 0; i < rest.rows(); ++i)
      if (rest.row(i).norm() <= no_drift * r_.position.row(i).norm()) rest.row(i).setZero();
    s.E.setZero(s.C.rows(), s.C.cols());
    s.E.rightCols(n_) = rest.rightCols(n_) * R_inverse_;
    s.F = rest.rightCols(n_) * prescribed_part_ + rest.leftCols(p_) * S_;
  }

  const ReducedSystem& r_;
  Eigen::Index p_, n_;
  Eigen::MatrixXd S_;
  Stiffness stiffness_;
  Eigen::MatrixXd R_inverse_, C_, load_;
  Eigen::MatrixXd prescribed_part_;  ///< -M^-1 M_p f: the part of the free velocities that is proportional to f itself
};

}  // namespace

StateSpace state_space(const ReducedSystem& reduced) {
  const Builder builder(reduced);
  StateSpace s = builder.equations();
  builder.add_readings(s);
  s.A *= reduced.shift;
  s.B *= reduced.shift;
  s.E *= reduced.shift;
  s.F *= reduced.shift;
  return s;
}

namespace detail {

namespace {

using Complex = std::complex<double>;

/// Largest tolerable difference of X diag(pole) X^-1 B and A B, relative to A B.
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
  // In real numbers, a quarter of the work: the pair x +- i y with amplitudes (c -+ i d)/2 is c x + d y.
  Eigen::MatrixXd X = modes.X.real();
  for (Eigen::Index j = 0; j < X.cols(); ++j)
    if (modes.pole[j].imag() < 0.) X.col(j) = modes.X.col(j - 1).imag();
  const Eigen::MatrixXd c = solve_dense(X, B);
  Eigen::MatrixXd again(c.rows(), c.cols());  // the coordinates of A B
  modes.load.resize(c.rows(), c.cols());
  for (Eigen::Index j = 0; j < c.rows(); ++j) {
    const Complex pole = modes.pole[j];
    modes.load.row(j) = c.row(j).cast<Complex>();
    again.row(j) = pole.real() * c.row(j);
    if (pole.imag() == 0.) continue;
    again.row(j) += pole.imag() * c.row(j + 1);
    again.row(j + 1) = pole.real() * c.row(j + 1) - pole.imag() * c.row(j);
    modes.load.row(j) = 0.5 * (c.row(j) - Complex(0., 1.) * c.row(j + 1));
    modes.load.row(j + 1) = modes.load.row(j).conjugate();
    ++j;
  }
  const Eigen::MatrixXd AB = product(A, B);
  const double difference = (product(X, again) - AB).norm() / AB.norm();
  if (!(difference <= diagonalisable) && !AB.isZero(0.))
    throw NumericsError("the reduced model cannot be diagonalised (its modes give it back to " +
                        significant(difference) + "); march this scene");
  return modes;
}

}  // namespace detail

namespace {

/// Poles below this share of the largest count as zero. The drift of such a mode counts as zero below this share of
/// the norms of drift and mode.
constexpr double no_pole = 1e-13, no_part = 1e-6;
/// The pole, over s_0, that replaces the pole zero of a body that floats free: in 1,000/s_0 a velocity loses a
/// millionth, and a position is known to 1e-7 after 1/s_0.
constexpr double pole_of_free = 1e-9;

/// Adds y += int (E s + F f): in modes, int z = (z - load int f) / pole. A mode with its pole at zero and no visible
/// drift is the pressure of closed water; one with a drift is a body that nothing holds.
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
  // A + A^T <= 0 leaves no pole with a positive real part (Bendixson); a positive one is round-off.
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
