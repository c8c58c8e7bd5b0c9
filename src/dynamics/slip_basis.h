// The space of a body that slips, as that of the bonded one with one start more: nothing is factorised, and no vector
// of a load is solved for again.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "dynamics/basis.h"
#include "dynamics/slip_row.h"

namespace upbead {

/// The unknowns x of the bonded system and its slip s obey
///
///     T(z) x + t(z) s = b f,        t(z)' x + t_ss(z) s = b_s f - F_T
///
/// (T(z) = z^2 M + z C + K; t its column of s). By the first, x = T^-1 b f - T^-1 t s: its moments about z = s_0 lie in
/// the span of those of T^-1 b, which is the bonded space, and of those of T^-1 t, whatever f and s are. So the space
/// of the loads and of F_T that the system with s has, s kept exactly, is spanned by as many vectors of each of these
/// two. Looks hold the bonded readings and coordinates, then s; the loads and readings of add_slip() are the last ones.
class SlipBasis : public Looks {
 public:
  /// `bonded`: of the system that the row is beside; undivided.
  SlipBasis(std::shared_ptr<GrowingBasis> bonded, SlipRow row);

  /// Solves for the slip's vectors of the first look; another thread may grow the bonded basis meanwhile.
  void prepare();
  const Look& look(std::size_t number, const std::function<void(int)>& progress = {}) override;
  bool has_looks() const override { return !looks_.empty(); }
  int n_independent_loads() const override { return bonded_->n_independent_loads() + 1; }
  int n_solves() const override { return bonded_->n_solves() + own_.n_solves(); }
  double factorise_seconds() const override { return bonded_->factorise_seconds(); }
  const Layout& layout() const override { return bonded_->layout(); }
  const std::shared_ptr<GrowingBasis>& bonded() const { return bonded_; }

 private:
  void grow_own(int n_vectors, const std::function<void(int)>& progress);
  Look next_look(const std::function<void(int)>& progress);
  void take_bonded(const Look& of_bonded, int n_vectors);
  void take_own();
  ReducedSystem with_slip() const;

  std::shared_ptr<GrowingBasis> bonded_;
  SlipRow row_;
  SecondOrderKrylov own_;
  bool exhausted_ = false;  ///< of own vectors
  FieldBasis u_, phi_;      ///< directions of both, without s
  int n_coordinates_ = 0;
  std::array<Eigen::Index, 2> of_bonded_{0, 0}, of_own_{0, 0};  ///< directions that are taken
  std::optional<Projection> projection_;                        ///< on u_ and phi_
  std::deque<Look> looks_;
};

}  // namespace upbead
