// Sliding as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "upbead/output/summary.h"

namespace upbead {

/// The object of docs/output.md; null where a value does not exist.
nlohmann::ordered_json to_object(const SlidingSummary& sliding);

}  // namespace upbead
