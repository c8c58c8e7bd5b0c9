// The results of `upbead waves`, and their output as JSON and in brief.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "design.h"
#include "design/water_levels.h"
#include "output/checks.h"
#include "sliding/elastic_block.h"
#include "upbead/sliding/pulse.h"
#include "upbead/waves/breaking_impact.h"
#include "upbead/waves/goda.h"
#include "upbead/waves/standing_stability.h"

namespace upbead {

struct OutputRow;

/// Sliding distances of a wave by each formula (m).
struct SlidingDistances {
  double paper = 0.;       ///< S_CAL, eq. (7)
  PaperParts paper_parts;  ///< S_1 and S_2
  double exact = 0.;       ///< eqs. (4) and (6), integrated
  double combined = 0.;    ///< with the standing wave besides the pulse, Shimosako and Takahashi (1998)
};

struct WaveAnswer {
  std::string name;
  std::string level;  ///< of still water; "": the section's own, where the design has no levels
  double rise = 0.;   ///< of that level (m)
  Section section;    ///< the section at that level
  double angle = 0.;  ///< degrees
  DesignWave wave;
  double wavelength = 0.;          ///< L (m)
  WavePressure pressure;           ///< by alpha* = max(alpha_2, alpha_I)
  WavePressure without_alpha_I;    ///< by alpha_2 alone
  Stability stability;             ///< by Goda's formula with alpha_I, even where P was measured
  bool measured = false;           ///< P is given in the design
  double force = 0., uplift = 0.;  ///< that slide the caisson: F_T and U (N/m)
  double tau_0F = 0., k = 0.;      ///< s, 1
  TriangularPulse pulse;           ///< F_Smax = F_T + mu U (N/m), tau_0 (s)
  double ratio = 0.;               ///< r = F_Smax / Stability::resistance
  SlidingDistances sliding;
  std::optional<ElasticSliding> elastic;  ///< on a ground that sways
  StandingResult standing;                ///< in case the wave does not break
  std::optional<BreakingImpact> impact;   ///< in case it does; only where the design has impacts by PROVERBS
  std::optional<double> direction;        ///< from which it comes, as on the chart (degrees)
  std::string direction_words;            ///< how that became `angle`; "" without one
  NumberedWarnings warnings;
  std::vector<WaveAnswer> levels;            ///< the wave at each level, the highest first, with the section's own
  std::optional<GoverningLevels> governing;  ///< where there are levels
};

/// The checks of all waves, each at the level of still water at which it is worst.
Checks checks_of(const DesignTables& design, const std::vector<WaveAnswer>& answers);

/// The warnings of all waves at all levels, equal ones once for each wave.
NumberedWarnings warnings_of(const Design& design, const std::vector<WaveAnswer>& answers);

/// All waves of a design, in the order of their names.
std::vector<WaveAnswer> answer_waves(const DesignTables& design);

/// summary.json. Throws NumericsError where a number is not finite.
Json to_json(const Design& design, const std::vector<WaveAnswer>& answers);
/// The keys of that JSON.
std::vector<OutputRow> rows_of_waves();
/// One screen for the terminal.
std::string brief(const Design& design, const std::vector<WaveAnswer>& answers, const Json& summary);

}  // namespace upbead
