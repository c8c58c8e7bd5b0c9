// Stability of a section in a standing wave of finite height: landward at the crest, seaward in the trough.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/output_schema.h"
#include "upbead/model/scene.h"
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

/// For a wave that comes straight at a plain wall, on a flat bed without the mound.
StandingResult standing_answer(const Section& section, const Water& water, const DesignWave& wave);

OutputSchema<StandingAnswer> standing_outputs();

/// Cells of a table, in m, kN/m and kPa; "!" marks a value beyond a limit.
std::vector<std::string> standing_head();
std::vector<std::string> standing_row(const std::string& name, const StandingAnswer& answer, const Limits& limits);

/// p_e (Pa); a value above all numbers where the caisson overturns or floats, so that p_e has no meaning.
double severity_of_heel(const Stability& stability);

/// Whether a limit is given and exceeded.
bool too_much_pressure(const Stability& stability, const Limits& limits);
bool overturns_too_easily(const Stability& stability, const Limits& limits);

}  // namespace upbead
