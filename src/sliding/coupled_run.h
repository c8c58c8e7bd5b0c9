// One wave's way through the phases of a slip.
#pragma once

#include "sliding/coupled_slip.h"
#include "slip_event.h"

namespace upbead::detail {

/// A stretch of time on which all loads are straight.
struct LoadStretch {
  double length = 0.;  ///< s
  Eigen::VectorXd begin, end;
};

/// Where a caisson is, in which phase, and what has become of it.
class CoupledRun {
 public:
  /// From rest under N_0 = `normal` (N/m). Model and levels, each with half the steps of the last, must outlive the
  /// object.
  CoupledRun(const SlipModel& model, const std::vector<SlipLevel>& levels, double normal);

  /// Through a stretch; `is_step`: it is as long as the longest steps. `jumps`: the loads do so at its beginning.
  void pass(const LoadStretch& stretch, bool is_step, bool jumps);

  bool stuck() const { return contact_ == BottomState::stuck; }
  /// Writes down what is read now, under these loads.
  void record(const Eigen::VectorXd& load, Eigen::Index column, CoupledHistory& history) const;
  /// A slip that is under way counts.
  CoupledSliding result() const;

 private:
  /// Readings at one time.
  struct Reading {
    double shear = 0., normal = 0., velocity = 0.;
  };

  const SlipPhase& phase() const { return model_.phase(contact_); }
  std::size_t state() const { return static_cast<std::size_t>(contact_); }
  std::size_t finest() const { return levels_.size() - 1; }
  double read(const ModalState& z, int row, const Eigen::VectorXd& load) const;
  Reading reading(double watched, double normal) const;
  Reading reading_now(const Eigen::VectorXd& load) const;
  /// Through a step of a level.
  void pass_step(const LoadStretch& stretch, std::size_t level);
  /// Through any stretch, in the longest steps that there are, from a level on.
  void pass_rest(LoadStretch rest, std::size_t level);
  /// Whether nothing can happen in a step. Counts what its bends make uncertain in the energies.
  bool is_quiet(const LoadStretch& stretch, const Reading& end, std::size_t level);
  /// Through a stretch no longer than a step of a level, at the end of which a change of phase shows.
  void follow(LoadStretch stretch, std::size_t level);
  void advance(double length, const Reading& now, double moved);
  void change(SlipEvent event, const Eigen::VectorXd& load);
  /// s' = 0: sticks, or slips the way it is pushed.
  void rest(const Eigen::VectorXd& state, const Eigen::VectorXd& load);
  void enter(BottomState contact, const Eigen::VectorXd& state, const Eigen::VectorXd& load);
  void begin_slip(const Eigen::VectorXd& state);
  void end_slip(const Eigen::VectorXd& state);

  const SlipModel& model_;
  const std::vector<SlipLevel>& levels_;
  BottomState contact_ = BottomState::stuck;
  ModalState z_, next_;
  int n_stretches_ = 0;
  bool fresh_ = false;  ///< the phase has just begun
  Reading last_;
  double time_ = 0.;
  double slip_ = 0.;  ///< s
  bool slipping_ = false;
  double way_ = 0.;  ///< of the slip that is under way: 1 forward, -1 backward, 0 not known yet
  Slip now_;
  double energy_ = 0.;  ///< stored when the slip began (J/m)
  CoupledSliding result_;
};

}  // namespace upbead::detail
