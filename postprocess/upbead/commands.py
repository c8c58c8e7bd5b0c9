"""The program's commands as functions: each calls the program and opens its results."""

import warnings
from pathlib import Path

from .errors import NumericsError
from .opening import open_model, open_result
from .program import call, settings


def run(case, set=None, out=None, program=None):
    """Solves a case: `upbead run`. Returns its Result.

    case: path of a case file. set: {key: value} instead of the case's values, as {"loads.impulse.factor": 5.0}.
    out: folder for the results (default: results/NAME, NAME of the case file). program: path of the program.
    Raises CaseError with every mistake of the input and its cure, NumericsError if the case cannot be solved.
    """
    return open_result(written("run", case, set, out, program, ""))


def reduce(case, set=None, out=None, program=None):
    """Solves a scene once for all waves: `upbead reduce`. Returns its ReducedModel. Arguments as for run."""
    return open_model(written("reduce", case, set, out, program, ""))


def study(file, set=None, out=None, jobs=None, program=None):
    """Varies keys of cases: `upbead study`. Returns its StudyTable, with the runs that failed in `failed`.

    jobs: runs at once (default: one per core). A study that was interrupted is continued. Other arguments as for run.
    """
    more = ["--jobs", jobs] if jobs else []
    try:
        return open_result(written("study", file, set, out, program, "", more))
    except NumericsError as error:  # by this the program reports that some runs failed
        folder = folder_of(file, out, "")
        if not (folder / "study.csv").is_file():
            raise
        table = open_result(folder)
        warnings.warn(f"{len(table.failed)} runs failed: {error}", stacklevel=2)
        return table


def waves(design, set=None, out=None, program=None):
    """Pressure, safety and sliding of given waves by formulas: `upbead waves`. Returns its summary as a dict."""
    return open_result(written("waves", design, set, out, program, ""))


def expected(design, set=None, out=None, program=None):
    """Expected sliding distance: `upbead expected`. Returns its ExpectedResult. Arguments as for run."""
    return open_result(written("expected", design, set, out, program, "-expected"))


def reliability(design, set=None, out=None, program=None):
    """Probabilities of failure: `upbead reliability`. Returns its summary as a dict."""
    return open_result(written("reliability", design, set, out, program, "-reliability"))


def calibrate(design, set=None, out=None, program=None):
    """k(alpha*) from the caisson's own dynamics: `upbead calibrate`. Returns its CalibrationResult."""
    return open_result(written("calibrate", design, set, out, program, "-calibration"))


def folder_of(file, out, ending):
    """The folder to which the program writes."""
    return Path(out) if out else Path("results") / (Path(file).stem + ending)


def written(command, file, values, out, program, ending, more=()):
    """Calls the program; returns the folder of its results."""
    folder = folder_of(file, out, ending)
    call([command, file, "--out", folder, *settings(values), *more], program)
    return folder
