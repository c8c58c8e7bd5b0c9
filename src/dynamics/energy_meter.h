// Keeps the account of energy of a march.
#pragma once

#include "dynamics/products.h"
#include "upbead/dynamics/energy.h"

namespace upbead::detail {

/// What C takes from Z: quadratic forms of the part inside the mesh, by field, and of absorbing sides.
struct Losses {
  FieldGrams inside;
  Eigen::MatrixXd radiated;
  Eigen::MatrixXd total() const { return inside.total() + radiated; }
};

/// Multiplying M a + C v + K x = f by v^T J makes M, K and the part of C that keeps the sign symmetric and >= 0; the
/// couplings of phi with u and W become skew and take no power. The schemes supply their own quadratures.
class EnergyMeter {
 public:
  explicit EnergyMeter(const System& system);

  /// Empties the account; what `state` stores counts as work done.
  void start(const State& state);
  const EnergyAccount& account() const { return account_; }
  /// Goes back to an account of before.
  void restore(const EnergyAccount& account) { account_ = account; }

  FieldGrams mass(const VectorBlock& Z) const { return mass_.grams(Z, system_.field); }
  FieldGrams stiffness(const VectorBlock& Z) const { return stiffness_.grams(Z, system_.field); }
  /// Of the part of C that takes power, and of the rest, which couples phi with u and W.
  Losses losses(const VectorBlock& Z) const;
  FieldGrams coupling(const VectorBlock& Z) const { return coupling_.grams(Z, system_.field); }

  /// weight times the work of the load vector f along `path` (n), and of the reactions (residual of the rows of
  /// prescribed unknowns at x, v, a) along theirs. At an interface these reactions change an equilibrium: with the
  /// forces at rest, -(work of what acts there) goes to friction, that of the forces at rest is stored. `internal`: of
  /// soil that yields, on the prescribed unknowns.
  void add_work(double weight, const Vector& path, const Vector& f, const Vector& x, const Vector& v, const Vector& a,
                const Vector* internal = nullptr);
  /// The (column, column) entry of the losses times `time` was taken.
  void add_losses(const Losses& losses, int column, double time);
  /// Taken by soil that yields, and stored by it beside x' K x / 2, for which set_stored() comes first. The work that
  /// its force did is minus what both grew by; what the stages make of it besides is the scheme's.
  void add_yielding(double internal_work, double dissipated, double stored_before, double stored_now);
  void add_scheme(double energy) { account_.scheme += energy; }
  /// What is stored now: v and x are the column `column` of the blocks whose grams these are.
  void set_stored(const FieldGrams& mass, const FieldGrams& stiffness, int column);

 private:
  void add_contact(double weight, const Vector& path, const Vector& reaction, const Vector& x);

  const System& system_;
  LowerTriangle mass_, stiffness_, dissipative_, radiating_, coupling_;
  bool radiates_;
  SparseMatrix prescribed_M_, prescribed_C_, prescribed_K_;  ///< rows of the prescribed unknowns
  Vector sign_;                                              ///< diagonal of J
  EnergyAccount account_;
};

}  // namespace upbead::detail
