#include "dynamics/ground_matrices.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <utility>

#include "algebra/dense.h"

namespace upbead {

namespace {

/// Orthonormal columns that span those of `exactly`, and those of S but for `least` of their length.
Eigen::MatrixXd span_of(const Eigen::MatrixXd& exactly, Eigen::MatrixXd S, double least) {
  constexpr double round_off = 1e-11;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> first;
  first.setThreshold(round_off);
  first.compute(exactly);
  Eigen::MatrixXd U = first.householderQ() * Eigen::MatrixXd::Identity(S.rows(), first.rank());
  const double shortest = least * S.norm();
  S -= product(U, transposed_product(U, S));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(product(S, S.transpose()));
  const Eigen::Index k = (found.eigenvalues().array() > shortest * shortest).count();
  Eigen::MatrixXd added = found.eigenvectors().rightCols(k);
  for (int pass = 0; pass < 2 && k > 0; ++pass) {  // squares of lengths keep half of the digits
    added -= product(U, transposed_product(U, added));
    added = (added.householderQr().householderQ() * Eigen::MatrixXd::Identity(S.rows(), k)).eval();
  }
  U.conservativeResize(Eigen::NoChange, U.cols() + k);
  U.rightCols(k) = added;
  return U;
}

}  // namespace

Vector product_of_some(const Eigen::MatrixXd& A, const Eigen::Ref<const Vector>& x) {
  Vector y = Vector::Zero(A.rows());
  const Eigen::Index half = x.size() / 2;
  for (const Eigen::Index begin : {Eigen::Index(0), half}) {
    Eigen::Index first = begin, last = begin == 0 ? half : x.size();
    while (first < last && x[first] == 0.) ++first;
    while (last > first && x[last - 1] == 0.) --last;
    if (last > first) y += product(A.middleCols(first, last - first), x.segment(first, last - first));
  }
  return y;
}

GroundMatrices::GroundMatrices(OfMatrices free, const OfMatrices& coupling, const OfMatrices& interface,
                               const Eigen::MatrixXd& exactly, Eigen::Index n_diagonal, double shift)
    : M_ff(std::move(free.M)),
      C_ff(std::move(free.C)),
      M_ii(interface.M),
      C_ii(interface.C),
      K_ii(interface.K),
      K_ff(free.K.diagonal()),
      M_diagonal_(Vector::Zero(K_ff.size())) {
  constexpr double least = 1e-5;
  const Eigen::Index r = n_free(), m = M_ii.rows();
  Eigen::MatrixXd all(m, 3 * r);
  all << shift * shift * coupling.M.transpose(), shift * coupling.C.transpose(), coupling.K.transpose();
  U = span_of(exactly, std::move(all), least);
  M_f = product(coupling.M, U);
  C_f = product(coupling.C, U);
  K_f = product(coupling.K, U);
  from_along_.resize(2 * r, U.cols());
  from_along_ << M_f, K_f;
  to_along_.resize(r, 2 * U.cols());
  to_along_ << C_f, K_f;
  interface_.resize(2 * m, m);
  interface_ << C_ii, K_ii;
  M_diagonal_.head(n_diagonal) = M_ff.diagonal().head(n_diagonal);
  if (const auto rest = M_ff.bottomRightCorner(r - n_diagonal, r - n_diagonal); !rest.isZero(0.)) M_rest_ = rest;
  M_ff = M_diagonal_.asDiagonal();
  M_ff.bottomRightCorner(M_rest_.rows(), M_rest_.rows()) += M_rest_;
}

Vector GroundMatrices::with_along(const Vector& v) const {
  Vector out(v.size() + U.cols());
  out << v, transposed_product(U, v.tail(U.rows()));
  return out;
}

GroundProducts GroundMatrices::products(const Vector& v) const {
  const Eigen::Index r = n_free(), m = U.rows();
  const auto with = [&](const Vector& of_free, const Eigen::MatrixXd& A, const Eigen::MatrixXd& ii) {
    Vector out(v.size());
    out << of_free + product(A, v.tail(U.cols())), product(ii, v.segment(r, m)), transposed_product(A, v.head(r));
    return out;
  };
  return {with(product(M_ff, v.head(r)), M_f, M_ii), with(product(C_ff, v.head(r)), C_f, C_ii),
          with(K_ff.cwiseProduct(v.head(r)), K_f, K_ii)};
}

/// In the rows of free coordinates C a is what M a and K a leave of rhs, in those of the interface M a is.
GroundProducts GroundMatrices::products(const Vector& a, const Vector& rhs, double g) const {
  const Eigen::Index r = n_free(), m = U.rows(), k = U.cols(), n_rest = M_rest_.rows();
  const auto free = a.head(r);
  GroundProducts out{Vector(a.size()), Vector::Zero(a.size()), Vector::Zero(a.size())};
  out.M.head(r) = M_diagonal_.cwiseProduct(free);
  if (n_rest > 0) out.M.segment(r - n_rest, n_rest) += product(M_rest_, free.tail(n_rest));
  out.K.head(r) = K_ff.cwiseProduct(free);
  const Vector C_and_K = transposed_product(to_along_, free);
  out.C.tail(k) = C_and_K.head(k);
  out.K.tail(k) = C_and_K.tail(k);
  if (const auto interface = a.segment(r, m); !interface.isZero(0.)) {
    const Vector along = product(from_along_, a.tail(k)), own = product_of_some(interface_, interface);
    out.M.head(r) += along.head(r);
    out.K.head(r) += along.tail(r);
    out.C.segment(r, m) = own.head(m);
    out.K.segment(r, m) = own.tail(m);
  }
  out.C.head(r) = (rhs.head(r) - out.M.head(r) - g * g * out.K.head(r)) / g;
  out.M.tail(m + k) = rhs.tail(m + k) - g * out.C.tail(m + k) - g * g * out.K.tail(m + k);
  return out;
}

}  // namespace upbead
