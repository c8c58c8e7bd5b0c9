"""Opens the results of any command of the program."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .calibration_result import CalibrationResult
from .errors import UserError
from .expected_result import ExpectedResult
from .h5 import open_h5
from .reduced_model import ReducedModel
from .results import Folder, Result, command_of, read_summary
from .sheet_result import read_sheet
from .slip_result import SlipResult
from .study_table import StudyTable
from .waves_result import read_waves


def open_result(folder: Folder) -> Any:
    """The results of a command in a folder.

    Parameters
    ----------
    folder : path
        What the command wrote.

    Returns
    -------
    Result, StudyTable, ExpectedResult, CalibrationResult or dict
        Of `run` a Result, or a SlipResult if the bottom slipped or lifted; of `study` a StudyTable; of `expected` an
        ExpectedResult; of `calibrate` a CalibrationResult; of `waves`, `sheet` and `reliability` its summary, a dict.

    Raises
    ------
    UserError
        The folder has none of these.
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise UserError(f"there is no folder '{folder}'")
    opened: Any = {"study": StudyTable, "waves": read_waves, "reliability": read_summary, "expected": ExpectedResult,
              "calibrate": CalibrationResult, "sheet": read_sheet}.get(command_of(folder) or "")
    if opened:
        return opened(folder)
    return SlipResult(folder) if slips(folder / "results.h5") else Result(folder)


def slips(path: Path) -> bool:
    """Whether a file has tables by node of the bottom."""
    try:
        with open_h5(path) as file:
            return "interface/slip" in file
    except OSError:
        return False  # Result then reports the fault of the file


def open_model(path: Folder) -> ReducedModel:
    """The ReducedModel of a file that `upbead reduce` wrote, or of the folder with its reduced.h5."""
    path = Path(path)
    return ReducedModel(path / "reduced.h5" if path.is_dir() else path)
