#include "supernodes.h"

#include <cholmod.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "upbead/base/error.h"

namespace upbead::detail {

namespace {

class Cholmod {
 public:
  Cholmod() { cholmod_start(&common_); }
  ~Cholmod() { cholmod_finish(&common_); }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_;
};

/// Measured on plane Q2 meshes: nested dissection (CHOLMOD's own, METIS) has 3 to 10 % fewer entries in L from 40,000
/// unknowns on, but takes 6 to 8 times as long to find as minimum degree: it pays only after more than 500 solves. With
/// 1,010,138 unknowns METIS leaves 12 % fewer entries and a third less work, and takes 7 s more.
void choose_methods(cholmod_common& common, Eigen::Index n) {
  common.print = 0;
  common.nmethods = 1;
  common.method[0].ordering = n < 600000 ? CHOLMOD_AMD : CHOLMOD_METIS;
  common.postorder = 1;
  common.supernodal = CHOLMOD_SUPERNODAL;
}

/// CHOLMOD reads rows of A as columns of its transpose, so that the lower triangle becomes the upper one (stype 1).
cholmod_sparse pattern_of(const SparseMatrix& A) {
  cholmod_sparse pattern{};
  pattern.nrow = pattern.ncol = static_cast<std::size_t>(A.rows());
  pattern.nzmax = static_cast<std::size_t>(A.nonZeros());
  pattern.p = const_cast<int*>(A.outerIndexPtr());
  pattern.i = const_cast<int*>(A.innerIndexPtr());
  pattern.stype = 1;
  pattern.itype = CHOLMOD_INT;
  pattern.xtype = CHOLMOD_PATTERN;
  pattern.dtype = CHOLMOD_DOUBLE;
  pattern.sorted = pattern.packed = 1;
  return pattern;
}

std::vector<int> copied(const void* values, std::size_t n) {
  const int* begin = static_cast<const int*>(values);
  return {begin, begin + n};
}

void find_parents(Supernodes& nodes) {
  std::vector<int> supernode_of(nodes.order.size());
  nodes.parent.resize(nodes.first.size() - 1);
  for (int s = 0; s < nodes.count(); ++s)
    for (int k = nodes.first[s]; k < nodes.first[s + 1]; ++k) supernode_of[k] = s;
  for (int s = 0; s < nodes.count(); ++s)
    nodes.parent[s] =
        nodes.width(s) < nodes.height(s) ? supernode_of[nodes.rows[nodes.row_begin[s] + nodes.width(s)]] : -1;
}

/// The pattern of A, with all entries between the `last` unknowns added.
SparseMatrix with_dense_block(const SparseMatrix& A, const std::vector<int>& last) {
  std::vector<bool> is_last(static_cast<std::size_t>(A.rows()), false);
  for (const int i : last) is_last[i] = true;
  std::vector<int> outer{0}, inner, row;
  for (int i = 0; i < A.rows(); ++i) {
    row.assign(A.innerIndexPtr() + A.outerIndexPtr()[i], A.innerIndexPtr() + A.outerIndexPtr()[i + 1]);
    const auto n = static_cast<std::ptrdiff_t>(row.size());
    if (is_last[i]) row.insert(row.end(), last.begin(), last.end());
    std::inplace_merge(row.begin(), row.begin() + n, row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    inner.insert(inner.end(), row.begin(), row.end());
    outer.push_back(static_cast<int>(inner.size()));
  }
  const std::vector<double> zeros(inner.size(), 0.);
  return Eigen::Map<const SparseMatrix>(A.rows(), A.cols(), outer.back(), outer.data(), inner.data(), zeros.data());
}

/// Minimum degree, with the `last` unknowns after all others, in their order: as they form a clique, their order does
/// not matter.
std::vector<int> constrained_order(cholmod_sparse& pattern, const std::vector<int>& last, cholmod_common* common) {
  std::vector<int> is_last(pattern.nrow, 0), order(pattern.nrow);
  for (const int i : last) is_last[i] = 1;
  if (cholmod_camd(&pattern, nullptr, 0, is_last.data(), order.data(), common) == 0)
    throw NumericsError("CHOLMOD finds no order for the unknowns (its status " + std::to_string(common->status) + ")");
  std::copy(last.begin(), last.end(), order.end() - static_cast<std::ptrdiff_t>(last.size()));
  return order;
}

/// Makes the last columns, those of `last`, a supernode of their own: CHOLMOD may have merged others with them.
void cut_off_root(Supernodes& nodes, const std::vector<int>& last) {
  const auto n_last = static_cast<int>(last.size()), begin = static_cast<int>(nodes.order.size()) - n_last;
  if (!std::equal(last.begin(), last.end(), nodes.order.begin() + begin))
    throw std::logic_error("the unknowns to be eliminated last are not");
  const auto keep = std::lower_bound(nodes.first.begin(), nodes.first.end(), begin) - nodes.first.begin();
  nodes.first.resize(static_cast<std::size_t>(keep));
  nodes.row_begin.resize(static_cast<std::size_t>(keep) + 1);
  nodes.rows.resize(static_cast<std::size_t>(nodes.row_begin.back()));
  for (int k = begin; k < begin + n_last; ++k) nodes.rows.push_back(k);
  nodes.first.insert(nodes.first.end(), {begin, begin + n_last});
  nodes.row_begin.push_back(static_cast<int>(nodes.rows.size()));
}

}  // namespace

Supernodes find_supernodes(const SparseMatrix& A, const std::vector<int>& last) {
  Cholmod cholmod;
  choose_methods(*cholmod.get(), A.rows());
  const SparseMatrix with_root = last.empty() ? SparseMatrix() : with_dense_block(A, last);
  cholmod_sparse pattern = pattern_of(last.empty() ? A : with_root);
  std::vector<int> given;
  if (!last.empty()) {
    given = constrained_order(pattern, last, cholmod.get());
    cholmod.get()->method[0].ordering = CHOLMOD_GIVEN;
  }
  const auto release = [&](cholmod_factor* factor) { cholmod_free_factor(&factor, cholmod.get()); };
  const std::unique_ptr<cholmod_factor, decltype(release)> L(
      cholmod_analyze_p(&pattern, given.empty() ? nullptr : given.data(), nullptr, 0, cholmod.get()), release);
  if (!L || cholmod.get()->status != CHOLMOD_OK)
    throw NumericsError("CHOLMOD finds no pattern for the factor of the matrix (its status " +
                        std::to_string(cholmod.get()->status) + ")");
  Supernodes nodes;
  nodes.order = copied(L->Perm, L->n);
  nodes.first = copied(L->super, L->nsuper + 1);
  nodes.row_begin = copied(L->pi, L->nsuper + 1);
  nodes.rows = copied(L->s, static_cast<std::size_t>(nodes.row_begin.back()));
  nodes.has_root = !last.empty();
  if (nodes.has_root) cut_off_root(nodes, last);
  find_parents(nodes);
  return nodes;
}

}  // namespace upbead::detail
