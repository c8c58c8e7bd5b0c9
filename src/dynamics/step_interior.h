// Readings inside the steps of a march.
#pragma once

#include <array>
#include <vector>

#include "dynamics/interpolate.h"
#include "upbead/dynamics/march.h"

namespace upbead {

/// Where readings are kept inside a step, as parts of it: at its begin, after the loads have jumped, and at four more
/// places. With the end they determine a polynomial of degree 5.
constexpr std::array<double, 5> inside_places{0., 0.2, 0.4, 0.6, 0.8};

/// Follows a march by a scheme of order 4 whose end satisfies the equation of motion. Within a step every reading is
/// that of a polynomial through the states of both ends, and of the loads themselves (Hairer, Norsett and Wanner,
/// Solving ODEs I, II.6):
///
///   x by the quintic through x, x' and x'', whose error is O(h^6) in x, O(h^5) in x', O(h^4) in x'';
///   by the quartic without x'' at the begin, where a load has jumped there;
///   by the cubic through x and x', O(h^4) and O(h^3), without inertia and where loads prescribe motions or pressures,
///   as x'' is of first order there;
///   straight where x or x' jumps: where a load jumps without inertia, or one that prescribes; without inertia in the
///   step after that, too, as x' at its begin still holds what is left of the stiff part of the jump.
class StepInterior {
 public:
  /// The system must outlive this.
  explicit StepInterior(const System& system);
  /// The state from which the next step begins, and the length of the step before (s); 0 at rest.
  void begin(const State& state, double last_step);
  /// Adds the readings and loads at inside_places of the step that ends with that state; the next one begins there.
  void add_step(const State& state, Series& inside);

 private:
  /// The rows of one reading applied to a state.
  struct Part {
    Jet position, velocity, acceleration;
  };
  enum class Course { quintic, quartic, cubic, straight };
  using Values = Eigen::Matrix<double, 1, inside_places.size()>;

  Course course(double h) const;
  std::vector<Part> parts_of(const State& state) const;
  /// A reading without its loads, at inside_places.
  static Values values(const Part& before, const Part& now, Course course, double h);

  const System& system_;
  bool inertia_ = false, prescribes_ = false;
  double last_ = 0., last_step_ = 0.;  ///< end and length of the step before (s)
  bool has_jumped_ = false;            ///< whether it was one of a jump without inertia
  std::vector<Part> before_;
};

}  // namespace upbead
