// Marching a system from rest through a time grid.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "upbead/dynamics/scheme.h"
#include "upbead/dynamics/time_grid.h"

namespace upbead {

/// A series in time: column i belongs to time[i].
struct Series {
  std::vector<double> time;  ///< s
  Eigen::MatrixXd reading;   ///< readings of the system, one row each
  Eigen::MatrixXd load;      ///< load values f_k, one row each
};

/// What a march found.
struct Response {
  Series ends;      ///< at t = 0 and at the end of every step
  Series balanced;  ///< at t = 0 and, for every step, where the scheme satisfies the equation of motion
  Series inside;    ///< of a scheme of order 4: inside every step, see dynamics/step_interior.h; else empty
  std::vector<EnergyAccount> energy;  ///< at the times of `ends`; empty where the scheme keeps no account
  State final_state;
  int order = 0;  ///< of the scheme
  int n_steps = 0;
  int n_solves = 0;
  int n_factorisations = 0;
  bool stopped_early = false;
};

/// A march interrupted after some of its steps, with everything needed to continue it as if it had not been
/// interrupted.
struct MarchCheckpoint {
  Response so_far;  ///< with the state that the march has reached, and the steps done
  SchemeMemory memory;
  std::vector<double> observed;  ///< memories of the observers, one after the other
};

/// Sees every state of a march, and remembers what it needs of them. Step 0 begins a march. Where a march was refused
/// and another one begins, the observer must forget what it saw before.
class MarchObserver {
 public:
  MarchObserver() = default;
  MarchObserver(const MarchObserver&) = default;
  MarchObserver& operator=(const MarchObserver&) = default;
  virtual ~MarchObserver() = default;

  /// At t = 0 (step 0) and after every step; n_steps is that of the whole grid.
  virtual void see(const State& state, int step, int n_steps) = 0;
  /// Whether a reduced model is to compute the state at this time, which costs a product. False: the observer is
  /// answered without states.
  virtual bool wants(double /*time*/) const { return true; }
  /// What this observer must keep for a march that is resumed; its size never changes. recall() takes it back.
  virtual std::vector<double> memory() const { return {}; }
  virtual void recall(const std::vector<double>& /*memory*/) {}
};

/// Calls a function at every state.
class ObserverFunction : public MarchObserver {
 public:
  using Function = std::function<void(const State&, int step, int n_steps)>;
  explicit ObserverFunction(Function function, bool wants_states = true)
      : function_(std::move(function)), wants_states_(wants_states) {}
  void see(const State& state, int step, int n_steps) override { function_(state, step, n_steps); }
  bool wants(double) const override { return wants_states_; }

 private:
  Function function_;
  bool wants_states_;
};

/// Calls `progress`, which may be empty, with the part of the march that is done, 0 to 1.
ObserverFunction progress_observer(std::function<void(double)> progress);

/// Checkpoints of a march. Those of a divided system are of the whole, so that any number of processes can go on from
/// them: all keep one where one of them finds it due, and all resume from the same.
struct Checkpointing {
  std::function<bool()> due;                           ///< asked after every step; none: never
  std::function<void(const MarchCheckpoint&)> keep;    ///< takes it, before observers see that step; none: another does
  std::shared_ptr<const MarchCheckpoint> resume_from;  ///< of the same system, scheme and grid; null: from rest
};

struct MarchOptions {
  std::vector<MarchObserver*> observers;  ///< in this order; they outlive the march
  /// Stop once the loads are over and the stored energy has fallen below this fraction of its largest; 0: never. Loads
  /// are over past the last kink before the end where all are zero and stay zero (keeps_value); prescribed motions
  /// count as loads. A march with a step, a harmonic, or a triangle that outlasts the march therefore never stops
  /// early.
  double stop_at_energy = 0.;
  Checkpointing checkpoints;
  int leap = 1;  ///< number of equal steps taken as one, where the scheme can; not with checkpoints
};

/// Marches from x = x' = 0 at t = 0, where loads count as 0. A load that jumps at the end of a step is recorded with
/// its value before the jump. Of a divided system, every process gets the readings and energies of the whole; an
/// observer sees the states of its process. A resumed march gives the same result as an uninterrupted one, to the last
/// bit, but for the number of factorisations; its observer sees the state that it resumes from. Throws NumericsError
/// where a value is not finite, std::invalid_argument where stop_at_energy is asked of a scheme that keeps no account
/// of energy, or checkpoints of contact.
Response march(const System& system, Scheme& scheme, const TimeGrid& grid, const MarchOptions& options = {});

}  // namespace upbead
