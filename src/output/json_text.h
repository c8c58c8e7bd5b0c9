// JSON for files and the terminal.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace upbead {

/// null where there is no value.
inline nlohmann::ordered_json json_or_null(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// The text, indented by two, with a final newline. JSON has no word for a number that is not finite: throws
/// NumericsError with its path.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace upbead
