// F_T of a soil under the loads of the case, by a small system that is a sum over the soil's constants, stepped by the
// trapezoidal rule (Newmark's constant average acceleration), as live/soil_data.py has it.

const floats = (text) => Float64Array.from(new Float32Array(Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0)).buffer));

// A matrix of its blocks; rows of phi multiplied by -1, with which the system has energy, and needs no pivots.
function matrixOf(part, key, n, nu) {
  if (!["uu", "pp", "up"].some((block) => part[key + block])) return null;
  const A = new Float64Array(n * n);
  for (const [block, from, to] of [["uu", 0, nu], ["pp", nu, n]]) {
    if (!part[key + block]) continue;
    const values = floats(part[key + block]);
    for (let i = from, k = 0; i < to; ++i) for (let j = from; j <= i; ++j, ++k) A[i * n + j] = A[j * n + i] = values[k];
  }
  if (part[`${key}up`]) {
    const values = floats(part[`${key}up`]);
    for (let i = 0, k = 0; i < nu; ++i) for (let j = nu; j < n; ++j, ++k) A[i * n + j] = A[j * n + i] = values[k];
  }
  for (let i = nu * n; i < n * n; ++i) A[i] = -A[i];
  return A;
}

// Of the numbers that soil_data.py wrote.
export function soilSystemOf(data) {
  const n = data.size, nu = data.of_u, load = floats(data.load), force = floats(data.force), count = data.direct.length;
  for (let i = nu * count; i < n * count; ++i) load[i] = -load[i];
  const parts = data.parts.map((part) => ({matrices: ["M", "C", "K"].map((key) => matrixOf(part, key, n, nu)), rows: part.rows.map(floats)}));
  return {...data, n, load, force, count, parts, steps: force.length / count - 1};
}

// theta_q of a soil {key: value}.
export function thetaOf({keys, theta, powers}, soil) {
  return theta.map((first, q) => keys.reduce((product, {key, value}, k) => product * (soil[key] / value) ** powers[q][k], first));
}

function sumOf(parts, theta, pick, size) {
  const sum = new Float64Array(size);
  parts.forEach((part, q) => {
    const values = pick(part), factor = q ? theta[q - 1] : 1;
    if (values) for (let i = 0; i < size; ++i) sum[i] += factor * values[i];
  });
  return sum;
}

function factorise(A, n) {
  for (let k = 0; k < n; ++k)
    for (let i = k + 1; i < n; ++i) {
      const factor = A[i * n + k] /= A[k * n + k];
      if (factor !== 0) for (let j = k + 1, row = i * n, pivot = k * n; j < n; ++j) A[row + j] -= factor * A[pivot + j];
    }
}

function solve(L, n, x) {
  for (let i = 1; i < n; ++i) for (let j = 0, at = i * n; j < i; ++j) x[i] -= L[at + j] * x[j];
  for (let i = n - 1; i >= 0; --i) {
    let sum = x[i];
    for (let j = i + 1, at = i * n; j < n; ++j) sum -= L[at + j] * x[j];
    x[i] = sum / L[i * n + i];
  }
}

// {time, P, F}: F_T at the ends of the steps, beside P.
export function soilAnswer(system, soil) {
  const {n, step: h, steps, count, load, force, direct, parts} = system, theta = thetaOf(system, soil);
  const [M, C, K] = [0, 1, 2].map((k) => sumOf(parts, theta, ({matrices}) => matrices[k], n * n));
  const [position, velocity, acceleration] = [0, 1, 2].map((k) => sumOf(parts, theta, ({rows}) => rows[k], n));
  const L = M.map((value, i) => value + 0.5 * h * C[i] + 0.25 * h * h * K[i]);
  factorise(L, n);
  const q = new Float64Array(n), v = new Float64Array(n), a = new Float64Array(n);
  const F = new Float64Array(steps + 1), time = F.map((_, s) => s * h), of = (k, s) => force[k * (steps + 1) + s];
  const P = F.map((_, s) => system.push.reduce((sum, push, k) => sum + push * of(k, s), 0));
  for (let s = 1; s <= steps; ++s) {
    for (let i = 0; i < n; ++i) {
      q[i] += h * v[i] + 0.25 * h * h * a[i];
      v[i] += 0.5 * h * a[i];
    }
    for (let i = 0; i < n; ++i) {
      let sum = 0;
      for (let k = 0; k < count; ++k) sum += load[i * count + k] * of(k, s);
      for (let j = 0, at = i * n; j < n; ++j) sum -= C[at + j] * v[j] + K[at + j] * q[j];
      a[i] = sum;
    }
    solve(L, n, a);
    for (let k = 0; k < count; ++k) F[s] += direct[k] * of(k, s);
    for (let i = 0; i < n; ++i) {
      q[i] += 0.25 * h * h * a[i];
      v[i] += 0.5 * h * a[i];
      F[s] += position[i] * q[i] + velocity[i] * v[i] + acceleration[i] * a[i];
    }
  }
  return {time, P, F};
}
