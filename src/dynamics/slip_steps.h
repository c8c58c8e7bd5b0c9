// The many equal steps of a slip model in which the phase does not change, and bounds that show that it does not.
#pragma once

#include <vector>

#include "dynamics/lanes.h"
#include "dynamics/slip_model.h"

namespace upbead {

/// Readings of a step.
struct SlipStep {
  double watched = 0.;   ///< at its end: F_T of a phase that sticks (N/m), s' of one that does not (m/s)
  double normal = 0.;    ///< N' at its end (N/m)
  double distance = 0.;  ///< integral of `watched` over the step
};

/// Steps of one phase and one length: exact for loads that are straight within a step, O(M K); const and safe to
/// share between threads. Exponentials are computed once.
class SlipSteps {
 public:
  /// `step` in s. Throws std::invalid_argument where there are more than 16 loads.
  SlipSteps(const SlipPhase& phase, ContactState contact, double step);
  /// Row that is watched.
  static int watched_row(ContactState contact) { return contact == ContactState::stick ? row_shear : row_velocity; }
  /// Advances from a state under loads that go from `begin` to `end` (K); `to` has the size of `from`, and is real
  /// where `from` is.
  SlipStep advance(const detail::SplitArray& from, const Eigen::VectorXd& begin, const Eigen::VectorXd& end,
                   detail::SplitArray& to) const;

 private:
  /// What one load adds to the modes: its value at the beginning times `begin`, plus its value at the end times
  /// `end`.
  struct Input {
    int load;
    detail::SplitArray begin, end;
  };

  Eigen::Index n_pairs_ = 0;  ///< modes that may be complex come first
  detail::SplitArray E_, watched_, normal_, distance_;
  std::vector<Input> inputs_;
  Eigen::RowVectorXd watched_load_, normal_load_;
  Eigen::RowVectorXd distance_begin_, distance_end_;
};

/// A reading stays within 4 slow (t/h) (1 - t/h) + fast of the straight line between its values at the ends of a step
/// h: every mode's part y has y'' = y''(0) e^(pt) under loads that are straight, so it leaves its chord by no more than
/// max|y''| t (h - t)/2, and by no more than 2 max|y''|/|p|^2.
struct SlipBend {
  double slow = 0., fast = 0.;
  /// Whether a reading that is `begin` and `end` at the ends cannot fall below zero between them: the least of
  /// a (1 - x) + b x - 4 slow x (1 - x) on [0, 1] is not negative where sqrt(a) + sqrt(b) >= 2 sqrt(slow).
  bool stays_positive(double begin, double end) const;
};

struct SlipBends {
  SlipBend velocity;  ///< s' (m/s)
  SlipBend normal;    ///< N' (N/m)
  double work = 0.;   ///< largest error of SlipWithinStep::work() (J/m)
};

/// Bounds and work within a step, for one phase and one length; const and safe to share between threads.
class SlipWithinStep {
 public:
  /// `rows`: of the velocities on which the loads do work, see load_rows(); `step` in s.
  SlipWithinStep(const SlipPhase& phase, const Eigen::MatrixXd& rows, double step);
  /// Bounds for a step from a state, under loads that go from `begin` to `end`.
  SlipBends bends(const detail::SplitArray& from, const Eigen::VectorXd& begin, const Eigen::VectorXd& end) const;
  /// Work of the loads (J/m), with `to` the state at the end: int f v = mean f int v + change of f int (t/h - 1/2) v.
  /// The first integral is exact. In the second v counts as straight; a bend of v makes it wrong by a quarter of the
  /// bend at most.
  double work(const detail::SplitArray& from, const detail::SplitArray& to, const Eigen::VectorXd& begin,
              const Eigen::VectorXd& end) const;
  /// The same for a shorter piece of time on which velocities are straight.
  double work_of_piece(const detail::SplitArray& from, const detail::SplitArray& to, const Eigen::VectorXd& begin,
                       const Eigen::VectorXd& end, double length) const;

 private:
  /// What one load adds to the modes.
  struct Input {
    int load;
    detail::SplitArray bend, bend_slope;  ///< to z'', by its value and by its slope
    detail::SplitArray begin, end;        ///< to the integral of z, by its values at the ends
  };
  /// Weights of |z''|: for modes that are slow within a step, and for fast ones.
  struct Weights {
    Eigen::ArrayXd slow, fast;
  };
  /// A load that does work, and its row.
  struct Worker {
    int load;
    detail::SplitArray row;
    Weights weights;
  };
  static Weights weights(const Eigen::VectorXcd& reading, const Eigen::VectorXcd& pole, double step);

  double step_;
  Weights velocity_, normal_;
  detail::SplitArray square_;    ///< p^2
  detail::SplitArray integral_;  ///< of z over the step, per z
  std::vector<Input> inputs_;
  std::vector<Worker> workers_;
};

/// Rows B^T of s' = A s + B f in energy coordinates, K x N: d(s.s/2)/dt = f.(B^T s) minus the losses. N_0 does no
/// work.
Eigen::MatrixXd load_rows(const SlipModel& model);

}  // namespace upbead
