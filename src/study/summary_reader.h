// Numbers of a summary, by their paths.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/output_schema.h"
#include "upbead/output/summary.h"

namespace upbead {

inline constexpr const char* not_in_a_summary = "no summary has it";  ///< of a name that is near another, perhaps

/// Why a path cannot be read from any summary; "" where it can. Wall times cannot, as they differ from run to run.
std::string objection_to_reading(const std::string& path);

/// All paths that can be read, without those of loads, which contain names of the user.
const std::vector<std::string>& readable_paths();

/// The numbers at the paths; none where a summary has null, or no such path.
std::vector<std::optional<double>> numbers_at(const Json& summary, const std::vector<std::string>& paths);

/// What a summary doubts: its checks, names of warnings, each with its text, and the names of those under which no
/// verdict may be drawn.
struct Doubts {
  Checks checks;
  std::vector<std::pair<std::string, std::string>> warnings;
  std::string why_void;
};
Doubts doubts_of(const Summary& summary);

}  // namespace upbead
