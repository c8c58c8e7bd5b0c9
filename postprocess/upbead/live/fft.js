// Discrete Fourier transform of lengths with the factors 2, 3 and 5.

// The least even length of at least `least` with these factors alone, as src/dynamics/real_fft.cc takes it.
export function goodSize(least) {
  for (let n = least + least % 2; ; n += 2) {
    let rest = n;
    for (const prime of [2, 3, 5]) while (rest > 1 && rest % prime === 0) rest /= prime;
    if (rest === 1) return n;
  }
}

const primeOf = (n) => [5, 3, 2].find((prime) => n % prime === 0);

function rootsOfUnity(n) {
  const cos = new Float64Array(n), sin = new Float64Array(n);
  for (let i = 0; i < n; ++i) [cos[i], sin[i]] = [Math.cos(2 * Math.PI * i / n), -Math.sin(2 * Math.PI * i / n)];
  return {cos, sin};
}

// One pass of p transforms of each `span` made one of p * span (Stockham: from one array into another, in order).
function pass(p, span, {re, im}, out, {cos, sin}) {
  const n = re.length, groups = n / (p * span), stride = n / p;
  for (let g = 0; g < groups; ++g)
    for (let s = 0; s < span; ++s)
      for (let q = 0; q < p; ++q) {
        let u = 0, v = 0;
        for (let r = 0; r < p; ++r) {
          const from = r * stride + g * span + s, turn = (r * (s + q * span) * groups) % n;
          u += re[from] * cos[turn] - im[from] * sin[turn];
          v += re[from] * sin[turn] + im[from] * cos[turn];
        }
        const to = g * p * span + q * span + s;
        out.re[to] = u;
        out.im[to] = v;
      }
}

// sum_j x_j exp(-2 pi i j k / n) of arrays of equal length, as new ones {re, im}.
export function transform(re, im) {
  const n = re.length, roots = rootsOfUnity(n);
  let now = {re, im}, other = {re: new Float64Array(n), im: new Float64Array(n)};
  const spare = {re: new Float64Array(n), im: new Float64Array(n)};
  for (let span = 1; span < n;) {
    const p = primeOf(n / span);
    pass(p, span, now, other, roots);
    span *= p;
    [now, other] = [other, now.re === re ? spare : now];
  }
  return now;
}

// Of a real series, filled with zeros to the length n: the amplitudes of 0 to n/2.
export function forward(series, n) {
  const padded = new Float64Array(n);
  padded.set(series);
  const {re, im} = transform(padded, new Float64Array(n));
  return {re: re.subarray(0, n / 2 + 1), im: im.subarray(0, n / 2 + 1)};
}

// The real series of these amplitudes.
export function backward({re, im}, n) {
  const u = new Float64Array(n), v = new Float64Array(n);
  for (let j = 0; j < n; ++j) {
    const at = j <= n / 2 ? j : n - j, mirrored = j > n / 2;
    u[j] = re[at];
    v[j] = at === 0 || at === n / 2 ? 0 : mirrored ? im[at] : -im[at];
  }
  return transform(u, v).re.map((value) => value / n);
}
