// Forces and motion of the caisson between the ends of the steps.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "dynamics/interpolate.h"
#include "fem/compile.h"
#include "upbead/dynamics/march.h"

namespace upbead {

using Samples = Eigen::RowVectorXd;

/// The values of a reading at all times of a series.
Samples samples(const CompiledScene& compiled, const Series& series, const char* name);

/// F_T and x_G between the ends of each step. A scheme of order 4 has x_G, x_G' and x_G'' good enough for a quintic; of
/// order 2 their errors, divided by h^2, would spoil its second derivative, so x_G'' is linear there; so it is in steps
/// so short that their round-off does.
///
/// Water answers acceleration at once, so its force is taken as -m_a x_G'' + r: the added mass m_a is fitted to the
/// whole march, r is small and linear within a step, and where P jumps x_G'' jumps by its jump over m + m_a.
class InsideSteps {
 public:
  InsideSteps(const CompiledScene& compiled, const Response& response, const TimeFunction& P);

  /// Extreme of P + `water` - m x_G'', `water` being a force of the water at the ends of the steps.
  Extremum shear_force(int sign, const Samples& water) const;
  Extremum displacement(int sign) const;
  /// Calls `see` with times and P + `water` - m x_G'': from the start of each step to its end in up to 16 equal parts.
  void for_each(const Samples& water, const std::function<void(double t, double shear_force, double P)>& see) const;

 private:
  /// What the water does: -m_a x_G'' + rest, rest linear within a step.
  struct WaterPart {
    double added_mass;
    Samples rest;
  };
  WaterPart split(const Samples& water) const;
  double shear_force_at(std::size_t n, double t, const WaterPart& water) const;
  double middle(std::size_t n) const { return 0.5 * (time_[n] + time_[n + 1]); }
  double acceleration(std::size_t n, std::size_t end) const;
  QuinticHermite motion(std::size_t n) const;
  double acceleration_at(std::size_t n, double t) const;
  double jerk(std::size_t n) const;  ///< mean of step n
  bool is_smooth(std::size_t n) const;
  double added_mass(const Samples& water) const;

  const std::vector<double>& time_;
  Samples x_, v_, a_;  ///< a as of the step that ends there
  const TimeFunction& P_;
  double mass_;
  double all_added_mass_;
  std::vector<bool> quintic_;  ///< whether x_G is one, by step
};

}  // namespace upbead
