#include "sliding_object.h"

#include "output/json_text.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

Json to_object(const HistoryDuration& d) {
  return {{"ratio", d.ratio},
          {"sliding", d.sliding},
          {"by_paper", json_or_null(d.by_paper)},
          {"by_exact", json_or_null(d.by_exact)},
          {"by_excess", json_or_null(d.by_excess)},
          {"by_impulse", json_or_null(d.by_impulse)}};
}

Json to_array(const std::vector<Slip>& slips) {
  Json list = Json::array();
  for (const Slip& slip : slips)
    list.push_back({{"start", slip.start},
                    {"stop", slip.stop},
                    {"distance", slip.distance},
                    {"peak_velocity", slip.peak_velocity}});
  return list;
}

void add_pulse(Json& json, const std::optional<PulseSliding>& pulse) {
  const auto value = [&pulse](double PulseSliding::*member) { return pulse ? Json((*pulse).*member) : Json(nullptr); };
  json["tau_0F"] = value(&PulseSliding::standing_duration);
  json["k"] = value(&PulseSliding::factor);
  json["tau_0"] = value(&PulseSliding::duration);
  json["sliding_paper"] = value(&PulseSliding::paper);
  json["sliding_paper_parts"] =
      pulse ? Json::array({pulse->paper_parts.accelerating, pulse->paper_parts.braking}) : Json(nullptr);
  json["sliding_exact"] = value(&PulseSliding::exact);
}

void add_coupled(Json& json, const std::optional<CoupledSummary>& coupled, const std::string& why_not) {
  json["sliding_coupled"] = coupled ? Json(coupled->slip.residual) : Json(nullptr);
  json["why_not_coupled"] = why_not.empty() ? Json(nullptr) : Json(why_not);
  json["coupled"] = nullptr;
  if (!coupled) return;
  json["coupled"] = {{"largest", coupled->slip.largest},
                     {"slips", to_array(coupled->slip.slips)},
                     {"dissipated", coupled->dissipated},
                     {"peak_shear", coupled->peak_shear},
                     {"least_normal", coupled->least_normal},
                     {"lifted_time", coupled->lifted_time},
                     {"vectors", coupled->vectors},
                     {"error", coupled->error},
                     {"glued_error", coupled->glued_error},
                     {"growth", coupled->growth},
                     {"damping_time", coupled->damping_time},
                     {"damping_effect", coupled->damping_effect},
                     {"error_estimate", json_or_null(coupled->error_estimate)}};
}

void add_equal_impulse(Json& json, const std::optional<EqualImpulse>& pulse) {
  json["equal_impulse"] = nullptr;
  if (pulse)
    json["equal_impulse"] = {
        {"tau_0", pulse->duration}, {"sliding_paper", pulse->paper}, {"sliding_exact", pulse->exact}};
}

}  // namespace

Json to_object(const SlidingSummary& s) {
  const HistorySliding& h = s.history;
  Json json = {{"friction", s.friction},
               {"weight", s.weight},
               {"buoyant_weight", s.buoyant_weight},
               {"drag", s.drag},
               {"uplift", s.uplift},
               {"resistance", h.resistance},
               {"peak_sliding_force", h.peak_force},
               {"peak_sliding_force_time", h.peak_force_time},
               {"shear_at_peak", h.shear_at_peak},
               {"uplift_at_peak", h.uplift_at_peak},
               {"ratio", h.ratio},
               {"least_normal_force", h.least_normal_force},
               {"sliding_history", h.by_history.residual},
               {"sliding_history_largest", h.by_history.largest},
               {"slips", to_array(h.by_history.slips)},
               {"sliding_normal_force", h.with_normal_force.residual},
               {"error_estimate", json_or_null(s.error_estimate)},
               {"why_no_error_estimate", s.why_no_estimate.empty() ? Json(nullptr) : Json(s.why_no_estimate)}};
  add_coupled(json, s.coupled, s.why_not_coupled);
  add_pulse(json, s.pulse);
  add_equal_impulse(json, s.equal_impulse);
  json["duration"] = h.own ? to_object(*h.own) : Json(nullptr);
  json["duration_table"] = Json::array();
  for (const HistoryDuration& d : h.table) json["duration_table"].push_back(to_object(d));
  return json;
}

}  // namespace upbead
