// The reduced model that `expected` sends waves through.
#pragma once

#include <string>

#include "design_tables.h"
#include "expected/dynamic_law.h"
#include "upbead/base/error.h"

namespace upbead {

/// What `expected` takes of a model's file.
struct WaveModel {
  std::string title;
  std::string load;  ///< name of the load that is the wave
  ShearModel shear;
};

/// Reads it and chooses the load. Throws InputError with every mistake, at `place` (of [dynamics]): no caisson, no such
/// load, a load without horizontal force, or a mass that is not the section's weight within 1 %.
WaveModel read_wave_model(const std::string& path, const DynamicsTable& table, const Section& section,
                          const Water& water, const Place& place);

}  // namespace upbead
