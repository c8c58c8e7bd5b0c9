// What a reduced model answers to one wave: the numbers of `upbead respond`, found as src/respond has them.
import {baseExtremes, edgesOf} from "./base.js";
import {circleOfWave, circlesOf} from "./circles.js";
import {checkTimes, endOfAnswer, onGrid, requireRoom, waveGrid} from "./grid.js";
import {answers, modesOf} from "./modes.js";
import {slideOnFriction} from "./slide.js";
import {longestStep} from "./step.js";
import {beyondBand, errorBound} from "./trust.js";

// Of the numbers that live/model_data.py wrote.
export function modelOf(data) {
  return {...data, modes: modesOf(data.modes), nested: data.nested && data.nested.map(modesOf), circles: circlesOf(data.circles)};
}

// {time, value}: the largest of way * y; where the history is smooth and its neighbours equally far, of the parabola
// through three.
function peakOf(time, y, way, smooth) {
  let at = 0;
  for (let n = 1; n < y.length; ++n) if (way * y[n] > way * y[at]) at = n;
  const top = {time: time[at], value: way * y[at]};
  if (!smooth || at === 0 || at + 1 === y.length) return top;
  const before = time[at] - time[at - 1], after = time[at + 1] - time[at];
  const slope = way * (y[at + 1] - y[at - 1]) / 2, bend = way * (y[at + 1] - 2 * y[at] + y[at - 1]);
  if (Math.abs(after - before) > 1e-6 * before || !(bend < 0)) return top;
  const aside = -slope / bend;
  return {time: time[at] + aside * after, value: top.value + 0.5 * aside * slope};
}

function peaks(time, P, F, smooth) {
  const landward = peakOf(time, F, 1, smooth), seaward = peakOf(time, F, -1, smooth);
  const most = peakOf(time, P, 1, false).value, least = -peakOf(time, P, -1, false).value;
  const isSeaward = -least > most, force = isSeaward ? least : most, shear = isSeaward ? -seaward.value : landward.value;
  return {peak_force: most, peak_force_seaward: least, peak_shear: landward.value, peak_shear_time: landward.time,
    peak_shear_seaward: -seaward.value, ratio: force === 0 ? null : shear / force};
}

// Straight between the times; the ends are kept beyond.
function valueAt(time, y, t) {
  let next = 0, high = time.length;
  while (next < high) {
    const middle = (next + high) >> 1;
    if (time[middle] <= t) next = middle + 1; else high = middle;
  }
  if (next === 0 || next === time.length) return y[Math.max(next - 1, 0)];
  const part = (t - time[next - 1]) / (time[next] - time[next - 1]);
  return (1 - part) * y[next - 1] + part * y[next];
}

// Whether waves press on the landward wall alone, but for noise: then all is as in a mirror (src/response/slip_law.cc).
function pushesSeawardAlone(P) {
  const largest = P.reduce((most, value) => Math.max(most, value), 0), least = P.reduce((most, value) => Math.min(most, value), 0);
  return least < 0 && largest <= -0.05 * least;
}

// U(t) that follows P(t), in phase or held, as src/respond/respond_slip.cc has it.
function upliftOfForce({uplift, uplift_per_force, lag}, time, force) {
  const P = pushesSeawardAlone(force) ? force.map((value) => -value) : force;
  let at = 0;
  for (let n = 1; n < P.length; ++n) if (P[n] > P[at]) at = n;
  const peak = Math.max(P[at], 0);
  return P.map((value, n) => {
    const t = time[n] - lag, then = lag > 0 ? (t < time[0] ? 0 : valueAt(time, P, t)) : value;
    return uplift_per_force * (uplift === "held" && t > time[at] ? peak : Math.max(then, 0));
  });
}

// How long the section swings on after a load (s), and until its rebound by the mode that makes most of F_T, as
// src/respond/respond_waves.cc has it.
function echoOf({modes, loads, end}) {
  const ofRebound = 0.75, weight = modes.readings.shear_force.weight;
  let period = 0, swing = 0, most = 0;
  for (let m = 0; m < modes.count; ++m) {
    const re = Math.abs(modes.pole[2 * m]), im = Math.abs(modes.pole[2 * m + 1]);
    if (re >= im) continue;
    period = Math.max(period, 2 * Math.PI / im);
    let load = 0;
    for (let at = 2 * m * modes.nLoads; at < 2 * (m + 1) * modes.nLoads; at += 2) load = Math.max(load, Math.hypot(modes.load[at], modes.load[at + 1]));
    const part = Math.hypot(weight[2 * m], weight[2 * m + 1]) / Math.hypot(re, im) * load;
    if (part <= most) continue;
    most = part;
    swing = 2 * Math.PI / im;
  }
  return Math.min(3 * period, Math.max(ofRebound * swing, end - Math.max(...loads.map(({duration}) => duration))));
}

// Grid and histories of a wave. They stay the same while only friction, W' or the uplift change. mostTimes: about so many
// times at most; fewer than `respond` takes where `rough`, each exact.
export function histories(model, wave, slides, mostTimes = Infinity) {
  const longest = longestStep(model, wave, slides), end = endOfAnswer(wave, model.end, echoOf(model));
  requireRoom(end / longest, longest, end);
  const rough = end > longest * mostTimes, grid = waveGrid(wave.time, rough ? end / mostTimes : longest, end), loads = onGrid(wave, grid.time);
  const endsAtZero = grid.last === null || loads.every((values) => values[grid.last] === 0);
  const startsAtZero = loads.every((values) => values[grid.first] === 0);
  const ofBase = slides ? ["normal_force", "base_moment", "uplift", "uplift_moment"].filter((name) => name in model.modes.readings) : [];
  const names = ["shear_force", ...ofBase], y = answers(model.modes, names, loads, grid, grid.equal !== null && endsAtZero);
  const force = model.modes.readings.force.feedthrough;
  const P = new Float64Array(grid.time.length);
  loads.forEach((values, k) => values.forEach((value, n) => { P[n] += force[k] * value; }));
  const smooth = startsAtZero && endsAtZero && model.modes.readings.shear_force.feedthrough.every((value) => value === 0);
  return {wave, grid, rough, longest, loads, P, smooth, smoothStart: grid.equal !== null && endsAtZero, F: y[0], ofBase: Object.fromEntries(ofBase.map((name, i) => [name, y[i + 1]]))};
}

// N', M' and U on the base under that W', which stands where the case's does; prescribed: an uplift besides the computed
// one, or null.
function onBase(model, {ofBase, P, loads}, weight, prescribed) {
  const {width, uplift_moment_per_force} = model.base;
  const arm = (pushesSeawardAlone(P) ? -1 : 1) * Math.abs(uplift_moment_per_force);
  const weightMoment = model.base.weight_moment * (weight / model.base.weight);
  const U = ofBase.uplift.map((value, n) => value + (prescribed ? prescribed[n] : 0));
  const uplifting = ofBase.uplift_moment.map((value, n) => value + (prescribed ? arm * prescribed[n] : 0));
  const N = ofBase.normal_force.map((value, n) => value - U[n] + weight);
  const M = ofBase.base_moment.map((value, n) => value + uplifting[n] + weightMoment);
  return {width, weight, weightMoment, U, uplifting, N, M, upright: uprightOf(model.base.upright, loads, P.length)};
}

// {down, turning} of all times under loads that act up or down alone, as src/respond/respond_waves.cc has it.
function uprightOf(upright, loads, n) {
  if (!upright) return null;
  const down = new Float64Array(n), turning = new Float64Array(n);
  upright.forEach(([force, moment], k) => {
    if (force !== 0) for (let i = 0; i < n; ++i) [down[i], turning[i]] = [down[i] + force * loads[k][i], turning[i] + moment * loads[k][i]];
  });
  return {down, turning};
}

// All but how wrong it is. sliding: {friction, weight, drag, uplift, uplift_per_force, lag}, or null where S is not asked.
export function answerOf(model, history, sliding) {
  const {grid, P, F, smooth} = history, answer = {...history, time: grid.time, ...peaks(grid.time, P, F, smooth)};
  if (!sliding) return answer;
  const computed = sliding.uplift === "computed" ? history.ofBase.uplift : null;
  const prescribed = computed || sliding.uplift === "none" ? null : upliftOfForce(sliding, grid.time, P);
  answer.U = computed || prescribed;
  Object.assign(answer, slideOnFriction(sliding, model.mass, grid.time, F, answer.U));
  if (!model.base) return answer;
  const base = onBase(model, history, sliding.weight, prescribed);
  const circle = model.circles && circleOfWave(model.circles, model.modes, base, F, history.loads, grid, history.smoothStart);
  return {...answer, N: base.N, M: base.M, ...edgesOf(base), worst: baseExtremes(base), circle};
}

// {beyond_band, error_estimate}, both over the largest |F_T|; the latter null where the model cannot tell.
export function trustOf(model, {wave, grid, longest, loads, F}) {
  const until = Math.max(wave.time[wave.time.length - 1], grid.time[grid.time.length - 1]);
  const time = checkTimes(grid, longest, until), same = time.length === grid.time.length && time.every((t, n) => t === grid.time[n]);
  const sampled = same ? loads : onGrid(wave, time), peak = F.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  if (peak === 0) return {beyond_band: 0, error_estimate: model.nested ? 0 : null};
  const error_estimate = model.nested ? errorBound(model, sampled, time[1]) / peak : null;
  return {beyond_band: beyondBand(model, sampled, time[1]) / peak, error_estimate};
}
