#include "output/json_text.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "upbead/base/error.h"

namespace upbead {

namespace {

void require_finite(const nlohmann::ordered_json& value, const std::string& path) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw NumericsError("'" + path + "' of the summary is not finite; nothing was written");
  if (value.is_structured())
    for (const auto& item : value.items()) require_finite(item.value(), path + "/" + item.key());
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& json) {
  require_finite(json, "");
  return json.dump(2) + "\n";
}

}  // namespace upbead
