// Pressures, forces and safety of a caisson under one wave, as src/waves/goda.cc has them: Goda (2000) with the impulsive
// pressure coefficient of Takahashi, Tanimoto and Shimosako (1994). Keys of a section are those of a design file (SI).
import {designHeights, HIGHEST_OVER_SIGNIFICANT, relativeWaveNumber} from "./heights.js";

// lambda_1 = lambda_3 behind wave-dissipating blocks, after Takahashi, Tanimoto and Shimosako (1990).
function behindBlocks(heightOverDepth) {
  if (heightOverDepth <= 0.3) return 1;
  return heightOverDepth <= 0.6 ? 1.2 - 2 / 3 * heightOverDepth : 0.8;
}

function alphaI1(bermOverLength, moundOverDepth) {
  const x = bermOverLength - 0.12, y = moundOverDepth - 0.6;
  const delta11 = 0.93 * x + 0.36 * y, delta22 = -0.36 * x + 0.93 * y;
  const delta1 = (delta11 <= 0 ? 20 : 15) * delta11, delta2 = (delta22 <= 0 ? 4.9 : 3) * delta22;
  if (delta2 <= 0) return Math.cos(delta2) / Math.cosh(delta1);
  return 1 / (Math.cosh(delta1) * Math.sqrt(Math.cosh(delta2)));
}

// The section with its still water `rise` higher (m), as at_water_level() has it: W' loses rho g B rise where the walls
// are under water, at B/2.
export function atLevel(section, water, rise) {
  const underWater = Math.min(Math.max(rise, -section.foundation_depth), section.crest);
  const buoyancy = water.density * water.gravity * section.width * underWater, submerged_weight = section.submerged_weight - buoyancy;
  const line = section.centroid === undefined || submerged_weight === 0 ? {} :
    {centroid: (section.submerged_weight * section.centroid - buoyancy * 0.5 * section.width) / submerged_weight};
  return {...section, ...line, submerged_weight, water_depth: section.water_depth + rise, foundation_depth: section.foundation_depth + rise,
    berm_depth: section.berm_depth + rise, crest: section.crest - rise};
}

// {height, significant, period, angle (rad)}, with heights by random breaking where that of deep water is given, as
// src/case/formula_wave.cc has it. given: keys of [waves.NAME].
export function designWave(given, section, water) {
  const {period} = given, angle = given.angle * Math.PI / 180;
  if (given.deep_water_height !== undefined)
    return {period, angle, ...designHeights({height: given.deep_water_height, period, depth: section.water_depth, slope: section.bed_slope}, water.gravity)};
  return {period, angle, height: given.height, significant: given.significant_height ?? given.height / HIGHEST_OVER_SIGNIFICANT};
}

// What does not depend on the formula for p_1.
function coefficients(section, water, {height, significant, period}) {
  const {water_depth: h, berm_depth: d} = section, kh = relativeWaveNumber(period, h, water.gravity);
  const wavelength = 2 * Math.PI * h / kh, depthB = h + 5 * significant * section.bed_slope, shallow = 2 * kh / Math.sinh(2 * kh);
  const relative = height / d, alpha_2 = Math.max(Math.min((depthB - d) / (3 * depthB) * relative * relative, 2 / relative), 0);
  const alpha_I = Math.min(relative, 2) * alphaI1(section.berm_width / wavelength, (h - d) / h);
  const standard = section.blocks ? behindBlocks(height / h) : 1;
  return {wavelength, depthB, alpha_1: 0.6 + 0.5 * shallow * shallow, alpha_2, alpha_I, alpha_star: Math.max(alpha_2, alpha_I),
    alpha_3: Math.max(1 - section.foundation_depth / h * (1 - 1 / Math.cosh(kh)), 0),
    lambda_1: section.lambda_1 ?? standard, lambda_2: section.lambda_2 ?? (section.blocks ? 0 : 1), lambda_3: section.lambda_3 ?? standard};
}

// P, M_P, U and M_U: trapezia over h' and h_c*, a triangle over B.
function resultants({foundation_depth: h, crest, width}, {p1, p3, p4, pu, eta_star}) {
  const top = Math.min(eta_star, crest), uplift = 0.5 * pu * width;
  return {force: 0.5 * (p1 + p3) * h + 0.5 * (p1 + p4) * top, uplift, uplift_moment: 2 / 3 * uplift * width,
    force_moment: (2 * p1 + p3) * h * h / 6 + 0.5 * (p1 + p4) * h * top + (p1 + 2 * p4) * top * top / 6};
}

// What stands beside alpha_1 in p_1: alpha* (extended), alpha_2 (Goda) or nothing (the standing part of Shimosako and
// Takahashi 1998).
const BESIDE = {extended: "alpha_star", goda: "alpha_2"};

export function pressureOf(section, water, wave, formula = "extended") {
  const c = coefficients(section, water, wave), cos = Math.cos(wave.angle);
  const head = 0.5 * (1 + cos) * water.density * water.gravity * wave.height; // what all pressures are multiples of
  const eta_star = 0.75 * (1 + cos) * c.lambda_1 * wave.height;
  const p1 = head * (c.lambda_1 * c.alpha_1 + c.lambda_2 * (formula in BESIDE ? c[BESIDE[formula]] : 0) * cos * cos);
  const p = {...c, eta_star, p1, p3: c.alpha_3 * p1, p4: eta_star > section.crest ? p1 * (1 - section.crest / eta_star) : 0,
    pu: head * c.lambda_3 * c.alpha_1 * c.alpha_3};
  return {...p, ...resultants(section, p)};
}

// p_e under the heel: a triangle where the resultant lies in the outer third, else a trapezium; null where it floats or
// overturns.
function heelPressure(width, vertical, moment) {
  if (vertical <= 0 || moment <= 0) return null;
  const arm = moment / vertical;
  if (arm <= width / 3) return 2 * vertical / (3 * arm);
  return 2 * vertical / width * (2 - 3 * arm / width);
}

export function stabilityOf(section, p) {
  const t = section.centroid ?? 0.5 * section.width, {submerged_weight: W, friction, width} = section;
  const vertical = W - p.uplift, resisting = W * t - p.uplift_moment, resistance = friction * W, sliding_force = p.force + friction * p.uplift;
  return {safety_sliding: friction * vertical / p.force, safety_overturning: resisting / p.force_moment,
    heel_pressure: heelPressure(width, vertical, resisting - p.force_moment), sliding_force, resistance, ratio: sliding_force / resistance};
}

// tau_0F, eq. (11) of Shimosako and Takahashi (1994); kept at its last value beyond H/h = 0.8.
export const standingDuration = (height, depth, period) => (0.5 - Math.min(height / depth, 0.8) / 8) * period;
// k(alpha*), eqs. (8)-(9).
export const durationFactor = (alphaStar, {a, b}) => 1 / (Math.max(alphaStar, 0) ** a + 1) ** b;
