// What the caisson presses on its base with, as src/sliding/base_pressure.cc has it.

// Pressures of the edges [seaward, landward] (Pa) under N' (N/m) and M' (N m/m, overturning landward positive), stress
// varying linearly over the width in contact.
function edgePressures(force, moment, width) {
  if (!(force > 0)) return [0, 0];
  const e = moment / force;
  if (Math.abs(e) <= width / 6) return [force / width * (1 - 6 * e / width), force / width * (1 + 6 * e / width)];
  const edge = 2 * force / (3 * Math.max(0.5 * width - Math.abs(e), 1e-3 * width));
  return e > 0 ? [0, edge] : [edge, 0];
}

// Of all times: {toe, heel} (Pa).
export function edgesOf({N, M, width}) {
  const toe = new Float64Array(N.length), heel = new Float64Array(N.length);
  for (let n = 0; n < N.length; ++n) [toe[n], heel[n]] = edgePressures(N[n], M[n], width);
  return {toe, heel};
}

// About the edge landward (side 1) or seaward (-1): moments that hold over moments that overturn; null where nothing
// overturns that way.
function overturningMargin(base, n, side) {
  const arm = 0.5 * base.width, {down, turning} = base.upright;
  const holds = (base.weight - base.U[n] + down[n]) * arm - side * (base.weightMoment + base.uplifting[n] + turning[n]);
  if (holds <= 0) return 0;  // it is lifted, whatever turns it
  const overturns = holds - (base.N[n] * arm - side * base.M[n]);
  return overturns > 1e-9 * base.weight * arm ? holds / overturns : null;
}

// base: {width, weight, weightMoment, U, uplifting: M_U, N, M, upright: {down, turning}}; upright: of loads that act up or
// down alone, their force and moment, null where the moment is not known, and neither is the margin. A peak is null where the resultant leaves the base there,
// the margin where nothing overturns. `lifts`: index of the first time at which an edge lifts, as the resultant is out of
// the middle third, or null; -1 is the seaward edge, 1 the landward one, 0 the whole base.
export function baseExtremes(base) {
  const worst = {heel: 0, toe: 0, margin: null, leastN: base.weight, lifts: null};
  for (let n = 0; n < base.N.length; ++n) {
    if (worst.lifts === null && !(Math.abs(base.M[n]) <= base.width / 6 * base.N[n])) worst.lifts = {n, edge: base.N[n] > 0 ? -Math.sign(base.M[n]) : 0};
    const [toe, heel] = edgePressures(base.N[n], base.M[n], base.width);
    const leaves = Math.abs(base.M[n]) >= 0.5 * base.width * base.N[n], floats = base.N[n] <= 0;
    if (floats || (leaves && base.M[n] >= 0)) worst.heel = null;
    if (floats || (leaves && base.M[n] <= 0)) worst.toe = null;
    if (worst.heel !== null) worst.heel = Math.max(worst.heel, heel);
    if (worst.toe !== null) worst.toe = Math.max(worst.toe, toe);
    worst.leastN = Math.min(worst.leastN, base.N[n]);
    for (const side of base.upright ? [1, -1] : []) {
      const margin = overturningMargin(base, n, side);
      if (margin !== null && (worst.margin === null || margin < worst.margin)) worst.margin = margin;
    }
  }
  return worst;
}
