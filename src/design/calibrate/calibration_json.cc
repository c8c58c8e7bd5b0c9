#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/version.h"
#include "calibration_report.h"
#include "output/json_text.h"
#include "output/versions.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

Json to_object(const FitQuality& quality) {
  return {{"deviation", quality.deviation}, {"bias", quality.bias}, {"r_squared", quality.r_squared}};
}

/// The ellipse: semi-axes and where the long one points, in the plane of (a, b).
Json ellipse_of(const DurationFit& fit) {
  const double q = ellipse_size(fit);
  const double aa = fit.covariance(0, 0), bb = fit.covariance(1, 1), ab = fit.covariance(0, 1);
  const double mean = 0.5 * (aa + bb), radius = std::hypot(0.5 * (aa - bb), ab);
  return {{"level", 0.95},
          {"long_axis", std::sqrt(q * (mean + radius))},
          {"short_axis", std::sqrt(q * std::max(mean - radius, 0.))},
          {"angle", 0.5 * std::atan2(2. * ab, aa - bb)}};
}

void add_certainty(const DurationFit& fit, Json& json) {
  const Eigen::Matrix2d& C = fit.covariance;
  const double sa = std::sqrt(C(0, 0)), sb = std::sqrt(C(1, 1));
  const bool degenerate = sa == 0. || sb == 0.;  // points that the formula meets exactly
  json["standard_error"] = {{"a", sa}, {"b", sb}};
  json["covariance"] = {{C(0, 0), C(0, 1)}, {C(1, 0), C(1, 1)}};
  json["correlation"] = degenerate ? Json(nullptr) : Json(C(0, 1) / (sa * sb));
  json["ellipse"] = ellipse_of(fit);
}

Json to_object(const CalibrationFit& found) {
  Json json = {{"measure", word(found.measure)},
               {"ratio", found.ratio ? Json(*found.ratio) : Json(nullptr)},
               {"points", found.points.size()},
               {"a", nullptr},
               {"b", nullptr},
               {"standard_error", nullptr},
               {"covariance", nullptr},
               {"correlation", nullptr},
               {"ellipse", nullptr}};
  if (const auto& fit = found.fit) {
    json["a"] = fit->best.a;
    json["b"] = fit->best.b;
    if (fit->has_covariance()) add_certainty(*fit, json);
    json["residual_deviation"] = fit->residual_deviation;
    json["quality"] = to_object(fit->quality);
  }
  json["doubt"] = found.fit ? word(found.fit->doubt) : "too_few";
  json["given"] = to_object(found.given);
  json["given_in_ellipse"] = found.given_in_ellipse;
  return json;
}

Json to_object(const CalibratedModel& model) {
  Json json = {{"title", model.title},
               {"load", model.load},
               {"scale", model.scale},
               {"step", model.step},
               {"shortest_rise", model.shortest_rise}};
  json["fits"] = Json::array();
  for (const CalibrationFit& fit : model.fits) json["fits"].push_back(to_object(fit));
  return json;
}

Json impact_of(const ImpactTable& impact) {
  const char* const uplift[] = {"held", "in_phase", "sinusoidal"};
  return {{"peak_gain", impact.peak_gain},           {"rise_coefficient", impact.rise_coefficient},
          {"duration_least", impact.duration_least}, {"duration_gain", impact.duration_gain},
          {"duration_decay", impact.duration_decay}, {"uplift", uplift[static_cast<int>(impact.uplift)]}};
}

}  // namespace

std::string to_json(const Design& design, const Calibration& found) {
  Json json = {{"title", design.tables.title}, {"program", program_version()}};
  json["waves"] = {{"grid", found.n_grid}, {"taken", found.n_waves}, {"left_out", found.left}};
  json["impact"] = impact_of(design.tables.impact);
  json["given"] = {{"a", found.given.a}, {"b", found.given.b}};
  json["models"] = Json::object();
  for (const CalibratedModel& model : found.models) json["models"][model.name] = to_object(model);
  json["timing"] = {{"calibrate", found.seconds}};
  json["versions"] = versions_object();
  return json_text(json);
}

}  // namespace upbead
