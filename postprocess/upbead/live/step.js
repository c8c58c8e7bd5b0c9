// How far apart the times of an answer may be, so that straight lines between them are the answer, as
// src/respond/answer_step.cc has it: a mode's |z''| follows from the wave's jumps and bends alone.
import {waveGrid, onGrid} from "./grid.js";
import {answers} from "./modes.js";

const OF_TOLERANCE = 0.02, HALVINGS = 16;

// By how much the loads of a wave jump and bend at its times.
function changes({time, loads}) {
  return loads.map((f) => {
    const n = f.length, jump = new Float64Array(n), bend = new Float64Array(n);
    jump[0] = f[0];
    jump[n - 1] = -f[n - 1];
    for (let i = 0; i + 1 < n; ++i) {
      const slope = (f[i + 1] - f[i]) / (time[i + 1] - time[i]);
      bend[i] += slope;
      bend[i + 1] -= slope;
    }
    return {jump, bend};
  });
}

// The largest |z''| of one mode.
function largestBend(modes, m, time, all) {
  const re = modes.pole[2 * m], size = Math.hypot(re, modes.pole[2 * m + 1]), K = modes.nLoads;
  let now = 0, most = 0, factor = 1, step = 0;
  for (let i = 0; i < time.length; ++i) {
    const since = i > 0 ? time[i] - time[i - 1] : 0;
    if (Math.abs(since - step) > 1e-6 * step) factor = Math.exp(re * (step = since));
    let bend = 0, jump = 0;
    for (let k = 0; k < K; ++k) {
      const load = Math.hypot(modes.load[2 * (m * K + k)], modes.load[2 * (m * K + k) + 1]);
      bend += load * Math.abs(all[k].bend[i]);
      jump += load * Math.abs(all[k].jump[i]);
    }
    now = now * factor + bend + size * jump;
    most = Math.max(most, now);
  }
  return most;
}

function largestOfIntegral(reading, all) {
  const slope = new Float64Array(all.length);
  let most = 0;
  for (let i = 0; i < all[0].bend.length; ++i) {
    let sum = 0;
    for (let k = 0; k < all.length; ++k) sum += Math.abs(reading.impulse[k]) * Math.abs(slope[k] += all[k].bend[i]);
    most = Math.max(most, sum);
  }
  return most;
}

// A function that tells by how much a reading leaves the lines between values h apart.
function lineMisses(modes, reading, bends, all) {
  const weighed = bends.map((bend, m) => bend * Math.hypot(reading.weight[2 * m], reading.weight[2 * m + 1]));
  const fast = bends.map((_, m) => 2 / (modes.pole[2 * m] ** 2 + modes.pole[2 * m + 1] ** 2));
  const ofIntegral = largestOfIntegral(reading, all);
  return (h) => {
    const slow = h * h / 8;
    return weighed.reduce((sum, bend, m) => sum + bend * Math.min(fast[m], slow), 0) + slow * ofIntegral;
  };
}

function longestResolved(misses, allowed, shortest, longest) {
  if (misses(longest) <= allowed) return longest;
  let low = Math.log(shortest), high = Math.log(longest);
  for (let i = 0; i < HALVINGS; ++i) {
    const middle = 0.5 * (low + high);
    if (misses(Math.exp(middle)) <= allowed) low = middle; else high = middle;
  }
  return Math.exp(low);
}

function answerStep(resolved, wave, shortest, longest) {
  const grid = waveGrid(wave.time, Infinity, wave.time[wave.time.length - 1]), all = changes(wave);
  const [own] = answers(resolved[0].modes, [resolved[0].name], onGrid(wave, grid.time), grid, false);
  const scale = own.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  if (scale === 0) return longest;
  const bends = new Map();
  let step = longest;
  for (const {modes, name, tolerance} of resolved) {
    if (!bends.has(modes))
      bends.set(modes, Array.from({length: modes.count}, (_, m) => largestBend(modes, m, wave.time, all)));
    const misses = lineMisses(modes, modes.readings[name], bends.get(modes), all);
    step = longestResolved(misses, tolerance * scale, shortest, step);
  }
  return step;
}

// Whose lines must be right, and by how much.
function resolvedReadings(model, slides) {
  const tolerance = OF_TOLERANCE * model.validity.tolerance, list = [{modes: model.modes, name: "shear_force", tolerance}];
  for (const modes of model.nested || []) list.push({modes, name: "shear_force", tolerance});
  if (slides && model.base)
    for (const [name, factor] of [["normal_force", 1], ["uplift", 1], ["base_moment", model.base.width],
      ["uplift_moment", model.base.width]])
      list.push({modes: model.modes, name, tolerance: tolerance * factor});
  return list;
}

// The longest step (s) that shows the answers to a wave; `slides`: whether S is asked.
export function longestStep(model, wave, slides) {
  let ofLoads = Infinity, own = 0;
  for (const {duration} of model.loads) if (duration > 0) ofLoads = Math.min(ofLoads, duration / 50);
  for (let n = 1; n < wave.time.length; ++n) own = Math.max(own, wave.time[n] - wave.time[n - 1]);
  const shortest = Math.min(1 / (20 * model.validity.highest_frequency), ofLoads);
  if (own <= shortest || !(shortest < ofLoads) || ofLoads === Infinity) return shortest;
  return answerStep(resolvedReadings(model, slides), wave, shortest, ofLoads);
}
