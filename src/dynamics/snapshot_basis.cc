#include "dynamics/snapshot_basis.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>
#include <vector>

#include "algebra/dense.h"
#include "dynamics/orthogonalise.h"

namespace upbead {

namespace {

/// Y without its part in the span of the orthonormal columns of Q, twice for accuracy.
Eigen::MatrixXd outside(const Eigen::Ref<const Eigen::MatrixXd>& Q, Eigen::MatrixXd Y) {
  for (int pass = 0; pass < 2 && Q.cols() > 0; ++pass) Y -= product(Q, transposed_product(Q, Y));
  return Y;
}

/// The orthonormal columns that span those of D with Q, whose columns are orthonormal, too, and orthogonal to those of
/// D but for round-off: by Cholesky's factor of D'D, twice for accuracy.
Eigen::MatrixXd orthonormal_beside(const Eigen::Ref<const Eigen::MatrixXd>& Q, Eigen::MatrixXd D) {
  for (int pass = 0; pass < 2; ++pass) {
    if (Q.cols() > 0) D -= product(Q, transposed_product(Q, D));
    const Eigen::LLT<Eigen::MatrixXd> factor(transposed_product(D, D));
    const Eigen::MatrixXd to_unit = factor.matrixU().solve(Eigen::MatrixXd::Identity(D.cols(), D.cols()));
    D = product(D, to_unit);
  }
  return D;
}

/// Number of the last eigenvalues, which ascend, without which at most `rest` of their sum is left.
Eigen::Index n_that_leave(const Vector& eigenvalues, double sum, double rest) {
  Eigen::Index n = 0;
  for (double left = sum; n < eigenvalues.size() && left > rest; ++n)
    left -= std::max(eigenvalues[eigenvalues.size() - 1 - n], 0.);
  return n;
}

}  // namespace

SnapshotBasis::SnapshotBasis(const System& like, double shift, const std::vector<int>& exact) {
  FieldBases exactly = exact_bases(like, shift * shift * like.M + shift * like.C + like.K, exact);
  u_ = std::move(exactly.displacements);
  phi_ = std::move(exactly.phi);
  n_coordinates_ = n_kept_ = static_cast<int>(u_.n() + phi_.n());
}

void SnapshotBasis::add(const Snapshots& of, double rest) {
  add(u_, held_u_, of.displacements, rest);
  add(phi_, held_phi_, of.phi, rest);
}

/// By the eigenvectors of Y'Y: they lose what is below 1e-8 of the largest direction, which `rest` exceeds.
void SnapshotBasis::add(FieldBasis& basis, Eigen::MatrixXd& held, const Eigen::MatrixXd& of, double rest) {
  const Eigen::Index kept = basis.n() - held.rows();
  const Eigen::MatrixXd scaled = basis.unit.cwiseInverse().asDiagonal() * of;
  const Eigen::MatrixXd Y = outside(basis.columns(), scaled);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> squares(transposed_product(Y, Y));
  const Eigen::Index n = n_that_leave(squares.eigenvalues(), Y.squaredNorm(), rest * rest * scaled.squaredNorm());
  if (n > 0) {
    const Eigen::MatrixXd directions = product(Y, squares.eigenvectors().rightCols(n).rowwise().reverse());
    const Eigen::MatrixXd added = orthonormal_beside(basis.columns(), directions.colwise().normalized());
    for (Eigen::Index j = 0; j < n; ++j) detail::add_column(basis, added.col(j), n_coordinates_++);
  }
  const Eigen::Index before = held.cols();
  held.conservativeResizeLike(Eigen::MatrixXd::Zero(basis.n() - kept, before + of.cols()));
  held.rightCols(of.cols()) = transposed_product(basis.columns_from(kept), scaled);
}

Eigen::MatrixXd SnapshotBasis::sorting() const {
  Eigen::MatrixXd rotation = Eigen::MatrixXd::Zero(n_coordinates_, n_coordinates_);
  rotation.topLeftCorner(n_kept_, n_kept_).setIdentity();
  std::vector<std::pair<double, Vector>> columns;
  for (const auto& [basis, held] : {std::pair(&u_, &held_u_), std::pair(&phi_, &held_phi_)}) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> squares(*held * held->transpose());
    const Eigen::Index n = held->rows(), kept = basis->n() - n;
    for (Eigen::Index j = n; j-- > 0;) {
      Vector column = Vector::Zero(n_coordinates_);
      for (Eigen::Index i = 0; i < n; ++i)
        column[basis->coordinate[static_cast<std::size_t>(kept + i)]] = squares.eigenvectors()(i, j);
      columns.emplace_back(static_cast<double>(n - 1 - j) / static_cast<double>(n), std::move(column));
    }
  }
  std::stable_sort(columns.begin(), columns.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t j = 0; j < columns.size(); ++j)
    rotation.col(n_kept_ + static_cast<Eigen::Index>(j)) = columns[j].second;
  return rotation;
}

FieldBasis SnapshotBasis::phi_in(const Eigen::MatrixXd& rotation) const {
  FieldBasis turned{phi_.unknown, phi_.unit, {}, {}, phi_.layout};
  const Eigen::MatrixXd of_phi = rotation(phi_.coordinate, Eigen::all);
  for (Eigen::Index j = 0; j < of_phi.cols(); ++j)
    if (!of_phi.col(j).isZero(0.)) turned.coordinate.push_back(static_cast<int>(j));
  turned.vectors = product(phi_.columns(), of_phi(Eigen::all, turned.coordinate).eval());
  return turned;
}

}  // namespace upbead
