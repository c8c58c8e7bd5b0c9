// The matrices that a time scheme factorises.
#pragma once

#include <list>
#include <optional>

#include "algebra/factorisation.h"
#include "upbead/algebra/layout.h"
#include "upbead/system/system.h"

namespace upbead::detail {

/// Coefficients of E = m M + c C + k K.
struct EffectiveCoefficients {
  double m = 1.;
  double c = 0.;
  double k = 0.;
};

/// E = m M + c C + k K, with its block of the free unknowns factorised.
class EffectiveMatrix {
 public:
  /// Throws NumericsError where E is singular, or has not one negative pivot for each free phi. `refined`: each
  /// solution is refined by its residual.
  EffectiveMatrix(const System& system, const EffectiveCoefficients& coefficients, bool refined);
  /// The same for an E that has been formed already.
  EffectiveMatrix(const System& system, const SparseMatrix& E, bool refined = false);

  /// Solves E y = rhs for the free unknowns of y, with the prescribed ones (its tail) given. `rhs` has all n entries;
  /// its head is overwritten. In a divided system, `rhs` is a sum over processes.
  void solve(Vector& rhs, Vector& y) const;
  /// The free unknowns of several solutions at once, where the prescribed ones are zero; not refined.
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& rhs) const { return factors_.solve_columns(rhs); }
  int n_free() const { return n_free_; }
  /// E y - rhs in the rows of the last n unknowns, which are prescribed. In a divided system it is the sum over all
  /// processes, the same on each; so is what is condensed.
  Vector residual_of_last(int n, const Vector& rhs, const Vector& y) const;
  /// E condensed on the last n unknowns, which are prescribed (its Schur complement): n x n, by n solves, or by half
  /// of each where there is a border.
  Eigen::MatrixXd condensed_on_last(int n, const std::optional<Border>& border = {}) const;
  /// The same solve in two halves, with a law on the last n unknowns in between; the border is empty where solves
  /// cannot be halved. begin() takes the motion that the law guesses and returns E y - rhs in the last n rows;
  /// finish() takes the change that the law makes to this part of y, and ends like solve().
  std::optional<Border> border_of_last(int n) const;
  Vector begin(const Border& border, Vector& rhs, Vector& y) const;
  void finish(const Border& border, const Vector& change, Vector& rhs, Vector& y) const;
  /// Takes other coefficients for the same system.
  void refactor(const System& system, const EffectiveCoefficients& coefficients);

 private:
  EffectiveMatrix(const System& system, SparseMatrix&& E, bool refined, const Factorisation::Again& again);
  /// The block of the free unknowns of what `again`, which must outlive it, gives.
  Factorisation::Again free_again(const Factorisation::Again& again) const;
  void check_inertia(const System& system) const;

  int n_free_;
  bool refined_;
  Layout layout_;
  SparseMatrix coupling_;    ///< rows of the free, columns of the prescribed unknowns
  SparseMatrix prescribed_;  ///< rows of the prescribed unknowns, all columns
  SparseMatrix free_;        ///< rows and columns of the free unknowns, where solutions are refined
  Factorisation factors_;
  mutable Vector residual_, correction_;
};

/// Effective matrices by their coefficients: a few are kept, then the one not used for longest is overwritten.
class EffectiveMatrices {
 public:
  EffectiveMatrices(const System& system, bool refined) : system_(system), refined_(refined) {}
  /// The matrix of these coefficients; it is factorised where it is not kept.
  const EffectiveMatrix& get(const EffectiveCoefficients& coefficients);
  int n_factorisations() const { return n_factorisations_; }
  /// Wall time of the factorisations (s).
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
