#include "summary_reader.h"

#include <algorithm>

#include "case/case_findings.h"
#include "output/checks.h"
#include "upbead/input/node.h"

namespace upbead {

namespace {

/// The part of a path before it becomes a list or has names of the user: "sliding.slips" of "sliding.slips[].start".
std::string plain_part(const std::string& path) {
  return path.substr(0, std::min(path.find("[]"), path.find(".NAME")));
}

const Json* find(const Json& json, const std::string& path) {
  const Json* at = &json;
  for (const std::string& key : split_dotted(path)) {
    if (at->is_array()) {
      const auto item = std::find_if(at->begin(), at->end(),
                                     [&key](const Json& i) { return i.is_object() && i.value("name", "") == key; });
      if (item == at->end()) return nullptr;
      at = &*item;
      continue;
    }
    if (!at->is_object() || !at->contains(key)) return nullptr;
    at = &at->at(key);
  }
  return at;
}

/// Whether a number stands at a path in which a name of the user is: "wave_loads.storm.safety_sliding"; or the name of
/// an item of a list: "checks.tilt.margin".
bool names_a_number(const std::vector<std::string>& keys) {
  if (keys.size() != 3) return false;
  const std::string list = keys[0] + "[]." + keys[2], named = keys[0] + ".NAME." + keys[2];
  const std::vector<OutputRow> rows = summary_outputs().rows();
  return std::any_of(rows.begin(), rows.end(),
                     [&](const OutputRow& row) { return row.is_number && (row.path == list || row.path == named); });
}

}  // namespace

const std::vector<std::string>& readable_paths() {
  static const std::vector<std::string> list = [] {
    std::vector<std::string> paths;
    for (const OutputRow& row : summary_outputs().rows())
      if (row.is_number && plain_part(row.path) == row.path && split_dotted(row.path).front() != "timing")
        paths.push_back(row.path);
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
  if (keys.front() == "wave_loads" && !names_a_number(keys))
    return "of a wave it takes wave_loads.NAME.safety_sliding or the like";
  if (keys.front() == "checks" && !names_a_number(keys))
    return "of a check it takes its margin or the like by its name, as checks.\"sliding distance\".margin";
  if (keys.front() == "wave_loads" || keys.front() == "checks") return "";
  if (keys.front() == "loads") return keys.size() == 3 ? "" : "of a load it takes loads.NAME.arm or the like";
  const std::vector<std::string>& known = readable_paths();
  if (std::find(known.begin(), known.end(), path) != known.end()) return "";
  for (const OutputRow& row : summary_outputs().rows())
    if (plain_part(row.path) == path) return "it is no number";
  return not_in_a_summary;
}

std::vector<std::optional<double>> numbers_at(const Json& summary, const std::vector<std::string>& paths) {
  std::vector<std::optional<double>> numbers;
  for (const std::string& path : paths) {
    const Json* value = find(summary, path);
    numbers.push_back(value != nullptr && value->is_number() ? std::optional(value->get<double>()) : std::nullopt);
  }
  return numbers;
}

Doubts doubts_of(const Summary& summary) {
  Doubts doubts{summary.checks, {}, verdict_of(summary.checks, summary.warnings).why_void};
  for (const NumberedWarning& warning : summary.warnings) doubts.warnings.emplace_back(warning.name, warning.text());
  return doubts;
}

}  // namespace upbead
