#include "design/model_section.h"

#include <cmath>
#include <optional>

#include "base/text.h"
#include "upbead/input/document.h"

namespace upbead {

namespace {

std::optional<double> number_at(const Document& text, const std::string& path) {
  const Node* node = text.find(path);
  if (node == nullptr) return std::nullopt;
  if (const auto* whole = std::get_if<std::int64_t>(&node->value)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&node->value)) return *real;
  return std::nullopt;
}

struct Depths {
  std::optional<double> water, foundation;  ///< h and h' (m)
};

/// By the case's own [section], else by the parameters of a shipped section that has a sea.
Depths depths_of(const Document& text) {
  if (text.find("section") != nullptr)
    return {number_at(text, "section.water_depth"), number_at(text, "section.foundation_depth")};
  const Node* geometry = text.find("mesh.geometry");
  const auto parameter = [&text](const char* name) { return number_at(text, std::string("mesh.parameters.") + name); };
  const std::optional<double> depth = parameter("water_depth"), mound = parameter("mound_height");
  if (geometry == nullptr || geometry->text() == nullptr || *geometry->text() != "composite" || !parameter("sea_front"))
    return {};
  return {depth, depth && mound ? std::optional(*depth - *mound) : std::nullopt};
}

}  // namespace

NumberedWarnings warnings_of_other_section(const ReducedModelFile& file, const Section& section, const Water& water) {
  constexpr double same = 0.02, same_water = 0.01;
  const Document text = Document::of_text(file.case_text, "case of the model");
  const Depths depths = depths_of(text);
  NumberedWarnings list;
  const auto compare = [&](const char* key, const std::optional<double>& of_model, double own, double tolerance,
                           const std::string& unit) {
    if (!of_model || std::abs(*of_model - own) <= tolerance * std::abs(own)) return;
    list.push_back({"model_of_other_section", *of_model, own, unit,
                    "the model of [dynamics] is of a section with " + with_unit(*of_model, unit) + ", and " + key +
                        " = " + with_unit(own, unit) + ": its waves have another caisson, ground or sea",
                    "reduce a case of that section", true});
  };
  compare("section.water_depth", depths.water, section.water_depth, same, "m");
  compare("section.foundation_depth", depths.foundation, section.foundation_depth, same, "m");
  if (file.base)
    compare("section.submerged_weight", file.base->weight - (file.still ? file.still->weight : 0.),
            section.submerged_weight, same, "N/m");
  compare("fluid.density", number_at(text, "fluid.density"), water.density, same_water, "kg/m3");
  return list;
}

}  // namespace upbead
