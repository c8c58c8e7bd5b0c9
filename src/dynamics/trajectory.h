// What a system did, at any time.
#pragma once

#include <vector>

#include "upbead/dynamics/march.h"
#include "upbead/dynamics/modal_model.h"

namespace upbead {

/// Times between which straight lines follow a trajectory.
struct Rows {
  std::vector<double> time;  ///< s
  /// Largest difference of these lines from the trajectory, over each reading's largest value; negative where nothing
  /// is known between the times.
  double error = -1.;
};

/// The readings of a response at any time, not only at the ends of its steps. Inside a step of a march by a scheme of
/// order 4 they are those of a polynomial of degree 5, with the loads themselves (dynamics/step_interior.h); those of a
/// reduced model are exact for loads that are linear between its times; else they are straight between the ends.
class Trajectory {
 public:
  /// `model`: what gave the response; null: it was marched. All must outlive this; the system may have fewer readings
  /// than the model, of which it has the first.
  Trajectory(const System& system, const Response& response, const ModalModel* model = nullptr);

  /// At ascending times (s). Where a load jumps, a reading belongs to the load's value before the jump. Times after the
  /// end of the response are left out.
  Series at(const std::vector<double>& times) const;

  /// The ends of the steps, with one row after each jump and as many equally spaced ones inside each step as straight
  /// lines need to err by at most `tolerance`, in these readings; but at most `most` in all. The ends alone where they
  /// are more, or where nothing is known between them.
  Rows rows(const std::vector<Eigen::Index>& readings, double tolerance, std::size_t most) const;

 private:
  bool is_straight() const { return model_ == nullptr && response_.inside.time.empty(); }
  double near() const { return 1e-8 * response_.ends.time.back(); }  ///< times so close are one (s)
  Series inside(const std::vector<double>& times) const;
  Series modal(const std::vector<double>& times) const;
  Eigen::MatrixXd at_begins() const;

  const System& system_;
  const Response& response_;
  const ModalModel* model_;
  std::vector<TimeFunction> loads_;
  Eigen::MatrixXd feedthrough_;  ///< of the loads to the readings
};

}  // namespace upbead
