// All that `upbead waves` tells of one wave on one section, but for the standing wave of finite height, as
// src/design/waves_report.cc puts it together.
import {distanceCombined} from "./combined.js";
import {distanceExact, distancePaper} from "./distance.js";
import {atLevel, designWave, durationFactor, pressureOf, stabilityOf, standingDuration} from "./goda.js";
import {warningsOf} from "./validity.js";

// design: {water, section: at its own level, duration, combined, limits}; given: keys of [waves.NAME]; rise (m).
export function formulaAnswer(design, given, rise) {
  const {water} = design, section = rise === 0 ? design.section : atLevel(design.section, water, rise), wave = designWave(given, section, water);
  const pressure = pressureOf(section, water, wave), stability = stabilityOf(section, pressure);
  const tau_0F = standingDuration(wave.height, section.water_depth, wave.period), k = durationFactor(pressure.alpha_star, design.duration);
  const mass = section.weight / water.gravity, pulse = {peak: stability.sliding_force, duration: k * tau_0F};
  const standing = pressureOf(section, water, wave, "standing").force;
  const added = design.combined.added_mass_factor * water.density * section.foundation_depth ** 2;
  const [sliding_paper, ...parts] = distancePaper(mass, stability.resistance, pulse);
  return {
    rise, section, wave, pressure, stability, without: pressureOf(section, water, wave, "goda"), standing_force: standing,
    tau_0F, k, tau_0: pulse.duration, sliding_paper, parts, sliding_exact: distanceExact(mass, stability.resistance, pulse),
    sliding_combined: distanceCombined(mass + added, section,
      {period: wave.period, standingForce: standing, peak: pressure.force, duration: pulse.duration, uplift: pressure.uplift}, design.combined),
    warnings: warningsOf(section, water, wave, pressure, design.limits, stability),
  };
}
