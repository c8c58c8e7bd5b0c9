// A scene as one of many with other soils, which one reduced model answers.
#pragma once

#include <memory>
#include <optional>

#include "dynamics/reduced_family.h"
#include "fem/compile.h"
#include "response/slip_reduction.h"

namespace upbead {

/// What stands for the scene's System: a small one in the coordinates of a basis for all soils.
struct SoilMember {
  CompiledScene compiled;
  double error = 0.;                      ///< estimated, of held_readings() over their peaks, by the basis
  std::shared_ptr<const FieldBasis> phi;  ///< see of_bonded_members()
  std::optional<SlipSystem> slip;  ///< with a caisson that slips as a whole; none: the scene itself is assembled for it
  std::shared_ptr<BasisRoom> room = nullptr;  ///< for the basis of `compiled`
};

}  // namespace upbead
