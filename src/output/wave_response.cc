#include "output/wave_response.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/version.h"
#include "hdf5_image.h"
#include "output/json_text.h"
#include "output/versions.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

struct Column {
  std::string name;
  detail::Label label;
  std::function<double(const WaveResponse&)> value;
};

/// One number a wave.
const std::vector<Column>& columns() {
  static const std::vector<Column> list{
      {"peak_force", {"N/m", "largest P, landward"}, [](const WaveResponse& w) { return w.peak_force; }},
      {"peak_shear", {"N/m", "largest F_T, landward"}, [](const WaveResponse& w) { return w.peak_shear; }},
      {"peak_shear_time", {"s", "time of the largest F_T"}, [](const WaveResponse& w) { return w.peak_shear_time; }},
      {"peak_shear_seaward",
       {"N/m", "least F_T: the largest seaward one is negative"},
       [](const WaveResponse& w) { return w.peak_shear_seaward; }},
      {"ratio",
       {"1", "peak F_T / peak P, both seaward where the largest |P| is; 0 where P = 0 throughout"},
       [](const WaveResponse& w) { return w.ratio.value_or(0.); }},
      {"beyond_band",
       {"1", "part of F_T from frequencies beyond the model's highest, over the largest |F_T|"},
       [](const WaveResponse& w) { return w.beyond_band; }}};
  return list;
}

const Column error_column{"error_estimate",
                          {"1", "bound of the error of F_T by the reduced model, over the largest |F_T|"},
                          [](const WaveResponse& w) { return w.error_estimate.value_or(0.); }};

const Column sliding_column{"sliding",
                            {"m", "S, sliding distance when the caisson has come to rest, landward"},
                            [](const WaveResponse& w) { return w.sliding.value_or(0.); }};

/// In the columns of a wave whose slip is not told.
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Where the caisson slips with its ground.
const std::vector<Column>& coupled_columns() {
  static const std::vector<Column> list{
      {"sliding_coupled",
       {"m", "S where the caisson slips as a whole on the ground that it shakes, landward"},
       [](const WaveResponse& w) { return w.coupled ? w.coupled->sliding : none; }},
      {"coupled_largest",
       {"m", "slip of largest magnitude on the way, landward"},
       [](const WaveResponse& w) { return w.coupled ? w.coupled->largest : none; }},
      {"coupled_slips",
       {"1", "number of slips"},
       [](const WaveResponse& w) { return w.coupled ? w.coupled->slips : none; }},
      {"coupled_dissipated",
       {"J/m", "taken by friction"},
       [](const WaveResponse& w) { return w.coupled ? w.coupled->dissipated : none; }},
      {"coupled_lifted_time", {"s", "for so long N' would have been negative"}, [](const WaveResponse& w) {
         return w.coupled ? w.coupled->lifted_time : none;
       }}};
  return list;
}

std::vector<double> values_of(const WaveResponses& file, const Column& column) {
  std::vector<double> values;
  for (const WaveResponse& wave : file.waves) values.push_back(column.value(wave));
  return values;
}

void write_column(detail::Hdf5Image& image, const WaveResponses& file, const Column& column) {
  const std::vector<double> values = values_of(file, column);
  image.numbers("/" + file.name + "/" + column.name, {values.size()}, values.data(), column.label);
}

void write_coupled_column(detail::Hdf5Image& image, const WaveResponses& file, const Column& column) {
  const std::vector<double> values = values_of(file, column);
  image.numbers_or_none("/" + file.name + "/" + column.name, values, column.label);
}

void write_histories(detail::Hdf5Image& image, const WaveResponses& file) {
  const std::string group = "/" + file.name + "/";
  const std::vector<hsize_t> shape{file.waves.size(), file.time.size()};
  image.numbers(group + "time", {file.time.size()}, file.time.data(), {"s", "time"});
  image.numbers(group + "force", shape, file.force.data(), {"N/m", "P, horizontal load on the caisson, landward"});
  image.numbers(group + "shear_force", shape, file.shear_force.data(),
                {"N/m", "F_T, shear force at the caisson's bottom, landward on the ground"});
}

Json to_object(const std::optional<CoupledWave>& coupled) {
  if (!coupled) return nullptr;
  return {{"largest", coupled->largest},
          {"slips", coupled->slips},
          {"dissipated", coupled->dissipated},
          {"lifted_time", coupled->lifted_time}};
}

Json to_object(const WaveResponse& wave, const std::string& name) {
  return {{"name", name},
          {"peak_force", wave.peak_force},
          {"peak_shear", wave.peak_shear},
          {"peak_shear_time", wave.peak_shear_time},
          {"peak_shear_seaward", wave.peak_shear_seaward},
          {"ratio", json_or_null(wave.ratio)},
          {"beyond_band", wave.beyond_band},
          {"error_estimate", json_or_null(wave.error_estimate)},
          {"sliding", json_or_null(wave.sliding)},
          {"sliding_coupled", wave.coupled ? Json(wave.coupled->sliding) : Json(nullptr)},
          {"why_not_coupled", wave.why_not_coupled.empty() ? Json(nullptr) : Json(wave.why_not_coupled)},
          {"coupled", to_object(wave.coupled)}};
}

}  // namespace

std::string WaveResponses::wave_name(std::size_t wave) const {
  return waves.size() == 1 ? name : name + "[" + std::to_string(wave) + "]";
}

std::string response_file(const std::string& title, const std::vector<WaveResponses>& files) {
  detail::Hdf5Image image(title);
  for (const WaveResponses& file : files) {
    write_histories(image, file);
    for (const Column& column : columns()) write_column(image, file, column);
    if (file.waves.front().error_estimate) write_column(image, file, error_column);
    if (file.waves.front().sliding) write_column(image, file, sliding_column);
    const auto asked = [](const WaveResponse& w) { return w.coupled || !w.why_not_coupled.empty(); };
    if (!std::any_of(file.waves.begin(), file.waves.end(), asked)) continue;
    for (const Column& column : coupled_columns()) write_coupled_column(image, file, column);
  }
  return image.bytes();
}

std::string to_json(const ReducedModelFile& model, const std::string& path, const std::vector<WaveResponses>& files,
                    const RespondTiming& timing, const NumberedWarnings& warnings) {
  Json json = {{"program", program_version()}};
  json["model"] = {{"title", model.title},
                   {"file", path},
                   {"error", model.error},
                   {"tolerance", model.tolerance},
                   {"highest_frequency", model.highest_frequency}};
  json["waves"] = Json::array();
  for (const WaveResponses& file : files)
    for (std::size_t w = 0; w < file.waves.size(); ++w)
      json["waves"].push_back(to_object(file.waves[w], file.wave_name(w)));
  json["warnings"] = Json::array();
  for (const NumberedWarning& w : warnings)
    json["warnings"].push_back(
        {{"name", w.name}, {"value", w.value}, {"limit", w.limit}, {"unit", w.unit}, {"text", w.text}});
  const double n = static_cast<double>(json["waves"].size());
  json["timing"] = {
      {"read", timing.read}, {"respond", timing.respond}, {"write", timing.write}, {"total", timing.total}};
  json["histories_per_second"] = timing.respond > 0. ? Json(n / timing.respond) : Json(nullptr);
  json["versions"] = versions_object();
  return json.dump(2) + "\n";
}

}  // namespace upbead
