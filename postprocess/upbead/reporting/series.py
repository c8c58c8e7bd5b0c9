"""Fewer points of a history with the same picture: the least and the largest value of every short span are kept."""

import numpy as np

SPANS = 400


def largest(values):
    """The largest finite magnitude; 0 if there is none."""
    size = np.abs(np.asarray(values, dtype=float))
    return float(np.max(size[np.isfinite(size)], initial=0.0))


def thinned(x, values, spans=SPANS):
    """(x, values) at no more than 2 spans + 2 points: both ends, and the least and the largest of each span."""
    x, values = np.asarray(x, dtype=float), np.asarray(values, dtype=float)
    kept = np.isfinite(x) & np.isfinite(values)
    x, values = x[kept], values[kept]
    if x.size <= 2 * spans + 2:
        return x, values
    chosen = {0, x.size - 1}
    edges = np.linspace(0, x.size, spans + 1).astype(int)
    for low, high in zip(edges[:-1], edges[1:]):
        chosen |= {low + int(np.argmin(values[low:high])), low + int(np.argmax(values[low:high]))}
    chosen = np.array(sorted(chosen))
    return x[chosen], values[chosen]


def rounded(values, digits=5):
    """Numbers for JSON; 5 digits of their extent are more than a screen resolves. Far from zero a number has more."""
    values = np.asarray(values, dtype=float)
    extent, size = (float(f(values)) if values.size else 0.0 for f in (np.ptp, largest))
    digits += int(np.ceil(np.log10(size / extent))) if 0 < extent < size else 0
    return [float(f"{value:.{min(digits, 17)}g}") for value in values]
