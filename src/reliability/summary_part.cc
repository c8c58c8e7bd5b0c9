// The part of a sheet that another process has written as its summary.
#include "reliability/answer.h"

namespace upbead {

namespace {

std::optional<double> number_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || !found->is_number() ? std::nullopt : std::optional(found->get<double>());
}

std::string words_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || !found->is_string() ? "" : found->get<std::string>();
}

Check check_in(const Json& json) {
  Check check = check_of(FailureMode::failure_of_life, words_in(json, "name"), words_in(json, "unit"),
                         number_in(json, "demand"), words_in(json, "measure"), words_in(json, "assumption"));
  check.by = words_in(json, "by");
  check.wave = words_in(json, "wave");
  check.level = words_in(json, "level");
  check.probability = number_in(json, "probability");
  const std::optional<double> capacity = number_in(json, "capacity");
  check = json.contains("at_least") ? at_least_as(check, capacity) : at_most(check, capacity);
  const std::string why = words_in(json, "why_not");
  return why.empty() ? check : not_checked(check, why);
}

NumberedWarning warning_in(const Json& json, const std::string& voids) {
  NumberedWarning warning{words_in(json, "name"),
                          number_in(json, "value").value_or(0.),
                          number_in(json, "limit").value_or(0.),
                          words_in(json, "unit"),
                          words_in(json, "text"),
                          words_in(json, "cure")};
  const std::string end = "; " + warning.cure;  // of the text, see NumberedWarning::text()
  if (!warning.cure.empty() && warning.what.size() > end.size()) warning.what.erase(warning.what.size() - end.size());
  warning.voids = ("; " + voids + "; ").find("; " + warning.name + "; ") != std::string::npos;
  return warning;
}

}  // namespace

Checks checks_in(const Json& summary) {
  Checks list;
  for (const Json& json : summary.at("checks")) list.push_back(check_in(json));
  return list;
}

NumberedWarnings warnings_in(const Json& summary) {
  NumberedWarnings list;
  const std::string voids = words_in(summary.at("verdict"), "why_void");
  for (const Json& json : summary.at("warnings")) list.push_back(warning_in(json, voids));
  return list;
}

}  // namespace upbead
