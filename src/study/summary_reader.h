// Numbers out of a summary.json by their paths.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace upbead {

/// Why a path can be read of no summary; "" where it may be. Wall times cannot: they differ from run to run.
std::string objection_to_reading(const std::string& path);

/// All paths that may be read, but those of loads, which have names of their own.
const std::vector<std::string>& readable_paths();

/// The numbers at the paths; none where a summary has null, or nothing, there.
std::vector<std::optional<double>> numbers_at(const std::string& summary_json, const std::vector<std::string>& paths);

}  // namespace upbead
