#include "upbead/dynamics/state_model.h"

#include <algorithm>
#include <cmath>

#include "algebra/dense.h"

namespace upbead {

namespace {

/// Puts V q of one kind of unknowns into its rows of `x`.
void add_field(const FieldBasis& basis, const Eigen::MatrixXd& q, Eigen::MatrixXd& x) {
  if (basis.unknown.empty()) return;
  const Eigen::MatrixXd of_basis = q(basis.coordinate, Eigen::all);
  const Eigen::MatrixXd values = product(basis.columns(), of_basis);
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    for (std::size_t i = 0; i < basis.unknown.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      x(basis.unknown[i], j) = basis.unit[row] * values(row, j);
    }
}

/// The energies of `q` and `v`, column by column (J/m).
Eigen::RowVectorXd energies(const ReducedSystem& system, const Eigen::MatrixXd& q, const Eigen::MatrixXd& v) {
  Eigen::VectorXd sign(system.size());
  for (int i = 0; i < system.size(); ++i) sign[i] = system.is_phi[static_cast<std::size_t>(i)] ? -1. : 1.;
  const auto squares = [&sign](const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& x) -> Eigen::RowVectorXd {
    return (sign.asDiagonal() * x).cwiseProduct(product(matrix, x)).colwise().sum();
  };
  return 0.5 * (squares(system.M, v) + squares(system.K, q));
}

Eigen::MatrixXd difference(Eigen::MatrixXd fine, const Eigen::MatrixXd& coarse) {
  fine.topRows(coarse.rows()) -= coarse;
  return fine;
}

}  // namespace

CoordinateSeries respond_in_coordinates(const ModalModel& model, const SampledLoads& loads) {
  Series series = respond(model, loads);
  const Eigen::Index n = series.reading.rows() / 3;
  return {std::move(series.time), series.reading.topRows(n), series.reading.middleRows(n, n),
          series.reading.bottomRows(n)};
}

void for_each_state(const StateModel& model, const CoordinateSeries& series, const std::vector<Eigen::Index>& times,
                    const std::function<void(const State&, Eigen::Index)>& see) {
  constexpr std::size_t most = 16;  // states at once: enough for products of matrices, little memory
  const auto size = static_cast<Eigen::Index>(model.displacements.unknown.size() + model.phi.unknown.size());
  for (std::size_t first = 0; first < times.size(); first += most) {
    const std::vector<Eigen::Index> block(
        times.begin() + static_cast<std::ptrdiff_t>(first),
        times.begin() + static_cast<std::ptrdiff_t>(std::min(first + most, times.size())));
    const auto n = static_cast<Eigen::Index>(block.size());
    Eigen::MatrixXd q(series.position.rows(), 3 * n), x = Eigen::MatrixXd::Zero(size, 3 * n);
    q << series.position(Eigen::all, block), series.velocity(Eigen::all, block), series.acceleration(Eigen::all, block);
    add_field(model.displacements, q, x);
    add_field(model.phi, q, x);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index at = block[static_cast<std::size_t>(i)];
      see({series.time[static_cast<std::size_t>(at)], x.col(i), x.col(n + i), x.col(2 * n + i)}, at);
    }
  }
}

double energy_distance(const ReducedSystem& system, const CoordinateSeries& fine, const CoordinateSeries& coarse) {
  const double largest = energies(system, fine.position, fine.velocity).maxCoeff();
  if (!(largest > 0.)) return 0.;
  const Eigen::RowVectorXd apart =
      energies(system, difference(fine.position, coarse.position), difference(fine.velocity, coarse.velocity));
  return std::sqrt(std::max(0., apart.maxCoeff()) / largest);
}

}  // namespace upbead
