// Still water above or below that of the section: the levels at which a design is computed, and which of them
// governs.
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

/// Name of the section's own level among the levels of a design.
extern const char* const level_of_section;

/// The levels of a design and that of its section, the highest first; empty where the design has no levels.
std::vector<WaterLevel> water_levels(const DesignTables& design);

/// What is wrong with a level, and how to correct it; without words where nothing is.
Diagnostic misfit(const WaterLevel& level, const Section& section, const Water& water);

/// Still water must stay above bed, mound and bottom and below the crest, and the caisson must not float.
void check_water_levels(const DesignTables& tables, const Document& document, Diagnostics& report);

/// At each level still water at two levels must leave the caisson where it is, and every wave must press on the wall.
void check_what_acts(const DesignTables& tables, const Document& document, Diagnostics& report);

/// The level at which the value of a check is worst, and that value.
struct GoverningLevel {
  std::string level;
  std::optional<double> value;  ///< none: p_e where the caisson overturns or floats
};

struct GoverningLevels {
  GoverningLevel safety_sliding, safety_overturning;  ///< least
  GoverningLevel heel_pressure;                       ///< largest; where it overturns or floats above all numbers
  GoverningLevel seaward;                             ///< least S.F. in the trough of the standing wave, or its bound
};

/// For one wave at all levels. Of equal values the first level governs; of several levels at which the caisson
/// overturns, the one with the least safety.
GoverningLevels governing(const std::vector<WaveAnswer>& levels);

/// The `[limits]` that a wave exceeds, breaking or standing; pressure and overturning each at its worst.
NumberedWarnings beyond_limits(const Limits& limits, const WaveAnswer& answer);

OutputSchema<GoverningLevels> governing_outputs();

}  // namespace upbead
