// Keeps the account of energy of a march.
#pragma once

#include "dynamics/products.h"
#include "upbead/dynamics/energy.h"

namespace upbead::detail {

/// The power that C takes, as quadratic forms of Z: inside the mesh by field, and at absorbing sides.
struct Losses {
  FieldGrams inside;
  Eigen::MatrixXd radiated;
  Eigen::MatrixXd total() const { return inside.total() + radiated; }
};

/// Multiplying M a + C v + K x = f by v^T J makes M, K and the part of C within each field symmetric and >= 0; the
/// couplings of phi with u and W become skew and take no power. The schemes supply their own quadratures.
class EnergyMeter {
 public:
  explicit EnergyMeter(const System& system);

  /// Empties the account; the energy stored in `state` counts as work done.
  void start(const State& state);
  const EnergyAccount& account() const { return account_; }
  /// Restores an earlier account.
  void restore(const EnergyAccount& account) { account_ = account; }

  FieldGrams mass(const VectorBlock& Z) const { return mass_.grams(Z, system_.field); }
  FieldGrams stiffness(const VectorBlock& Z) const { return stiffness_.grams(Z, system_.field); }
  /// Losses of the part of C that takes power; coupling() is the rest, which couples phi with u and W.
  Losses losses(const VectorBlock& Z) const;
  FieldGrams coupling(const VectorBlock& Z) const { return coupling_.grams(Z, system_.field); }

  /// Adds `weight` times the work of the load vector f along `path` (n), and of the reactions (residuals of the rows
  /// of prescribed unknowns at x, v, a) along their part of `path`. At an interface these reactions are changes from
  /// a state of rest: with the forces at rest included, minus the work of the forces there goes to friction; the work
  /// of the forces at rest is stored. `internal`: the force of yielding soil on the prescribed unknowns.
  void add_work(double weight, const Vector& path, const Vector& f, const Vector& x, const Vector& v, const Vector& a,
                const Vector* internal = nullptr);
  /// Dashpots on a frame that moves take (v - r f)' C (v - r f), and the frame does the work of their reactions on its
  /// own velocity. add_losses() counts v' C v and add_work() v' C r f, the work on the system: this corrects both, for
  /// the loads' values f, over `time`. Call it before add_work().
  void add_frame(double time, const Vector& v, const std::vector<double>& load);
  /// Adds the (column, column) entry of the losses, times `time`, to the energy taken.
  void add_losses(const Losses& losses, int column, double time);
  /// Adds what yielding soil takes, and what it stores besides x' K x / 2; set_stored() must be called before. The
  /// work of the soil's force is minus the growth of both; what the quadrature of the stages adds to it belongs to
  /// the scheme.
  void add_yielding(double internal_work, double dissipated, double stored_before, double stored_now);
  void add_scheme(double energy) { account_.scheme += energy; }
  /// Sets the energy that is stored now: v and x are the column `column` of the blocks whose grams these are.
  void set_stored(const FieldGrams& mass, const FieldGrams& stiffness, int column);

 private:
  /// Forces at rest are whole on every process: the first one counts for them.
  Vector forces_at_rest() const;
  void add_contact(double weight, const Vector& path, const Vector& reaction, const Vector& x);

  const System& system_;
  LowerTriangle mass_, stiffness_, dissipative_, radiating_, coupling_;
  bool radiates_;
  SparseMatrix prescribed_M_, prescribed_C_, prescribed_K_;  ///< rows of the prescribed unknowns
  Vector sign_;                                              ///< diagonal of J
  EnergyAccount account_;
};

}  // namespace upbead::detail
