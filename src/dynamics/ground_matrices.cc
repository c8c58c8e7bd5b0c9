#include "dynamics/ground_matrices.h"

#include <Eigen/Eigenvalues>
#include <utility>

#include "algebra/dense.h"

namespace upbead {

namespace {

/// Orthonormal columns that span those of S, but for `least` of the largest; in two passes, as the squares of lengths
/// keep half of the digits.
Eigen::MatrixXd span_of(Eigen::MatrixXd S, double least) {
  Eigen::MatrixXd U(S.rows(), 0);
  double largest = 0.;
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(product(S, S.transpose()));
    if (pass == 0) largest = found.eigenvalues().tail<1>()[0];
    const double part = pass == 0 ? 1e-6 : least;
    const Eigen::Index k = (found.eigenvalues().array() > part * part * largest).count();
    if (k == 0) break;
    Eigen::MatrixXd added = found.eigenvectors().rightCols(k);
    added -= product(U, transposed_product(U, added));
    for (Eigen::Index j = 0; j < k; ++j) added.col(j).normalize();
    U.conservativeResize(Eigen::NoChange, U.cols() + k);
    U.rightCols(k) = added;
    S -= product(U, transposed_product(U, S));
  }
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

GroundMatrices::GroundMatrices(OfMatrices free, const OfMatrices& coupling, const OfMatrices& interface, double shift)
    : M_ff(std::move(free.M)),
      C_ff(std::move(free.C)),
      M_ii(interface.M),
      C_ii(interface.C),
      K_ii(interface.K),
      K_ff(free.K.diagonal()) {
  constexpr double least = 1e-11;
  const Eigen::Index r = n_free(), m = M_ii.rows();
  Eigen::MatrixXd all(m, 3 * r);
  all << shift * shift * coupling.M.transpose(), shift * coupling.C.transpose(), coupling.K.transpose();
  U = span_of(std::move(all), least);
  M_f = product(coupling.M, U);
  C_f = product(coupling.C, U);
  K_f = product(coupling.K, U);
  const Eigen::Index k = U.cols();
  of_free.resize(r + 3 * k, r);
  of_free << C_ff, M_f.transpose(), C_f.transpose(), K_f.transpose();
  of_along.resize(2 * r, k);
  of_along << C_f, K_f;
  of_interface.resize(2 * m, m);
  of_interface << C_ii, K_ii;
}

GroundProducts GroundMatrices::products(const Vector& a) const {
  const Eigen::Index r = n_free(), m = a.size() - r, k = U.cols();
  const auto free = a.head(r), interface = a.tail(m);
  const Vector by_free = product(of_free, free);
  GroundProducts out{Vector::Zero(a.size()), Vector::Zero(a.size())};
  out.C.head(r) = by_free.head(r);
  out.K.head(r) = K_ff.cwiseProduct(free);
  const Vector C_and_K = product(U, by_free.tail(2 * k).reshaped(k, 2)).reshaped();
  out.C.tail(m) = C_and_K.head(m);
  out.K.tail(m) = C_and_K.tail(m);
  if (interface.isZero(0.)) return out;
  const Vector along = product(of_along, transposed_product(U, interface)),
               own = product_of_some(of_interface, interface);
  out.C.head(r) += along.head(r);
  out.K.head(r) += along.tail(r);
  out.C.tail(m) += own.head(m);
  out.K.tail(m) += own.tail(m);
  return out;
}

Vector GroundMatrices::with_mass(const Vector& v) const {
  const Eigen::Index r = n_free(), m = v.size() - r;
  Vector out(v.size());
  out.head(r) = product(M_ff, v.head(r)) + product(M_f, transposed_product(U, v.tail(m)));
  out.tail(m) = product(U, transposed_product(M_f, v.head(r))) + product(M_ii, v.tail(m));
  return out;
}

}  // namespace upbead
