// The part of a reduced model that does not depend on how its loads go in time: a Krylov space that grows look by
// look, the System projected on it, and the modes of each look.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "dynamics/projection.h"
#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/modal_model.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/dynamics/reduced_system.h"

namespace upbead {

/// The coordinates of a space that are read beside the readings of its System.
enum class Kept { none, pressures, states };

/// What options keep, see ReduceOptions.
Kept kept_by(const ReduceOptions& options);

/// The state of a space at a look.
struct Look {
  int n_vectors = 0, n_solves = 0;
  bool exhausted = false;
  int next = 0;                                 ///< vectors at the next look
  Eigen::Index n_displacements = 0, n_phi = 0;  ///< directions of both kinds
  ReducedSystem system;
};

/// A model, and one of the kept coordinates apart: of pressures x', of states x, then x', then x''.
struct Modes {
  ModalModel model, kept;
};

/// Where looks come from: each is made once and is the same whoever asks for it.
class Looks {
 public:
  virtual ~Looks() = default;
  /// The look of that number, from 0; `progress`: called after every solve that it still takes, with the number of
  /// vectors. Throws NumericsError; then no look may be asked for any more.
  virtual const Look& look(std::size_t number, const std::function<void(int)>& progress = {}) = 0;
  virtual bool has_looks() const = 0;
  virtual int n_independent_loads() const = 0;
  virtual int n_solves() const = 0;
  virtual double factorise_seconds() const = 0;
  virtual const Layout& layout() const = 0;
};

/// The System is read by the constructor alone. Each look is made once and is the same whoever asks for it, so that a
/// model is the same to the last bit on a basis of its own and on one that others have grown before.
class GrowingBasis : public Looks {
 public:
  /// Throws as SecondOrderKrylov and Projection do.
  GrowingBasis(const System& system, const ReduceOptions& options);

  /// Whether these options make the same basis of the same System: they may differ in training, tolerances, what is
  /// measured and kept, and in the most vectors beyond the first look.
  bool serves(const ReduceOptions& options) const;
  /// Whether it is one about that shift, with these exact unknowns and no other directions.
  bool is_about(double shift, const std::vector<int>& exact) const;
  const Look& look(std::size_t number, const std::function<void(int)>& progress = {}) override;
  /// The first look with so many vectors, or with all that there are.
  const Look& reach(int n_vectors, const std::function<void(int)>& progress = {});
  /// The modes at a look that was made.
  const Modes& modes(std::size_t number, Kept kept);
  /// The directions of displacements with W, and of phi, at a look.
  FieldBasis displacements(const Look& look) const;
  FieldBasis phi(const Look& look) const;
  const Layout& layout() const override { return krylov_.phi().layout; }
  bool has_looks() const override { return !made_.empty(); }
  int n_independent_loads() const override { return krylov_.n_independent_loads(); }
  int n_solves() const override { return krylov_.n_solves(); }
  double factorise_seconds() const override { return krylov_.factorise_seconds(); }
  const SecondOrderKrylov& krylov() const { return krylov_; }
  const Projection& projection() const { return projection_; }

 private:
  void grow(const std::function<void(int)>& progress);

  struct Made {
    Look look;
    std::array<std::optional<Modes>, 3> modes;  ///< by Kept
  };

  int first_;  ///< vectors at the first look, per independent load
  std::vector<int> exact_;
  std::vector<Vector> kept_;
  SecondOrderKrylov krylov_;
  Projection projection_;
  std::deque<Made> made_;
  bool broken_ = false;
};

class SlipBasis;
struct ContactRoom;

/// Room for one basis of one System, from one reduction to the next, and for what slip adds to it.
class BasisRoom {
 public:
  BasisRoom() = default;
  /// For bases about that shift, in place of the one of the scene that is reduced.
  explicit BasisRoom(double shift) : shift_(shift) {}
  const std::optional<double>& shift() const { return shift_; }
  /// The kept basis where it serves these options, else a new one in its place.
  std::shared_ptr<GrowingBasis> basis(const System& system, const ReduceOptions& options);
  /// The kept basis where it is about that shift, see GrowingBasis::is_about; else null.
  std::shared_ptr<GrowingBasis> basis_about(double shift, const std::vector<int>& exact) const;
  /// What slip adds to the kept basis; may be null.
  const std::shared_ptr<SlipBasis>& slip() const { return slip_; }
  /// Keeps it, where it is of the kept basis.
  void keep(const std::shared_ptr<SlipBasis>& slip);
  /// What contact node by node makes of the same System, see run/contact/contact_room.h; null before it has.
  std::shared_ptr<ContactRoom>& contact() { return contact_; }

 private:
  std::shared_ptr<GrowingBasis> basis_;
  std::shared_ptr<SlipBasis> slip_;
  std::optional<double> shift_;
  std::shared_ptr<ContactRoom> contact_;
};

}  // namespace upbead
