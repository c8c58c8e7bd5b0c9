// Reduced models made by hand, with impulse responses known in closed form.
#pragma once

#include "upbead/dynamics/modal_model.h"

namespace upbead::test {

/// m x'' + c x' + k x = f, underdamped, as one mode; readings x, x' and x''.
struct Oscillator {
  double m = 2., c = 1.2, k = 800.;

  std::complex<double> pole() const;
  ModalModel model() const;
  /// x(t) of an impulse of 1 at t = 0.
  double impulse_response(double t) const;
  /// x(t) of a force of 1 from t = 0 on.
  double step_response(double t) const;
};

/// y = z with z' = pole z + f.
ModalModel single_mode(std::complex<double> pole);

/// n_modes random modes for steps of order `step` (s): slow and fast, pairs and real poles, poles at 0 and on the
/// imaginary axis, one whose period is one step, and load factors that are zero; with feedthrough and impulse.
ModalModel random_model(int n_modes, int n_loads, int n_readings, double step);

}  // namespace upbead::test
