// An impulsive triangle beside half a standing wave, as src/expected/dynamic_law.cc has it: assumptions of docs/expected.md.
// a: table [loads.NAME.wave.impact]; on: {height, period, standingForce: P_1 (N/m), alphaStar}.
import {rootBetween} from "./root.js";

const triangleAt = ({rise, duration, peak}, t) => t <= rise ? peak * t / rise : t < duration ? peak * (duration - t) / (duration - rise) : 0;

// Between which times the triangle is above gamma P_1 sin(omega t).
function triangleLeads(wave, gamma) {
  const omega = 2 * Math.PI / wave.period, {rise, duration} = wave, early = 1e-6 * rise;
  const excess = (t) => triangleAt(wave, t) - gamma * wave.standingForce * Math.sin(omega * t);
  if (excess(rise) <= 0) return [rise, rise];
  return [excess(early) < 0 ? rootBetween(excess, early, rise) : 0, excess(duration) < 0 ? rootBetween(excess, rise, duration) : duration];
}

function impulseBy(wave, gamma) {
  const omega = 2 * Math.PI / wave.period, {rise, duration, peak} = wave, [t1, t2] = triangleLeads(wave, gamma);
  const sine = gamma * wave.standingForce / omega * (2 - (Math.cos(omega * t1) - Math.cos(omega * t2)));
  return sine + 0.5 * peak / rise * (rise * rise - t1 * t1) + 0.5 * peak / (duration - rise) * ((duration - rise) ** 2 - (duration - t2) ** 2);
}

// gamma: half a period keeps the impulse P_1 T/pi.
function reductionOf(wave) {
  const whole = wave.standingForce * wave.period / Math.PI, excess = (gamma) => impulseBy(wave, gamma) - whole;
  if (excess(0) >= 0) return 0;
  return excess(1) <= 1e-14 * whole ? 1 : rootBetween(excess, 0, 1);
}

export function impactWave(a, on, {density, gravity}, bermDepth) {
  const peak = on.standingForce * (1 + a.peak_gain * on.alphaStar), relative = peak / (density * gravity * on.height * on.height);
  const rise = a.rise_coefficient * Math.sqrt(bermDepth / gravity) / relative;
  const duration = Math.min(rise * (a.duration_least + a.duration_gain * Math.exp(-a.duration_decay * rise / on.period)), 0.5 * on.period);
  const wave = {period: on.period, standingForce: on.standingForce, peak, duration, rise: Math.min(rise, 0.5 * duration)};
  return {...wave, reduction: reductionOf(wave)};
}

// P(t), and the times at which it has kinks.
export function impactForce(wave, t) {
  if (t <= 0 || t >= 0.5 * wave.period) return 0;
  return Math.max(wave.reduction * wave.standingForce * Math.sin(2 * Math.PI * t / wave.period), triangleAt(wave, t));
}
export const impactKinks = (wave) => [wave.rise, ...triangleLeads(wave, wave.reduction)].filter((t) => t < 0.5 * wave.period);
