#include "summary_reader.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "upbead/input/node.h"
#include "upbead/output/summary.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

/// A summary with everything in it.
Json full_summary() {
  Summary summary;
  summary.response.emplace();
  summary.energy.emplace();
  summary.reduction.emplace();
  summary.sliding.emplace();
  summary.sliding->history.own.emplace();
  summary.sliding->pulse.emplace();
  summary.sliding->equal_impulse.emplace();
  summary.sliding->coupled.emplace();
  summary.sliding->why_not_coupled = "a reason";
  summary.contact.emplace().solved.emplace();
  summary.soil.emplace();
  return Json::parse(to_json(summary));
}

/// Adds the paths of all numbers below `json`; null stands for a number that this summary has not.
void collect(const Json& json, const std::string& path, std::vector<std::string>& list) {
  if (json.is_object())
    for (const auto& [key, value] : json.items()) collect(value, dotted(path, key), list);
  else if (json.is_number() || json.is_null())
    list.push_back(path);
}

const Json* find(const Json& json, const std::string& path) {
  const Json* at = &json;
  for (const std::string& key : split_dotted(path)) {
    if (!at->is_object() || !at->contains(key)) return nullptr;
    at = &at->at(key);
  }
  return at;
}

}  // namespace

const std::vector<std::string>& readable_paths() {
  static const std::vector<std::string> list = [] {
    Json json = full_summary();
    json.erase("timing");
    std::vector<std::string> paths;
    collect(json, "", paths);
    return paths;
  }();
  return list;
}

std::string objection_to_reading(const std::string& path) {
  const std::vector<std::string> keys = split_dotted(path);
  if (keys.front() == "timing") return "wall times differ from run to run; summary.json of the study has them";
  if (keys.front() == "measured") return keys.size() == 3 ? "" : "of records it takes measured.NAME.rms or the like";
  if (keys.front() == "gauges")
    return keys.size() == 3
               ? ""
               : "of gauges it takes gauges.NAME.peak_force or the like, such as gauges.\"sliding.uplift\".arm";
  if (keys.front() == "loads") return keys.size() == 3 ? "" : "of a load it takes loads.NAME.arm or the like";
  const std::vector<std::string>& known = readable_paths();
  if (std::find(known.begin(), known.end(), path) != known.end()) return "";
  return find(full_summary(), path) != nullptr ? "it is no number" : "no summary has it";
}

std::vector<std::optional<double>> numbers_at(const std::string& summary_json, const std::vector<std::string>& paths) {
  const Json json = Json::parse(summary_json);
  std::vector<std::optional<double>> numbers;
  for (const std::string& path : paths) {
    const Json* value = find(json, path);
    numbers.push_back(value != nullptr && value->is_number() ? std::optional(value->get<double>()) : std::nullopt);
  }
  return numbers;
}

}  // namespace upbead
