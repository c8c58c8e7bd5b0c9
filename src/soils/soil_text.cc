#include "soils/soil_text.h"

#include <utility>
#include <vector>

#include "case/case_schema.h"
#include "input/schema.h"

namespace upbead {

namespace {

struct SoilTables {
  double gravity = 0.;
  Fluid fluid;
  std::map<std::string, Region> regions;
};

const TableSchema<SoilTables>& soil_schema() {
  static const TableSchema<SoilTables> schema = [] {
    TableSchema<Region> region = region_schema();
    region.key("pore_fluid_modulus", &Region::pore_fluid_modulus, "Pa", "bulk modulus of the pore water with its air")
        .range(above(0.));
    TableSchema<SoilTables> table;
    table.key("gravity", &SoilTables::gravity, "m/s2", "acceleration of gravity").range(above(0.)).required();
    table.table("fluid", &SoilTables::fluid, fluid_schema());
    table.tables("regions", &SoilTables::regions, region);
    return table;
  }();
  return schema;
}

/// What keeps the constants of a region from following from its keys.
std::string objection_to_region(const Region& region) {
  const bool skeleton = region.kind == RegionKind::porous || region.kind == RegionKind::solid;
  if (region.kind == RegionKind::porous && region.flow == Flow::automatic) return "its flow is not decided";
  if (region.kind == RegionKind::solid && region.deformation == Deformation::automatic)
    return "it is not decided whether it deforms";
  if (region.kind == RegionKind::water && region.compressibility == Compressibility::automatic)
    return "its compressibility is not decided";
  if (skeleton && !region.shear_modulus && !region.youngs_modulus) return "its stiffness is not one number";
  return "";
}

SoilTables read_tables(const Document& document) {
  SoilTables tables;
  Diagnostics report;
  soil_schema().read(document.root(), "", tables, report);
  for (const auto& [name, region] : tables.regions) {
    const std::string path = dotted("regions", name);
    if (!report.sound(path)) continue;
    for (const Diagnostic& mistake : diagnose(region))
      report.add(document.place(path), path + ": " + mistake.what, mistake.cure);
    const std::string objection = objection_to_region(region);
    if (!objection.empty()) report.add(document.place(path), path + ": " + objection, "");
  }
  report.throw_if_any();
  return tables;
}

std::map<std::string, Coefficients> coefficients_of(const Document& document) {
  const SoilTables tables = read_tables(document);
  return upbead::coefficients(tables.regions, tables.fluid, tables.gravity);
}

}  // namespace

std::string soil_text(const Scene& scene) {
  return soil_schema().echo({scene.gravity, scene.fluid, scene.regions});
}

SoilText::SoilText(std::string text, std::string path)
    : text_(std::move(text)),
      path_(std::move(path)),
      document_(Document::of_text(text_, path_)),
      nominal_(coefficients_of(document_)) {}

std::optional<double> SoilText::number(const std::string& key) const {
  const Node* node = document_.find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto* value = std::get_if<double>(&node->value)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&node->value)) return static_cast<double>(*value);
  return std::nullopt;
}

std::string SoilText::unit(const std::string& key) const {
  std::string unit;
  SoilTables tables = read_tables(document_);
  soil_schema().visit_numbers(tables, "", [&](const KeyInfo& info, const std::string& at, double&) {
    if (is_same_key(at, key)) unit = info.unit;
  });
  return unit;
}

std::map<std::string, Coefficients> SoilText::coefficients(const Soil& soil) const {
  if (soil.empty()) return nominal_;
  std::vector<std::string> overrides;
  for (const auto& [key, value] : soil) overrides.push_back(key + "=" + to_toml(value));
  return coefficients_of(Document::of_text(text_, path_, overrides));
}

bool is_same_key(const std::string& a, const std::string& b) {
  return split_dotted(a) == split_dotted(b);
}

}  // namespace upbead
