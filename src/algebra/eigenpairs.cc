#include "algebra/eigenpairs.h"

#include <petscsys.h>
// after petscsys.h, which it needs
#include <petscblaslapack.h>

#include <vector>

#include "blas_turn.h"
#include "upbead/base/error.h"

namespace upbead {

Eigenpairs eigenpairs(Eigen::MatrixXd A) {
  const auto n = static_cast<PetscBLASInt>(A.rows());
  PetscBLASInt info = 0, size = -1;
  Eigen::VectorXd real(n), imaginary(n);
  Eigen::MatrixXd X(n, n);
  double best_size = 0.;
  const auto call = [&](double* work) {
    LAPACKgeev_("N", "V", &n, A.data(), &n, real.data(), imaginary.data(), nullptr, &n, X.data(), &n, work, &size,
                &info);
  };
  const auto turn = detail::blas_turn();
  call(&best_size);  // asks for the size of the work space
  size = static_cast<PetscBLASInt>(best_size);
  std::vector<double> work(static_cast<std::size_t>(size));
  call(work.data());
  if (info != 0) throw NumericsError("the eigenvalues of the reduced model do not converge");
  Eigenpairs pairs{real + std::complex<double>(0., 1.) * imaginary, Eigen::MatrixXcd(n, n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    if (imaginary[j] == 0.) {
      pairs.vector.col(j) = X.col(j).cast<std::complex<double>>();
    } else {  // columns j and j + 1 hold the real and imaginary parts
      pairs.vector.col(j) = X.col(j) + std::complex<double>(0., 1.) * X.col(j + 1);
      pairs.vector.col(j + 1) = pairs.vector.col(j).conjugate();
      ++j;
    }
  }
  return pairs;
}

}  // namespace upbead
