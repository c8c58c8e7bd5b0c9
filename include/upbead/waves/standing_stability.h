// Stability of a section in a standing wave of finite height: landward at the crest, seaward in the trough.
#pragma once

#include <optional>
#include <string>

#include "upbead/waves/standing_wave.h"

namespace upbead {

/// By the section's own W', mu and t; in the trough about the seaward edge, without suction under the base.
struct StandingAnswer {
  double wavelength = 0.;  ///< L (m)
  double residual = 0.;    ///< StandingWave::residual
  StandingExtremes worst;
  Stability landward, seaward;  ///< heel_pressure of `seaward` is that of the toe
};

/// The answer, or why there is none.
struct StandingResult {
  std::optional<StandingAnswer> answer;
  std::string why_not;
};

/// For a wave that comes straight at a plain wall, on a flat bed without the mound. All its forces are multiplied by
/// `factor`, as those of a load are.
StandingResult standing_answer(const Section& section, const Water& water, const DesignWave& wave, double factor = 1.);

}  // namespace upbead
