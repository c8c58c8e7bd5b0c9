// Waves of small amplitude and random breaking before the wall, as src/waves/wave_heights.cc has them; formulas of
// Goda (2000), Random Seas and Design of Maritime Structures.

export const HIGHEST_OVER_SIGNIFICANT = 1.8; // H_max / H_1/3 outside the surf zone

const SURF = 0.2; // h/L_0 from which nothing breaks
const DEEP_POWER = -0.38, LARGEST_POWER = -0.29; // of H_0'/L_0 in beta_0 and beta_max

// kh of omega^2 = g k tanh(kh), by Newton's method between bounds: tanh(x) < 1 and tanh(x) < x.
export function relativeWaveNumber(period, depth, gravity) {
  const omega = 2 * Math.PI / period, y = omega * omega * depth / gravity;
  const low = Math.max(y, Math.sqrt(y)), high = y + Math.sqrt(y);
  let x = Math.min(Math.max(y / Math.sqrt(Math.tanh(y)), low), high);
  for (let i = 0; i < 50; ++i) {
    const c = Math.cosh(x), last = x; // may be infinite, the slope is then 1
    x -= (x * Math.tanh(x) - y) / (Math.tanh(x) + x / c / c);
    if (Math.abs(x - last) <= 1e-16 * x) break;
  }
  return x;
}

export const wavelengthAt = (period, depth, gravity) => 2 * Math.PI * depth / relativeWaveNumber(period, depth, gravity);
export const deepWavelength = (period, gravity) => gravity * period * period / (2 * Math.PI);

// K_s of small waves and what the finite height adds.
function shoalingOf({height, period, depth}, gravity) {
  const kh = relativeWaveNumber(period, depth, gravity), L0 = deepWavelength(period, gravity);
  return 1 / Math.sqrt((1 + 2 * kh / Math.sinh(2 * kh)) * Math.tanh(kh)) +
    0.0015 * (depth / L0) ** -2.87 * (height / L0) ** 1.27;
}

// [beta_0, beta_1, beta_max] of H_1/3, or those of H_max with a star.
const ofSignificant = (steepness, slope) => [0.028 * steepness ** DEEP_POWER * Math.exp(20 * slope ** 1.5), 0.52 * Math.exp(4.2 * slope),
  Math.max(0.92, 0.32 * steepness ** LARGEST_POWER * Math.exp(2.4 * slope))];
const ofHighest = (steepness, slope) => [0.052 * steepness ** DEEP_POWER * Math.exp(20 * slope ** 1.5), 0.63 * Math.exp(3.8 * slope),
  Math.max(1.65, 0.53 * steepness ** LARGEST_POWER * Math.exp(2.4 * slope))];

// {height: H, significant: H_1/3} at the wall of the equivalent deep-water height H_0' (m).
export function designHeights({height: H0, period, depth, slope}, gravity) {
  const L0 = deepWavelength(period, gravity), shoaled = shoalingOf({height: H0, period, depth}, gravity) * H0;
  if (depth / L0 >= SURF) return {height: HIGHEST_OVER_SIGNIFICANT * shoaled, significant: shoaled};
  const [s0, s1, sMost] = ofSignificant(H0 / L0, slope), [m0, m1, mMost] = ofHighest(H0 / L0, slope);
  const significant = Math.min(s0 * H0 + s1 * depth, sMost * H0, shoaled), before = depth + 5 * significant * slope;
  return {height: Math.min(m0 * H0 + m1 * before, mMost * H0, HIGHEST_OVER_SIGNIFICANT * shoaled), significant};
}
