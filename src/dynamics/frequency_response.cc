#include "dynamics/frequency_response.h"

#include "algebra/dense.h"

namespace upbead {

Eigen::VectorXcd laplace_transform(const SampledLoads& loads, std::complex<double> s) {
  Eigen::VectorXcd F = Eigen::VectorXcd::Zero(loads.begin.rows());
  for (Eigen::Index n = 0; n < loads.begin.cols(); ++n) {
    const double t = loads.time[n], h = loads.time[static_cast<std::size_t>(n) + 1] - t;
    const std::complex<double> decay = std::exp(-s * h), start = std::exp(-s * t);
    const std::complex<double> whole = (1. - decay) / s, moment = (1. - decay * (1. + s * h)) / (s * s);
    F += start * (whole * loads.begin.col(n) + moment / h * (loads.end.col(n) - loads.begin.col(n)));
  }
  return F;
}

Eigen::MatrixXcd coordinates_at(const ReducedSystem& reduced, std::complex<double> s, const Eigen::MatrixXcd& F) {
  const Eigen::Index p = reduced.n_prescribed, n = reduced.size() - p;
  const Eigen::MatrixXcd A = s * s * reduced.M + s * reduced.C + reduced.K;
  Eigen::MatrixXcd q = Eigen::MatrixXcd::Zero(p + n, F.cols());
  for (std::size_t k = 0; k < reduced.prescribed.size(); ++k)
    if (reduced.prescribed[k] >= 0) q.row(reduced.prescribed[k]) += F.row(static_cast<Eigen::Index>(k)) / s;
  const Eigen::MatrixXcd b = reduced.load * F - A.leftCols(p) * q.topRows(p);
  q.bottomRows(n) = solve_complex(A.bottomRightCorner(n, n), b.bottomRows(n));
  return q;
}

Eigen::VectorXcd frequency_response(const SecondOrderKrylov& krylov, const ReducedSystem& reduced,
                                    std::complex<double> s, const Eigen::VectorXcd& F) {
  const Eigen::VectorXcd q = coordinates_at(reduced, s, F);
  Eigen::VectorXcd x = Eigen::VectorXcd::Zero(krylov.displacements().unknown.size() + krylov.phi().unknown.size());
  for (const FieldBasis* basis : {&krylov.displacements(), &krylov.phi()}) {
    const Eigen::VectorXcd values = basis->columns() * q(basis->coordinate);
    x(basis->unknown) = basis->unit.cwiseProduct(values);
  }
  return x;
}

}  // namespace upbead
