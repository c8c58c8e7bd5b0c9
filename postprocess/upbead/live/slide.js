// A rigid block on friction, as src/sliding/block.cc has it: eq. (4) of Shimosako and Takahashi (1994), exact on straight
// lines of F and of what resists it.

// phi_k(z) = sum_i z^i / (i + k)!
function realPhi(k, z) {
  if (Math.abs(z) > 0.5) {
    let value = Math.exp(z), factorial = 1;
    for (let i = 1; i <= k; ++i) {
      value = (value - 1 / factorial) / z;
      factorial *= i;
    }
    return value;
  }
  let term = 1;
  for (let i = 2; i <= k; ++i) term /= i;
  let sum = term;
  for (let i = 1; i < 16; ++i) sum += term *= z / (i + k);
  return sum;
}

// v' = a + jerk t - lambda v from v(0) = speed >= 0, while v > 0.
class SlipMotion {
  constructor(speed, a, jerk, lambda) {
    Object.assign(this, {v: speed, a, jerk, lambda});
  }
  rawSpeed(t) {
    if (this.lambda === 0) return this.v + t * (this.a + t * this.jerk / 2);
    const z = -this.lambda * t;
    return this.v * Math.exp(z) + t * (this.a * realPhi(1, z) + t * this.jerk * realPhi(2, z));
  }
  speed(t) {
    return Math.max(this.rawSpeed(t), 0);
  }
  distance(t) {
    if (this.lambda === 0) return t * (this.v + t * (this.a / 2 + t * this.jerk / 6));
    const z = -this.lambda * t;
    return t * (this.v * realPhi(1, z) + t * (this.a * realPhi(2, z) + t * this.jerk * realPhi(3, z)));
  }
  // Where v' = 0, beyond 0; Infinity where it is nowhere.
  turn() {
    const b = this.a - this.lambda * this.v;
    if (this.jerk === 0 || b / this.jerk >= 0) return Infinity;
    return this.lambda === 0 ? -b / this.jerk : Math.log1p(-this.lambda * b / this.jerk) / this.lambda;
  }
  // The least t > 0 with v = 0; Infinity where there is none up to `end`.
  stop(end) {
    if (this.lambda === 0) return this.stopOfParabola();
    const extremum = Math.min(this.turn(), end);
    const from = this.jerk < 0 && extremum < end ? extremum : 0, to = this.jerk > 0 ? extremum : end;
    if (this.rawSpeed(to) > 0) return Infinity;
    if (!(this.rawSpeed(from) > 0)) return this.v === 0 && this.jerk < 0 ? 2 * from : Infinity;
    return this.rootBetween(from, to);
  }
  rootBetween(low, high) {
    for (let i = 0; i < 200; ++i) {
      const middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      if (this.rawSpeed(middle) > 0) low = middle; else high = middle;
    }
    return high;
  }
  // Roots without cancellation, after Press et al., Numerical Recipes, section 5.6.
  stopOfParabola() {
    if (this.v === 0) return this.jerk < 0 ? -2 * this.a / this.jerk : Infinity;
    const discriminant = this.a * this.a - 2 * this.jerk * this.v;
    if (discriminant < 0) return Infinity;
    const q = -(this.a + (this.a < 0 || Object.is(this.a, -0) ? -1 : 1) * Math.sqrt(discriminant));
    return Math.min(...[q / this.jerk, 2 * this.v / q].filter((root) => root > 0), Infinity);
  }
}

const lineAt = (line, fraction) => (1 - fraction) * line[0] + fraction * line[1];

// What is left of a piece {start, length, F: [begin, end], R: [begin, end]} past some seconds.
function restOf(piece, passed) {
  const {start, length, F, R} = piece, fraction = passed / length;
  return {start: start + passed, length: length - passed, F: [lineAt(F, fraction), F[1]], R: [lineAt(R, fraction), R[1]]};
}

const netForce = ({F, R}, way) => [way * F[0] - R[0], way * F[1] - R[1]];

function timeToStart(net, length) {
  if (net[0] > 0) return 0;
  return net[1] <= 0 ? length : length * -net[0] / (net[1] - net[0]);
}

class Block {
  constructor(mass, drag) {
    Object.assign(this, {mass, drag, way: 0, speed: 0, slip: 0, residual: 0, slips: 0});
  }
  pass(piece) {
    let stopped = 0;
    if (this.way !== 0 && this.speed === 0) this.endSlip();
    while (piece.length > 0) {
      if (this.way === 0) {
        piece = restOf(piece, this.rest(piece, stopped));
      } else {
        stopped = this.way;
        piece = restOf(piece, this.slide(piece));
      }
    }
  }
  // Waits for a start. The force that has just stopped the block does not push it, whatever round-off says.
  rest(piece, stopped) {
    let passed = piece.length;
    for (const way of [1, -1]) {
      const net = netForce(piece, way);
      if (way === stopped) net[0] = Math.min(net[0], 0);
      const start = timeToStart(net, piece.length);
      if (start >= passed) continue;
      passed = start;
      this.way = way;
    }
    this.slip = 0;
    return passed;
  }
  slide(piece) {
    const net = netForce(piece, this.way);
    if (this.speed === 0) net[0] = Math.max(net[0], 0);
    const motion = new SlipMotion(this.speed, net[0] / this.mass, (net[1] - net[0]) / (this.mass * piece.length),
      this.drag / this.mass);
    const stop = motion.stop(piece.length), passed = Math.min(stop, piece.length);
    this.slip += this.way * motion.distance(passed);
    this.speed = passed === stop ? 0 : motion.speed(passed);
    if (passed === stop) this.endSlip();
    return passed;
  }
  endSlip() {
    this.way = 0;
    if (this.slip === 0) return;
    this.residual += this.slip;
    ++this.slips;
  }
}

// {S, slips}: where the block comes to rest (m, landward), and in how many slips. sliding: {friction, weight: W' (N/m),
// drag}; U: uplift over time, or null.
export function slideOnFriction(sliding, mass, time, F, U) {
  const {friction, weight, drag} = sliding;
  const R = new Float64Array(F.length).fill(friction * weight);
  if (U) U.forEach((uplift, n) => { R[n] = friction * Math.max(weight - uplift, 0); });
  let start = 0;
  while (start < F.length && Math.abs(F[start]) <= R[start]) ++start;
  if (start === F.length) return {S: 0, slips: 0};
  const stays = sliding.uplift === "held" && U && R[R.length - 1] > 0;  // as src/respond/respond_slip.cc has it
  const block = new Block(mass, drag), after = stays ? R[R.length - 1] : friction * weight;
  for (let n = Math.max(start - 1, 0); n + 1 < F.length; ++n)
    block.pass({start: time[n], length: time[n + 1] - time[n], F: [F[n], F[n + 1]], R: [R[n], R[n + 1]]});
  if (block.speed > 0)
    block.pass({start: time[F.length - 1], length: 2 * mass * block.speed / after, F: [0, 0], R: [after, after]});
  return {S: block.residual, slips: block.slips};
}
