#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "base/version.h"
#include "expected_report.h"
#include "output/json_text.h"
#include "output/versions.h"

namespace upbead {

using Json = nlohmann::ordered_json;

namespace {

/// A height from which waves slide: null where none does.
Json height(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json by_law(const std::map<Law, Expectation>& laws, double Expectation::*member) {
  Json json = Json::object();
  for (const Law law : all_laws) {
    const auto found = laws.find(law);
    json[word(law)] = found == laws.end() ? Json(nullptr) : height(found->second.*member);
  }
  return json;
}

Json to_object(const StateAnswer& answer) {
  Json json = {{"significant_height", answer.state.significant_height},
               {"period", answer.state.period},
               {"waves", answer.state.waves}};
  json["distance"] = by_law(answer.by_law, &Expectation::distance);
  json["threshold_height"] = by_law(answer.by_law, &Expectation::threshold);
  return json;
}

Json to_object(const Design& design, const ExpectedAnswer& answer) {
  Json json = {{"years", design.tables.sea->years}};
  for (const Law law : all_laws) {
    const auto found = answer.total.find(law);
    json[std::string("distance_") + word(law)] =
        found == answer.total.end() ? Json(nullptr) : Json(found->second.distance);
  }
  json["error_estimate"] = by_law(answer.total, &Expectation::error);
  json["waves"] = answer.waves;
  json["waves_that_slide"] = by_law(answer.total, &Expectation::sliding_waves);
  json["threshold_height"] = by_law(answer.total, &Expectation::threshold);
  json["highest"] = answer.highest;
  json["states"] = Json::array();
  for (const StateAnswer& state : answer.states) json["states"].push_back(to_object(state));
  return json;
}

Json to_object(const MonteCarlo& found, const LifeTable& life) {
  const LifeStatistics& s = found.statistics;
  Json json = {{"lives", life.lives},
               {"years", life.years},
               {"seed", life.seed},
               {"law", word(found.law)},
               {"mean", s.mean},
               {"standard_error", s.standard_error},
               {"confidence_interval", s.interval},
               {"without_scatter", found.without_scatter ? Json(*found.without_scatter) : Json(nullptr)},
               {"lives_that_slide", s.sliding_lives}};
  for (const Quantile& q : s.quantiles) json["quantiles"][significant(q.probability)] = q.value;
  for (const Exceeded& e : s.exceeded)
    json["probability"][significant(e.limit)] = {{"value", e.probability}, {"confidence_interval", e.interval}};
  json["waves"] = found.waves;
  json["waves_computed"] = found.answered;
  return json;
}

}  // namespace

std::string to_json(const Design& design, const ExpectedAnswer& answer, const ExpectedTiming& timing) {
  Json json = {{"title", design.tables.title}, {"program", program_version()}};
  json["expected"] = design.tables.sea ? to_object(design, answer) : Json(nullptr);
  json["exceedance"] = Json::object();
  for (const Exceedance& e : answer.exceedance) json["exceedance"][e.name] = {{"height", e.height}, {"waves", e.waves}};
  json["model"] = nullptr;
  if (answer.model)
    json["model"] = {{"title", answer.model->title},
                     {"load", answer.model->load},
                     {"step", answer.model->step},
                     {"shortest_rise", answer.model->shortest_rise}};
  json["monte_carlo"] = answer.monte_carlo ? to_object(*answer.monte_carlo, *design.tables.life) : Json(nullptr);
  json["timing"] = {{"read", timing.read}, {"quadrature", answer.quadrature_seconds}, {"monte_carlo", nullptr}};
  if (const auto& found = answer.monte_carlo) {
    json["timing"]["monte_carlo"] = found->seconds;
    json["timing"]["waves_per_second"] = found->seconds > 0. ? Json(found->waves / found->seconds) : Json(nullptr);
    json["timing"]["waves_computed_per_second"] =
        found->seconds > 0. ? Json(found->answered / found->seconds) : Json(nullptr);
  }
  json["timing"]["total"] = timing.total;
  json["versions"] = versions_object();
  return json_text(json);
}

}  // namespace upbead
