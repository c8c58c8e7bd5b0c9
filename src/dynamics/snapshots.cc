#include "dynamics/snapshots.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "algebra/dense.h"
#include "dynamics/frequency_response.h"
#include "dynamics/projection.h"

namespace upbead {

namespace {

using Complex = std::complex<double>;

constexpr double decay = 3.;  ///< of exp(-Re s t) over the end

/// Length of the columns of a reading over that of all loads: with a hundredth of it a family takes a third more
/// points.
constexpr double share_of_readings = 0.1;

/// Bound of |F(s)| / min(...) that counts at least.
constexpr double least_share = 0.1;

/// int |f| and the variation of f', of a load that is straight between samples.
struct Sizes {
  double area = 0., variation = 0.;
};

Sizes sizes_of(const SampledLoads& loads, Eigen::Index k) {
  Sizes sizes;
  double slope_before = 0.;
  for (Eigen::Index n = 0; n < loads.begin.cols(); ++n) {
    const double h = loads.time[static_cast<std::size_t>(n) + 1] - loads.time[static_cast<std::size_t>(n)];
    sizes.area += 0.5 * h * (std::abs(loads.begin(k, n)) + std::abs(loads.end(k, n)));
    const double slope = (loads.end(k, n) - loads.begin(k, n)) / h;
    sizes.variation += std::abs(slope - slope_before);
    slope_before = slope;
  }
  sizes.variation += std::abs(slope_before);
  return sizes;
}

/// Real and imaginary parts side by side.
Eigen::MatrixXd real_columns(const Eigen::MatrixXcd& X) {
  Eigen::MatrixXd columns(X.rows(), 2 * X.cols());
  columns << X.real(), X.imag();
  return columns;
}

/// Columns of loads side by side for each frequency; the last loads stand for readings.
void scale_readings(Eigen::MatrixXcd& Q, Eigen::Index n_loads, int n_readings) {
  const auto columns = [&](Eigen::Index k) { return Q(Eigen::all, Eigen::seqN(k, Q.cols() / n_loads, n_loads)); };
  double of_loads = 0.;
  for (Eigen::Index k = 0; k < n_loads - n_readings; ++k) of_loads += columns(k).squaredNorm();
  for (Eigen::Index k = n_loads - n_readings; k < n_loads; ++k)
    if (const double own = columns(k).norm(); own > 0.) columns(k) *= share_of_readings * std::sqrt(of_loads) / own;
}

/// Coordinates of both kinds by column: those of X(s_j) under each load.
Eigen::MatrixXd coordinates(const ReducedSystem& reduced, const SnapshotOptions& options) {
  const auto n = static_cast<Eigen::Index>(options.frequencies.size());
  const Eigen::Index loads = options.weights.rows();
  Eigen::MatrixXcd Q(reduced.size(), n * loads);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::MatrixXcd F = options.weights.col(j).cast<Complex>().asDiagonal();
    Q.middleCols(j * loads, loads) = coordinates_at(reduced, options.frequencies[static_cast<std::size_t>(j)], F);
  }
  scale_readings(Q, loads, options.n_readings);
  return real_columns(Q);
}

/// The left singular vectors of the columns, times their singular values: fewer columns hold the same products X X'.
/// What is below a billionth of the largest is left out, far less than any basis leaves out of snapshots.
Eigen::MatrixXd condensed(const Eigen::MatrixXd& columns) {
  constexpr double negligible = 1e-9;
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(columns, Eigen::ComputeThinU);
  const Vector& sizes = svd.singularValues();
  const Eigen::Index n = (sizes.array() > negligible * sizes[0]).count();
  return svd.matrixU().leftCols(n) * sizes.head(n).asDiagonal();
}

Eigen::MatrixXd of_field(const FieldBasis& basis, const Eigen::MatrixXd& Q) {
  if (basis.coordinate.empty()) return Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(basis.unknown.size()), 0);
  const Eigen::MatrixXd of_basis = Q(basis.coordinate, Eigen::all);
  return basis.unit.asDiagonal() * product(basis.columns(), condensed(of_basis));
}

}  // namespace

Snapshots snapshots(const System& system, const SnapshotOptions& options) {
  SecondOrderKrylov krylov(system, options.shift, options.exact);
  const int wanted = options.vectors * krylov.n_independent_loads();
  while (krylov.n_vectors() < wanted && krylov.extend_together())
    if (options.progress) options.progress(static_cast<double>(krylov.n_vectors()) / wanted);
  const Projection projection(system, krylov);
  Eigen::MatrixXd Q = coordinates(projection.reduced(), options);
  Q /= Q.norm();
  return {of_field(krylov.displacements(), Q), of_field(krylov.phi(), Q), projection.reduced()};
}

std::vector<Complex> snapshot_frequencies(double end, double highest, int most) {
  const double real = decay / end;
  const int n = std::clamp(static_cast<int>(std::ceil(highest / real)), 2, most);
  std::vector<Complex> s;
  for (int j = 0; j < n; ++j) s.emplace_back(real, highest * j / (n - 1));
  return s;
}

Eigen::MatrixXd snapshot_weights(const SampledLoads& loads, const std::vector<Complex>& frequencies) {
  Eigen::MatrixXd weights(loads.begin.rows(), static_cast<Eigen::Index>(frequencies.size()));
  for (Eigen::Index j = 0; j < weights.cols(); ++j) {
    const Complex s = frequencies[static_cast<std::size_t>(j)];
    weights.col(j) = laplace_transform(loads, s).cwiseAbs();
    for (Eigen::Index k = 0; k < weights.rows(); ++k) {
      const Sizes sizes = sizes_of(loads, k);
      weights(k, j) = std::max(weights(k, j), least_share * std::min(sizes.area, sizes.variation / std::norm(s)));
    }
  }
  for (Eigen::Index k = 0; k < weights.rows(); ++k)
    if (const double largest = weights.row(k).maxCoeff(); largest > 0.) weights.row(k) /= largest;
  return weights;
}

}  // namespace upbead
