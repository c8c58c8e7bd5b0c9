// Two larger models of the same system, which show how wrong a reduced model is under any load.
#pragma once

#include <functional>
#include <vector>

#include "upbead/dynamics/modal_model.h"

namespace upbead {

struct System;

/// Three nested spaces: that of the model in question lies within that of `middle`, which lies within that of
/// `reference`. The models have only the readings that were asked for.
struct NestedModels {
  ModalModel middle, reference;
  int solves = 0, factorisations = 0;  ///< what both cost
  /// Safety factor on the difference between both in the bound of an answer's error: docs/reduced.md.
  double safety = 1.5;
};

/// The Krylov space of the model in question.
struct NestedSpace {
  double shift = 0.;  ///< s_0 (1/s)
  int vectors = 0;
  std::vector<int> exact;  ///< unknowns that are coordinates themselves
};

/// Makes the space anew and enlarges it: by more vectors about s_0, and by spaces of the same loads about a much lower
/// and a much higher shift, which contain the response to much longer records and to much shorter pulses than those
/// that the space was made for. Throws NumericsError as SecondOrderKrylov and modal_model do.
NestedModels nested_models(const System& system, const NestedSpace& space, const std::vector<int>& readings,
                           const std::function<void(double)>& progress = {});

}  // namespace upbead
