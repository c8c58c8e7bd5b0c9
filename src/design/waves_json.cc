#include <nlohmann/json.hpp>

#include "base/version.h"
#include "output/json_text.h"
#include "output/versions.h"
#include "waves_report.h"

namespace upbead {

using Json = nlohmann::ordered_json;

namespace {

Json to_object(const Section& s) {
  return {{"water_depth", s.water_depth},
          {"foundation_depth", s.foundation_depth},
          {"berm_depth", s.berm_depth},
          {"crest", s.crest},
          {"width", s.width},
          {"berm_width", s.berm_width},
          {"bed_slope", s.bed_slope},
          {"weight", s.weight},
          {"buoyant_weight", s.buoyant_weight},
          {"centroid", s.centroid.value_or(0.5 * s.width)},
          {"friction", s.friction},
          {"blocks", s.dissipating_blocks}};
}

void add_wave(const WaveAnswer& a, double angle, Json& json) {
  json["height"] = a.wave.height;
  json["significant_height"] = a.wave.significant_height;
  json["period"] = a.wave.period;
  json["angle"] = angle;
  json["wavelength"] = a.wavelength;
}

void add_pressure(const WaveAnswer& a, double crest, Json& json) {
  const WavePressure &p = a.pressure, &q = a.without_alpha_I;
  json["alpha_1"] = p.alpha_1;
  json["alpha_2"] = p.alpha_2;
  json["alpha_3"] = p.alpha_3;
  json["alpha_I"] = p.alpha_I;
  json["alpha_star"] = p.alpha_star;
  json["lambda_1"] = p.lambda_1;
  json["lambda_2"] = p.lambda_2;
  json["lambda_3"] = p.lambda_3;
  json["eta_star"] = p.eta_star;
  json["overtopped"] = p.eta_star > crest;
  json["p1"] = p.p1;
  json["p3"] = p.p3;
  json["p4"] = p.p4;
  json["pu"] = p.pu;
  json["force"] = p.force;
  json["uplift"] = p.uplift;
  json["force_moment"] = p.force_moment;
  json["uplift_moment"] = p.uplift_moment;
  json["without_alpha_I"] = {{"p1", q.p1}, {"p3", q.p3}, {"p4", q.p4}, {"force", q.force}, {"uplift", q.uplift}};
}

void add_stability(const WaveAnswer& a, Json& json) {
  json["safety_sliding"] = a.stability.safety_sliding;
  json["safety_overturning"] = a.stability.safety_overturning;
  json["toe_pressure"] = a.stability.toe_pressure;
}

void add_sliding(const WaveAnswer& a, Json& json) {
  json["tau_0F"] = a.tau_0F;
  json["k"] = a.k;
  json["tau_0"] = a.pulse.duration;
  json["shear_force"] = a.force;
  json["shear_force_from"] = a.measured ? "measured" : "goda";
  json["sliding_force"] = a.pulse.peak;
  json["ratio"] = a.ratio;
  json["sliding_paper"] = a.sliding.paper;
  json["sliding_paper_parts"] = {a.sliding.paper_parts.accelerating, a.sliding.paper_parts.braking};
  json["sliding_exact"] = a.sliding.exact;
  json["sliding_combined"] = a.sliding.combined;
  json["elastic"] = nullptr;
  if (a.elastic)
    json["elastic"] = {{"peak_shear", a.elastic->peak_shear},
                       {"peak_displacement", a.elastic->peak_displacement},
                       {"sliding", a.elastic->slip.residual}};
}

}  // namespace

std::string to_json(const DesignTables& design, const std::vector<WaveAnswer>& answers) {
  Json json = {{"title", design.title}, {"program", program_version()}};
  json["gravity"] = design.water.gravity;
  json["fluid"] = {{"density", design.water.density}};
  json["section"] = to_object(design.section);
  json["duration"] = {{"a", design.duration.a}, {"b", design.duration.b}};
  json["waves"] = Json::object();
  for (const WaveAnswer& a : answers) {
    Json& wave = json["waves"][a.name];
    add_wave(a, design.waves.at(a.name).angle, wave);
    add_pressure(a, design.section.crest, wave);
    add_stability(a, wave);
    add_sliding(a, wave);
    wave["warnings"] = Json::array();
    for (const Warning& warning : a.warnings)
      wave["warnings"].push_back({{"name", warning.name}, {"text", warning.text}});
  }
  json["versions"] = versions_object();
  return json_text(json);
}

}  // namespace upbead
