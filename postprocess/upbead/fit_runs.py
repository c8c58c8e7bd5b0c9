"""The runs of the program that a fit needs."""

import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from . import told
from .commands import run
from .errors import CaseError, NumericsError, UserError
from .fit_modes import modes_of, require_modes
from .fit_parameters import TIME_FACTOR, value_of

# most and fewest steps of a window; between these limits the step is that of the record
FINEST, COARSEST = 20000, 2000


class Runs:
    """Histories of one reading, and modes, by the values of keys: with one run of the program for each point, whose
    results are kept.

    small: keys of a separate run for the modes, which soils that follow the strain need; {}: no separate run.
    history, modes: whether they are wanted. doubts: what runs warn of, by the name of the warning, as the last one told it.
    """

    def __init__(self, case, reading, ties, set, jobs, program):
        self.case, self.reading, self.ties, self.jobs, self.program = case, reading, ties, jobs, program
        self.set = {"time.scheme": "reduced", **(set or {})}
        self.kept, self.n_runs, self.failures, self.doubts = {}, 0, [], {}
        self.small, self.wants_history, self.wants_modes, self.tolerance = {}, True, False, None
        self.end = None  # of the window (s), once it is known

    def look_at(self, time):
        """Uses the record's times as steps of reduced models, which take nearly no time."""
        self.end = float(time[-1])
        if self.set["time.scheme"] == "reduced":
            step = np.clip(np.median(np.diff(time)), self.end / FINEST, self.end / COARSEST)
            self.set.setdefault("time.step", float(step))

    def settings(self, point):
        """All keys of a run."""
        keys = {**self.set, **point}
        keys |= {tied: factor * point[key] for tied, (factor, key) in self.ties.items() if key in point}
        scale = keys.pop(TIME_FACTOR, None)
        if scale and self.end:  # the window is longer by this factor
            keys["time.end"] = scale * self.end
            if "time.step" in keys:
                keys["time.step"] *= scale
        return keys

    def read(self, point, answer, more=None):
        """answer(Result) of a run with the values of `point` and with the keys `more`."""
        keys = self.settings(point) | (more or {})
        try:
            with tempfile.TemporaryDirectory(prefix="upbead-fit-") as folder:
                with run(self.case, set=keys, out=Path(folder) / "run", program=self.program) as result:
                    return answer(result)
        except (CaseError, NumericsError) as error:
            where = ", ".join(f"{key} = {value:.6g}" for key, value in point.items()) or "the keys of the case"
            marched = isinstance(error, NumericsError) and keys["time.scheme"] == "reduced"
            cure = '\nmarch it: set time.scheme to "sdirk4", and time.step to that of the record' if marched else ""
            raise type(error)(f"the run with {where} failed: {error}{cure}") from error

    def answers(self, points):
        """[(time, values, modes)] of the points, {key: value}; points that are not known yet are run in parallel."""
        names = [tuple(point.items()) for point in points]
        missing = {name: point for name, point in zip(names, points) if name not in self.kept}
        with ThreadPoolExecutor(max(1, self.jobs)) as pool:
            found = list(pool.map(self.answer, missing.values()))
        self.kept.update(zip(missing, found))
        self.n_runs += len(found) * (2 if self.wants_history and self.small else 1)
        return [self.kept[name] for name in names]

    def histories(self, points):
        return [answer[:2] for answer in self.answers(points)]

    def modes(self, points):
        """[rows of f, damping ratio, share]; no rows for a run that failed."""
        return [answer[2] for answer in self.answers(points)]

    def answer(self, point):
        """The answer at a point: only nan if the case cannot be solved there, so that the search avoids it."""
        try:
            if self.wants_history and self.small:
                time, values, _ = self.read(point, self.look)
                return time, values, self.read(point, modes_of, self.small)
            return self.read(point, self.look, self.small)
        except (CaseError, NumericsError) as error:
            self.failures.append(error)
            return np.array([0.0]), np.array([np.nan]), np.empty((0, 3))

    def look(self, result):
        self.doubts.update(told.warnings(result.summary))
        if told.void(result.summary):
            self.doubts["void"] = f"no verdict may be drawn of the scene: {told.void(result.summary)}"
        if self.wants_modes and not self.small:
            require_modes(result)
        time, values = (result.time, result[self.reading]) if self.wants_history else (np.zeros(1), np.zeros(1))
        return np.array(time), np.array(values), modes_of(result)

    def finer(self, point):
        """The modes of a point with a tenth of the tolerance; None if they cannot be computed."""
        try:
            return self.read(point, modes_of, {**self.small, "accuracy.tolerance": self.tolerance / 10})
        except (CaseError, NumericsError):
            return None
        finally:
            self.n_runs += 1

    def at(self, time, points):
        """The reading at times of the record, one array for each point."""
        return [np.interp(point.get(TIME_FACTOR, 1.0) * time, *history)
                for point, history in zip(points, self.histories(points))]
