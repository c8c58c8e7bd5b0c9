// The object `contact` of summary.json.
#pragma once

#include <nlohmann/json.hpp>

#include "upbead/output/summary.h"

namespace upbead {

nlohmann::ordered_json to_object(const ContactSummary& contact);

}  // namespace upbead
