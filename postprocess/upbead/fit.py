"""Parameters of a case fitted to a measured record, to measured modes or to both, and the combinations that these do
not determine.

    found = upbead.fit("case.toml", "lab.csv", parameters={"regions.seabed.shear_modulus": 30e6})
    found = upbead.fit("case.toml", frequencies=[(1.20, 0.03)], parameters=["regions.seabed.shear_modulus"])
    print(found)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from . import fit_record
from .errors import UserError
from .fit_directions import identifiable, joined
from .fit_modes import Paired, at_small_strain, require_modes, surveyed
from .fit_parameters import TIME_FACTOR, as_asked, parameters_of, parse_ties, value_of
from .fit_result import Fit
from .fit_posterior import OfRuns, SoilFit, sampled
from .fit_runs import Runs
from .fit_weights import Weights
from .history import History
from .least_squares import compass, search

Place = str | PathLike[str]
LIMIT = 0.25  # relative; a combination with a larger uncertainty is called not fixed


def fit(case: Place, record: Any = None, reading: str | None = None, parameters: Any = None, ties: Mapping[str, str] | None = None, *,
        column: str | None = None, unit: str | None = None, start: float = 0.0, zero: float = 0.0, noise: float | None = None,
        frequencies: Sequence[Any] | None = None, dampings: Sequence[Any] | None = None, limit: float = LIMIT, set: Mapping[str, Any] | None = None,
        jobs: int = 2, program: Place | None = None, posterior: int | None = None, model: Any = None, also: Sequence[str] = (), checks: int = 20) -> Fit:
    """Fits keys of a case to a record, to natural frequencies and damping ratios, or to both, by nonlinear least squares
    on their logarithms.

    Each evaluation is an `upbead run` of a reduced model, where no model of soils is given.

    Parameters
    ----------
    case : path
        A case file.
    record : path, (times, values) or str, optional
        A file; arrays of shape (N,), s and SI units; or the name of one of the case's own, [measured.NAME].
    reading : str, optional
        The measured quantity, a path below /history; default: that of the case's record, else shear_force.
    parameters : dict or list of str
        {key: first guess, (low, high) or None}; None: the case's own value; if all have ranges, these are searched first. Values
        are positive numbers in SI units. "record.time_factor" is a key too: the record's times are multiplied with it.
    ties : dict, optional
        {key: "1.667*other key"}: a key that changes in proportion to another.
    column, unit : str, optional
        Of the file: default the column after the time, and the unit of its header.
    start : float
        Time of the record that is t = 0 of the run, s.
    zero : float
        Length of its beginning that is at rest, s; the mean of that part is subtracted.
    noise : float, optional
        Standard deviation of a sample in SI units; default: by the residual.
    frequencies : list of tuple, optional
        Measured: (f, standard deviation), Hz, or (f, standard deviation, N) of the N-th mode of `periods` by the first guess.
    dampings : list of tuple, optional
        (ratio, standard deviation) or None; the n-th belongs to the n-th frequency.
    limit : float
        Relative; a combination with a larger uncertainty is not fixed.
    set : dict, optional
        Further keys of the case.
    jobs : int
        Runs at once.
    program : path, optional
        The program; default: see `upbead.program.find`.
    posterior : int, optional
        Number of evaluations by which the posterior of the keys is sampled, from the fit on.
    model : path or SoilModel, optional
        A model of soils of this case, with the readings in its histories; it then answers in place of runs, within its box, and
        `checks` points of the posterior are answered again by runs.
    checks : int
        See model.
    also : list of str
        Names of further records of the case, [measured.NAME], which the posterior has in common with the first; only with a model.

    Returns
    -------
    Fit

    Raises
    ------
    UserError
        And the errors of `run`.
    """
    asked, modes = as_asked(parameters), surveyed(frequencies, dampings)
    if noise is not None and not noise > 0:
        raise UserError(f"noise = {noise} is no standard deviation; give a positive number, or leave it out")
    runs = Runs(case, reading, parse_ties(ties, list(asked)), set, jobs, program)
    shown, window = measured_by(runs, asked, record, modes, column, unit, start, zero)
    parameters = parameters_of(asked, shown["case"])
    soils = SoilFit(model, runs, window, parameters, modes, also, noise) if model is not None else None
    if also and not (soils and posterior):
        raise UserError("further records need a model of soils and a posterior: give model and posterior, too")
    if soils:
        parameters = soils.parameters
    paired: Any = Paired(modes, runs, parameters) if modes else None
    measured = np.concatenate([window.value, modes.values]) if modes else window.value
    weights = Weights(window.time.size, noise, modes.uncertainty if modes else np.empty(0))

    def compute(points):
        answers = (soils or runs).at(window.time, [parameters.point(x) for x in points])
        return [np.append(answer, paired.rows(x)) for answer, x in zip(answers, points)] if modes else answers

    failures = soils.failures if soils else runs.failures
    solution = solve(compute, measured, parameters, failures, weights)
    first = compute([np.zeros(len(asked))])[0]
    statistics = judge(parameters, solution, measured, noise, limit, weights)
    if modes:
        statistics["cautions"] += paired.cautions(solution.x)
    if not soils:
        statistics["cautions"] += [f"runs warn of {name}: {text}" for name, text in runs.doubts.items()]
    if failures:
        what = "soils were not answered" if soils else "runs failed"
        statistics["cautions"].append(f"{len(failures)} {what} and were left out; the first: {failures[0]}")
    sample = None
    if posterior:
        source = soils or OfRuns(compute, parameters, window.time.size)
        sample = sampled(source, measured, solution, statistics, weights, noise, posterior, limit, checks)
    histories: dict[str, Any] = {name: History(values[: window.time.size], shown["unit"], told) for name, values, told in (
        ("record", measured, "measured"), ("first", first, "first guess"), ("computed", solution.computed, "fit"),
        ("residual", measured - solution.computed, "record minus fit"))}
    return Fit(posterior=sample, values=parameters.point(solution.x), guess=parameters.guess, n_runs=runs.n_runs + 1, reading=runs.reading,
               time=window.time, ties=runs.ties, modes=paired.table(solution.x) if modes else [], **histories, **statistics)


def measured_by(runs, asked, record, modes, column, unit, start, zero):
    """Facts of the case, and the Record within its run; an empty Record if there are only modes."""
    runs.wants_modes = modes is not None
    if record is None:
        if not modes:
            raise UserError("give a record, or frequencies=[(1.20, 0.03)] in Hz with their standard deviations")
        if TIME_FACTOR in asked:
            raise UserError(f"{TIME_FACTOR} is of a record, and none is given")
        runs.wants_history = False
        shown, window = first_run(runs, asked), fit_record.Record(np.empty(0), np.empty(0))
    else:
        shown, window = with_record(runs, asked, record, column, unit, start, zero)
        if window.time.size < len(asked) + 2:
            raise UserError(f"{window.source}: {window.time.size} samples within the run do not tell {len(asked)} parameters")
        runs.look_at(window.time)
    if modes:
        runs.small, runs.tolerance = at_small_strain(shown["case"]), value_of(shown["case"], "accuracy.tolerance")
    return shown, window


def with_record(runs, asked, record, column, unit, start, zero):
    """Facts of the case, and the record cut to its run."""
    if isinstance(record, (str, Path)):
        name, keys = fit_record.named(record, runs.reading or "shear_force", column, unit, start, zero)
        shown = first_run(runs, asked, name, keys)
        start, zero = (0.0, 0.0) if keys else (start, zero)  # for files the program has applied both
    else:
        given = fit_record.of_arrays(record)  # checked before the first run
        shown = first_run(runs, asked) | {"record": given}
    return shown, fit_record.cut(shown["record"], start, zero, shown["end"])


def first_run(runs, asked, name=None, keys=None):
    """Facts of the case with further keys: its numbers, the unit and the end of the reading, its record of this
    name."""
    given = {key: value for key, value in asked.items() if key != TIME_FACTOR and value is not None and not np.ndim(value)}
    shown = runs.read(given, lambda result: look(runs, result, name), keys)
    if value_of(shown["case"], "mesh.refine") == "auto":
        raise UserError('mesh.refine = "auto" makes another mesh for every run; set a number, as {"mesh.refine": 0}')
    return shown


def look(runs, result, name):
    shown = {"case": result.case, "end": float(result.time[-1]), "unit": ""}
    if runs.wants_modes:
        require_modes(result)
    if not runs.wants_history:
        return shown
    if name is not None:
        shown["record"], of = fit_record.of_run(result, name)
        runs.reading = runs.reading or of
    runs.reading = runs.reading or "shear_force"
    return shown | {"unit": result[runs.reading].unit}


def solve(compute, measured, parameters, failures=(), weights=None):
    """The Solution: a first search around the guess or over the ranges, then least squares."""
    low, high, weights = parameters.low, parameters.high, weights or Weights(len(measured))
    if parameters.searched:
        x = search(compute, measured, low, high, size=weights.size)
    else:
        x = compass(compute, measured, np.zeros(len(low)), low, high, size=weights.size)
    if not np.isfinite(compute([x])[0]).all():
        raise failures[0]
    return weights.solve(compute, measured, x, low, high)


def judge(parameters, solution, measured, noise, limit, weights=None):
    """Noise, covariance, intervals and identifiable combinations, linearised at the solution.

    s^2 = RSS/(n - p), covariance (J^T J)^-1 with J over the uncertainties, for a record alone s^2 (J^T J)^-1;
    intervals by Student's t (Seber and Wild 2003, ch. 2.1.2 and 5.1), by the normal distribution if the uncertainties
    are given.
    """
    weights = weights or Weights(len(measured), noise)
    residual = measured - solution.computed
    noise, quantile = weights.quantile(residual, solution.jacobian)
    known = identifiable(parameters.keys, joined(weights.blocks(solution, noise)), 1.0, quantile, limit)
    covariance = known.ellipsoid() / quantile**2
    half = quantile * np.sqrt(np.diag(covariance))
    deviation = np.sqrt(np.diag(covariance))
    values = parameters.point(solution.x)
    with np.errstate(over="ignore"):
        confidence = {key: (float(value * np.exp(-h)), float(value * np.exp(h)))
                      for (key, value), h in zip(values.items(), half)}
    return {"noise": noise, "covariance": covariance, "correlation": covariance / np.outer(deviation, deviation),
            "confidence": confidence, "identifiable": known, "cautions": cautions(parameters, solution, residual[: weights.samples])}


def cautions(parameters, solution, residual):
    """Reasons to doubt the numbers, in words."""
    found = []
    if not solution.converged:
        found.append("the search for the least squares was broken off before it had converged")
    for key, x, low, high in zip(parameters.keys, solution.x, parameters.low, parameters.high):
        if min(x - low, high - x) < 1e-3:
            found.append(f"{key} went to an end of its range, {parameters.guess[key] * np.exp(x):.4g}")
    if not len(residual):
        return found
    correlation = residual[1:] @ residual[:-1] / max(residual @ residual, 1e-300)
    if correlation > 3.0 / np.sqrt(len(residual)):  # white noise has a standard deviation of 1/sqrt(n)
        wider = np.sqrt((1 + correlation) / max(1 - correlation, 1e-6))
        found.append(f"the residual is not white (correlation {correlation:.2f} between neighbours): the model errs or the noise "
                     f"is slow, and intervals are too narrow, by a factor of {wider:.2g} were it noise")
    return found
