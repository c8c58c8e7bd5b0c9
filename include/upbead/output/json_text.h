// JSON for files and the terminal.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace upbead {

/// The text, indented by two, with a final newline. JSON has no word for a number that is not finite: throws
/// NumericsError with its path.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace upbead
