// A chain of masses and springs with its modes in closed form.
#pragma once

#include "sample_system.h"
#include "upbead/dynamics/modal_model.h"

namespace upbead::test {

/// n unit masses, each tied to the next by a unit spring, the first to a rigid base, each with a dashpot of
/// coefficient `damping` to the rigid base; a force at the free end. Readings "end" and "inside" (at three quarters)
/// are displacements.
struct SpringChain {
  int n = 300;
  double damping = 0.004;

  System system(const TimeFunction& force) const;
  /// All n modes: omega_j = 2 sin(a_j / 2), shape sin(i a_j), a_j = (2 j - 1) pi / (2 n + 1).
  ModalModel exact() const;
};

}  // namespace upbead::test
