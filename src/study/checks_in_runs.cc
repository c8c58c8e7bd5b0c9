#include "study/checks_in_runs.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/text.h"

namespace upbead {

namespace {

/// The names under which a journal keeps a check, in short.
constexpr const char *name_key = "name", *mode_key = "mode", *limit_key = "limit", *unit_key = "unit",
                     *demand_key = "demand", *capacity_key = "capacity", *margin_key = "margin", *holds_key = "holds",
                     *measure_key = "measure", *by_key = "by", *wave_key = "wave", *level_key = "level",
                     *why_key = "why_not", *least_key = "at_least";

bool fails(const Check& check) {
  return check.holds && !*check.holds;
}

bool is_same(const Check& a, const Check& b) {
  return name_of(a) == name_of(b) && a.by == b.by;
}

bool is_kept(const Check& check) {
  return check.holds || (check.capacity && !check.why_not.empty() && !check.limit.empty());
}

/// Calls visit(key, member) for all texts and numbers of a check.
template <class Visit>
void for_each_text(Visit visit) {
  visit(name_key, &Check::name);
  visit(limit_key, &Check::limit);
  visit(unit_key, &Check::unit);
  visit(measure_key, &Check::measure);
  visit(by_key, &Check::by);
  visit(wave_key, &Check::wave);
  visit(level_key, &Check::level);
  visit(why_key, &Check::why_not);
}
template <class Visit>
void for_each_number(Visit visit) {
  visit(demand_key, &Check::demand);
  visit(capacity_key, &Check::capacity);
  visit(margin_key, &Check::margin);
}

}  // namespace

Json to_json(const Checks& checks) {
  Json list = Json::array();
  for (const Check& check : checks) {
    if (!is_kept(check)) continue;
    Json json{{mode_key, static_cast<int>(check.mode)}};
    for_each_text([&](const char* key, std::string Check::*text) {
      if (!(check.*text).empty()) json[key] = check.*text;
    });
    for_each_number([&](const char* key, std::optional<double> Check::*number) {
      if (check.*number) json[key] = *(check.*number);
    });
    if (check.holds) json[holds_key] = *check.holds;
    if (check.at_least) json[least_key] = true;
    list.push_back(std::move(json));
  }
  return list;
}

Checks checks_from(const Json& list) {
  Checks checks;
  for (const Json& json : list) {
    Check check;
    check.mode = static_cast<FailureMode>(json.at(mode_key).get<int>());
    for_each_text([&](const char* key, std::string Check::*text) { check.*text = json.value(key, std::string()); });
    for_each_number([&](const char* key, std::optional<double> Check::*number) {
      if (json.contains(key) && json[key].is_number()) check.*number = json[key].get<double>();
    });
    if (json.contains(holds_key)) check.holds = json[holds_key].get<bool>();
    check.at_least = json.contains(least_key);
    checks.push_back(std::move(check));
  }
  return checks;
}

std::vector<CheckInRuns> checks_in_runs(const Results& results) {
  std::vector<CheckInRuns> list;
  for (std::size_t run = 0; run < results.size(); ++run) {
    if (!results[run]) continue;
    for (const Check& check : results[run]->doubts.checks) {
      auto known =
          std::find_if(list.begin(), list.end(), [&](const CheckInRuns& one) { return is_same(one.worst, check); });
      if (known == list.end())
        known = list.insert(list.end(), {check, 0, 0, 0, run, {}});
      else if (is_worse(check, known->worst))
        std::tie(known->worst, known->worst_run) = std::pair(check, run);
      if (check.holds) ++known->judged;
      if (!check.why_not.empty()) ++known->unjudged;
      if (!fails(check)) continue;
      ++known->failing;
      if (!known->first_run) known->first_run = run;
    }
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const CheckInRuns& a, const CheckInRuns& b) { return a.failing > b.failing; });
  return list;
}

Json to_json(const std::vector<CheckInRuns>& checks) {
  Json list = Json::array();
  for (const CheckInRuns& one : checks) {
    Json json = check_outputs().to_json(one.worst);
    json["failing"] = one.failing;
    json["judged"] = one.judged;
    json["unjudged"] = one.unjudged;
    json["first_run"] = one.first_run ? Json(*one.first_run) : Json(nullptr);
    json["worst_run"] = one.worst_run;
    list.push_back(std::move(json));
  }
  return list;
}

std::string in_words(const std::vector<CheckInRuns>& checks, std::size_t of) {
  std::string text;
  for (const CheckInRuns& one : checks) {
    const std::string runs = " of " + std::to_string(of) + " runs";
    if (one.failing > 0)
      text += "check fails " + name_of(one.worst) + ": in " + std::to_string(one.failing) + runs + ", worst in run " +
              std::to_string(one.worst_run) + ": " + text_of(one.worst) + "\n";
    if (one.unjudged > 0)
      text += "not checked " + name_of(one.worst) + ": in " + std::to_string(one.unjudged) + runs +
              ", where its limit could not be judged\n";
  }
  return text;
}

std::string failing_names(const Checks& checks) {
  std::vector<std::string> names;
  for (const Check& check : checks)
    if (fails(check) && std::find(names.begin(), names.end(), check.name) == names.end()) names.push_back(check.name);
  return join(names, "; ");
}

}  // namespace upbead
