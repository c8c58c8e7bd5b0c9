"""Natural frequencies and damping ratios of a survey of ambient vibration, and the computed modes that they belong
to.

A mode keeps its identity while keys change: it is followed to every other point from the first guess, where it is
chosen by the user or by its share in F_T. Poles change at most in proportion to stiffness and mass: |d ln f / d ln
theta| is 1/2 at most for a modulus (Rayleigh's quotient), so that a short step leads to one mode only; a long step is
halved until it does.
"""

from dataclasses import dataclass

import numpy as np

from .errors import NumericsError, UserError
from .fit_parameters import value_of

SHORTEST = 0.05  # of ln(parameter): shorter steps are not halved
JITTER = 0.002  # of ln f: change of a pole by the error of reduced models
NARROW = 1.5  # ratio of shares: modes with a smaller ratio may be exchanged
LEAST_DAMPING = 1e-9
SMALL = 1e-6  # factor of the loads at which strains vanish
FAR = 3.0  # uncertainties


@dataclass
class Surveyed:
    """Measured modes. frequency (Hz), damping (ratio): (value, uncertainty) of each, damping or None; rank: in the
    `periods` of the first guess, from 1, or None."""

    frequency: list
    damping: list
    rank: list

    @property
    def values(self):
        """Logarithms of all frequencies, then of the damping ratios."""
        return np.log([value for value, _ in self.rows])

    @property
    def uncertainty(self):
        """Relative uncertainties, which are those of the logarithms."""
        return np.array([uncertainty / value for value, uncertainty in self.rows])

    @property
    def rows(self):
        return self.frequency + [row for row in self.damping if row]

    @property
    def names(self):
        return ([f"the frequency {value:.4g} Hz" for value, _ in self.frequency]
                + [f"the damping ratio {row[0]:.4g}" for row in self.damping if row])

    def pick(self, modes):
        """The rows of `values` computed from modes[i] = (f, damping ratio, share) of the i-th mode."""
        damping = [mode[1] for mode, row in zip(modes, self.damping) if row]
        return np.log(np.maximum(np.concatenate([modes[:, 0], damping]), 1e-300))


def surveyed(frequencies, dampings):
    """The Surveyed of [(f, uncertainty), or (f, uncertainty, rank)] and [(damping ratio, uncertainty) or None]; None
    if nothing is given."""
    given, damping = list(frequencies or ()), list(dampings or ())
    if not given:
        if damping:
            raise UserError("a damping ratio is of a mode: give its frequency too, in the same order")
        return None
    if len(damping) > len(given):
        raise UserError(f"{len(damping)} damping ratios of {len(given)} frequencies: the n-th is of the n-th; give as many, or fewer")
    damping += [None] * (len(given) - len(damping))
    try:
        rank = [int(row[2]) if len(row) == 3 and row[2] is not None else None for row in given]
        frequency = [number_pair(row[:2]) for row in given]
        damping = [None if row is None else number_pair(row) for row in damping]
    except (TypeError, ValueError) as error:
        raise UserError(f"a measured mode is not understood ({error}): give positive numbers, frequencies=[(1.2, 0.03)] in Hz, "
                        "dampings=[(0.031, 0.006)] as ratios, each with its standard deviation") from error
    if any(row and row[0] >= 1.0 for row in damping):
        raise UserError("a damping ratio of 1 or more does not swing: 3.1 % is 0.031")
    told = [number for number in rank if number is not None]
    if len(set(told)) < len(told) or any(number < 1 for number in told):
        raise UserError(f"modes are numbered from 1, each frequency another: {told}")
    return Surveyed(frequency, damping, rank)


def number_pair(row):
    value, uncertainty = map(float, row)
    if not (0 < value < np.inf and 0 < uncertainty < np.inf):
        raise ValueError(f"{value:g} +- {uncertainty:g}")
    return value, uncertainty


def modes_of(result):
    """Rows of f (Hz), damping ratio, share of a run, largest share first."""
    found = result.summary.get("periods") or []
    return np.array([[1.0 / mode["period"], mode["damping_ratio"], mode["share"]] for mode in found]).reshape(-1, 3)


def require_modes(result):
    """Raises UserError if a run has no modes."""
    if result.summary.get("periods"):
        return
    if not result.has_caisson:
        raise UserError("the case has no surface `caisson`: no natural frequencies are told, and none can be fitted")
    scheme = (result.summary.get("discretisation") or {}).get("scheme", "another scheme")
    raise UserError(f"the run was solved by {scheme}, and tells no natural frequencies: they are the poles of a reduced "
                    'model; set time.scheme to "reduced", or to "auto" with friction node by node')


def at_small_strain(case):
    """{key: factor} by which soil that follows the strain is as stiff as under ambient vibration; {} for other
    soil."""
    if not any(region.get("strain") for region in case.get("regions", {}).values()):
        return {}
    return {f"loads.{name}.factor": SMALL * (value_of(load, "factor") or 1.0)
            for name, load in case.get("loads", {}).items() if value_of(load, "factor") != 0}


def by_share(measured, modes):
    """Index of the computed mode of each measured one: by its rank if given; for the others the k modes of largest
    share, in the order of the frequencies."""
    if max([len(measured.rank), *filter(None, measured.rank)]) > len(modes):
        raise UserError(f"{len(measured.rank)} modes were asked for, up to mode {max([0, *filter(None, measured.rank)])}; by the "
                        f"first guess {told(modes)}")
    index = [None if rank is None else rank - 1 for rank in measured.rank]
    free = [i for i in range(len(modes)) if i not in index]
    left = [n for n, taken in enumerate(index) if taken is None]
    chosen = sorted(free[: len(left)], key=lambda i: modes[i, 0])
    for n, i in zip(sorted(left, key=lambda n: measured.frequency[n][0]), chosen):
        index[n] = i
    return index


def told(modes):
    text = ", ".join(f"{n}: {f:.4g} Hz, damping {100 * z:.2g} %, share {100 * share:.2g} %"
                     for n, (f, z, share) in enumerate(modes[:8], 1))
    return f"F_T has these modes: {text}"


class Paired:
    """Computes the rows of measured modes at points x of parameters; each mode is followed from the first guess."""

    def __init__(self, measured, runs, parameters):
        self.measured, self.runs, self.parameters, self.doubts = measured, runs, parameters, []
        self.origin = np.zeros(len(parameters.keys))
        modes = self.modes(self.origin)
        if not len(modes):
            raise runs.failures[0] if runs.failures else NumericsError("no mode of the first guess swings")
        self.index = {tuple(self.origin): by_share(measured, modes)}
        first = self.at(self.origin)
        if any(row and mode[1] < LEAST_DAMPING for row, mode in zip(measured.damping, first)):
            raise UserError("the scene has no damping where a measured damping ratio is to be met: give its regions `damping`, "
                            "or fit frequencies alone")

    def modes(self, x):
        return self.runs.modes([self.parameters.point(x)])[0]

    def at(self, x):
        """(f, damping ratio, share) of each measured mode; nan if the run failed or a mode is lost."""
        key = tuple(x)
        if key not in self.index:
            near = min(self.index, key=lambda other: np.abs(np.array(other) - x).sum())
            self.walk(np.array(near), np.array(x))
        index = self.index.get(key)
        return self.modes(x)[index] if index else np.full((len(self.measured.rank), 3), np.nan)

    def rows(self, x):
        return self.measured.pick(self.at(x))

    def walk(self, begin, end):
        """Follows the modes from a point where they are known; leaves `end` out if that is not possible."""
        if tuple(begin) not in self.index:
            return
        way, modes = np.abs(end - begin).sum(), self.modes(end)
        if not len(modes):
            return
        start = self.modes(begin)[self.index[tuple(begin)]]
        found = [candidates(mode, modes, way) for mode in start]
        if all(len(one) == 1 for one in found) and len({one[0] for one in found}) == len(found):
            self.index[tuple(end)] = [one[0] for one in found]
        elif way > SHORTEST:
            middle = (begin + end) / 2
            self.walk(begin, middle)
            self.walk(middle, end)
        else:
            self.take_nearest(start, modes, end)

    def take_nearest(self, start, modes, end):
        index = [int(np.argmin(distance(mode, modes))) for mode in start]
        mode = start[0]
        if len(set(index)) == len(index) and all(abs(np.log(modes[i, 0] / m[0])) < SHORTEST + JITTER for i, m in zip(index, start)):
            self.index[tuple(end)] = index
            mode = next((m for m, i in zip(start, index) if candidates(m, modes, SHORTEST) != [i]), mode)
        values = ", ".join(f"{key} = {value:.4g}" for key, value in self.parameters.point(end).items())
        self.doubts.append(f"near {values} the mode of {mode[0]:.4g} Hz comes close to another, or is lost: which one goes on "
                           "is not certain")

    def table(self, x):
        """The pairs of measured and computed modes, for texts and files."""
        rows, first, now = [], self.at(self.origin), self.at(x)
        for n, (frequency, damping) in enumerate(zip(self.measured.frequency, self.measured.damping)):
            names = ("frequency", "damping_ratio", "share")
            rank = {"first guess": self.index[tuple(self.origin)][n] + 1, "fit": self.index[tuple(x)][n] + 1}
            rows.append({"measured": {"frequency": frequency[0], "frequency_uncertainty": frequency[1],
                                      "damping_ratio": damping and damping[0], "damping_uncertainty": damping and damping[1]},
                         **{name: {**dict(zip(names, map(float, modes[n]))), "mode": rank[name]}
                            for name, modes in (("first guess", first), ("fit", now))}})
        return rows

    def cautions(self, x):
        """Reasons to doubt the pairing and the numbers, in words."""
        found, modes = list(dict.fromkeys(self.doubts)), self.modes(x)
        found += self.narrow(self.modes(self.origin))
        index = self.index[tuple(x)]
        if (by_rule := rule_again(self.measured, modes, index)) != index:
            meant = ", ".join(f"{modes[i, 0]:.4g} Hz" for i in by_rule)
            found.append("modes changed places: by their shares at the fit the measured frequencies would be those of " + meant
                         + "; say which are meant, @N of the first guess, or begin nearer")
        off = (self.measured.values - self.rows(x)) / self.measured.uncertainty
        found += [f"{name} lies {abs(distance):.1f} of its uncertainties from the fit: the model, the pairing or the "
                  "uncertainty is wrong" for name, distance in zip(self.measured.names, off) if abs(distance) > FAR]
        return found + self.coarse(x)

    def narrow(self, modes):
        """A caution if the shares do not decide which mode is meant."""
        index = self.index[tuple(self.origin)]
        by_rule = [i for i, rank in zip(index, self.measured.rank) if rank is None]
        others = [i for i in range(len(modes)) if i not in index]
        if not by_rule or not others:
            return []
        last, next_one = min(by_rule, key=lambda i: modes[i, 2]), others[0]
        if modes[last, 2] > NARROW * modes[next_one, 2]:
            return []
        return [f"the mode of {modes[last, 0]:.4g} Hz by the first guess has hardly more share than that of "
                f"{modes[next_one, 0]:.4g} Hz; say which is meant, @N: {told(modes)}"]

    def coarse(self, x):
        """Cautions if a reduced model with a tenth of the tolerance has other poles."""
        fine = self.runs.finer(self.parameters.point(x))
        if fine is None or not len(fine):
            return ["how exact the computed modes are is not known, as no finer reduced model converges; a pulse about as long as "
                    "the period makes it easier"]
        moved = self.measured.pick(np.array([fine[np.argmin(distance(mode, fine))] for mode in self.at(x)])) - self.rows(x)
        return [f"{name}: a finer reduced model moves what is computed by {100 * np.expm1(abs(step)):.2g} %, more than a third of the "
                "uncertainty; lower accuracy.tolerance, or set a pulse about as long as the period"
                for name, step, error in zip(self.measured.names, moved, self.measured.uncertainty) if abs(step) > error / 3]


def rule_again(measured, modes, index):
    """by_share at another point; modes with a given rank are not changed."""
    rank = [i + 1 if asked is not None else None for i, asked in zip(index, measured.rank)]
    return by_share(Surveyed(measured.frequency, measured.damping, rank), modes)


def candidates(mode, modes, way):
    """The modes that `mode` may have become over a step `way` of ln(parameter): within the change that poles may
    have, and with a similar share."""
    near = np.abs(np.log(modes[:, 0] / mode[0])) <= way + JITTER
    return [int(i) for i in np.flatnonzero(near & (np.abs(np.log(modes[:, 2] / mode[2])) <= np.log(2.0)))]


def distance(mode, modes):
    """Difference of modes: mainly in frequency, then in share."""
    return np.abs(np.log(modes[:, 0] / mode[0])) + 0.02 * np.abs(np.log(modes[:, 2] / mode[2]))
