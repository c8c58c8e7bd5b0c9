// A stage of a time scheme under the law of contact.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "dynamics/contact_problem.h"
#include "dynamics/dirk.h"
#include "dynamics/gap_water.h"

namespace upbead::detail {

/// The event at which a step stops.
enum class StopAt {
  release,  ///< a node slips or opens
  impact,   ///< a node closes
  never,
};

/// The state of the nodes at one time, and what happened to them in the steps up to then.
struct InterfaceState {
  std::vector<ContactState> status;
  InterfaceForces forces;
  bool slipped = false;  ///< whether a node slipped in this step
  bool opened = false;   ///< whether a node opened in this step
  int impacts = 0;       ///< nodes that closed, in this step
};

/// The equations of a stage, condensed on the interface.
class CondensedStage {
 public:
  virtual ~CondensedStage() = default;
  /// Residual of the interface's rows, at the motion in the tail of stage.a.
  virtual Vector begin(const DirkStage& stage) = 0;
  virtual ContactProblem& problem() = 0;
  /// Sets stage.a of the free unknowns, at the motion in its tail. After begin().
  virtual void finish(DirkStage& stage) = 0;
};

/// Solves stages under the law of contact (ContactProblem). In a stage the free unknowns depend linearly on those of
/// the interface, and so do the interface's forces: D is E condensed on the interface, for motions q = (slip rate /
/// g, opening / g^2).
class ContactStage : public StageLaw {
  /// For one E. Where the solve can be halted halfway (Border), the law is applied there, and a stage takes one
  /// solve; else it is applied after a solve, and a second one follows.
  struct Condensed {
    std::optional<Border> border;
    ContactProblem problem;
  };

 public:
  explicit ContactStage(const System& system);
  void start(const State& state);
  /// Gaps stay as they are now until the next step begins.
  void begin_step(StopAt stop);
  void add_load(double time, double inside, Vector& f) override;
  bool solve(const EffectiveMatrix& E, double g, DirkStage& stage) override;
  bool solve(CondensedStage& E, double g, DirkStage& stage);

  const InterfaceState& now() const { return now_; }
  /// Forces of the water in gaps in the last stage; empty: none act.
  const Vector& gap() const { return gap_; }
  /// Restores an earlier state.
  void restore(const InterfaceState& before) { now_ = before; }
  /// Whether all nodes stick.
  bool all_stick() const;
  int n_solves() const { return n_solves_; }
  int n_fallbacks() const { return n_fallbacks_; }

 private:
  Vector first_guess(double g, const DirkStage& stage) const;
  Condensed& condensed(const EffectiveMatrix& E, double g);
  InterfaceForces forces(const Vector& residual) const;
  bool decide(const std::function<ContactProblem&()>& problem, ContactPoint& point);
  bool solve_whole(const EffectiveMatrix& E, double g, DirkStage& stage, ContactPoint& point);
  bool solve_by_halves(const EffectiveMatrix& E, double g, DirkStage& stage, ContactPoint& point);
  void set_accelerations(const Vector& motion, double g, DirkStage& stage) const;
  void set_motions(const Vector& motion, double g, DirkStage& stage) const;
  void correct(const EffectiveMatrix& E, double g, const Vector& motion, DirkStage& stage);
  bool note(const std::vector<ContactState>& status);

  const System& system_;
  const Interface& interface_;
  int n_;
  double scale_;  ///< largest normal force at rest
  InterfaceState now_;
  GapForces gaps_;
  Vector gap_;
  StopAt stop_ = StopAt::never;
  std::map<double, Condensed> condensed_;  ///< by g
  int n_fallbacks_ = 0;
  int n_solves_ = 0;
  Vector no_load_, correction_;
};

}  // namespace upbead::detail
