// The many equal steps of a slip model in which the phase does not change, and bounds that show that it does not.
#pragma once

#include <vector>

#include "dynamics/lanes.h"
#include "dynamics/slip_model.h"

namespace upbead {

/// Readings at the end of a step.
struct SlipStep {
  double watched = 0.;  ///< F_T of a phase that sticks (N/m), s' of one that does not (m/s)
  double normal = 0.;   ///< N' (N/m)
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

/// What happens within a step.
struct SlipWithin {
  SlipBend velocity;       ///< s' (m/s)
  SlipBend normal;         ///< N' (N/m)
  double distance = 0.;    ///< integral of s' (m)
  double work = 0.;        ///< of the loads (J/m)
  double work_error = 0.;  ///< the largest of that (J/m)
};

/// Steps of one phase and one length: exact for loads that are straight within a step, O(M K); const and safe to
/// share between threads. Exponentials are computed once.
class SlipSteps {
 public:
  /// `rows`: of the velocities on which the loads do work, see load_rows(); `step` in s.
  SlipSteps(const SlipPhase& phase, ContactState contact, const Eigen::MatrixXd& rows, double step);
  /// Row that is watched.
  static int watched_row(ContactState contact) { return contact == ContactState::stick ? row_shear : row_velocity; }
  /// Advances from a state under loads that go from `begin` to `end` (K); `to` has the size of `from`, and is real
  /// where `from` is.
  SlipStep advance(const detail::SplitArray& from, const Eigen::VectorXd& begin, const Eigen::VectorXd& end,
                   detail::SplitArray& to) const;
  /// Bounds, distance and work in that step, of a phase that does not stick; `to` as it was found. The work is int f v
  /// = mean f int v + change of f int (t/h - 1/2) v: the first integral is exact, as the distance; in the second v
  /// counts as straight, and a bend of v makes it wrong by a quarter of the bend at most.
  SlipWithin within(const detail::SplitArray& from, const detail::SplitArray& to, const Eigen::VectorXd& begin,
                    const Eigen::VectorXd& end) const;
  /// The work in a shorter piece of time, on which velocities are straight.
  double work_of_piece(const detail::SplitArray& from, const detail::SplitArray& to, const Eigen::VectorXd& begin,
                       const Eigen::VectorXd& end, double length) const;

  /// What one load adds to the modes.
  struct Input {
    int load;
    detail::SplitArray rate;        ///< to z', by its value
    detail::SplitArray begin, end;  ///< to z at the end of a step, by its values at the ends
  };

 private:
  /// Weights of |z''|: for modes that are slow within a step, and for fast ones.
  struct Weights {
    Eigen::ArrayXd slow, fast;
  };
  /// The integral of a reading over the step, without its direct part: by the modes at the beginning, and by the loads
  /// at both ends.
  struct Integral {
    detail::SplitArray from;
    Eigen::RowVectorXd begin, end;
  };
  /// A load that does work, and its row.
  struct Worker {
    int load;
    detail::SplitArray row;
    Integral integral;
    Weights weights;
  };
  static Weights weights(const Eigen::VectorXcd& reading, const Eigen::VectorXcd& pole, double step);
  /// What loads add to z'.
  detail::SplitArray rate(const Eigen::VectorXd& loads) const;

  double step_;
  Eigen::Index n_pairs_ = 0;  ///< modes that may be complex come first
  detail::SplitArray pole_, E_, watched_, normal_;
  Integral distance_;  ///< of s'
  Weights velocity_weights_, normal_weights_;
  std::vector<Input> inputs_;
  std::vector<Worker> workers_;
  Eigen::RowVectorXd watched_load_, normal_load_;
};

/// Rows B^T of s' = A s + B f in energy coordinates, K x N: d(s.s/2)/dt = f.(B^T s) minus the losses. N_0 does no
/// work.
Eigen::MatrixXd load_rows(const SlipModel& model);

}  // namespace upbead
