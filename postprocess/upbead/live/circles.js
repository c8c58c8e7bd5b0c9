// Slip circles under the caisson in a wave, as src/rupture/circle_family.cc and slices.cc have them.
import {doubles, readingsAt} from "./modes.js";

const OF_CIRCLE = 8, OF_SLICE = 7, LEAST_M = 0.2; // numbers of a circle and of a slice in the model's file

// Of the numbers that live/model_data.py wrote; null where the model has none.
export function circlesOf(data) {
  if (!data) return null;
  const circle = doubles(data.circle), slice = doubles(data.slice), circles = [];
  for (let i = 0, first = 0, reading = 0; i < circle.length; i += OF_CIRCLE) {
    const [x, y, radius, from, to, side, weightMoment, count] = circle.subarray(i, i + OF_CIRCLE);
    circles.push({x, y, radius, from, to, side, weightMoment, count, slices: slice.subarray(first * OF_SLICE, (first + count) * OF_SLICE), reading});
    first += count;
    reading += count + 1;
  }
  const [left, right, level, gap] = data.base, table = (name) => doubles(data[name]);
  return {left, right, level, gap, circles, weight: table("reading"), feedthrough: table("feedthrough"), impulse: table("impulse")};
}

const standsOn = (force, moment, width) => force > 0 && Math.abs(moment) < 0.499 * width * force;

// The load on the effective width, at the edge to which the resultant is nearer.
function stripOf({left, right}, force, moment) {
  const e = moment / force, half = 0.5 * (right - left) - Math.abs(e), q = 0.5 * force / half;
  return e > 0 ? {from: right - 2 * half, to: right, q} : {from: left, to: left + 2 * half, q};
}

// F = sum borne/max(cos + sin tan/F, 0.1)/driving, by the steps of slices.cc; null where it is too steep.
function fixedFactor(borne, cosine, slope, driving) {
  const resistance = (F) => {
    let sum = 0;
    for (let i = 0; i < borne.length; ++i) sum += borne[i] / Math.max(cosine[i] + slope[i] / F, 0.5 * LEAST_M);
    return sum;
  };
  let before = 1, F = resistance(before) / driving, restBefore = F - before;
  for (let i = 0; i < 60; ++i) {
    if (!(F > 0)) { F = 0; break; }
    const rest = resistance(F) / driving - F;
    if (Math.abs(rest) <= 1e-10 * F) break;
    const gradient = (rest - restBefore) / (F - before);
    before = F;
    restBefore = rest;
    F = gradient < -0.05 ? Math.max(F - rest / gradient, 0.2 * F) : F + rest;
  }
  for (let i = 0; i < borne.length; ++i) if (cosine[i] + slope[i] / F < LEAST_M) return null;
  return F;
}

// readings: those of the family, or null for the pressure of still water.
function factorUnder(circle, strip, level, {force, shear}, readings) {
  const trifle = 1e-9 * (strip.to - strip.from), {slices, count, side} = circle;
  if (circle.from > strip.from + trifle || circle.to < strip.to - trifle) return null;
  let moment = circle.weightMoment + side * (force * (circle.x - 0.5 * (strip.from + strip.to)) + shear * (circle.y - level));
  if (readings) moment += readings[circle.reading + count];
  if (!(moment > 0)) return null;
  const borne = new Float64Array(count), cosine = new Float64Array(count), slope = new Float64Array(count);
  for (let i = 0; i < count; ++i) {
    const at = i * OF_SLICE, x = slices[at], width = slices[at + 1], friction = slices[at + 5];
    const share = Math.max(0, Math.min(strip.to, x + 0.5 * width) - Math.max(strip.from, x - 0.5 * width)) / width;
    const normal = slices[at + 6] + strip.q * share + (readings ? readings[circle.reading + i] : 0);
    borne[i] = Math.max(slices[at + 4] + normal * friction, 0) * width;
    cosine[i] = slices[at + 3];
    slope[i] = slices[at + 2] * friction;
  }
  return fixedFactor(borne, cosine, slope, moment / circle.radius);
}

function leastFactor(family, load, readings) {
  const strip = stripOf(family, load.force, load.moment);
  let least = null;
  for (const circle of family.circles) {
    if (circle.side * load.shear < 0 && circle.side * load.moment < 0) continue;
    const factor = factorUnder(circle, strip, family.level, load, readings);
    if (factor !== null && (least === null || factor < least.factor)) least = {factor, circle};
  }
  return least;
}

// Of the largest F_T both ways, |M'/N'| and F_T/N', of the least N', and the first.
function momentsOf(N, M, F, width) {
  const measures = [(n) => F[n], (n) => -F[n], (n) => Math.abs(M[n]) / N[n], (n) => Math.abs(F[n]) / N[n], (n) => -N[n]];
  const list = new Set([0]);
  for (const measure of measures) {
    let best = -1;
    for (let n = 0; n < N.length; ++n) if (standsOn(N[n], M[n], width) && (best < 0 || measure(n) > measure(best))) best = n;
    if (best >= 0) list.add(best);
  }
  return [...list].sort((a, b) => a - b);
}

// {factor, n, circle, computed} of the least factor over a wave; a factor of 0 where the resultant leaves the base; null
// where no circle has a factor.
export function circleOfWave(family, modes, {N, M, width}, F, loads, grid, smoothStart) {
  for (let n = 0; n < N.length; ++n) if (!standsOn(N[n], M[n], width)) return {factor: 0, n, circle: null, computed: false};
  const moments = momentsOf(N, M, F, width), readings = readingsAt(modes, family, loads, grid, moments, smoothStart);
  let least = null;
  moments.forEach((n, i) => {
    for (const computed of [false, true]) {
      const found = leastFactor(family, {force: N[n], shear: F[n], moment: M[n]}, computed ? readings[i] : null);
      if (found && (least === null || found.factor < least.factor)) least = {...found, n, computed};
    }
  });
  return least;
}
