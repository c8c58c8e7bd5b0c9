"""The posterior of a fit: by its own runs, or by a model of soils that is checked by runs."""

from pathlib import Path

import numpy as np

from . import fit_record
from .errors import UserError
from .fit_parameters import Parameters
from .fit_runs import Runs
from .fit_soils import SoilHistories, SoilRecord, fixed_by, model_cautions, range_of
from .posterior import Likelihood, posterior
from .soil_model import SoilModel


class OfRuns:
    """The fit's own runs as a model of posterior.py: the box of its parameters, its record and its modes."""

    full = None  # nothing is to be checked

    def __init__(self, compute, parameters, samples):
        self.compute, self.parameters, self.samples = compute, parameters, samples
        self.box = box_of(parameters)

    def answers(self, asked):
        guess = np.array(list(self.parameters.guess.values()))
        points = [np.log(np.array([keys[key] for key in self.box]) / guess) for keys in asked]
        return [parts(answer, self.samples) for answer in self.compute(points)]

    def likelihood(self, measured, weights, noise):
        return Likelihood(parts(measured, self.samples),
                          ([noise] if self.samples else []) + [weights.given] * bool(len(weights.given)))

    def cautions(self, keys):
        return []


class SoilFit:
    """A model of soils in place of the fit's runs, with the case's loads as the wave, and with further records of the case."""

    def __init__(self, model, runs, window, parameters, modes, also, noise):
        if modes:
            raise UserError("a model of soils has no modes to compare with a survey: fit frequencies without it")
        known = model if isinstance(model, SoilModel) else SoilModel(model, program=runs.program)
        self.parameters = within(parameters, known)
        self.sources, self.noise = [(runs, window)] + [further(runs, name) for name in also], [noise] + [None] * len(also)
        readings = list(dict.fromkeys(source.reading for source, _ in self.sources))
        own = SoilModel(known.path, histories=readings, jobs=runs.jobs, program=known.program)
        wave = Path(runs.case).resolve()
        self.box, self.full = box_of(self.parameters), FullRuns(self.sources, box_of(self.parameters))
        self.records = [SoilRecord(wave, source.reading, cut.time, cut.value) for source, cut in self.sources]
        fixed = fixed_by(own, {key: value for key, value in runs.set.items() if key != "time.scheme"})
        self.fast = SoilHistories(own, self.records, self.box, runs.ties, fixed)
        self.first = SoilHistories(own, self.records[:1], self.box, runs.ties, fixed)
        self.failures = self.first.failures

    def at(self, time, points):
        """As Runs has it, for the first record."""
        return [answer[0] for answer in self.first.answers(points)]

    def answers(self, asked):
        return self.fast.answers(asked)

    def likelihood(self, measured, weights, noise):
        return Likelihood([record.value for record in self.records], self.noise)

    def cautions(self, keys):
        return model_cautions(self.fast, keys, self.noise)


class FullRuns:
    """Runs of the program for all records."""

    def __init__(self, sources, box):
        self.sources, self.box = sources, box

    def answers(self, asked):
        return [list(of_soil) for of_soil in zip(*(runs.at(cut.time, asked) for runs, cut in self.sources))]


def further(runs, name):
    """(Runs, Record) of another record of the case."""
    (record, reading), end = runs.read({}, lambda result: (fit_record.of_run(result, name), float(result.time[-1])))
    keys = {key: value for key, value in runs.set.items() if key != "time.step"}  # that of the first record's times
    found = Runs(runs.case, reading, runs.ties, keys, runs.jobs, runs.program)
    record = fit_record.cut(record, until=end)
    found.look_at(record.time)
    return found, record


def within(parameters, model):
    """The parameters in the box of the model; a range that was asked for must lie in it."""
    low, high = [], []
    for key, guess, a, b in zip(parameters.keys, parameters.guess.values(), parameters.low, parameters.high):
        ends = range_of(model, key, (guess * np.exp(a), guess * np.exp(b)) if parameters.searched else None)
        if not ends[0] <= guess <= ends[1]:
            raise UserError(f"the first guess of '{key}', {guess:.4g}, lies outside the model's box, {ends[0]:.4g} to {ends[1]:.4g}")
        low.append(np.log(ends[0] / guess))
        high.append(np.log(ends[1] / guess))
    return Parameters(parameters.guess, np.array(low), np.array(high), parameters.searched)


def box_of(parameters):
    return {key: (value * np.exp(low), value * np.exp(high))
            for (key, value), low, high in zip(parameters.guess.items(), parameters.low, parameters.high)}


def parts(numbers, samples):
    """Those of the record and those of the modes, without an empty part."""
    return [part for part in (numbers[:samples], numbers[samples:]) if len(part)]


def sampled(source, measured, solution, statistics, weights, noise, evaluations, limit, checks):
    """The Posterior by an OfRuns or a SoilFit, from the fit on."""
    start = np.log(list(source.parameters.guess.values())) + solution.x
    found = posterior(source, source.likelihood(measured, weights, noise), evaluations, start=start, covariance=statistics["covariance"],
                      full=source.full, checks=checks, limit=limit)
    found.cautions += source.cautions(found.median)
    return found
