// Where the formulas are used beyond what they were made from.
#pragma once

#include <string>
#include <vector>

#include "upbead/waves/goda.h"

namespace upbead {

/// A named warning with its numbers.
struct Warning {
  std::string name;  ///< such as "impulsive_breaking", "height_over_depth"
  std::string text;
};

/// All that hold for a wave on a section.
std::vector<Warning> warnings(const Section& section, const Water& water, const DesignWave& wave,
                              const WavePressure& pressure);

}  // namespace upbead
