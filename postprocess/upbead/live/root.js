// Where a function of one variable changes its sign between two places: bisection, until no number is left between.
export function rootBetween(f, from, to) {
  const rises = f(from) < 0;
  let low = from, high = to;
  for (let i = 0; i < 200; ++i) {
    const middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    if (f(middle) < 0 === rises) low = middle; else high = middle;
  }
  return 0.5 * (low + high);
}
