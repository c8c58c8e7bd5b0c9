#include "upbead/output/summary.h"

#include <nlohmann/json.hpp>

#include "base/version.h"
#include "contact_object.h"
#include "output/json_text.h"
#include "output/versions.h"
#include "sliding_object.h"

namespace upbead {

using Json = nlohmann::ordered_json;

namespace {

Json to_object(const Discretisation& d) {
  return {
      {"cells", d.cells},         {"unknowns", d.unknowns}, {"degree", d.degree}, {"scheme", d.scheme},
      {"time_step", d.time_step}, {"steps", d.steps},       {"solves", d.solves}, {"factorisations", d.factorisations},
      {"processes", d.processes}};
}

Json to_object(const ErrorEstimate& e) {
  return {{"mesh", e.mesh}, {"time", e.time}, {"reduced_model", e.reduced_model}, {"far_boundary", e.far_boundary}};
}

Json to_object(const ShearResponse& r, const std::optional<EnergyAccount>& energy,
               const std::optional<ErrorEstimate>& error, const std::optional<ErrorEstimate>& history) {
  return {{"peak_force", r.peak_force},
          {"peak_force_time", r.peak_force_time},
          {"peak_force_seaward", r.peak_force_seaward},
          {"peak_force_seaward_time", r.peak_force_seaward_time},
          {"impulse", r.impulse},
          {"peak_shear", r.peak_shear},
          {"peak_shear_time", r.peak_shear_time},
          {"peak_shear_seaward", r.peak_shear_seaward},
          {"peak_shear_seaward_time", r.peak_shear_seaward_time},
          {"shear_to_force_ratio", json_or_null(r.shear_to_force_ratio)},
          {"peak_displacement", r.peak_displacement},
          {"peak_rotation", r.peak_rotation},
          {"peak_shear_paper", r.peak_shear_paper},
          {"peak_shear_experiment", r.peak_shear_experiment},
          {"shear_to_impulse", json_or_null(r.shear_to_impulse)},
          {"arm", json_or_null(r.arm)},
          {"peak_base_moment", r.peak_base_moment},
          {"reaction_mismatch", r.reaction_mismatch},
          {"energy_mismatch", energy ? Json(energy->mismatch()) : Json(nullptr)},
          {"error_estimate", error ? Json(error->total()) : Json(nullptr)},
          {"error_sources", error ? to_object(*error) : Json(nullptr)},
          {"history_error_estimate", history ? Json(history->total()) : Json(nullptr)},
          {"history_error_sources", history ? to_object(*history) : Json(nullptr)}};
}

Json to_object(const LoadOnCaisson& load) {
  return {
      {"force_x", load.force_x}, {"force_y", load.force_y}, {"moment", load.moment}, {"arm", json_or_null(load.arm())}};
}

Json to_object(const std::vector<GaugeSummary>& gauges) {
  Json rows = Json::object();
  for (const GaugeSummary& g : gauges)
    rows[g.name] = {{"gauges", g.gauges},
                    {"samples", g.samples},
                    {"interval", g.interval},
                    {"peak_gauge", g.peak_gauge},
                    {"peak_pressure", g.peak_pressure},
                    {"peak_pressure_time", g.peak_pressure_time},
                    {"peak_pressure_at", g.peak_at},
                    {"peak_force", g.peak_force},
                    {"peak_force_time", g.peak_force_time},
                    {"arm", json_or_null(g.arm)},
                    {"force_error", g.force_error},
                    {"arm_error", g.arm_error},
                    {"load_cell", json_or_null(g.load_cell)}};
  return rows;
}

Json to_object(const MeasuredSummary& m) {
  const Comparison& c = m.comparison;
  return {{"reading", m.reading},
          {"peak_measured", c.peak_measured},
          {"peak_computed", c.peak_computed},
          {"peak_ratio", c.peak_ratio},
          {"rms", c.rms},
          {"rms_relative", c.rms_relative},
          {"phase", c.phase}};
}

Json to_object(const EnergyAccount& e) {
  return {{"work", e.work},         {"kinetic", e.kinetic}, {"strain", e.strain},      {"fluid", e.fluid},
          {"lifted", e.lifted},     {"drag", e.drag},       {"damping", e.damping},    {"radiated", e.radiated},
          {"friction", e.friction}, {"scheme", e.scheme},   {"mismatch", e.mismatch()}};
}

Json to_object(const std::vector<LooseReading>& readings) {
  Json object = Json::object();
  for (const LooseReading& reading : readings) object[reading.name] = reading.error;
  return object;
}

Json to_object(const ReductionSummary& r) {
  return {{"vectors", r.vectors},
          {"modes", r.modes},
          {"error", r.error},
          {"error_peak", r.error_peak},
          {"error_of_others", r.error_of_others},
          {"highest_frequency", r.highest_frequency},
          {"loose", to_object(r.loose)}};
}

Json to_object(const SoilSummary& s) {
  return {{"iterations", s.iterations},
          {"converged", s.converged},
          {"change", s.change},
          {"peak_linear", s.linear},
          {"peak", s.settled},
          {"largest_strain", s.largest_strain},
          {"least_modulus_ratio", s.least_modulus_ratio},
          {"largest_damping", s.largest_damping}};
}

Json to_object(const MobilisedStrength& s) {
  return {{"region", s.region},   {"initial", s.initial},     {"initial_share", s.initial_share},
          {"largest", s.largest}, {"at", {s.at[0], s.at[1]}}, {"time", s.time},
          {"share", s.share},     {"left_out", s.left_out}};
}

Json to_object(const NumberedWarning& w) {
  return {{"name", w.name}, {"value", w.value}, {"limit", w.limit}, {"unit", w.unit}, {"text", w.text}};
}

Json to_object(const LadderStep& step) {
  return {{"way", step.way}, {"refused", step.refused.empty() ? Json(nullptr) : Json(step.refused)}};
}

Json to_object(const Timing& t) {
  return {{"mesh", t.mesh},   {"compile", t.compile}, {"factorise", t.factorise},
          {"march", t.march}, {"output", t.output},   {"total", t.total}};
}

}  // namespace

std::string gauges_json(const std::vector<GaugeSummary>& gauges) {
  return json_text(to_object(gauges));
}

std::string to_json(const Summary& summary) {
  Json json = {{"title", summary.title}, {"program", program_version()}};
  json["discretisation"] = to_object(summary.discretisation);
  json["response"] = summary.response
                         ? to_object(*summary.response, summary.energy, summary.error, summary.history_error)
                         : Json(nullptr);
  json["loads"] = Json::object();
  for (const LoadOnCaisson& load : summary.loads) json["loads"][load.name] = to_object(load);
  json["gauges"] = to_object(summary.gauges);
  json["measured"] = Json::object();
  for (const MeasuredSummary& measured : summary.measured) json["measured"][measured.name] = to_object(measured);
  json["energy"] = summary.energy ? to_object(*summary.energy) : Json(nullptr);
  json["reduction"] = summary.reduction ? to_object(*summary.reduction) : Json(nullptr);
  json["sliding"] = summary.sliding ? to_object(*summary.sliding) : Json(nullptr);
  json["contact"] = summary.contact ? to_object(*summary.contact) : Json(nullptr);
  json["soil"] = summary.soil ? to_object(*summary.soil) : Json(nullptr);
  json["strength"] = Json::array();
  for (const MobilisedStrength& strength : summary.strength) json["strength"].push_back(to_object(strength));
  json["warnings"] = Json::array();
  for (const NumberedWarning& warning : summary.warnings) json["warnings"].push_back(to_object(warning));
  json["ladder"] = Json::array();
  for (const LadderStep& step : summary.ladder) json["ladder"].push_back(to_object(step));
  json["skipped"] = Json::array();
  for (const Skipped& skipped : summary.skipped)
    json["skipped"].push_back({{"what", skipped.what}, {"why", skipped.why}});
  json["timing"] = to_object(summary.timing);
  json["versions"] = versions_object();
  return json_text(json);
}

}  // namespace upbead
