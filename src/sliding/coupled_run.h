// One wave's way through the phases of a slip.
#pragma once

#include "slip_event.h"
#include "upbead/sliding/coupled_slip.h"

namespace upbead::detail {

/// A stretch of time on which all loads are straight.
struct LoadStretch {
  double length = 0.;  ///< s
  Eigen::VectorXd begin, end;
};

/// Where a caisson is, in which phase, and what has become of it.
class CoupledRun {
 public:
  /// From rest under N_0 = `normal` (N/m). Model and steps must outlive the object.
  CoupledRun(const SlipModel& model, const std::array<SlipSteps, 4>& steps, double normal);

  /// Through a stretch; `is_step`: it is as long as the steps. `jumps`: the loads do so at its beginning.
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
  const SlipSteps& steps() const { return steps_[static_cast<std::size_t>(contact_)]; }
  double read(const ModalState& z, int row, const Eigen::VectorXd& load) const;
  Reading reading(double watched, double normal) const;
  Reading reading_now(const Eigen::VectorXd& load) const;
  void follow(LoadStretch stretch);
  void advance(double length, const Reading& now, double moved);
  void change(SlipEvent event, const Eigen::VectorXd& load);
  /// s' = 0: sticks, or slips the way it is pushed.
  void rest(const Eigen::VectorXd& state, const Eigen::VectorXd& load);
  void enter(BottomState contact, const Eigen::VectorXd& state, const Eigen::VectorXd& load);
  void begin_slip();
  void end_slip();

  const SlipModel& model_;
  const std::array<SlipSteps, 4>& steps_;
  BottomState contact_ = BottomState::stuck;
  ModalState z_, next_;
  int n_stretches_ = 0;
  Reading last_;
  double time_ = 0.;
  double slip_ = 0.;  ///< s
  bool slipping_ = false;
  double way_ = 0.;  ///< of the slip that is under way: 1 forward, -1 backward, 0 not known yet
  Slip now_;
  CoupledSliding result_;
};

}  // namespace upbead::detail
