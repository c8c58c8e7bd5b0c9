#include "dynamics/carried_motions.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra/dense.h"
#include "algebra/factorisation.h"
#include "dynamics/products.h"

namespace upbead {

namespace {

constexpr Eigen::Index all_degrees = 14;  ///< beyond about 20 polynomials are not independent in doubles
/// Layers of unknowns around the interface, each of those that share a cell with the one before: at least 12, and a
/// layer for every 12 nodes, so that a finer mesh has a patch as deep. With 161 nodes 40 layers give the same S to
/// 1e-5.
constexpr int least_layers = 12, nodes_of_layer = 12;

/// Orthonormal functions of the nodes: polynomials of rising degree as far as these are independent.
Eigen::MatrixXd polynomials(const std::vector<double>& position, Eigen::Index n_degrees) {
  const auto n = static_cast<Eigen::Index>(position.size());
  const double first = position.front(), length = std::max(position.back() - first, 1e-300);
  Eigen::MatrixXd values(n, n_degrees);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = 2. * (position[static_cast<std::size_t>(i)] - first) / length - 1.;
    double now = 1., next = x;  // Chebyshev's, by their recurrence
    for (Eigen::Index k = 0; k < n_degrees; ++k) {
      values(i, k) = now;
      now = std::exchange(next, 2. * x * next - now);
    }
  }
  return values.householderQr().householderQ() * Eigen::MatrixXd::Identity(n, n_degrees);
}

/// A(rows, columns) for ascending index lists.
SparseMatrix part_of(const SparseMatrix& A, const std::vector<int>& rows, const std::vector<int>& columns) {
  std::vector<int> local(static_cast<std::size_t>(A.cols()), -1);
  for (std::size_t j = 0; j < columns.size(); ++j) local[static_cast<std::size_t>(columns[j])] = static_cast<int>(j);
  SparseMatrix B(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    B.startVec(static_cast<Eigen::Index>(i));
    for (SparseMatrix::InnerIterator entry(A, rows[i]); entry; ++entry)
      if (const int j = local[static_cast<std::size_t>(entry.col())]; j >= 0)
        B.insertBack(static_cast<Eigen::Index>(i), j) = entry.value();
  }
  B.finalize();
  return B;
}

/// The indices that are marked, ascending.
std::vector<int> marked(const std::vector<bool>& marks) {
  std::vector<int> list;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i]) list.push_back(static_cast<int>(i));
  return list;
}

/// Marks all that couple with the listed unknowns.
void mark_neighbours(const SparseMatrix& A, const std::vector<int>& of, std::vector<bool>& marks) {
  for (const int i : of)
    for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry) marks[static_cast<std::size_t>(entry.col())] = true;
}

}  // namespace

CarriedMotions::CarriedMotions(const System& system, const SparseMatrix& at_shift, const std::vector<bool>& own)
    : system_(system) {
  const auto n = static_cast<Eigen::Index>(system.interface->n_nodes()), n_degrees = std::min(all_degrees, n);
  const Eigen::MatrixXd degrees = polynomials(system.interface->position, n_degrees);
  by_degree_ = Eigen::MatrixXd::Zero(2 * n, 2 * n_degrees);
  Eigen::MatrixXd high = Eigen::MatrixXd::Identity(2 * n, 2 * n);
  for (Eigen::Index k = 0; k < n_degrees; ++k) {
    by_degree_.col(2 * k).head(n) = degrees.col(k);
    by_degree_.col(2 * k + 1).tail(n) = degrees.col(k);
  }
  const auto low = by_degree_.leftCols(2 * std::min(low_degrees, n));
  high -= product(low, low.transpose());
  choose_patch(at_shift, own, std::max(least_layers, static_cast<int>(n) / nodes_of_layer));
  carry(at_shift, high);
  const auto product_with = [&](const SparseMatrix& A) -> Eigen::MatrixXd {
    return detail::block_product(part_of(A, near_, unknown_), motion_);
  };
  products_ = {product_with(system.M), product_with(system.C), product_with(system.K)};
  std::vector<int> places;
  for (const int unknown : unknown_)
    places.push_back(static_cast<int>(std::lower_bound(near_.begin(), near_.end(), unknown) - near_.begin()));
  const auto own_block = [&](const Eigen::MatrixXd& Y) -> Eigen::MatrixXd {
    const Eigen::MatrixXd A = transposed_product(motion_, Y(places, Eigen::all));
    return 0.5 * (A + A.transpose());
  };
  matrices_ = {own_block(products_.M), own_block(products_.C), own_block(products_.K)};
}

void CarriedMotions::choose_patch(const SparseMatrix& at_shift, const std::vector<bool>& own, int n_layers) {
  const auto n_free = static_cast<std::size_t>(system_.n_free());
  std::vector<bool> reached(own.size(), false);
  std::fill(reached.begin() + system_.n_free(), reached.end(), true);
  std::vector<int> list = marked(reached);
  for (int layer = 0; layer < n_layers; ++layer) {
    mark_neighbours(at_shift, list, reached);
    for (std::size_t i = 0; i < n_free; ++i) reached[i] = reached[i] && !own[i];
    list = marked(reached);
  }
  patch_.assign(list.begin(), std::lower_bound(list.begin(), list.end(), system_.n_free()));
  for (const int i : list)
    if (i >= system_.n_free() || system_.field[static_cast<std::size_t>(i)] != Field::pressure_impulse)
      unknown_.push_back(i);
  mark_neighbours(at_shift, unknown_, reached);
  near_ = marked(reached);
}

void CarriedMotions::carry(const SparseMatrix& at_shift, const Eigen::MatrixXd& high) {
  const Eigen::Index n = high.rows(), n_moving = static_cast<Eigen::Index>(unknown_.size());
  std::vector<int> interface, places;
  for (int i = system_.n_free(); i < system_.size(); ++i) interface.push_back(i);
  motion_ = Eigen::MatrixXd::Zero(n_moving, n);
  motion_.bottomRows(n).setIdentity();
  if (patch_.empty()) return;
  const Factorisation factors(part_of(at_shift, patch_, patch_), {});
  const Eigen::MatrixXd answer =
      factors.solve_columns(detail::block_product(part_of(at_shift, patch_, interface), -high));
  const auto place = [&](int i) { return std::lower_bound(patch_.begin(), patch_.end(), i) - patch_.begin(); };
  for (Eigen::Index i = 0; i < n_moving - n; ++i)
    places.push_back(static_cast<int>(place(unknown_[static_cast<std::size_t>(i)])));
  motion_.topRows(n_moving - n) = answer(places, Eigen::all);
}

OfMatrices CarriedMotions::with(const FieldBasis& basis, Eigen::Index first) const {
  std::vector<int> rows, places;  // of the basis and of near_
  for (std::size_t i = 0, k = 0; i < basis.unknown.size() && k < near_.size();) {
    if (basis.unknown[i] < near_[k]) {
      ++i;
    } else if (near_[k] < basis.unknown[i]) {
      ++k;
    } else {
      rows.push_back(static_cast<int>(i++));
      places.push_back(static_cast<int>(k++));
    }
  }
  const Eigen::MatrixXd V = basis.unit(rows).asDiagonal() * basis.columns_from(first)(rows, Eigen::all);
  const auto block = [&](const Eigen::MatrixXd& Y) { return transposed_product(V, Y(places, Eigen::all).eval()); };
  return {block(products_.M), block(products_.C), block(products_.K)};
}

Eigen::MatrixXd CarriedMotions::read(const std::vector<Reading>& readings, Row Reading::*part) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(readings.size()), motion_.cols());
  for (std::size_t i = 0; i < readings.size(); ++i)
    for (const auto& [j, weight] : readings[i].*part) {
      const auto found = std::lower_bound(unknown_.begin(), unknown_.end(), j);
      if (found != unknown_.end() && *found == j)
        out.row(static_cast<Eigen::Index>(i)) += weight * motion_.row(found - unknown_.begin());
    }
  return out;
}

Vector CarriedMotions::along(const Vector& vector) const {
  return transposed_product(motion_, vector(unknown_).eval());
}

void CarriedMotions::add_to(const Eigen::Ref<const Vector>& motion, Vector& state) const {
  const Vector added = product(motion_, motion);
  for (std::size_t i = 0; i < unknown_.size(); ++i) state[unknown_[i]] += added[static_cast<Eigen::Index>(i)];
}

}  // namespace upbead
