#include "design.h"

#include <boost/math/constants/constants.hpp>
#include <filesystem>

#include "design/design.h"
#include "design_checks.h"
#include "upbead/waves/wave_heights.h"

namespace fs = std::filesystem;

namespace upbead {

std::string Design::resolve(const std::string& path) const {
  return (fs::path(document.path()).parent_path() / path).lexically_normal().string();
}

Design read_design(const std::string& path, const std::vector<std::string>& overrides,
                   const std::vector<DesignCheck>& further) {
  Design design;
  design.document = Document(path, overrides);
  design.stem = fs::path(path).stem().string();
  Diagnostics report;
  design_schema().read(design.document.root(), "", design.tables, report);
  design.tables.water.gravity = design.tables.gravity;
  for (const DesignCheck check : {check_section, check_waves, check_ground})
    check(design.tables, design.document, report);
  for (const DesignCheck check : further) check(design.tables, design.document, report);
  report.throw_if_any(path);
  return design;
}

std::string effective_design(const Design& design, const std::string& output_folder) {
  const fs::path folder = fs::absolute(output_folder);
  DesignTables tables = design.tables;
  const auto look_from_folder = [&](std::string& path) {
    if (!path.empty()) path = fs::relative(fs::absolute(design.resolve(path)), folder).string();
  };
  if (tables.sea) look_from_folder(tables.sea->states);
  if (tables.dynamics) look_from_folder(tables.dynamics->model);
  if (tables.calibration)
    for (auto& [name, model] : tables.calibration->models) look_from_folder(model.model);
  return design_schema().echo(tables);
}

std::string effective_design(const std::string& path, const std::vector<std::string>& overrides,
                             const std::string& output_folder) {
  return effective_design(read_design(path, overrides), output_folder);
}

std::string design_reference() {
  return reference(design_schema());
}

DesignWave design_wave(const WaveTable& wave, const Section& section, const Water& water) {
  DesignWave w;
  w.period = wave.period;
  w.angle = wave.angle * boost::math::constants::degree<double>();
  if (wave.deep_water_height) {
    const DesignHeights heights =
        design_heights({*wave.deep_water_height, wave.period, section.water_depth, section.bed_slope}, water.gravity);
    w.height = heights.highest;
    w.significant_height = heights.significant;
  } else {
    w.height = *wave.height;
    w.significant_height = wave.significant_height.value_or(w.height / highest_over_significant);
  }
  return w;
}

}  // namespace upbead
