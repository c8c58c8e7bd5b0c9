// How the force of a wave by Goda's formulas runs in time, as src/case/wave_load.cc has it: {time, force} (s, N/m), straight
// between; it begins at 0 and is over at T/2, a triangle at tau_0.
import {combinedForce} from "./combined.js";
import {durationFactor, standingDuration} from "./goda.js";
import {impactForce, impactKinks, impactWave} from "./impact.js";
import {SHAPES} from "./pulse.js";

const PARTS = 400; // straight lines of half a period; they miss the sine by 8e-6 of its height
const STANDARD = {a: 0.3, b: 2}; // of k(alpha*): a load knows no table [duration]

// Of the wave as formulas.js answers it.
const tauOf = ({wave, section, pressure}) => durationFactor(pressure.alpha_star, STANDARD) * standingDuration(wave.height, section.water_depth, wave.period);

const ofCorners = (corners) => ({time: corners.map(([time]) => time), force: corners.map(([, value]) => value)});

// With P of Goda's formulas for the peak, or no peak_gain, e is what makes P_1 (1 + e alpha*) of it.
function churchRoof(answer, {force, impact}, water) {
  const {wave, pressure: p, standing_force: standingForce} = answer, own = p.alpha_star > 0 ? (p.force / standingForce - 1) / p.alpha_star : 0;
  const made = impactWave(force === "impulse" && impact.peak_gain != null ? impact : {...impact, peak_gain: own},
    {height: wave.height, period: wave.period, standingForce, alphaStar: p.alpha_star}, water, answer.section.berm_depth);
  const times = [...impactKinks(made), ...Array.from({length: PARTS + 1}, (_, i) => 0.5 * wave.period * i / PARTS)].sort((a, b) => a - b);
  const time = times.filter((t, i) => i === 0 || t - times[i - 1] > 1e-9 * wave.period);
  return {time, force: time.map((t) => impactForce(made, t))};
}

// By [loads.NAME.wave] course. table: {force, impact} of a church roof.
export const COURSES = {
  church_roof: churchRoof,
  triangle: (answer) => ofCorners(SHAPES.triangle.corners({start: 0, rise: 0.5 * tauOf(answer), duration: tauOf(answer), peak: answer.pressure.force})),
  sine: ({wave, pressure}) => ofCorners(SHAPES.half_sine.corners({start: 0, duration: 0.5 * wave.period, peak: pressure.force})),
  combined: (answer) => combinedForce({period: answer.wave.period, standingForce: answer.standing_force, peak: answer.pressure.force, duration: tauOf(answer),
    uplift: answer.pressure.uplift}),
};
