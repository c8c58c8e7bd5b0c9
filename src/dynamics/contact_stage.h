// A stage of a time scheme under the law of contact.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "dynamics/contact_problem.h"
#include "dynamics/dirk.h"

namespace upbead::detail {

/// What a step shall not go on with.
enum class StopAt {
  release,  ///< a node slips or opens
  impact,   ///< a node closes
  never,
};

/// What the nodes do at one time, and what they did in the steps that led there.
struct InterfaceState {
  std::vector<ContactState> status;
  InterfaceForces forces;
  bool slipped = false;  ///< a node, in this step
  bool opened = false;   ///< a node, in this step
  int impacts = 0;       ///< nodes that closed, in this step
};

/// Solves stages under the law of contact (ContactProblem). In a stage the free unknowns follow those of the interface
/// linearly, so that its forces do as well: D is E condensed on the interface, for motions q = (slip rate / g,
/// opening / g^2).
class ContactStage : public StageLaw {
  /// Of one E: the law halfway through a solve, where that can be halted, so that a stage takes one solve; else after
  /// it, and a second one follows.
  struct Condensed {
    std::optional<Border> border;
    ContactProblem problem;
  };

 public:
  explicit ContactStage(const System& system);
  void start(const State& state);
  void begin_step(StopAt stop);
  bool solve(const EffectiveMatrix& E, double g, DirkStage& stage) override;

  const InterfaceState& now() const { return now_; }
  /// Goes back to what was before.
  void restore(const InterfaceState& before) { now_ = before; }
  /// Whether all nodes stick.
  bool all_stick() const;
  int n_solves() const { return n_solves_; }
  int n_fallbacks() const;

 private:
  Vector first_guess(double g, const DirkStage& stage) const;
  Condensed& condensed(const EffectiveMatrix& E, double g);
  InterfaceForces forces(const Vector& residual) const;
  bool decide(const EffectiveMatrix& E, double g, ContactPoint& point);
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
  StopAt stop_ = StopAt::never;
  std::map<double, Condensed> condensed_;  ///< by g
  int fallbacks_of_dropped_ = 0;
  int n_solves_ = 0;
  Vector no_load_, correction_;
};

}  // namespace upbead::detail
