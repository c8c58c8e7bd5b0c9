// What a standing wave of finite height asks of a section, landward and, in its trough, seaward.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/output_schema.h"
#include "upbead/model/scene.h"
#include "upbead/waves/standing_wave.h"

namespace upbead {

/// By the section's own W', mu and t; of the trough about the seaward edge, without the suction under the base.
struct StandingAnswer {
  double wavelength = 0.;  ///< L (m)
  double residual = 0.;    ///< StandingWave::residual
  StandingExtremes worst;
  Stability landward, seaward;  ///< heel_pressure of `seaward` is that of the toe
};

/// Or why there is none.
struct StandingResult {
  std::optional<StandingAnswer> answer;
  std::string why_not;
};

/// Of a wave that comes straight at a plain wall, on a flat bed without the mound.
StandingResult standing_answer(const Section& section, const Water& water, const DesignWave& wave);

OutputSchema<StandingAnswer> standing_outputs();

/// Cells of a table, m and kN/m and kPa; "!" where a limit is passed.
std::vector<std::string> standing_head();
std::vector<std::string> standing_row(const std::string& name, const StandingAnswer& answer, const Limits& limits);

/// p_e, or more than any number where it says nothing, as the caisson overturns or floats (Pa).
double severity_of_heel(const Stability& stability);

/// Whether a limit is given and passed.
bool too_much_pressure(const Stability& stability, const Limits& limits);
bool overturns_too_easily(const Stability& stability, const Limits& limits);

}  // namespace upbead
