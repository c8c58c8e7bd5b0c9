// The steady response of a system to harmonic loads: i omega in place of d/dt in the same M, C and K.
#pragma once

#include <Eigen/UmfPackSupport>
#include <complex>

#include "upbead/system/system.h"

namespace upbead::test {

using Complex = std::complex<double>;
using ComplexVector = Eigen::VectorXcd;

/// Solves (-omega^2 M + i omega C + K) x = sum_k b_k F_k by UMFPACK, which comes with deal.II; omega = 0 gives the
/// static response of a system whose K is regular. A load that prescribes an unknown gives x_p = F_k / (i omega).
class FrequencyResponse {
 public:
  /// omega in rad/s. Throws std::runtime_error where the matrix is singular.
  FrequencyResponse(const System& system, double omega);
  /// x at amplitudes F_k, one per load.
  ComplexVector operator()(const std::vector<Complex>& load) const;
  /// x under a right-hand side over the free unknowns, nothing prescribed moving.
  ComplexVector solve(const ComplexVector& right_side) const;
  /// Amplitude of a reading of x.
  Complex read(const Reading& reading, const ComplexVector& x, const std::vector<Complex>& load) const;

 private:
  using Matrix = Eigen::SparseMatrix<Complex>;
  const System& system_;
  double omega_;
  Matrix matrix_;  ///< over all unknowns
  Eigen::VectorXd scale_;
  Matrix free_;  ///< over the free unknowns, scaled; UMFPACK refines its solutions with this matrix
  Eigen::UmfPackLU<Matrix> factors_;
};

}  // namespace upbead::test
