"""The program's commands as functions: each calls the program and opens its results."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Any, Optional, TypeVar, Union

from . import told
from .calibration_result import CalibrationResult
from .errors import NumericsError
from .expected_result import ExpectedResult
from .named import Named
from .opening import open_model, open_result
from .program import call, settings
from .reduced_model import ReducedModel
from .results import Result
from .stress_law import answering, laws_of
from .study_table import StudyTable
from .waves_result import WavesSummary
from .written_case import Case, as_file, name_of

Place = Optional[Union[str, "PathLike[str]"]]
Values = Optional[Mapping[str, Any]]
Found = TypeVar("Found")


def run(case: Case, set: Values = None, out: Place = None, program: Place = None) -> Result:
    """Solves a case: `upbead run`.

    Parameters
    ----------
    case : path or mapping
        A case file; or its tables as dicts, {"regions": {"seabed": {...}}}, or a Scene. In a mapping the `history` of a load may
        be (times, values) or a function f(t), and its `gauges` a function p(s, t) (docs/python.md).
    set : dict, optional
        Keys with dots instead of the case's values, as {"loads.impulse.factor": 5.0}.
    out : path, optional
        Folder for the results; default: results/NAME, NAME of the case file, or by the title.
    program : path, optional
        The program; default: see `upbead.program.find`.

    Returns
    -------
    Result
        A SlipResult if the bottom slips or lifts. Python warns where no verdict may be drawn of it.

    Raises
    ------
    CaseError
        With every mistake of the input and its cure.
    NumericsError
        The case cannot be solved.
    """
    found: Result = opened(written("run", case, set, out, program, ""))
    return found


def reduce(case: Case, set: Values = None, out: Place = None, program: Place = None) -> ReducedModel:
    """Solves a scene once for all waves: `upbead reduce`. Parameters and errors as of `run`."""
    return warned(open_model(written("reduce", case, set, out, program, "")))


def study(file: Case, set: Values = None, out: Place = None, jobs: int | None = None, program: Place = None) -> StudyTable:
    """Varies keys of cases: `upbead study`.

    Parameters
    ----------
    file : path or mapping
        A study file, or its tables as dicts; its `case` may be a mapping, too.
    set, out, program
        As of `run`.
    jobs : int, optional
        Runs at once; default: one per core. A study that was interrupted is continued, unless a law of its soil is a function.

    Returns
    -------
    StudyTable
        With the runs that failed in `failed`; Python warns of them.
    """
    more = ["--jobs", jobs] if jobs else []
    table: StudyTable
    try:
        table = opened(written("study", file, set, out, program, "", more))
        return table
    except NumericsError as error:  # by this the program reports that some runs failed
        folder = folder_of(file, out, "")
        if not (folder / "study.csv").is_file():
            raise
        table = opened(folder)
        warnings.warn(f"{len(table.failed)} runs failed: {error}", stacklevel=2)
        return table


def waves(design: Case, set: Values = None, out: Place = None, program: Place = None) -> WavesSummary:
    """Pressure, safety and sliding of given waves by formulas: `upbead waves`. Returns its summary, a dict. Parameters and
    errors as of `run`."""
    found: WavesSummary = opened(written("waves", design, set, out, program, ""))
    return found


def expected(design: Case, set: Values = None, out: Place = None, program: Place = None) -> ExpectedResult:
    """Expected sliding distance: `upbead expected`. Parameters and errors as of `run`."""
    found: ExpectedResult = opened(written("expected", design, set, out, program, "-expected"))
    return found


def reliability(design: Case, set: Values = None, out: Place = None, program: Place = None) -> Named:
    """Probabilities of failure: `upbead reliability`. Returns its summary, a dict. Parameters and errors as of `run`."""
    found: Named = opened(written("reliability", design, set, out, program, "-reliability"))
    return found


def calibrate(design: Case, set: Values = None, out: Place = None, program: Place = None) -> CalibrationResult:
    """k(alpha*) from the caisson's own dynamics: `upbead calibrate`. Parameters and errors as of `run`."""
    found: CalibrationResult = opened(written("calibrate", design, set, out, program, "-calibration"))
    return found


def opened(folder: Path) -> Any:
    return warned(open_result(folder), 4)


def warned(found: Found, level: int = 3) -> Found:
    """The same; Python warns where no verdict may be drawn of it, as the program would tell in its terminal."""
    for summary in told.summaries(found):
        if why := told.void(summary):
            warnings.warn(f"no verdict may be drawn of '{summary.get('title') or 'this'}': {why}", stacklevel=level)
    return found


def folder_of(file: Case, out: Place, ending: str) -> Path:
    """The folder to which the program writes."""
    return Path(out) if out else Path("results") / name_of(file, ending)


def written(command: str, file: Case, values: Values, out: Place, program: Place, ending: str, more: list[Any] | tuple[()] = ()) -> Path:
    """Calls the program; returns the folder of its results."""
    folder, laws = folder_of(file, out, ending), laws_of(file)
    anew = ["--restart"] if laws and command == "study" else []  # what runs were made by other functions, nobody can tell
    with answering(laws, raises=command != "study") as variables:
        call([command, as_file(file, folder, values), "--out", folder, *settings(values), *more, *anew], program, variables)
    return folder
