// How wrong an answer may be, as src/dynamics/answer_error.cc has it: beside two larger models, and beyond the frequencies
// up to which the model has been checked.
import {backward, forward, goodSize} from "./fft.js";
import {equalStretch} from "./grid.js";
import {answers} from "./modes.js";
import {phiFunctions} from "./phi.js";

const SAFETY_OF_MODEL = 1.2, SAFETY_OF_MIDDLE = 1.5;

const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
const largestDifference = (a, b) => a.reduce((most, value, n) => Math.max(most, Math.abs(value - b[n])), 0);

// A bound of the error of F_T by the model (N/m). loads: of equally spaced times; a first sample is reached along a line.
export function errorBound(model, loads, step) {
  const n = loads[0].length, time = Array.from({length: n + 1}, (_, i) => i * step);
  const grid = {time, stretches: equalStretch(n, step), equal: step, first: 0, last: null};
  const fromZero = loads.map((values) => {
    const longer = new Float64Array(values.length + 1);
    longer.set(values, 1);
    return longer;
  });
  const [own, middle, reference] = [model.modes, ...model.nested].map(
    (modes) => answers(modes, ["shear_force"], fromZero, grid, true)[0]);
  return SAFETY_OF_MODEL * largestDifference(reference, own) + SAFETY_OF_MIDDLE * largestDifference(reference, middle);
}

// Adds (a2 q^2 + a1 q + a0) / ((q - g) (q - conj g)) where q are complex numbers.
function addSampledPair({a2, a1, a0, gRe, gIm}, q, H) {
  for (let j = 0; j < q.re.length; ++j) {
    const x = q.re[j], y = q.im[j], c = a2 * x + a1, d = a2 * y, u = c * x - d * y + a0, v = c * y + d * x;
    const dx = x - gRe, down = y - gIm, up = y + gIm, s = dx * dx - down * up, t = dx * (down + up);
    const size = 1 / (s * s + t * t);
    H.re[j] += (u * s + v * t) * size;
    H.im[j] += (v * s - u * t) * size;
  }
}

function residueOf(modes, reading, m, k) {
  const at = 2 * (m * modes.nLoads + k), [a, b] = [reading.weight[2 * m], reading.weight[2 * m + 1]];
  const [c, d] = [modes.load[at], modes.load[at + 1]];
  return [a * c - b * d, a * d + b * c];
}

// What the recurrence of every mode does to lines between samples, where Z - 1 is q.
function sampledTransfer(modes, reading, k, h, q) {
  const n = q.re.length, H = {re: new Float64Array(n), im: new Float64Array(n)};
  for (let m = 0; m < modes.count; ++m) {
    const [rRe, rIm] = residueOf(modes, reading, m, k), pRe = modes.pole[2 * m] * h, pIm = modes.pole[2 * m + 1] * h;
    if (rRe === 0 && rIm === 0) continue;
    const [, , a, b, c, d] = phiFunctions(pRe, pIm), gRe = pRe * a - pIm * b, gIm = pRe * b + pIm * a;
    const uRe = h * (rRe * a - rIm * b), uIm = h * (rRe * b + rIm * a), vRe = h * (rRe * c - rIm * d), vIm = h * (rRe * d + rIm * c);
    addSampledPair({a2: vRe, a1: uRe - (vRe * gRe + vIm * gIm), a0: -(uRe * gRe + uIm * gIm), gRe, gIm}, q, H);
  }
  addDirectTransfer(reading, k, h, q, H);
  return H;
}

// Of what acts at once, and of integrals: impulse h (1 + q/2) / q.
function addDirectTransfer(reading, k, h, q, H) {
  const impulse = reading.impulse[k];
  for (let j = 0; j < q.re.length; ++j) {
    H.re[j] += reading.feedthrough[k];
    if (impulse === 0) continue;
    const size = q.re[j] ** 2 + q.im[j] ** 2;
    H.re[j] += impulse * h * (q.re[j] / size + 0.5);
    H.im[j] -= impulse * h * q.im[j] / size;
  }
}

// Takes the part of frequencies up to `limit` off: `round` apart, each with the spectrum of the hat that a sample makes
// of lines.
function takeOffBelow(modes, reading, k, h, at, limit, H) {
  const round = 2 * Math.PI / h, aliases = Math.ceil(limit / round);
  for (let a = -aliases; a <= aliases; ++a)
    for (let j = 0; j < at.length; ++j) {
      const omega = at[j] + a * round, half = 0.5 * h * omega;
      if (!(Math.abs(omega) <= limit) || omega === 0) continue;
      const hat = (Math.sin(half) / half) ** 2, [re, im] = transferAt(modes, reading, k, omega);
      H.re[j] -= hat * re;
      H.im[j] -= hat * im;
    }
}

// The transfer function at i omega, not 0.
function transferAt(modes, reading, k, omega) {
  let re = reading.feedthrough[k], im = -reading.impulse[k] / omega;
  for (let m = 0; m < modes.count; ++m) {
    const [rRe, rIm] = residueOf(modes, reading, m, k), pRe = modes.pole[2 * m], pIm = modes.pole[2 * m + 1];
    const u = -(rRe * pRe + rIm * pIm), v = rRe * omega, s = pRe * pRe + pIm * pIm - omega * omega, t = -2 * pRe * omega;
    const size = 1 / (s * s + t * t);
    re += (u * s + v * t) * size;
    im += (v * s - u * t) * size;
  }
  return [re, im];
}

// The largest part of F_T (N/m) from beyond the frequency up to which the model has been checked.
export function beyondBand(model, loads, h) {
  const n = loads[0].length, size = goodSize(2 * n), J = size / 2 + 1, limit = 2 * Math.PI * model.validity.highest_frequency;
  const at = Float64Array.from({length: J}, (_, j) => j * (2 * Math.PI / h) / size);
  const q = {re: at.map((omega) => Math.cos(omega * h) - 1), im: at.map((omega) => Math.sin(omega * h))};
  const sum = {re: new Float64Array(J), im: new Float64Array(J)}, reading = model.modes.readings.shear_force;
  loads.forEach((values, k) => {
    if (values.every((value) => value === 0)) return;
    const H = sampledTransfer(model.modes, reading, k, h, q), f = forward(values, size);
    takeOffBelow(model.modes, reading, k, h, at, limit, H);
    H.re[0] = H.im[0] = 0; // lines between equal samples have no corners
    for (let j = 0; j < J; ++j) {
      sum.re[j] += H.re[j] * f.re[j] - H.im[j] * f.im[j];
      sum.im[j] += H.re[j] * f.im[j] + H.im[j] * f.re[j];
    }
  });
  return largest(backward(sum, size));
}
