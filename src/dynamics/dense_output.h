// Readings of a march at any times, also between the ends of its steps.
#pragma once

#include <vector>

#include "dynamics/interpolate.h"
#include "upbead/dynamics/march.h"

namespace upbead {

/// Follows a march by a scheme of order 4 whose end satisfies the equation of motion. Within a step every reading is
/// that of a polynomial through the states of both ends, and of the loads themselves (Hairer, Norsett and Wanner,
/// Solving ODEs I, II.6):
///
///   x by the quintic through x, x' and x'', whose error is O(h^6) in x, O(h^5) in x', O(h^4) in x'';
///   by the quartic without x'' at the begin, where a load has jumped there;
///   by the cubic through x and x', O(h^4) and O(h^3), without inertia and where loads prescribe motions or pressures,
///   as x'' is of first order there;
///   straight where x or x' jumps: where a load jumps without inertia, or one that prescribes.
class DenseRecorder : public MarchObserver {
 public:
  /// `times`: ascending (s). The system must outlive this.
  DenseRecorder(const System& system, std::vector<double> times, bool inertia);
  void see(const State& state, int step, int n_steps) override;
  /// At those of the times that the march has reached.
  Series series() const;

 private:
  /// The rows of one reading applied to a state.
  struct Part {
    Jet position, velocity, acceleration;
  };
  enum class Course { quintic, quartic, cubic, straight };

  Course course(double begin, double h) const;
  std::vector<Part> parts_of(const State& state) const;
  double between(const Part& before, const Part& now, Course course, double h, double t) const;
  void record(double time, double inside, double h, Course course, const std::vector<Part>& now);

  const System& system_;
  std::vector<double> times_;
  bool inertia_, prescribes_;
  Series series_;
  double last_ = 0., last_step_ = 0.;  ///< end and length of the step before (s)
  std::vector<Part> before_;
};

/// The columns of a series at those times (s), each within `tolerance` (s); times without a column are left out.
Series at_times(const Series& series, const std::vector<double>& times, double tolerance);

/// Linear interpolation between the columns of a series, at those of the times that it covers: as accurate as a
/// scheme of order 2.
Series straight_between(const Series& series, const std::vector<double>& times);

}  // namespace upbead
