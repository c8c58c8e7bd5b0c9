// What `upbead waves` tells, to people and to programs.
#pragma once

#include <string>
#include <vector>

#include "wave_answer.h"

namespace upbead {

/// Tables of pressures, safety and sliding, a row a wave.
std::string describe(const DesignTables& design, const std::vector<WaveAnswer>& answers);

/// A line for every warning, each once with the waves that it holds for.
std::string warning_lines(const std::vector<WaveAnswer>& answers);

/// summary.json. Throws NumericsError where a number is not finite.
std::string to_json(const DesignTables& design, const std::vector<WaveAnswer>& answers);

}  // namespace upbead
