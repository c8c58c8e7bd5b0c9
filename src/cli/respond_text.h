// What `respond` prints for people.
#pragma once

#include <string>

#include "output/output_schema.h"
#include "output/wave_response.h"

namespace upbead {

/// The model, its soil, and a table of a few waves; of many, the range of each number.
std::string answers_text(const AnsweredModel& of, const Json& summary, const RespondTiming& timing);

}  // namespace upbead
