// F_T of a caisson under any wave force, by its reduced model on one time step.
#pragma once

#include <vector>

#include "dynamics/batch_response.h"

namespace upbead {

/// Which part of a reduced model answers.
struct ShearModel {
  ModalModel modes;            ///< of everything that was reduced
  int load = 0;                ///< the load that is the wave
  int shear = 0;               ///< the reading F_T
  double force_per_load = 1.;  ///< P (N/m) of a unit of that load
  double caisson_mass = 0.;    ///< W/g (kg/m)
};

/// What is known of a force before it is sampled: P(0) = 0 and how steep it is.
struct ForceLimits {
  double largest = 0.;      ///< |P| (N/m)
  double rise = 0.;         ///< how long it may be steep at first (s)
  double first_slope = 0.;  ///< largest |P'| until then (N/m/s)
  double later_slope = 0.;  ///< and afterwards
};

/// Safe to share between threads.
class ShearAnswer {
 public:
  /// `step`: of all waves (s). `longest`: how long a wave may last for bound() to know it (s).
  ShearAnswer(const ShearModel& model, double step, double longest);
  /// F_T for P, both in n samples from t = 0, where P is 0; straight in between.
  void respond(const double* force, int n, double* shear) const;
  /// No |F_T| among the first n samples exceeds this; infinity for longer waves than known.
  double bound(const ForceLimits& force, int n) const;
  double step() const { return step_; }
  double caisson_mass() const { return mass_; }

 private:
  void make_bounds(int n);

  double step_, mass_, load_per_force_;
  BatchResponse batch_;
  /// Of the answer a to a hat function and the answer s to a ramp of one step that stays at 1:
  std::vector<double> hat_;           ///< sum of the first |a|
  std::vector<double> late_;          ///< sum of the first |s - 1| times the step (s)
  std::vector<double> late_windows_;  ///< the largest such sum over i * stride_ neighbours (s)
  int stride_ = 1;
};

}  // namespace upbead
