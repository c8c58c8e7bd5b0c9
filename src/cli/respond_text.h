// What `respond` prints for people.
#pragma once

#include <string>
#include <vector>

#include "output/wave_response.h"

namespace upbead {

/// The model, its soil, and a table of a few waves; of many, their number, ranges and the worst.
std::string answers_text(const AnsweredModel& of, const std::vector<WaveResponses>& files, const RespondTiming& timing);

}  // namespace upbead
