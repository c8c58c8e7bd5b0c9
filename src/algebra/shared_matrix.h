// A symmetric matrix in the unknowns that several processes share, which all of them factorise together.
#pragma once

#include <vector>

namespace upbead::detail {

/// Made by Processes::shared_matrix(), so that nobody here needs to know whose solver does it. All processes make the
/// same calls, with n shared unknowns each; where a call throws NumericsError, it throws on all.
class SharedMatrix {
 public:
  SharedMatrix() = default;
  virtual ~SharedMatrix() = default;
  SharedMatrix(const SharedMatrix&) = delete;
  SharedMatrix& operator=(const SharedMatrix&) = delete;

  /// Factorises the sum of the parts (n x n, both triangles), which is symmetric, of inertia unknown. Throws
  /// NumericsError where it is singular.
  virtual void factorise(const std::vector<double>& part) = 0;
  /// Takes this process's part of a right-hand side, the sum of all parts, and gives the solution in the n unknowns.
  virtual void solve(double* x) const = 0;
  /// Negative pivots of the last factorisation.
  virtual int n_negative() const = 0;
};

}  // namespace upbead::detail
