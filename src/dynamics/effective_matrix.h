// The matrices that a time scheme factorises.
#pragma once

#include <list>
#include <optional>

#include "algebra/factorisation.h"
#include "upbead/system/system.h"

namespace upbead::detail {

/// Coefficients of E = m M + c C + k K.
struct EffectiveCoefficients {
  double m = 1.;
  double c = 0.;
  double k = 0.;
};

/// E = m M + c C + k K, its rows and columns of the free unknowns factorised.
class EffectiveMatrix {
 public:
  /// Throws NumericsError where E is singular or has not one negative pivot for each free phi. `refined`: each solution
  /// is, by its residual.
  EffectiveMatrix(const System& system, const EffectiveCoefficients& coefficients, bool refined);
  /// The same of an E that is at hand.
  EffectiveMatrix(const System& system, const SparseMatrix& E, bool refined = false);

  /// Solves E y = rhs for the free unknowns of y, with the prescribed ones (its tail) given. `rhs` has all n entries;
  /// its head is overwritten. Of a divided system, `rhs` is a sum over processes.
  void solve(Vector& rhs, Vector& y) const;
  /// Rows of the last n unknowns, prescribed ones, of E y - rhs.
  Vector residual_of_last(int n, const Vector& rhs, const Vector& y) const;
  /// What is left of E on the last n unknowns, prescribed ones, once the free ones follow them: n x n, by n solves, or
  /// by half of each where there is a border.
  Eigen::MatrixXd condensed_on_last(int n, const std::optional<Border>& border = {}) const;
  /// The same solve in two halves for a law on the last n unknowns, where that is all that is to be solved (else the
  /// border is empty). begin() takes what the law guesses and returns rows of the last n of E y - rhs; finish() takes
  /// by how much the law changes their part of y, and ends like solve().
  std::optional<Border> border_of_last(int n) const;
  Vector begin(const Border& border, Vector& rhs, Vector& y) const;
  void finish(const Border& border, const Vector& change, Vector& rhs, Vector& y) const;
  /// Takes other coefficients for the same system.
  void refactor(const System& system, const EffectiveCoefficients& coefficients);

 private:
  void check_inertia(const System& system) const;

  int n_free_;
  bool refined_;
  SparseMatrix free_;        ///< rows and columns of the free unknowns, where solutions are refined
  SparseMatrix coupling_;    ///< rows of the free, columns of the prescribed unknowns
  SparseMatrix prescribed_;  ///< rows of the prescribed unknowns, all columns
  Factorisation factors_;
  mutable Vector residual_, correction_;
};

/// Effective matrices by step size: a few are kept, then the oldest is overwritten.
class EffectiveMatrices {
 public:
  EffectiveMatrices(const System& system, bool refined) : system_(system), refined_(refined) {}
  /// The matrix of these coefficients, factorised when it is not at hand.
  const EffectiveMatrix& get(const EffectiveCoefficients& coefficients);
  int n_factorisations() const { return n_factorisations_; }
  /// Wall time of them (s).
  double seconds() const { return seconds_; }

 private:
  void factorise(const EffectiveCoefficients& coefficients);

  struct Entry {
    EffectiveCoefficients coefficients;
    EffectiveMatrix matrix;
  };

  const System& system_;
  bool refined_;
  std::list<Entry> entries_;  ///< latest used first
  int n_factorisations_ = 0;
  double seconds_ = 0.;
};

}  // namespace upbead::detail
