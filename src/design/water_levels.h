// Still water higher or lower than that of the section: which levels a design is asked at, and which of them governs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "design/design.h"
#include "output/output_schema.h"

namespace upbead {

struct WaveAnswer;

struct WaterLevel {
  std::string name;
  double rise = 0.;  ///< above the section's still water (m)
};

/// That of the section itself among those of a design.
extern const char* const level_of_section;

/// Those of a design and that of its section, the highest first; none where the design has none.
std::vector<WaterLevel> water_levels(const DesignTables& design);

/// Still water must stay above bed, mound and bottom and below the crest, and the caisson heavier than the water.
void check_water_levels(const DesignTables& tables, const Document& document, Diagnostics& report);

/// The level of the worst value of a check.
struct GoverningLevel {
  std::string level;
  double value = 0.;
};

struct GoverningLevels {
  GoverningLevel safety_sliding, safety_overturning;  ///< least
  GoverningLevel heel_pressure;                       ///< largest; above all numbers where it overturns
  std::optional<GoverningLevel> seaward;              ///< least S.F. in the trough of the standing waves that there are
};

/// Of a wave at each level; of equal ones the first, of several at which it overturns the one where it does so most.
GoverningLevels governing(const std::vector<WaveAnswer>& levels);

/// What does not hold of `[limits]`, of the wave as it breaks or as it stands: each of pressure and overturning at its
/// worst.
std::vector<Warning> beyond_limits(const Limits& limits, const WaveAnswer& answer);

OutputSchema<GoverningLevels> governing_outputs();

}  // namespace upbead
