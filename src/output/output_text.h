// A summary for the terminal, made from the declaration of its keys: a line each, with value, unit and label.
#pragma once

#include <string>
#include <vector>

#include "output/output_schema.h"

namespace upbead {

/// Objects and lists get a heading, and what is inside is indented. Nothing of what is null or empty.
std::string text_of(const Json& summary, const std::vector<OutputRow>& rows);

}  // namespace upbead
