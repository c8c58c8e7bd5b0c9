"""Weights of a record and of measured modes in one fit: each is divided by its own uncertainty.

Data are the record's samples, then the modes' logarithms. The uncertainties of modes are given. The noise s of a
record may be unknown: it then follows from the residual at the best fit, which depends on the weights by s: both are
computed in turns.
"""

from dataclasses import dataclass, field

import numpy as np

from .least_squares import least_squares, misfit, scipy_part

LEAST_SCALE = 1e-12  # least scale over the record's largest value; absolute for a record that is zero throughout
LEAST_NOISE = 1e-30  # noise of a record that is fitted exactly
TURNS, SETTLED = 10, 0.01


@dataclass
class Weights:
    """samples: number of samples of the record. noise: standard deviation of a sample, None if unknown. given:
    relative uncertainties of the modes."""

    samples: int
    noise: float | None = None
    given: np.ndarray = field(default_factory=lambda: np.empty(0))

    def size(self, answers, measured):
        """The function to be minimised: -2 ln(likelihood) without constants, with the best s if that is unknown
        (Seber and Wild 2003, ch. 2.2.1); for a record alone its sum of squares."""
        n = self.samples
        if not len(self.given):
            return misfit(answers, measured)
        modes = misfit([answer[n:] / self.given for answer in answers], measured[n:] / self.given)
        record = misfit([answer[:n] for answer in answers], measured[:n])
        if self.noise:
            return modes + record / self.noise**2
        return modes + n * np.log(np.maximum(record, 1e-300)) if n else modes

    def scales(self, noise):
        return np.concatenate([np.full(self.samples, noise), self.given])

    def solve(self, compute, measured, x, low, high):
        """The Solution, starting from x."""
        least = max(np.abs(measured[: self.samples]).max(initial=0.0), 1e-300)
        if not len(self.given) or self.noise or not self.samples:
            return least_squares(compute, measured, x, low, high, self.scales(self.noise or max(least, LEAST_SCALE)))
        noise = np.sqrt(np.mean((compute([x])[0] - measured)[: self.samples] ** 2))
        for _ in range(TURNS):
            noise = max(noise, LEAST_SCALE * least)
            solution = least_squares(compute, measured, x, low, high, self.scales(noise))
            x, last = solution.x, noise
            noise = self.noise_of(measured - solution.computed, solution.jacobian, last)[0]
            if abs(noise / last - 1) < SETTLED:
                break
        return solution

    def noise_of(self, residual, jacobian, about=None):
        """s and its degrees of freedom by the record's residual: s^2 = sum r^2/(n - tr H), where H = U U^T is the
        record's part of the projection on J over the uncertainties. E sum r^2 = s^2 (n - tr H) to first order, as the
        residual has the covariance I - H; without modes tr H = p."""
        n, p = self.samples, jacobian.shape[1]
        square = residual[:n] @ residual[:n]
        if len(self.given):
            about = about or max(np.sqrt(square / n), 1e-300)
            basis = np.linalg.svd(jacobian / self.scales(about)[:, None], full_matrices=False)[0]
            p = np.sum(basis[:n] ** 2)
        return float(np.sqrt(square / (n - p))), n - p

    def quantile(self, residual, jacobian):
        """The record's noise (None without record), and the quantile of 95 %: Student's t if the noise is that of the
        residual."""
        if self.noise or not self.samples:
            return self.noise, scipy_part("stats").norm.ppf(0.975)
        noise, freedom = self.noise_of(residual, jacobian)
        return noise, scipy_part("stats").t.ppf(0.975, freedom)

    def blocks(self, solution, noise):
        """[(jacobian, doubt)] of record and modes, each over its uncertainties."""
        n, found = self.samples, []
        scales = self.scales(noise or LEAST_NOISE)[:, None]
        for rows in (slice(0, n), slice(n, None)):
            jacobian, doubt = solution.jacobian[rows] / scales[rows], solution.doubt[rows] / scales[rows]
            if len(jacobian):
                found.append((jacobian, np.sqrt(np.mean(doubt**2, axis=0))))
        return found
