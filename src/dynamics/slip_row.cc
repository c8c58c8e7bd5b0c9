#include "dynamics/slip_row.h"

#include <stdexcept>

#include "dynamics/slip_model.h"

namespace upbead {

namespace {

/// The row without its own diagonal, in the numbers of the unknowns without that of the slip; the diagonal to `own`.
Row beside_diagonal(const SparseMatrix& A, Eigen::Index slip, double& own) {
  Row row;
  own = 0.;
  for (SparseMatrix::InnerIterator entry(A, slip); entry; ++entry) {
    const Eigen::Index column = entry.col();
    if (column == slip)
      own += entry.value();
    else if (entry.value() != 0.)
      row.emplace_back(static_cast<int>(column < slip ? column : column - 1), entry.value());
  }
  return row;
}

double weight_of(const Row& row, Eigen::Index unknown) {
  double sum = 0.;
  for (const auto& [i, weight] : row)
    if (i == unknown) sum += weight;
  return sum;
}

}  // namespace

SlipRow slip_row(const System& slipping) {
  constexpr std::size_t own_readings = 2;  // s and s'
  if (slipping.loads.empty() || slipping.loads.back().name != slip_name::friction ||
      slipping.readings.size() < own_readings)
    throw std::invalid_argument("a system that slips has the load and the readings of its slip");
  Eigen::Index slip = 0;
  slipping.loads.back().vector.cwiseAbs().maxCoeff(&slip);
  SlipRow out;
  out.M = beside_diagonal(slipping.M, slip, out.m);
  out.C = beside_diagonal(slipping.C, slip, out.c);
  out.K = beside_diagonal(slipping.K, slip, out.k);
  out.unit = -slipping.loads.back().vector[slip];
  for (std::size_t k = 0; k + 1 < slipping.loads.size(); ++k) {
    const Vector& b = slipping.loads[k].vector;
    out.load.push_back(b.size() > 0 ? b[slip] : 0.);
  }
  for (std::size_t i = 0; i + own_readings < slipping.readings.size(); ++i) {
    const Reading& reading = slipping.readings[i];
    out.position.push_back(weight_of(reading.position, slip));
    out.velocity.push_back(weight_of(reading.velocity, slip));
    out.acceleration.push_back(weight_of(reading.acceleration, slip));
  }
  return out;
}

}  // namespace upbead
