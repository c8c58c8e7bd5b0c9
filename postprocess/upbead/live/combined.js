// A pulse beside half a standing wave, as src/sliding/combined.cc has it: Shimosako and Takahashi (1998).
// wave: {period, standingForce: P_1 (N/m), peak: P_2, duration: tau_0 (s), uplift: U_max (N/m)}.
import {rootBetween} from "./root.js";
import {slideOnFriction} from "./slide.js";

const POINTS = 400; // of half a period: chords of the sine are 8e-6 of its height too low

// P_1 by a given gamma, P_2, and from when to when P_2 is the larger one.
function partsOf(wave, gamma) {
  const omega = 2 * Math.PI / wave.period, peak = gamma * wave.standingForce, half = 0.5 * wave.duration;
  const standing = (t) => omega * t < Math.PI ? peak * Math.sin(omega * t) : 0;
  const triangle = (t) => t < wave.duration ? wave.peak * (1 - Math.abs(t - half) / half) : 0;
  const excess = (t) => triangle(t) - standing(t), parts = {omega, peak, half, t1: 0, t2: 0, force: (t) => Math.max(standing(t), triangle(t))};
  if (excess(half) <= 0) return parts;
  if (!(wave.peak / half >= peak * omega)) parts.t1 = rootBetween(excess, 1e-9 * half, half);
  parts.t2 = excess(wave.duration) < 0 ? rootBetween(excess, half, wave.duration) : wave.duration;
  return parts;
}

// Integral of max(P_1, P_2).
function impulseOf(wave, {omega, peak, half, t1, t2}) {
  if (!(t2 > t1)) return 2 * peak / omega;
  const sine = peak / omega * (2 - (Math.cos(omega * t1) - Math.cos(omega * t2))), rest = wave.duration - t2;
  return sine + 0.5 * wave.peak / half * (half * half - t1 * t1) + 0.5 * wave.peak / half * (half * half - rest * rest);
}

// gamma_P in [0, 1], by which both parts together have the impulse P_1 T/pi; 0 where P_2 alone has more.
export function standingReduction(wave) {
  const excess = (gamma) => impulseOf(wave, partsOf(wave, gamma)) - wave.standingForce * wave.period / Math.PI;
  if (excess(0) >= 0) return 0;
  return excess(1) <= 0 ? 1 : rootBetween(excess, 0, 1);
}

// {time, force}: straight between points of the half period, the kinks of P_2 and where P_1 and P_2 cross.
export function combinedForce(wave) {
  const parts = partsOf(wave, standingReduction(wave)), times = [0.5 * wave.duration, wave.duration, parts.t1, parts.t2];
  for (let i = 0; i <= POINTS; ++i) times.push(0.5 * wave.period * i / POINTS);
  const time = [...new Set(times)].sort((a, b) => a - b);
  return {time, force: time.map(parts.force)};
}

// largest: of P over time
function upliftAt(wave, {uplift, uplift_gain: gain = 1}, force, largest, t) {
  if (uplift === "in_phase") return largest > 0 ? wave.uplift * force / largest : 0;
  return 2 * t < wave.period ? gain * wave.uplift * Math.sin(2 * Math.PI * t / wave.period) : 0;
}

// S (m). mass: W/g and the added mass (kg/m); model: table [combined] of a design.
export function distanceCombined(mass, {friction, submerged_weight: weight}, wave, model) {
  const resistance = friction * weight, peak = Math.max(wave.peak, wave.standingForce);
  const most = wave.uplift * Math.max(model.uplift_gain ?? 1, 1);
  if (peak + friction * most <= resistance) return 0;
  const {time, force} = combinedForce(wave), largest = Math.max(...force);
  const F = force.map((value, n) => value + friction * upliftAt(wave, model, value, largest, time[n]));
  return slideOnFriction({friction, weight, drag: 0}, mass, time, Float64Array.from(F), null).S;
}
