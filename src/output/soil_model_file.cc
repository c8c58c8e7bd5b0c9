#include "output/soil_model_file.h"

#include <algorithm>

#include "base/text.h"
#include "family_parts.h"

namespace upbead {

namespace {

using namespace detail;

const std::string family_group = "/family";

void write_box(Hdf5Image& image, const std::vector<SoilAxis>& box) {
  std::vector<std::string> key;
  std::vector<double> low, high, logarithmic;
  for (const SoilAxis& axis : box) {
    key.push_back(axis.key);
    low.push_back(axis.low);
    high.push_back(axis.high);
    logarithmic.push_back(axis.logarithmic ? 1. : 0.);
  }
  image.group("/box");
  image.texts("/box/key", key);
  image.numbers("/box/low", {low.size()}, low.data(), {"that of the key", "least value"});
  image.numbers("/box/high", {high.size()}, high.data(), {"that of the key", "largest value"});
  image.numbers("/box/logarithmic", {logarithmic.size()}, logarithmic.data(),
                {"1", "1: soils are spread over the logarithm of the key; 0: over the key"});
}

std::vector<SoilAxis> read_box(ModelParts& parts) {
  const std::vector<std::string> keys = parts.texts("/box/key");
  const std::size_t n = keys.size();
  if (n == 0) parts.wrong("/box/key names no key");
  const std::vector<double> low = parts.numbers("/box/low", {n}), high = parts.numbers("/box/high", {n});
  const std::vector<int> logarithmic = read_indices(parts, "/box/logarithmic", n, 0, 2);
  std::vector<SoilAxis> box;
  for (std::size_t i = 0; i < n; ++i) {
    const SoilAxis axis{keys[i], low[i], high[i], logarithmic[i] == 1};
    const auto same = [&axis](const SoilAxis& other) { return other.key == axis.key; };
    if (axis.key.empty() || std::any_of(box.begin(), box.end(), same))
      parts.wrong("/box/key names " + in_quotes(axis.key) + (axis.key.empty() ? "" : " twice"));
    if (!(axis.low < axis.high) || (axis.logarithmic && !(axis.low > 0.)))
      parts.wrong("/box goes from " + significant(axis.low) + " to " + significant(axis.high) + " in " +
                  in_quotes(axis.key));
    box.push_back(axis);
  }
  return box;
}

SoilModelFile read_soils(ModelParts& parts) {
  SoilModelFile model;
  model.frame = read_model(parts);
  model.box = read_box(parts);
  model.regions_text = parts.texts("/regions", 1).front();
  model.family = read_family(parts, family_group);
  model.points = parts.matrix("/box/points", static_cast<std::size_t>(model.family.factors.rows()), model.box.size());
  parts.require_checksum();
  parts.throw_if_any();
  return model;
}

}  // namespace

std::string soil_model_file(const SoilModelFile& model) {
  Hdf5Image image(model.frame.title);
  image.attribute("/", "kind", std::string(soil_model_kind.kind));
  image.attribute("/", "format_version", soil_model_kind.newest);
  write_model(image, model.frame);
  write_box(image, model.box);
  image.text("/regions", model.regions_text);
  write_family(image, family_group, model.family);
  write_matrix(image, "/box/points", model.points, {"", "soils that were solved, by axis of the box"});
  image.seal();
  return image.bytes();
}

SoilModelFile read_soil_model_file(const std::string& path) {
  ModelParts parts(path, {soil_model_kind});
  return read_soils(parts);
}

std::string soil_family_file(const SoilFamilyFile& family, const std::string& made_for) {
  Hdf5Image image("");
  image.attribute("/", "kind", std::string(soil_family_kind.kind));
  image.attribute("/", "format_version", soil_family_kind.newest);
  image.attribute("/", "made_for", made_for);
  write_family(image, family_group, family);
  image.seal();
  return image.bytes();
}

std::optional<SoilFamilyFile> read_soil_family_file(const std::string& path, const std::string& made_for) {
  ModelParts parts(path, {soil_family_kind});
  if (parts.text("/", "made_for") != made_for) return std::nullopt;
  SoilFamilyFile family = read_family(parts, family_group);
  parts.require_checksum();
  parts.throw_if_any();
  return family;
}

std::variant<ReducedModelFile, SoilModelFile> read_any_model_file(const std::string& path) {
  ModelParts parts(path, {reduced_model_kind, soil_model_kind});
  if (std::string(parts.kind().kind) == soil_model_kind.kind) return read_soils(parts);
  ReducedModelFile model = read_model(parts);
  parts.require_checksum();
  parts.throw_if_any();
  return model;
}

System slipping_names(const SoilFamilyFile& family) {
  const ReducedSystem& fixed = family.reduced.fixed;
  System system;
  for (std::size_t k = 0; k < fixed.load_name.size(); ++k)
    system.loads.push_back({fixed.load_name[k], {}, {}, fixed.prescribed[k]});
  for (std::size_t i = 0; i < family.names.size(); ++i) {
    const ReadingLabel& label = fixed.reading_label[i];
    const Eigen::RowVectorXd feedthrough = fixed.feedthrough.row(static_cast<Eigen::Index>(i));
    system.readings.push_back(
        {family.names[i], label.unit, label.description, {}, {}, {}, {feedthrough.begin(), feedthrough.end()}, {}});
  }
  return system;
}

System bonded_names(const SoilFamilyFile& family) {
  System system = slipping_names(family);
  system.loads.resize(system.loads.size() - static_cast<std::size_t>(family.reduced.slip_loads));
  system.readings.resize(system.readings.size() - static_cast<std::size_t>(family.reduced.slip_readings));
  for (Reading& reading : system.readings) reading.feedthrough.resize(system.loads.size());
  return system;
}

}  // namespace upbead
