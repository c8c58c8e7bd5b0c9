"""The affine-invariant ensemble sampler of Goodman and Weare (2010): no step size to choose, and as good in narrow,
oblique valleys as in round ones."""

from dataclasses import dataclass

import numpy as np

STRETCH = 2.0  # a of Goodman and Weare
WINDOW = 5.0  # of Sokal's estimate of the autocorrelation time, in such times


@dataclass
class Chain:
    """points: (steps, walkers, dimension). log: of the density there. accepted: share of the proposals."""

    points: np.ndarray
    log: np.ndarray
    accepted: float

    def after(self, share):
        """The chain without this share of its beginning."""
        begin = int(share * len(self.points))
        return Chain(self.points[begin:], self.log[begin:], self.accepted)

    @property
    def flat(self):
        return self.points.reshape(-1, self.points.shape[-1])


def ensemble(log_density, start, steps, rng):
    """The Chain of `steps` moves of all walkers from start, (walkers, dimension).

    log_density: list of points -> list of numbers; -inf where the density is zero. Half of the walkers move at a time,
    each along the line to one of the other half, so that their densities may be computed side by side (Foreman-Mackey
    et al. 2013). A stretch z has the density 1/sqrt(z) between 1/a and a, and is accepted with
    min(1, z^(d - 1) p(new)/p(old)) (Goodman and Weare 2010, eq. 7 to 9).
    """
    points = np.array(start, dtype=float)
    walkers, dimension = points.shape
    if walkers % 2 or walkers < 2 * dimension:
        raise ValueError(f"{walkers} walkers in {dimension} dimensions; an even number, at least twice as many, is needed")
    log = np.array(log_density(list(points)), dtype=float)
    if not np.isfinite(log).all():
        raise ValueError("a walker begins where the density is zero")
    halves = np.arange(walkers).reshape(2, -1)
    kept, logs, accepted = [], [], 0
    for _ in range(steps):
        for moving, other in (halves, halves[::-1]):
            z = (1 + (STRETCH - 1) * rng.random(len(moving))) ** 2 / STRETCH
            partner = points[rng.choice(other, len(moving))]
            proposed = partner + z[:, None] * (points[moving] - partner)
            new = np.array(log_density(list(proposed)), dtype=float)
            with np.errstate(divide="ignore"):
                taken = np.log(rng.random(len(moving))) < (dimension - 1) * np.log(z) + new - log[moving]
            points[moving[taken]], log[moving[taken]] = proposed[taken], new[taken]
            accepted += taken.sum()
        kept.append(points.copy())
        logs.append(log.copy())
    return Chain(np.array(kept), np.array(logs), accepted / (steps * walkers))


def autocorrelation_time(series):
    """Steps between independent states of (steps, walkers): 1 + 2 sum rho(t), rho the mean of all walkers, up to the
    first t beyond WINDOW such times (Sokal 1996; Goodman and Weare 2010, ch. 5)."""
    steps = len(series)
    centred = series - series.mean()
    size = 2 ** int(np.ceil(np.log2(2 * steps)))
    spectrum = np.abs(np.fft.rfft(centred, size, axis=0)) ** 2
    covariance = np.fft.irfft(spectrum, size, axis=0)[:steps].mean(axis=1)
    if not covariance[0] > 0:
        return float(steps)
    times = 2 * np.cumsum(covariance / covariance[0]) - 1
    beyond = np.flatnonzero(np.arange(steps) >= WINDOW * times)
    return float(max(1.0, times[beyond[0] if len(beyond) else -1]))
