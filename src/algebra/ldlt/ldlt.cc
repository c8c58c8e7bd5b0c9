#include "ldlt.h"

#include <algorithm>

#include "algebra/fail_together.h"
#include "triangular_solve.h"

namespace upbead::detail {

namespace {

/// Fills the upper triangle of an n x n matrix by its lower one.
void mirror(std::vector<double>& matrix, int n) {
  Eigen::Map<Eigen::MatrixXd> whole(matrix.data(), n, n);
  for (int j = 1; j < n; ++j) whole.col(j).head(j) = whole.row(j).head(j).transpose();
}

}  // namespace

Ldlt::Ldlt(const SparseMatrix& A, const Sharing& sharing)
    : sharing_(sharing),
      nodes_(find_supernodes(A, sharing.unknowns)),
      entries_(find_panel_entries(A, nodes_)),
      factor_(make_factor(nodes_)),
      root_(sharing.n_all > 0 ? sharing.processes->shared_matrix(sharing) : nullptr),
      work_size_(static_cast<std::size_t>(triangular_solve_work(nodes_))) {}

void Ldlt::factorise(SparseMatrix& A, const Vector& scale) {
  for (int i = 0; i < A.rows(); ++i)
    for (int k = A.outerIndexPtr()[i]; k < A.outerIndexPtr()[i + 1]; ++k)
      A.valuePtr()[k] = scale[i] * A.valuePtr()[k] * scale[A.innerIndexPtr()[k]];
  std::vector<double> left;
  fail_together(sharing_, [&] {
    const std::vector<int> signs = root_ ? std::vector<int>() : signs_of(A);
    left = detail::factorise(nodes_, entries_, A.valuePtr(), factor_, signs);
  });
  if (root_) {
    mirror(left, nodes_.n_root());
    root_->factorise(left);
  }
  scale_.resize(A.rows());
  for (int k = 0; k < A.rows(); ++k) scale_[k] = scale[nodes_.order[k]];
}

std::vector<int> Ldlt::signs_of(const SparseMatrix& A) const {
  std::vector<int> signs;
  for (const int i : nodes_.order) signs.push_back(A.coeff(i, i) > 0. ? 1 : -1);
  return signs;
}

void Ldlt::load(const Eigen::Ref<const Eigen::MatrixXd>& B) const {
  const Eigen::Index n = B.rows(), n_columns = B.cols();
  if (n_columns > n_columns_) {
    x_ = make_big_array(static_cast<std::size_t>(n * n_columns));
    work_ = make_big_array(work_size_ * static_cast<std::size_t>(n_columns));
    n_columns_ = n_columns;
  }
  for (Eigen::Index c = 0; c < n_columns; ++c)
    for (Eigen::Index k = 0; k < n; ++k) x_[c * n + k] = scale_[k] * B(nodes_.order[k], c);
}

void Ldlt::unload(Eigen::Ref<Eigen::MatrixXd> X) const {
  const Eigen::Index n = X.rows();
  for (Eigen::Index c = 0; c < X.cols(); ++c)
    for (Eigen::Index k = 0; k < n; ++k) X(nodes_.order[k], c) = scale_[k] * x_[c * n + k];
}

void Ldlt::solve(const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::Ref<Eigen::MatrixXd> X) const {
  begin(B);
  if (root_) solve_root(static_cast<int>(B.cols()));
  finish(X);
}

void Ldlt::solve_root(int n_columns) const {
  const auto n = static_cast<std::ptrdiff_t>(nodes_.order.size());
  for (int c = 0; c < n_columns; ++c) root_->solve(x_.get() + (c + 1) * n - nodes_.n_root());
}

void Ldlt::begin(const Eigen::Ref<const Eigen::MatrixXd>& B) const {
  load(B);
  end_ = forward_half(view(nodes_, factor_), x_.get(), static_cast<int>(B.cols()), work_.get());
}

Eigen::Map<Eigen::MatrixXd> Ldlt::halfway(Eigen::Index n_columns) const {
  return {x_.get(), static_cast<Eigen::Index>(nodes_.order.size()), n_columns};
}

void Ldlt::finish(Eigen::Ref<Eigen::MatrixXd> X) const {
  backward_half(view(nodes_, factor_), end_, x_.get(), static_cast<int>(X.cols()), work_.get());
  unload(X);
}

Inertia Ldlt::inertia() const {
  const auto negative = (factor_.inverse_pivot.array() < 0.).count();
  return {static_cast<int>(factor_.inverse_pivot.size() - negative), static_cast<int>(negative)};
}

Inertia Ldlt::shared_inertia() const {
  if (!root_) return {};
  const int negative = root_->n_negative();
  return {sharing_.n_all - negative, negative};
}

double Ldlt::growth() const {
  return factor_.inverse_pivot.size() == 0 ? 1. : 1. / factor_.inverse_pivot.array().abs().minCoeff();
}

}  // namespace upbead::detail
