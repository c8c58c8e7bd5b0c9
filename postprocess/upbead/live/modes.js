// The exact answer of modes z' = pole z + sum_k load_k f_k to loads that are straight between times, as
// src/dynamics/modal_response.cc has it: y = Re sum reading z + feedthrough f + impulse int f dt.
import {phiFunctions} from "./phi.js";

export const doubles = (text) => new Float64Array(Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0)).buffer);

// Of the numbers that live.model_data wrote. `readings`: {name: {weight, feedthrough, impulse}}
export function modesOf(data) {
  const readings = {};
  for (const name in data.readings) {
    const one = data.readings[name];
    readings[name] = {weight: doubles(one.weight), feedthrough: doubles(one.feedthrough), impulse: doubles(one.impulse)};
  }
  return {pole: doubles(data.pole), load: doubles(data.load), readings, count: data.count, nLoads: data.load_count};
}

// Values of one load at the begin and at the end of every step. A wave jumps from zero to its first value, and from its
// last value to zero.
function steps(values, grid) {
  const begin = values.slice(0, -1), end = values.slice(1);
  if (grid.first > 0) end[grid.first - 1] = 0;
  if (grid.last !== null) begin[grid.last] = 0;
  return {begin, end};
}

const GONE = 1e-250, BLOCK = 256; // numbers that small slow a processor down; so many samples stay in its cache

// What a step of every mode is made of under one load: E, and E's parts for the load's begin and for its rise.
function stepTable(modes, k, step) {
  const table = new Float64Array(6 * modes.count);
  for (let m = 0; m < modes.count; ++m) {
    const at = 2 * (m * modes.nLoads + k), b = step * modes.load[at], c = step * modes.load[at + 1];
    const [e, f, p, q, r, s] = phiFunctions(modes.pole[2 * m] * step, modes.pole[2 * m + 1] * step);
    table.set([e, f, p * b - q * c, p * c + q * b, r * b - s * c, r * c + s * b], 6 * m);
  }
  return table;
}

// z of mode m through the steps from `from` to `to`: into re and im, from 0 on; its last value stays in z.
function advance(table, m, z, {begin, end}, from, to, re, im) {
  const e = table[6 * m], f = table[6 * m + 1], g = table[6 * m + 2], h = table[6 * m + 3], r = table[6 * m + 4], s = table[6 * m + 5];
  let u = z[2 * m], v = z[2 * m + 1];
  for (let n = from; n < to; ++n) {
    const x = begin[n], rise = end[n] - x, next = e * u - f * v + (g * x + r * rise);
    v = e * v + f * u + (h * x + s * rise);
    u = next;
    re[n - from] = u;
    im[n - from] = v;
  }
  z[2 * m] = Math.abs(u) < GONE ? 0 : u;
  z[2 * m + 1] = Math.abs(v) < GONE ? 0 : v;
}

function addReading(c, d, re, im, from, to, row) {
  for (let n = from; n < to; ++n) row[n + 1] += c * re[n - from] - d * im[n - from];
}

function addModes(modes, weights, k, load, stretches, y) {
  const z = new Float64Array(2 * modes.count), re = new Float64Array(BLOCK), im = new Float64Array(BLOCK);
  for (const {from, to, step} of stretches) {
    const table = stepTable(modes, k, step);
    for (let first = from; first < to; first += BLOCK) {
      const stop = Math.min(first + BLOCK, to);
      for (let m = 0; m < modes.count; ++m) {
        advance(table, m, z, load, first, stop, re, im);
        for (let i = 0; i < y.length; ++i) addReading(weights[i][2 * m], weights[i][2 * m + 1], re, im, first, stop, y[i]);
      }
    }
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
  const y = names.map(() => new Float64Array(grid.time.length)), weights = names.map((name) => modes.readings[name].weight);
  loads.forEach((values, k) => {
    if (values.every((value) => value === 0)) return;
    const load = steps(values, grid);
    addModes(modes, weights, k, load, grid.stretches, y);
    names.forEach((name, i) => addDirect(modes.readings[name], k, smoothStart ? values[0] : 0, load, grid.time, y[i]));
  });
  return y;
}

// z of all modes after the steps that end at those ascending times, from a load: for each time Re and Im by turns.
function statesAt(modes, k, load, grid, moments) {
  const states = moments.map(() => new Float64Array(2 * modes.count)), z = new Float64Array(2 * modes.count);
  const re = new Float64Array(BLOCK), im = new Float64Array(BLOCK);
  let next = moments.findIndex((n) => n > 0);
  for (const {from, to, step} of grid.stretches) {
    const table = stepTable(modes, k, step);
    for (let first = from; first < to && next >= 0 && next < moments.length;) {
      const stop = Math.min(first + BLOCK, to, moments[next]);
      for (let m = 0; m < modes.count; ++m) advance(table, m, z, load, first, stop, re, im);
      first = stop;
      if (stop === moments[next]) states[next++].set(z);
    }
  }
  return states;
}

// Many readings at a few ascending times: for each time a row. table: {weight, feedthrough, impulse}, by reading.
export function readingsAt(modes, table, loads, grid, moments, smoothStart) {
  const count = table.feedthrough.length / modes.nLoads, rows = moments.map(() => new Float64Array(count));
  loads.forEach((values, k) => {
    if (values.every((value) => value === 0)) return;
    const load = steps(values, grid), states = statesAt(modes, k, load, grid, moments), direct = new Float64Array(grid.time.length);
    const area = new Float64Array(grid.time.length);
    addDirect({feedthrough: {[k]: 1}, impulse: {[k]: 0}}, k, smoothStart ? values[0] : 0, load, grid.time, direct);
    addDirect({feedthrough: {[k]: 0}, impulse: {[k]: 1}}, k, 0, load, grid.time, area);
    moments.forEach((n, i) => {
      for (let r = 0; r < count; ++r) {
        let sum = table.feedthrough[r * modes.nLoads + k] * direct[n] + table.impulse[r * modes.nLoads + k] * area[n];
        for (let m = 0, at = 2 * r * modes.count; m < modes.count; ++m, at += 2)
          sum += table.weight[at] * states[i][2 * m] - table.weight[at + 1] * states[i][2 * m + 1];
        rows[i][r] += sum;
      }
    });
  });
  return rows;
}
