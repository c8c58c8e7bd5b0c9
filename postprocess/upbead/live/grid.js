// The times at which a model is asked about a wave, as src/respond/wave_grid.cc has them. A wave is {time, loads}: its
// times (s), ascending, and of each load its values; straight between them, zero before and after.

const MOST_TIMES = 400000; // what a page holds and draws at ease; `upbead respond` takes more

// Throws Error where that would be too many times.
export function requireRoom(n, step, end) {
  if (n > MOST_TIMES)
    throw new Error(`answers up to ${end.toPrecision(4)} s in steps of ${step.toPrecision(4)} s are ${Math.round(n)} ` +
      `times, more than the ${MOST_TIMES} that this page takes: ask upbead respond`);
}

// The step of times 0, step, 2 step, ..., as far as a file with six digits can tell; else null.
function equalStep(time) {
  const step = time[time.length - 1] / (time.length - 1);
  return time.every((t, n) => Math.abs(t - n * step) <= 1e-6 * step) ? step : null;
}

// When the last load of a wave is over (s): what is left then is less than a thousandth of the largest. 0 where the wave is
// cut off under load: more than a twentieth is left.
function endOfLoads({time, loads}) {
  const largest = loads.reduce((most, values) => values.reduce((one, value) => Math.max(one, Math.abs(value)), most), 0), least = 1e-3 * largest;
  let n = time.length - 1;
  if (loads.some((values) => Math.abs(values[n]) > 0.05 * largest)) return 0;
  while (n >= 0 && loads.every((values) => Math.abs(values[n]) <= least)) --n;
  return n < 0 ? 0 : time[Math.min(n + 1, time.length - 1)];
}

// When the answer to a wave ends (s): not before `end`, and `echo` after the last of its loads, but with a wave that is cut off under load.
export function endOfAnswer(wave, end, echo) {
  const last = wave.time[wave.time.length - 1], longer = Math.max(last, end), wanted = endOfLoads(wave) + echo;
  if (wanted <= longer * (1 + 1e-9)) return longer;
  const own = equalStep(wave.time);
  return own === null ? wanted : last + own * Math.ceil((wanted - last) / own * (1 - 1e-9));
}

function appendParts({time, stretches}, to, longest) {
  const from = time[time.length - 1], n = Math.max(1, Math.ceil((to - from) / longest * (1 - 1e-9)));
  requireRoom(n + time.length, longest, to);
  for (let i = 1; i < n; ++i) time.push(from + (to - from) * i / n);
  time.push(to);
  appendStretch(stretches, from, to, n);
}

// n more steps up to `to`. Steps that end within 1e-9 of themselves where the last ones would go on are taken as equal:
// ends are compared, not sizes, so that no number of steps drifts by more.
function appendStretch(stretches, from, to, n) {
  const last = stretches[stretches.length - 1];
  if (last && Math.abs(last.start + (last.to - last.from + n) * last.step - to) <= 1e-9 * last.step) last.to += n;
  else stretches.push({from: last ? last.to : 0, to: (last ? last.to : 0) + n, start: from, step: (to - from) / n});
}

export function equalTimesUntil(step, end) {
  const n = Math.ceil(end / step * (1 - 1e-9));
  requireRoom(n, step, end);
  return Array.from({length: n + 1}, (_, i) => i * step);
}

// n equal steps from 0.
export const equalStretch = (n, step) => [{from: 0, to: n, start: 0, step}];

// {time, stretches: of equal steps, by indices of times, equal: the step where all are equal or null, first: index of the wave's first time, last: of its last one
// where the grid goes on beyond, else null}
export function waveGrid(time, longestStep, end) {
  const own = equalStep(time), grid = {time: [0], stretches: [], equal: null, first: 0, last: null};
  if (own !== null) {
    const parts = Math.max(1, Math.ceil(own / longestStep * (1 - 1e-9))), step = own / parts, n = end / step;
    if (parts === 1 || Math.abs(n - Math.round(n)) <= 1e-6) {
      const last = (time.length - 1) * parts, all = equalTimesUntil(step, end);
      return {time: all, stretches: equalStretch(all.length - 1, step), equal: step, first: 0, last: all.length > last + 1 ? last : null};
    }
  }
  for (const t of time) if (t > 0 && t < end) appendParts(grid, t, longestStep);
  if (time[time.length - 1] < end) grid.last = grid.time.length - 1;
  appendParts(grid, end, longestStep);
  if (time[0] <= end) grid.first = grid.time.findIndex((t) => t >= time[0]);
  return grid;
}

// One load of a wave at the times of a grid.
function onTimes(own, values, time) {
  const sampled = new Float64Array(time.length), roundOff = 1e-6 * (own[1] - own[0]), last = own.length - 1;
  if (own.length <= time.length && own.every((t, n) => Math.abs(t - time[n]) <= roundOff)) {
    sampled.set(values);
    return sampled;
  }
  for (let n = 0, left = 0; n < time.length; ++n) {
    const t = Math.min(Math.max(time[n], own[0]), own[last]);
    if (Math.abs(t - time[n]) > roundOff) continue;
    while (left + 2 < own.length && own[left + 1] <= t) ++left;
    const right = (t - own[left]) / (own[left + 1] - own[left]);
    sampled[n] = (1 - right) * values[left] + right * values[left + 1];
  }
  return sampled;
}

export const onGrid = (wave, time) => wave.loads.map((values) => onTimes(wave.time, values, time));

// Equally spaced times to look at frequencies.
export function checkTimes(grid, longestStep, until) {
  if (grid.equal !== null) return equalTimesUntil(grid.equal, until);
  let shortest = longestStep;
  for (let n = 1; n < grid.time.length; ++n) shortest = Math.min(shortest, grid.time[n] - grid.time[n - 1]);
  return equalTimesUntil(Math.max(shortest, longestStep / 10), until);
}
