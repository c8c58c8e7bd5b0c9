// The many equal steps of a slip model in which nothing happens.
#pragma once

#include <vector>

#include "dynamics/slip_model.h"
#include "dynamics/split_array.h"

namespace upbead {

/// What a step tells.
struct SlipStep {
  double watched = 0.;   ///< at its end: F_T of a phase that sticks (N/m), s' of one that does not (m/s)
  double normal = 0.;    ///< N' at its end (N/m)
  double distance = 0.;  ///< integral of `watched` over it
};

/// Steps of one phase and one length: exact for loads that are straight within a step, O(M K); const and safe to share
/// between threads. What costs exponentials is done once.
class SlipSteps {
 public:
  /// `step` in s. Throws std::invalid_argument where there are more than 16 loads.
  SlipSteps(const SlipPhase& phase, ContactState contact, double step);
  /// Row that is watched.
  static int watched_row(ContactState contact) { return contact == ContactState::stick ? row_shear : row_velocity; }
  /// From a state under loads that go from `begin` to `end` (K); `to` has the size of `from` and
  /// is real where that is.
  SlipStep advance(const detail::SplitArray& from, const Eigen::VectorXd& begin, const Eigen::VectorXd& end,
                   detail::SplitArray& to) const;

 private:
  /// What one load adds to the modes: begin times the first, end times the second.
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

}  // namespace upbead
