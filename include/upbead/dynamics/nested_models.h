// Two larger models of the same system, which tell how far a reduced model is off under any load.
#pragma once

#include <functional>
#include <vector>

#include "upbead/dynamics/modal_model.h"

namespace upbead {

struct System;

/// Models on spaces that hold each other: that of the model in question, of `middle`, of `reference`. Their readings
/// are those asked for alone.
struct NestedModels {
  ModalModel middle, reference;
  int solves = 0, factorisations = 0;  ///< that they took
};

/// The Krylov space of the model in question.
struct NestedSpace {
  double shift = 0.;  ///< s_0 (1/s)
  int vectors = 0;
  std::vector<int> exact;  ///< unknowns that are kept as they are
};

/// Makes the space anew and enlarges it: by more vectors about s_0, and by spaces of the same loads about a much lower
/// and a much higher shift, which hold the answers to records much longer and pulses much shorter than those that the
/// space was made for. Throws NumericsError as SecondOrderKrylov and modal_model do.
NestedModels nested_models(const System& system, const NestedSpace& space, const std::vector<int>& readings,
                           const std::function<void(double)>& progress = {});

}  // namespace upbead
