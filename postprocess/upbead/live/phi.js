// exp(x), phi_1 = (exp(x) - 1)/x and phi_2 = (phi_1 - 1)/x of a complex x, as src/dynamics/phi_functions.cc has them.

const N_TERMS = 18; // 1/20! is below round-off of 1/2

// 2 phi_2 by its power series, for |x| <= 1, where the closed form cancels.
function twicePhi2(re, im) {
  let u = 1, v = 0;
  for (let n = N_TERMS + 2; n > 2; --n) [u, v] = [1 + (u * re - v * im) / n, (u * im + v * re) / n];
  return [u, v];
}

// [Re exp, Im exp, Re phi_1, Im phi_1, Re phi_2, Im phi_2]
export function phiFunctions(re, im) {
  const size = Math.exp(re), e = size * Math.cos(im), f = size * Math.sin(im), square = re * re + im * im;
  if (square > 1) {
    const a = ((e - 1) * re + f * im) / square, b = (f * re - (e - 1) * im) / square;
    return [e, f, a, b, ((a - 1) * re + b * im) / square, (b * re - (a - 1) * im) / square];
  }
  const [u, v] = twicePhi2(re, im), a = 0.5 * u, b = 0.5 * v;
  return [e, f, 1 + re * a - im * b, re * b + im * a, a, b];
}
