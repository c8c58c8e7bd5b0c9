"""Parameters of a case fitted to a measured record, with what the record does not tell.

    found = upbead.fit("case.toml", "lab.csv", parameters={"regions.seabed.shear_modulus": 30e6})
    print(found)
"""

from pathlib import Path

import numpy as np

from . import fit_record
from .errors import UserError
from .fit_directions import identifiable
from .fit_parameters import TIME_FACTOR, as_asked, parameters_of, parse_ties, value_of
from .fit_result import Fit
from .fit_runs import Runs
from .history import History
from .least_squares import compass, least_squares, scipy_part, search

LIMIT = 0.25  # relative; what is known worse is called not fixed
LEAST_SCALE = 1e-12  # of the record, for one that is zero throughout


def fit(case, record, reading=None, parameters=None, ties=None, *, column=None, unit=None, start=0.0, zero=0.0,
        noise=None, limit=LIMIT, set=None, jobs=2, program=None):
    """Fits keys of a case to a record, by nonlinear least squares on their logarithms. Returns a Fit.

    case: path of a case file. record: path of a file (`column`: default the one after the time), (times, values) in SI
    units, or the name of one of the case's own, [measured.NAME]. reading: what was measured, a path below /history
    (default: what the case says of its record, else shear_force). parameters: {key: first guess, (low, high) or None};
    None: the case's own value; where all have ranges these are searched first. Values are positive numbers.
    "record.time_factor" is a key too: the record's times are multiplied with it. ties: {key: "1.667*other key"}, goes
    along. unit: of the column, in place of its header. start: time of the record that is t = 0 of the run (s). zero: so
    much of its beginning is at rest (s); the mean of that is taken off. noise: standard deviation of a sample in SI
    units (default: by the residual). limit: relative; a combination known worse than this is not fixed. set: further
    keys of the case. jobs: runs at once. Each evaluation is an `upbead run` of a reduced model.
    Raises UserError, and what `run` raises.
    """
    asked = as_asked(parameters)
    if noise is not None and not noise > 0:
        raise UserError(f"noise = {noise} is no standard deviation; give a positive number, or leave it out")
    runs = Runs(case, reading, parse_ties(ties, list(asked)), set, jobs, program)
    if isinstance(record, (str, Path)):
        name, keys = fit_record.named(record, reading or "shear_force", column, unit, start, zero)
        shown = first_run(runs, asked, name, keys)
        start, zero = (0.0, 0.0) if keys else (start, zero)  # that of files the program has seen to
    else:
        given = fit_record.of_arrays(record)  # a mistake costs no run
        shown = first_run(runs, asked) | {"record": given}
    parameters = parameters_of(asked, shown["case"])
    window = fit_record.cut(shown["record"], start, zero, shown["end"])
    if window.time.size < len(asked) + 2:
        raise UserError(f"{window.source}: {window.time.size} samples within the run do not tell {len(asked)} parameters")
    measured = History(window.value, shown["unit"], "measured")
    runs.look_at(window.time)

    def compute(points):
        return runs.at(window.time, [parameters.point(x) for x in points])

    solution = solve(compute, measured.values, parameters, runs.failures)
    first = compute([np.zeros(len(asked))])[0]
    statistics = judge(parameters, solution, measured.values, noise, limit)
    if runs.failures:
        statistics["cautions"].append(f"{len(runs.failures)} runs failed and were left out; the first: {runs.failures[0]}")
    return Fit(values=parameters.point(solution.x), guess=parameters.guess, n_runs=runs.n_runs + 1, reading=runs.reading,
               time=window.time, record=measured, first=History(first, measured.unit, "first guess"),
               computed=History(solution.computed, measured.unit, "fit"), ties=runs.ties,
               residual=History(measured.values - solution.computed, measured.unit, "record minus fit"), **statistics)


def first_run(runs, asked, name=None, keys=None):
    """What the case says with further keys: its numbers, the unit and the end of the reading, its record of this name."""
    given = {key: value for key, value in asked.items() if key != TIME_FACTOR and value is not None and not np.ndim(value)}
    shown = runs.read(given, lambda result: look(runs, result, name), keys)
    if value_of(shown["case"], "mesh.refine") == "auto":
        raise UserError('mesh.refine = "auto" makes another mesh for every run; set a number, as {"mesh.refine": 0}')
    return shown


def look(runs, result, name):
    shown = {"case": result.case, "end": float(result.time[-1])}
    if name is not None:
        shown["record"], of = fit_record.of_run(result, name)
        runs.reading = runs.reading or of
    runs.reading = runs.reading or "shear_force"
    return shown | {"unit": result[runs.reading].unit}


def solve(compute, measured, parameters, failures=()):
    """The Solution: a first look around the guess or over the ranges, then least squares."""
    low, high = parameters.low, parameters.high
    if parameters.searched:
        x = search(compute, measured, low, high)
    else:
        x = compass(compute, measured, np.zeros(len(low)), low, high)
    if not np.isfinite(compute([x])[0]).all():
        raise failures[0]
    return least_squares(compute, measured, x, low, high, max(np.abs(measured).max(), LEAST_SCALE))


def judge(parameters, solution, measured, noise, limit):
    """Noise, covariance, intervals and what is identifiable, linearised at the solution.

    s^2 = RSS/(n - p), covariance s^2 (J^T J)^-1, intervals by Student's t (Seber and Wild 2003, ch. 2.1.2 and 5.1).
    """
    keys, n, p = parameters.keys, len(measured), len(solution.x)
    residual = measured - solution.computed
    if noise is None:
        noise, quantile = float(np.sqrt(residual @ residual / (n - p))), scipy_part("stats").t.ppf(0.975, n - p)
    else:
        quantile = scipy_part("stats").norm.ppf(0.975)
    known = identifiable(keys, solution.jacobian, noise, quantile, limit, solution.doubt)
    covariance = known.ellipsoid() / quantile**2
    half = quantile * np.sqrt(np.diag(covariance))
    deviation = np.sqrt(np.diag(covariance))
    values = parameters.point(solution.x)
    with np.errstate(over="ignore"):
        confidence = {key: (float(value * np.exp(-h)), float(value * np.exp(h)))
                      for (key, value), h in zip(values.items(), half)}
    return {"noise": noise, "covariance": covariance, "correlation": covariance / np.outer(deviation, deviation),
            "confidence": confidence, "identifiable": known, "cautions": cautions(parameters, solution, residual, noise, quantile)}


def cautions(parameters, solution, residual, noise, quantile):
    """What speaks against the numbers, in words."""
    found = []
    if not solution.converged:
        found.append("the search for the least squares was broken off before it had converged")
    for key, x, low, high in zip(parameters.keys, solution.x, parameters.low, parameters.high):
        if min(x - low, high - x) < 1e-3:
            found.append(f"{key} went to an end of its range, {parameters.guess[key] * np.exp(x):.4g}")
    correlation = residual[1:] @ residual[:-1] / max(residual @ residual, 1e-300)
    if correlation > 3.0 / np.sqrt(len(residual)):  # white noise has a standard deviation of 1/sqrt(n)
        wider = np.sqrt((1 + correlation) / max(1 - correlation, 1e-6))
        found.append(f"the residual is not white (correlation {correlation:.2f} between neighbours): the model errs or the noise "
                     f"is slow, and intervals are too narrow, by a factor of {wider:.2g} were it noise")
    return found
