// The exact answer of modes z' = pole z + sum_k load_k f_k to loads that are straight between times, as
// src/dynamics/modal_response.cc has it: y = Re sum reading z + feedthrough f + impulse int f dt.
import {phiFunctions} from "./phi.js";

const doubles = (text) => new Float64Array(Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0)).buffer);

// Of the numbers that live.model_data wrote. `readings`: {name: {weight, feedthrough, impulse}}
export function modesOf(data) {
  const readings = {};
  for (const name in data.readings) {
    const one = data.readings[name];
    readings[name] = {weight: doubles(one.weight), feedthrough: doubles(one.feedthrough), impulse: doubles(one.impulse)};
  }
  return {pole: doubles(data.pole), load: doubles(data.load), readings, count: data.count, nLoads: data.load_count};
}

// Steps that differ by round-off of the times only share their exponentials: [{from, to, step}], indices of times.
export function stretches(time) {
  const list = [];
  let start = 0, step = 0, equal = 0;
  for (let n = 1; n < time.length; ++n) {
    if (equal > 0 && Math.abs(start + (equal + 1) * step - time[n]) <= 1e-9 * step) {
      ++equal;
      list[list.length - 1].to = n;
      continue;
    }
    start += equal * step;
    step = time[n] - start;
    equal = 1;
    list.push({from: n - 1, to: n, step});
  }
  return list;
}

// Values of one load at the begin and at the end of every step. A wave jumps from zero to its first value, and from its
// last value to zero.
function steps(values, grid) {
  const begin = values.slice(0, -1), end = values.slice(1);
  if (grid.first > 0) end[grid.first - 1] = 0;
  if (grid.last !== null) begin[grid.last] = 0;
  return {begin, end};
}

const GONE = 1e-250, BLOCK = 64; // numbers that small slow a processor down

// Fills z (re, im) of one mode under one load.
function advance(list, pole, b, {begin, end}, re, im) {
  let u = 0, v = 0;
  re[0] = im[0] = 0;
  for (const {from, to, step} of list) {
    const [e, f, p, q, r, s] = phiFunctions(pole[0] * step, pole[1] * step);
    const wr = step * (p * b[0] - q * b[1]), wi = step * (p * b[1] + q * b[0]);
    const rr = step * (r * b[0] - s * b[1]), ri = step * (r * b[1] + s * b[0]);
    for (let first = from; first < to; first += BLOCK) {
      if (Math.abs(u) < GONE) u = 0;
      if (Math.abs(v) < GONE) v = 0;
      for (let n = first, stop = Math.min(first + BLOCK, to); n < stop; ++n) {
        const x = begin[n], rise = end[n] - x, next = e * u - f * v + wr * x + rr * rise;
        v = e * v + f * u + wi * x + ri * rise;
        u = next;
        re[n + 1] = u;
        im[n + 1] = v;
      }
    }
  }
}

function addModes(modes, names, k, load, list, re, im, y) {
  for (let m = 0; m < modes.count; ++m) {
    const at = 2 * (m * modes.nLoads + k), b = [modes.load[at], modes.load[at + 1]];
    if (b[0] === 0 && b[1] === 0) continue;
    advance(list, [modes.pole[2 * m], modes.pole[2 * m + 1]], b, load, re, im);
    names.forEach((name, i) => {
      const c = modes.readings[name].weight[2 * m], d = modes.readings[name].weight[2 * m + 1], row = y[i];
      for (let n = 0; n < re.length; ++n) row[n] += c * re[n] - d * im[n];
    });
  }
}

// What the loads do to a reading at once, and what their integrals do.
function addDirect(reading, k, first, {begin, end}, time, row) {
  const direct = reading.feedthrough[k], impulse = reading.impulse[k];
  row[0] += direct * first;
  for (let n = 1, integral = 0; n < row.length; ++n) {
    integral += 0.5 * (time[n] - time[n - 1]) * (begin[n - 1] + end[n - 1]);
    row[n] += direct * end[n - 1] + impulse * integral;
  }
}

// Readings over the times of a grid. `smoothStart`: a first value counts at once, as in respond's batches of equal steps.
export function answers(modes, names, loads, grid, smoothStart) {
  const N = grid.time.length, list = stretches(grid.time), re = new Float64Array(N), im = new Float64Array(N);
  const y = names.map(() => new Float64Array(N));
  loads.forEach((values, k) => {
    if (values.every((value) => value === 0)) return;
    const load = steps(values, grid);
    addModes(modes, names, k, load, list, re, im, y);
    names.forEach((name, i) => addDirect(modes.readings[name], k, smoothStart ? values[0] : 0, load, grid.time, y[i]));
  });
  return y;
}
