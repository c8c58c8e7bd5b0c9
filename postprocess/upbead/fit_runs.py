"""The runs that answer a fit."""

import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from .commands import run
from .errors import CaseError, NumericsError
from .fit_parameters import TIME_FACTOR

FINEST, COARSEST = 20000, 2000  # steps of a window; between them as fine as the record


class Runs:
    """Histories of one reading by the values of keys: a run of the program for each point, kept."""

    def __init__(self, case, reading, ties, set, jobs, program):
        self.case, self.reading, self.ties, self.jobs, self.program = case, reading, ties, jobs, program
        self.set = {"time.scheme": "reduced", **(set or {})}
        self.kept, self.n_runs, self.failures = {}, 0, []
        self.end = None  # of the window (s), once that is known

    def look_at(self, time):
        """Takes the record's times: they set the steps of reduced models, which cost next to nothing."""
        self.end = float(time[-1])
        if self.set["time.scheme"] == "reduced":
            step = np.clip(np.median(np.diff(time)), self.end / FINEST, self.end / COARSEST)
            self.set.setdefault("time.step", float(step))

    def settings(self, point):
        """All keys of a run."""
        keys = {**self.set, **point}
        keys |= {tied: factor * point[key] for tied, (factor, key) in self.ties.items() if key in point}
        scale = keys.pop(TIME_FACTOR, None)
        if scale and self.end:  # the window lasts that much longer
            keys["time.end"] = scale * self.end
            if "time.step" in keys:
                keys["time.step"] *= scale
        return keys

    def read(self, point, answer, more=None):
        """answer(Result) of a run with the values of point, and with more keys."""
        keys = self.settings(point) | (more or {})
        try:
            with tempfile.TemporaryDirectory(prefix="upbead-fit-") as folder:
                with run(self.case, set=keys, out=Path(folder) / "run", program=self.program) as result:
                    return answer(result)
        except (CaseError, NumericsError) as error:
            told = ", ".join(f"{key} = {value:.6g}" for key, value in point.items()) or "the keys of the case"
            marched = isinstance(error, NumericsError) and keys["time.scheme"] == "reduced"
            cure = '\nmarch it: set time.scheme to "sdirk4", and time.step to that of the record' if marched else ""
            raise type(error)(f"the run with {told} failed: {error}{cure}") from error

    def histories(self, points):
        """[(time, values)] of the points, {key: value}; those not known yet run side by side."""
        names = [tuple(point.items()) for point in points]
        missing = {name: point for name, point in zip(names, points) if name not in self.kept}
        with ThreadPoolExecutor(max(1, self.jobs)) as pool:
            found = list(pool.map(self.history, missing.values()))
        self.kept.update(zip(missing, found))
        self.n_runs += len(found)
        return [self.kept[name] for name in names]

    def history(self, point):
        """Nothing but nan where the case cannot be solved so; the search then keeps away from there."""
        try:
            return self.read(point, lambda result: (result.time.values.copy(), result[self.reading].values.copy()))
        except (CaseError, NumericsError) as error:
            self.failures.append(error)
            return np.array([0.0]), np.array([np.nan])

    def at(self, time, points):
        """The reading at times of the record, one array for each point."""
        return [np.interp(point.get(TIME_FACTOR, 1.0) * time, *history)
                for point, history in zip(points, self.histories(points))]
