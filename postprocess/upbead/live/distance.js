// How far a symmetric triangular pulse slides a block, as src/sliding/pulse.cc has it: eq. (7) of Shimosako and Takahashi
// (1994), and the exact integral of their eqs. (4) and (6).

// pulse: {peak: F_Smax (N/m), duration: tau_0 (s)}; mass W/g (kg/m), resistance mu W' (N/m). Distances in m.
function scaleOfPulse(mass, resistance, {peak, duration}) {
  return {C: resistance * duration * duration / mass, r: peak / resistance};
}

// [S, S_1, S_2] by eq. (7): until F_S has fallen to mu W', and braking after it.
export function distancePaper(mass, resistance, pulse) {
  const {C, r} = scaleOfPulse(mass, resistance, pulse);
  if (!(r > 1)) return [0, 0, 0];
  return [C * (r - 1) ** 3 * (r + 1) / (8 * r * r), C * (r - 1) ** 3 / (4 * r * r), C * (r - 1) ** 4 / (8 * r * r)];
}

export function distanceExact(mass, resistance, pulse) {
  const {C, r} = scaleOfPulse(mass, resistance, pulse);
  if (!(r > 1)) return 0;
  if (r <= 1 + Math.sqrt(0.5)) return C * (0.25 + Math.sqrt(2) / 6) * (r - 1) ** 3 / (r * r);
  return C / 8 * ((r - 1) ** 2 - 1 / (12 * r * r));
}
