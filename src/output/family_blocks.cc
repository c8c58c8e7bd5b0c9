#include <algorithm>
#include <array>
#include <stdexcept>

#include "family_parts.h"

namespace upbead::detail {

namespace {

const Label of_block{"", "block of M, C or K; on the diagonal its lower triangle, row by row"};

/// The coordinates of displacements, then those of phi.
std::array<std::vector<int>, 2> by_kind(const std::vector<bool>& is_phi) {
  std::array<std::vector<int>, 2> list;
  for (std::size_t i = 0; i < is_phi.size(); ++i) list[is_phi[i] ? 1 : 0].push_back(static_cast<int>(i));
  return list;
}

constexpr std::array<const char*, 2> names_on_diagonal{"_uu", "_pp"};
const char* const name_aside = "_up";

void require_equal(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  constexpr double round_off = 1e-8;
  if (a.size() > 0 && (a - b).cwiseAbs().maxCoeff() > round_off * a.cwiseAbs().maxCoeff())
    throw std::logic_error("a matrix of a family is not symmetric");
}

std::vector<double> lower_triangle(const Eigen::MatrixXd& A) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j) values.push_back(A(i, j));
  return values;
}

Eigen::MatrixXd from_lower_triangle(const std::vector<double>& values, Eigen::Index n) {
  Eigen::MatrixXd A(n, n);
  std::size_t next = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) A(i, j) = A(j, i) = values[next++];
  return A;
}

bool is_there(const Eigen::MatrixXd& block) {
  return block.size() > 0 && !block.isZero(0.);
}

}  // namespace

void write_blocks(Hdf5Image& image, const std::string& path, const Eigen::MatrixXd& matrix,
                  const std::vector<bool>& is_phi) {
  if (matrix.size() == 0) return;
  const auto of_kind = by_kind(is_phi);
  for (std::size_t k = 0; k < 2; ++k) {
    const Eigen::MatrixXd block = matrix(of_kind[k], of_kind[k]);
    if (!is_there(block)) continue;
    require_equal(block, block.transpose());
    const std::vector<double> values = lower_triangle(block);
    image.packed_numbers(path + names_on_diagonal[k], {values.size()}, values.data(), of_block);
  }
  const Eigen::MatrixXd aside = matrix(of_kind[0], of_kind[1]);
  require_equal(aside, matrix(of_kind[1], of_kind[0]).transpose());
  if (is_there(aside)) write_packed(image, path + name_aside, aside, of_block);
}

Eigen::MatrixXd read_blocks(ModelParts& parts, const std::string& path, const std::vector<bool>& is_phi) {
  const auto of_kind = by_kind(is_phi);
  Eigen::MatrixXd matrix;
  const auto whole = [&]() -> Eigen::MatrixXd& {
    const auto n = static_cast<Eigen::Index>(is_phi.size());
    if (matrix.size() == 0) matrix.setZero(n, n);
    return matrix;
  };
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t n = of_kind[k].size();
    if (!parts.has_dataset(path + names_on_diagonal[k])) continue;
    const std::vector<double> values = parts.numbers(path + names_on_diagonal[k], {n * (n + 1) / 2});
    whole()(of_kind[k], of_kind[k]) = from_lower_triangle(values, static_cast<Eigen::Index>(n));
  }
  if (!parts.has_dataset(path + name_aside)) return matrix;
  const Eigen::MatrixXd aside = parts.matrix(path + name_aside, of_kind[0].size(), of_kind[1].size());
  whole()(of_kind[0], of_kind[1]) = aside;
  whole()(of_kind[1], of_kind[0]) = aside.transpose();
  return matrix;
}

}  // namespace upbead::detail
