// What is looked at in every state of a solution: least pressure of the water, mobilised strength of linear soil, shear
// of sand that builds pore pressure, excess pressure below the surface of the ground.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "response/cyclic_shear.h"
#include "response/monitors.h"
#include "response/upward_pressure.h"
#include "upbead/run/simulation.h"

namespace upbead {

struct Monitors {
  /// For the simulation that will be solved, which must outlive the march.
  /// `shared_before`: a part of the march is done by several processes, which kept nothing of what is looked at.
  explicit Monitors(const Simulation& simulation, bool shared_before = false);

  /// The observers of a march; this object must outlive the march.
  std::vector<MarchObserver*> observers();

  std::optional<LeastPressure> pressure;
  std::optional<Mobilisation> strength;
  std::optional<CyclicShear> cyclic;
  std::optional<UpwardPressure> upward;  ///< where [limits] liquefaction asks for it
  std::optional<StaticStage> rest;       ///< the ground at rest, where strength or cycles ask for it
  std::string why_no_pressure, why_no_strength, why_no_cyclic;  ///< "" where there is one
};

/// Those of the march, or what they see in all that a reduced model answers.
std::shared_ptr<const Monitors> monitors_of(const Solution& solution);

}  // namespace upbead
