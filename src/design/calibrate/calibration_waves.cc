#include "design/calibrate/calibration_waves.h"

#include <cmath>

#include "upbead/waves/goda.h"
#include "upbead/waves/wave_heights.h"

namespace upbead {

namespace {

constexpr double round_off = 1e-9;  // of H/h = 0.8 and d = h' from a grid

/// Why a wave is left out; "" where it is not.
std::string why_not(const DesignTables& tables, const CalibrationWave& wave, const WavePressure& pressure) {
  const Section section = with_mound(tables.section, wave);
  if (wave.berm_depth > section.foundation_depth * (1. + round_off)) return "berm_below_caisson";
  if (wave.berm_depth >= section.water_depth) return "berm_below_bed";
  const DesignWave design{wave.height * (1. - round_off), wave.height / highest_over_significant, wave.period, 0.};
  for (const NumberedWarning& warning : warnings(section, tables.water, design, pressure))
    if (warning.name == "height_over_depth" || warning.name == "breaking_limit" || warning.name == "long_period")
      return warning.name;
  const double steepness = wave.height / wave.wavelength;
  const Pair& limits = tables.calibration->steepness;
  return steepness < limits[0] || steepness > limits[1] ? "steepness" : "";
}

void add_wave(const DesignTables& tables, CalibrationWave wave, CalibrationWaves& waves) {
  ++waves.n_grid;
  const SeaState state = sea_state(wave);
  const WaveForces forces({with_mound(tables.section, wave), tables.water, {}, {}}, state);
  const WavePressure pressure = forces.at(wave.height, {});
  wave.alpha_I = pressure.alpha_I;
  wave.alpha_star = pressure.alpha_star;
  const std::string why = why_not(tables, wave, pressure);
  if (why.empty())
    waves.waves.push_back(wave);
  else
    ++waves.left[why];
}

}  // namespace

CalibrationWaves calibration_waves(const DesignTables& tables) {
  const CalibrationTable& grid = *tables.calibration;
  const double h = tables.section.water_depth;
  CalibrationWaves waves;
  for (const double T : grid.period.values) {
    const double L = wavelength(T, h, tables.water.gravity);
    for (const double d : grid.relative_berm_depth.values)
      for (const double B_M : grid.relative_berm_width.values)
        for (const double H : grid.relative_height.values)
          add_wave(tables, {H * h, T, L, d * h, B_M * L, 0., 0.}, waves);
  }
  return waves;
}

Section scaled(const Section& section, double scale) {
  Section s = section;
  for (double* length : {&s.water_depth, &s.foundation_depth, &s.berm_depth, &s.crest, &s.width, &s.berm_width})
    *length *= scale;
  if (s.centroid) *s.centroid *= scale;
  s.weight *= scale * scale;
  s.submerged_weight *= scale * scale;
  return s;
}

CalibrationWave scaled(CalibrationWave wave, double scale) {
  for (double* length : {&wave.height, &wave.wavelength, &wave.berm_depth, &wave.berm_width}) *length *= scale;
  wave.period *= std::sqrt(scale);
  return wave;
}

Section with_mound(Section section, const CalibrationWave& wave) {
  section.berm_depth = wave.berm_depth;
  section.berm_width = wave.berm_width;
  return section;
}

SeaState sea_state(const CalibrationWave& wave) {
  return {wave.height / highest_over_significant, wave.period, 1., 0., 0.};
}

}  // namespace upbead
