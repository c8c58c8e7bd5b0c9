#include "dynamics/projection.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "algebra/dense.h"

namespace upbead {

namespace {

/// Row by row, so that a sparse matrix is read once for all columns.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Columns that are multiplied at once: products with those behind them follow by symmetry, and are half of all.
constexpr Eigen::Index projected_at_once = 64;

/// V^T P.
Eigen::MatrixXd gram_of(const Eigen::Ref<const Eigen::MatrixXd>& V, const Columns& P) {
  return product(Eigen::Map<const Eigen::MatrixXd>(P.data(), P.cols(), P.rows()), V).transpose();
}

/// A(rows, columns) for ascending index lists.
SparseMatrix block(const SparseMatrix& A, const std::vector<int>& rows, const std::vector<int>& columns) {
  std::vector<int> local(static_cast<std::size_t>(A.cols()), -1);
  for (std::size_t j = 0; j < columns.size(); ++j) local[columns[j]] = static_cast<int>(j);
  SparseMatrix B(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    B.startVec(static_cast<Eigen::Index>(i));
    for (SparseMatrix::InnerIterator entry(A, rows[i]); entry; ++entry)
      if (const int j = local[entry.col()]; j >= 0 && entry.value() != 0.)
        B.insertBack(static_cast<Eigen::Index>(i), j) = entry.value();
  }
  B.finalize();
  return B;
}

/// Whether a row holds an entry that is not zero.
bool has_row(const SparseMatrix& A, int row) {
  for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry)
    if (entry.value() != 0.) return true;
  return false;
}

SparseMatrix row_matrix(const std::vector<Reading>& readings, Row Reading::*part, int n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < readings.size(); ++i)
    for (const auto& [j, weight] : readings[i].*part) entries.emplace_back(static_cast<int>(i), j, weight);
  SparseMatrix rows(static_cast<Eigen::Index>(readings.size()), n);
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

ReducedSystem without_coordinates(const System& system, double shift) {
  ReducedSystem out;
  out.shift = shift;
  out.n_prescribed = system.n_prescribed;
  const auto I = static_cast<Eigen::Index>(system.readings.size()), K = static_cast<Eigen::Index>(system.loads.size());
  out.feedthrough.setZero(I, K);
  for (Eigen::Index i = 0; i < I; ++i) {
    const Reading& reading = system.readings[i];
    for (std::size_t k = 0; k < reading.feedthrough.size(); ++k)
      out.feedthrough(i, static_cast<Eigen::Index>(k)) = reading.feedthrough[k];
    out.reading_label.push_back({reading.name.text(), reading.unit, reading.description});
  }
  for (const SystemLoad& load : system.loads) {
    out.load_name.push_back(load.name);
    out.prescribed.push_back(load.prescribed < 0 ? -1 : load.prescribed - system.n_free());
  }
  out.load.resize(0, K);
  out.position.resize(I, 0);
  out.velocity.resize(I, 0);
  out.acceleration.resize(I, 0);
  return out;
}

/// Enlarges a matrix with zeros.
void grow(Eigen::MatrixXd& A, Eigen::Index rows, Eigen::Index columns) {
  A.conservativeResizeLike(Eigen::MatrixXd::Zero(rows, columns));
}

}  // namespace

Projection::Projection(const System& system, const SecondOrderKrylov& krylov)
    : Projection(system, krylov.displacements(), krylov.phi(), krylov.shift()) {}

Projection::Projection(const System& system, const FieldBasis& displacements, const FieldBasis& phi, double shift)
    : matrices_(std::make_shared<const Matrices>(matrices_of(system, displacements, phi))),
      u_{displacements, matrices_->u, 0},
      phi_{phi, matrices_->phi, 0},
      reduced_(without_coordinates(system, shift)) {
  u_.basis.layout.add_up(reduced_.feedthrough);
  extend();
}

Projection::Projection(const Projection& of, ReducedSystem reduced, const FieldBasis& displacements,
                       const FieldBasis& phi)
    : matrices_(of.matrices_),
      u_{displacements, matrices_->u, displacements.n()},
      phi_{phi, matrices_->phi, phi.n()},
      reduced_(std::move(reduced)) {}

Projection::Matrices Projection::matrices_of(const System& system, const FieldBasis& displacements,
                                             const FieldBasis& phi) {
  const auto coupling = [&](const SparseMatrix& A) -> SparseMatrix {
    return phi.unit.asDiagonal() * block(A, phi.unknown, displacements.unknown) * displacements.unit.asDiagonal();
  };
  Matrices out{blocks_of(system, displacements),
               blocks_of(system, phi),
               coupling(system.C),
               row_matrix(system.readings, &Reading::position, system.size()),
               row_matrix(system.readings, &Reading::velocity, system.size()),
               row_matrix(system.readings, &Reading::acceleration, system.size()),
               {}};
  for (const SystemLoad& load : system.loads) out.loads.push_back(load.vector);
  if (coupling(system.M).nonZeros() + coupling(system.K).nonZeros() > 0)
    throw std::logic_error("M or K couples phi with displacements: they cannot be projected apart");
  return out;
}

Projection::Blocks Projection::blocks_of(const System& system, const FieldBasis& basis) {
  std::vector<int> rows, unknown;
  for (std::size_t i = 0; i < basis.unknown.size(); ++i)
    if (const int u = basis.unknown[i]; has_row(system.M, u) || has_row(system.C, u) || has_row(system.K, u)) {
      rows.push_back(static_cast<int>(i));
      unknown.push_back(u);
    }
  const Vector unit = basis.unit(rows);
  const auto scaled = [&](const SparseMatrix& A) -> SparseMatrix {
    return unit.asDiagonal() * block(A, unknown, unknown) * unit.asDiagonal();
  };
  return {rows, scaled(system.M), scaled(system.C), scaled(system.K)};
}

Eigen::MatrixXd Projection::columns_of(const Group& group) {
  return group.basis.vectors(group.blocks.rows, Eigen::seqN(0, group.basis.n()));
}

void Projection::extend() {
  resize();
  project_coupling();
  project(u_);
  project(phi_);
}

void Projection::resize() {
  const Eigen::Index R = u_.basis.n() + phi_.basis.n();
  for (Eigen::MatrixXd* A : {&reduced_.M, &reduced_.C, &reduced_.K}) grow(*A, R, R);
  grow(reduced_.load, R, reduced_.load.cols());
  for (Eigen::MatrixXd* rows : {&reduced_.position, &reduced_.velocity, &reduced_.acceleration})
    grow(*rows, rows->rows(), R);
  reduced_.is_phi.assign(static_cast<std::size_t>(R), false);
  for (const int coordinate : phi_.basis.coordinate) reduced_.is_phi[coordinate] = true;
}

void Projection::project(Group& group) {
  const std::vector<int>& coordinate = group.basis.coordinate;
  using ColumnsOfBasis = Eigen::Ref<const Eigen::MatrixXd>;
  const bool on_all_rows = static_cast<Eigen::Index>(group.blocks.rows.size()) == group.basis.vectors.rows();
  const Eigen::MatrixXd some = on_all_rows ? Eigen::MatrixXd() : columns_of(group);
  const ColumnsOfBasis all = on_all_rows ? ColumnsOfBasis(group.basis.columns()) : ColumnsOfBasis(some);
  const bool alone = group.basis.layout.is_alone();
  for (Eigen::Index first = group.n_projected; first < all.cols(); first += projected_at_once) {
    const Eigen::Index n = std::min(projected_at_once, all.cols() - first);
    const Columns added = all.middleCols(first, n);
    const auto fill = [&](const SparseMatrix& A, Eigen::MatrixXd& reduced) {
      if (alone && A.nonZeros() == 0) return;
      Eigen::MatrixXd gram = gram_of(all.leftCols(first + n), A * added);
      group.basis.layout.add_up(gram);
      for (Eigen::Index i = 0; i < gram.rows(); ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
          const int row = coordinate[i], column = coordinate[first + j];
          reduced(row, column) = reduced(column, row) = gram(i, j);
        }
    };
    fill(group.blocks.M, reduced_.M);
    fill(group.blocks.C, reduced_.C);
    fill(group.blocks.K, reduced_.K);
  }
  project_rows(group);
  project_loads(group);
  group.n_projected = group.basis.n();
}

/// Entries of C between phi and u for new directions: new u with all phi, then new phi with old u.
void Projection::project_coupling() {
  if (u_.basis.layout.is_alone() && matrices_->C_phiu.nonZeros() == 0) return;
  const auto fill = [&](Eigen::MatrixXd gram, Eigen::Index first_phi, Eigen::Index first_u) {
    u_.basis.layout.add_up(gram);
    for (Eigen::Index i = 0; i < gram.rows(); ++i)
      for (Eigen::Index j = 0; j < gram.cols(); ++j) {
        const int row = phi_.basis.coordinate[first_phi + i];
        const int column = u_.basis.coordinate[first_u + j];
        reduced_.C(row, column) = reduced_.C(column, row) = gram(i, j);
      }
  };
  const Columns new_u = u_.basis.columns_from(u_.n_projected), new_phi = phi_.basis.columns_from(phi_.n_projected);
  fill(gram_of(phi_.basis.columns(), matrices_->C_phiu * new_u), 0, u_.n_projected);
  const Columns of_new_phi = matrices_->C_phiu.transpose() * new_phi;
  fill(gram_of(u_.basis.vectors.leftCols(u_.n_projected), of_new_phi).transpose(), phi_.n_projected, 0);
}

void Projection::project_rows(const Group& group) {
  const FieldBasis& basis = group.basis;
  std::vector<int> local(static_cast<std::size_t>(matrices_->position.cols()), -1);
  for (std::size_t i = 0; i < basis.unknown.size(); ++i) local[basis.unknown[i]] = static_cast<int>(i);
  const Eigen::Index first = group.n_projected, n = basis.n() - first;
  const auto project = [&](const SparseMatrix& rows, Eigen::MatrixXd& reduced) {
    Eigen::MatrixXd added = Eigen::MatrixXd::Zero(rows.rows(), n);
    for (int i = 0; i < rows.rows(); ++i)
      for (SparseMatrix::InnerIterator entry(rows, i); entry; ++entry)
        if (const int j = local[entry.col()]; j >= 0)
          for (Eigen::Index c = 0; c < n; ++c)
            added(i, c) += entry.value() * (basis.unit[j] * basis.vectors(j, first + c));
    basis.layout.add_up(added);
    for (Eigen::Index c = 0; c < n; ++c) reduced.col(basis.coordinate[first + c]) = added.col(c);
  };
  project(matrices_->position, reduced_.position);
  project(matrices_->velocity, reduced_.velocity);
  project(matrices_->acceleration, reduced_.acceleration);
}

void Projection::project_loads(const Group& group) {
  const FieldBasis& basis = group.basis;
  const Eigen::Index first = group.n_projected, n = basis.n() - first;
  for (std::size_t k = 0; k < matrices_->loads.size(); ++k) {
    if (matrices_->loads[k].size() == 0) continue;
    const Vector scaled = basis.unit.cwiseProduct(matrices_->loads[k](basis.unknown));
    Vector added(n);
    for (Eigen::Index c = 0; c < n; ++c) added[c] = scaled.dot(basis.vectors.col(first + c));
    basis.layout.add_up(added);
    for (Eigen::Index c = 0; c < n; ++c)
      reduced_.load(basis.coordinate[first + c], static_cast<Eigen::Index>(k)) = added[c];
  }
}

}  // namespace upbead
