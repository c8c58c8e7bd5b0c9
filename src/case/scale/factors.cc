#include "factors.h"

#include <cmath>
#include <cstdlib>

#include "base/suggest.h"

namespace upbead {

Ratios::Ratios(const std::vector<std::string>& texts) {
  Mistakes mistakes;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string key = text.substr(0, equals), value = equals == std::string::npos ? "" : text.substr(equals + 1);
    char* end = nullptr;
    const double ratio = std::strtod(value.c_str(), &end);
    if (key.empty() || value.empty() || *end != '\0' || !std::isfinite(ratio))
      mistakes.add({"--ratio " + text}, "it is not a key and a number",
                   "write --ratio KEY=VALUE, such as --ratio regions.seabed.shear_modulus=4.47");
    else if (!text_.emplace(key, text).second)
      mistakes.add({"--ratio " + text}, "the key has a ratio already", "keep one of them");
    else
      ratio_[key] = ratio;
  }
  mistakes.throw_if_any();
}

const double* Ratios::find(const std::string& path) {
  asked_.insert(path);
  const auto found = ratio_.find(path);
  if (found == ratio_.end()) return nullptr;
  used_.insert(path);
  return &found->second;
}

Place Ratios::place(const std::string& path) const {
  return {"--ratio " + text_.at(path)};
}

void Ratios::require_all_used() const {
  Mistakes mistakes;
  for (const auto& [path, ratio] : ratio_)
    if (used_.count(path) == 0)
      mistakes.add(place(path), "the case has no number '" + path + "'",
                   suggestion(path, {asked_.begin(), asked_.end()}, "numbers"));
  mistakes.throw_if_any();
}

std::string history_unit(const Load& load) {
  return load.kind == LoadKind::force ? "N/m" : "Pa";
}

namespace {

bool starts_with(const std::string& text, const std::string& beginning) {
  return text.rfind(beginning, 0) == 0;
}

/// The soil's own constants, which stay with the same soil: moduli and the hydraulic conductivity.
bool is_of_the_soil(const std::string& path, const std::string& unit) {
  return (starts_with(path, "regions.") || starts_with(path, "fluid.")) && (unit == "Pa" || unit == "m/s");
}

/// The unit of a number; that of a pulse's peak is told by the kind of its load.
std::string dimension_of(const KeyInfo& key, const std::string& path, const CaseTables& tables) {
  if (key.unit != "N/m or Pa") return key.unit;
  return history_unit(tables.load_tables.at(split_dotted(path).at(1)));
}

/// Of a list of pairs the second number has no dimension, and a ratio is not meant for it.
bool is_second_of_pair(const KeyInfo& key) {
  return !key.unit_of_first.empty() && key.unit != key.unit_of_first;
}

}  // namespace

void scale_numbers(CaseTables& tables, const ScaleOptions& options, Ratios& ratios, std::vector<std::string>& kept) {
  Mistakes mistakes;
  const auto scale = [&](const KeyInfo& key, const std::string& path, double& number) {
    if (starts_with(path, "mesh.parameters.") || is_second_of_pair(key)) return;
    const double before = number;
    const std::string unit = dimension_of(key, path, tables);
    const double exponent = froude_exponent(unit);
    if (const double* ratio = ratios.find(path)) {
      number *= *ratio;
      if (!key.range.contains(number) && std::isfinite(before))
        mistakes.add(ratios.place(path), path + " = " + number_text(number) + " is outside " + key.range.text(),
                     "give another ratio");
    } else if (options.soil == SoilScaling::same && is_of_the_soil(path, unit)) {
      if (std::isfinite(number)) kept.push_back(path);
    } else {
      number *= std::pow(options.factor, exponent);
    }
  };
  case_schema().visit_numbers(tables, "", scale);
  mistakes.throw_if_any();
}

}  // namespace upbead
