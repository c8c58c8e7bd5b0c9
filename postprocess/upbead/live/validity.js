// Where the formulas do not hold, and what of a section contradicts itself: names and sentences are those of
// src/waves/validity.cc, src/waves/goda.cc and src/design/water_levels.cc.
import {atLevel, stabilityOf} from "./goda.js";
import {deepWavelength} from "./heights.js";
import {digits} from "./numbers.js";

const metresOf = (value) => `${digits(value, 4)} m`;
const SHALLOWEST = 1e-3; // m

// After Deltares' coastal-structures-toolbox 1.0.0: waves that break on a steep bed, or on a high mound.
function mayBreak(section, water, wave, {wavelength}) {
  const berm = section.berm_width / wavelength, steepness = wave.significant / deepWavelength(wave.period, water.gravity);
  if (wave.angle / (Math.PI / 180) >= 20 || section.crest / wave.significant <= 0.3) return false;
  return (berm < 0.02 && section.bed_slope > 1 / 50 && steepness < 0.03) ||
    (berm > 0.02 && berm < 0.3 && section.berm_depth / section.water_depth < 0.6);
}

function ofWave(section, water, wave, p) {
  const H = wave.height, h = section.water_depth, limit = 0.142 * p.wavelength * Math.tanh(2 * Math.PI * h / p.wavelength);
  return [
    ["impulsive_breaking", mayBreak(section, water, wave, p), `waves may break on the wall (B_M/L = ${digits(section.berm_width / p.wavelength)}, d/h = ` +
      `${digits(section.berm_depth / h)}): Goda's formula alone does not hold, alpha_I is made for it but the scatter is large`,
      "compare with tests of such a section before the force is believed"],
    ["height_over_depth", H > 0.8 * h, `H/h = ${digits(H / h)} is beyond 0.8, where eq. (11) for tau_0F ends; 0.4 T is used`,
      "check height and water_depth, or take sliding distances as rough"],
    ["breaking_limit", H > limit, `H = ${metresOf(H)} is above Miche's limit of breaking at the wall, ${metresOf(limit)}: such a wave breaks before`,
      `give a height of at most ${metresOf(limit)}, or check period and water_depth`],
    ["significant_height", wave.significant >= H, `H_1/3 = ${metresOf(wave.significant)} is not below H = ${metresOf(H)}, which is to be the highest wave`,
      "check height and significant_height (H mostly is 1.8 H_1/3)"],
    ["significant_height", wave.significant < H / 4, `H_1/3 = ${metresOf(wave.significant)} is less than a quarter of H = ${metresOf(H)}: no sea has so high a wave, and P is found too near the wall`,
      "check height and significant_height (H mostly is 1.8 H_1/3)"],
    ["long_period", wave.period > 30, `T = ${digits(wave.period, 4)} s is longer than 30 s, where the tests end`,
      "check the period, or compare with tests of so long waves"],
  ];
}

// The usual slip is kN for N, or W in place of W'.
function ofSection(c, water) {
  const given = c.weight - c.submerged_weight, displaced = water.density * water.gravity * c.foundation_depth * c.width;
  return [
    ["bed_slope", c.bed_slope > 0.1 || c.bed_slope < 0.01, `tan(theta) = ${digits(c.bed_slope)} is outside 0.01 to 0.1, where the tests are`,
      "check bed_slope (a tangent, not percent), or compare with tests of such a bed"],
    ["berm_below_bed", c.berm_depth > c.water_depth, `d = ${metresOf(c.berm_depth)} is below the bed at h = ${metresOf(c.water_depth)}`,
      "check berm_depth and water_depth (both from still water down)"],
    ["foundation_below_bed", c.foundation_depth > c.water_depth, `h' = ${metresOf(c.foundation_depth)} is below the bed at h = ` +
      `${metresOf(c.water_depth)}, where alpha_3 was not made for`,
      "check foundation_depth and water_depth (both from still water down)"],
    ["buoyancy", Math.abs(given - displaced) > 0.2 * displaced, `W - W' = ${digits(given, 4)} N/m, but a caisson of width B displaces ` +
      `rho g h' B = ${digits(displaced, 4)} N/m`,
      "check the units of weight and submerged_weight (N/m), and which of them is in water"],
  ];
}

function ofPressure(section, p) {
  const safety = stabilityOf(section, p).safety_overturning, lifted = p.uplift >= section.submerged_weight;
  return [
    ["alpha_2_clamped", p.depthB <= section.berm_depth, `h_b = ${metresOf(p.depthB)} is not below the berm, d = ` +
      `${metresOf(section.berm_depth)}: alpha_2 would be negative, 0 is used`,
      "check berm_depth, water_depth and bed_slope"],
    ["alpha_3_clamped", p.alpha_3 <= 0, `h' = ${metresOf(section.foundation_depth)} at h = ${metresOf(section.water_depth)}: alpha_3 would be negative, 0 is used`,
      "check foundation_depth and water_depth"],
    ["alpha_I_negative", p.alpha_I < 0, `alpha_I = ${digits(p.alpha_I)} is negative, as on low mounds: no impulsive pressure, alpha_2 rules`,
      "check berm_depth and berm_width where a high mound is meant"],
    ["eta_star_below_crest", p.eta_star <= section.crest, `eta* = ${metresOf(p.eta_star)} does not rise above the crest, h_c = ${metresOf(section.crest)}: p4 = 0`,
      "check crest where the wave is to overtop"],
    ["overturns", !lifted && safety < 1, `the safety factor against overturning is ${digits(safety)}: the caisson tilts, and a formula for sliding knows nothing of that`,
      "widen the caisson, or make it heavier"],
    ["lifted", lifted, "U is not below W': the caisson floats up, and no safety factor means anything",
      "make the caisson heavier, or check submerged_weight"],
  ];
}

// Table [limits] of a design, without the standing wave.
function ofLimits(limits, s) {
  const heel = s.safety_overturning > 1 && s.safety_sliding > 0 ? s.heel_pressure : Infinity;
  return [
    ["base_pressure", heel > (limits.base_pressure ?? Infinity), `the pressure under the heel is ${Number.isFinite(heel) ? `${digits(heel / 1e3, 4)} kPa, above`
      : "beyond all numbers, as the caisson overturns or floats, and so above"} limits.base_pressure = ${digits(limits.base_pressure / 1e3, 4)} kPa`,
      "widen the caisson, or spread its weight"],
    ["overturning_limit", s.safety_overturning < (limits.overturning ?? -Infinity), `the safety factor against overturning is ` +
      `${digits(s.safety_overturning, 4)}, below limits.overturning = ${digits(limits.overturning, 4)}`,
      "widen the caisson, or make it heavier"],
  ];
}

// [{name, text}] of all that hold, in the program's order; the text says first what to do.
export function warningsOf(section, water, wave, pressure, limits, stability) {
  return [...ofWave(section, water, wave, pressure), ...ofSection(section, water), ...ofPressure(section, pressure), ...ofLimits(limits, stability)]
    .filter(([, holds]) => holds).map(([name, , what, cure]) => ({name, text: `${cure}: ${what}`}));
}

// What the program refuses, as sentences with a cure.
export function contradictions(section, water, rise) {
  const there = atLevel(section, water, rise), depth = Math.min(section.water_depth, section.foundation_depth, section.berm_depth);
  const what = `Water level = ${digits(rise, 6)} m: `, between = `; give a rise over the section's still water above ${digits(-depth, 6)} m and of at most ${digits(section.crest, 6)} m`;
  const list = [];
  if (section.submerged_weight >= section.weight)
    list.push(`W′ = ${digits(section.submerged_weight, 6)} N/m is not below W = ${digits(section.weight, 6)} N/m; give W′ in still water, W less the weight of the displaced water`);
  if (depth + rise < SHALLOWEST) list.push(`${what}still water would fall to the sea bed, the mound's armour or the caisson's bottom${between}`);
  else if (there.crest < 0) list.push(`${what}still water would rise above the crest${between}`);
  else if (there.submerged_weight <= 0) list.push(`${what}the caisson would float, W' = ${digits(there.submerged_weight, 4)} N/m; give a lower level, or check W′`);
  return list;
}
