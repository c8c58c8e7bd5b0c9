"""Points of a chain by a fast model answered again by full runs.

The second stage of delayed acceptance (Christen and Fox 2005, with any number of first stages before each second): a
point x of the chain of the fast model's density q, far enough from the one before to be independent of it, is accepted
by the full density p with min(1, w(x)/w(before)), w = p/q. The same w, scaled to a sum of 1, are weights of importance.
"""

from dataclasses import dataclass

import numpy as np

LEAST_WORTH = 0.5  # of the points' number, that weighted points are worth
LARGEST_SHIFT = 0.5  # of a mean, in standard deviations of the posterior; the chance of 20 points is 0.22


@dataclass
class Check:
    """points: answered by full runs, of which `failed` could not be. accepted: share in the second stage. worth: number
    of points that the weighted ones are worth, (sum w)^2/sum w^2. shift: of the mean of ln(keys) by the weights, in
    standard deviations of the posterior; the largest. spread: standard deviation of ln w."""

    points: int
    failed: int
    accepted: float
    worth: float
    shift: float
    spread: float

    def summary(self):
        return dict(vars(self))

    def __str__(self):
        return (f"checked by {self.points} full runs: {100 * self.accepted:.0f} % accepted, weighted they are worth {self.worth:.1f}, "
                f"and move the means by up to {self.shift:.2g} standard deviations")

    def cautions(self):
        found = []
        if self.failed:
            found.append(f"{self.failed} of {self.points} full runs of the check failed")
        if self.worth < LEAST_WORTH * self.points or self.shift > LARGEST_SHIFT:
            found.append(f"the fast model is too coarse for this record: {self.points} points of its chain are worth {self.worth:.1f} by "
                         f"full runs, and their mean moves by {self.shift:.2g} standard deviations; lower the model's tolerance")
        return found


def checked(chain, full, checks, time, rng):
    """The Check of points of the end of a Chain, at least an autocorrelation time apart; full: list of points -> ln of
    the density by full runs."""
    steps, walkers, _ = chain.points.shape
    apart = max(1, int(np.ceil(time)))
    rows = np.arange(steps - 1, -1, -apart)[: -(-checks // walkers)]
    places = [(row, walker) for row in rows for walker in rng.permutation(walkers)][:checks]
    points = np.array([chain.points[place] for place in places])
    difference = np.array(full(list(points))) - np.array([chain.log[place] for place in places])
    good = np.isfinite(difference)
    if not good.any():
        return Check(len(points), len(points), 0.0, 0.0, np.inf, np.inf)
    log = difference[good] - difference[good].max()
    weight = np.exp(log) / np.exp(log).sum()
    shift = np.abs(weight @ points[good] - points[good].mean(axis=0)) / chain.flat.std(axis=0)
    return Check(len(points), int((~good).sum()), second_stage(difference, rng), float(1.0 / (weight @ weight)), float(shift.max()),
                 float(log.std()))


def second_stage(log, rng):
    """The share of points that are accepted one after the other, from the first."""
    now, accepted = log[0], 0
    for new in log[1:]:
        if np.log(rng.random()) < new - now:
            now, accepted = new, accepted + 1
    return accepted / max(1, len(log) - 1)
