#include "system/affine_system.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace upbead {

namespace {

void add(SparseMatrix& to, const SparseMatrix& part, double factor) {
  if (part.nonZeros() > 0) to += factor * part;
}

SparseMatrix difference(const SparseMatrix& one, const SparseMatrix& other) {
  SparseMatrix rest = one - other;
  rest.prune([](Eigen::Index, Eigen::Index, double value) { return value != 0.; });
  return rest;
}

constexpr Row Reading::*rows_of_reading[] = {&Reading::position, &Reading::velocity, &Reading::acceleration};

/// Largest |entry| of each row; 1 of an empty one.
Vector scales(const SparseMatrix& A) {
  Vector scale = Vector::Zero(A.rows());
  for (int i = 0; i < A.rows(); ++i)
    for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
      scale[i] = std::max(scale[i], std::abs(entry.value()));
  return (scale.array() > 0.).select(scale, 1.);
}

double distance(const SparseMatrix& one, const SparseMatrix& other) {
  const Vector scale = scales(one);
  const SparseMatrix apart = one - other;
  double largest = 0.;
  for (int i = 0; i < apart.rows(); ++i)
    for (SparseMatrix::InnerIterator entry(apart, i); entry; ++entry)
      largest = std::max(largest, std::abs(entry.value()) / std::sqrt(scale[i] * scale[entry.col()]));
  return largest;
}

double largest_in(const Row& row) {
  double largest = 0.;
  for (const auto& [unknown, weight] : row) largest = std::max(largest, std::abs(weight));
  return largest;
}

double distance(const Row& one, const Row& other) {
  const double scale = std::max(largest_in(one), largest_in(other));
  return scale > 0. ? largest_in(sum(one, other, -1.)) / scale : 0.;
}

}  // namespace

Row sum(const Row& a, const Row& b, double factor) {
  std::map<int, double> entries(a.begin(), a.end());
  for (const auto& [unknown, weight] : b) entries[unknown] += factor * weight;
  Row row;
  for (const auto& entry : entries)
    if (entry.second != 0.) row.push_back(entry);
  return row;
}

System AffineSystem::at(const std::vector<double>& factors) const {
  if (factors.size() != parts.size()) throw std::invalid_argument("a sum of systems needs a factor for each part");
  System system = fixed;
  for (std::size_t q = 0; q < parts.size(); ++q) {
    const System& part = parts[q];
    add(system.M, part.M, factors[q]);
    add(system.C, part.C, factors[q]);
    add(system.K, part.K, factors[q]);
    add(system.radiation, part.radiation, factors[q]);
    for (std::size_t i = 0; i < system.readings.size(); ++i)
      for (Row Reading::*row : rows_of_reading)
        if (!(part.readings[i].*row).empty())
          system.readings[i].*row = sum(system.readings[i].*row, part.readings[i].*row, factors[q]);
  }
  return system;
}

System difference(const System& one, const System& other) {
  System rest = one;
  rest.M = difference(one.M, other.M);
  rest.C = difference(one.C, other.C);
  rest.K = difference(one.K, other.K);
  rest.radiation = difference(one.radiation, other.radiation);
  for (SystemLoad& load : rest.loads) load.vector.resize(0);
  for (std::size_t i = 0; i < rest.readings.size(); ++i)
    for (Row Reading::*row : rows_of_reading)
      rest.readings[i].*row = sum(one.readings[i].*row, other.readings[i].*row, -1.);
  return rest;
}

double distance(const System& one, const System& other) {
  double largest = std::max({distance(one.M, other.M), distance(one.C, other.C), distance(one.K, other.K)});
  for (std::size_t i = 0; i < one.readings.size(); ++i)
    for (Row Reading::*row : rows_of_reading)
      largest = std::max(largest, distance(one.readings[i].*row, other.readings[i].*row));
  for (std::size_t k = 0; k < one.loads.size(); ++k)
    largest = std::max(largest, (one.loads[k].vector - other.loads[k].vector).cwiseAbs().maxCoeff() /
                                    std::max(1e-300, one.loads[k].vector.cwiseAbs().maxCoeff()));
  return largest;
}

}  // namespace upbead
