// Waves of idealised shapes, with the keys of [loads.NAME.pulse] (src/model/load.cc); times in s.

const HALF_SINE_PARTS = 200; // straight lines between miss the sine by 3e-5 of its peak

// A load that jumps begins with its first value, and ends with its last: one of two corners at one time is left out.
function corners(list) {
  const last = list.length - 1, endsWithJump = list[last - 1][0] === list[last][0];
  return list.filter(([time], i) => (i === 0 ? time !== list[1][0] : true) && !(i === last && endsWithJump));
}

function halfSine({start, duration, peak}) {
  const part = (i) => [start + duration * i / HALF_SINE_PARTS, i === HALF_SINE_PARTS ? 0 : peak * Math.sin(Math.PI * i / HALF_SINE_PARTS)];
  return Array.from({length: HALF_SINE_PARTS + 1}, (_, i) => part(i));
}

// By shape: [[time, value] ...] and the keys that it has. `end`: until when a step is followed.
export const SHAPES = {
  triangle: {keys: ["peak", "rise", "duration", "start"], corners: ({start, rise, duration, peak}) =>
    corners([[start, 0], [start + rise, peak], [start + duration, 0]])},
  church_roof: {keys: ["peak", "rise", "duration", "plateau", "plateau_duration", "start"], corners: (pulse) => corners([
    [pulse.start, 0], [pulse.start + pulse.rise, pulse.peak], [pulse.start + pulse.duration, pulse.plateau * pulse.peak],
    [pulse.start + pulse.plateau_duration, 0]])},
  half_sine: {keys: ["peak", "duration", "start"], corners: halfSine},
  step: {keys: ["peak", "rise", "start"], corners: ({start, rise, peak}, end) =>
    corners([[start, 0], [start + rise, peak], [Math.max(end, 2 * (start + rise)), peak]])},
};

// Of `count` loads the one called `load` has the pulse; the others are zero.
export function waveOf(pulse, load, count, end) {
  const points = SHAPES[pulse.shape].corners(pulse, end);
  const loads = Array.from({length: count}, (_, k) => points.map(([, value]) => k === load ? value : 0));
  return {time: points.map(([time]) => time), loads};
}
