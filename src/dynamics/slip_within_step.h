// What may happen within a step of a slip model: how far its readings can leave a straight line, and what loads do.
#pragma once

#include <vector>

#include "dynamics/slip_model.h"
#include "dynamics/split_array.h"

namespace upbead {

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
  double work = 0.;   ///< most that SlipWithinStep::work() is wrong by (J/m)
};

/// Of one phase and one length; const and safe to share between threads.
class SlipWithinStep {
 public:
  /// `rows`: of what the loads do work on, see load_rows(); `step` in s.
  SlipWithinStep(const SlipPhase& phase, const Eigen::MatrixXd& rows, double step);
  /// From a state under loads that go from `begin` to `end`.
  SlipBends bends(const detail::SplitArray& from, const Eigen::VectorXd& begin, const Eigen::VectorXd& end) const;
  /// Of the loads (J/m), with `to` the state at the end: int f v = mean f int v + change of f int (t/h - 1/2) v. The
  /// first integral is exact, v counts as straight in the second, which a bend of v makes wrong by a quarter of it at
  /// most.
  double work(const detail::SplitArray& from, const detail::SplitArray& to, const Eigen::VectorXd& begin,
              const Eigen::VectorXd& end) const;
  /// The same of a shorter piece of time whose velocities are straight.
  double work_of_piece(const detail::SplitArray& from, const detail::SplitArray& to, const Eigen::VectorXd& begin,
                       const Eigen::VectorXd& end, double length) const;

 private:
  /// What one load adds.
  struct Input {
    int load;
    detail::SplitArray bend, bend_slope;  ///< to z'', of its value and its slope
    detail::SplitArray begin, end;        ///< to the integral of z, of its values at the ends
  };
  /// Per |z''|: of modes that are slow within a step, and of fast ones.
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
  detail::SplitArray integral_;  ///< of z, per z
  std::vector<Input> inputs_;
  std::vector<Worker> workers_;
};

/// Rows B^T of s' = A s + B f in energy coordinates, K x N: d(s.s/2)/dt = f.(B^T s) - what is lost. N_0 does no work.
Eigen::MatrixXd load_rows(const SlipModel& model);

}  // namespace upbead
