"""Opens the results of any command of the program."""

from pathlib import Path


from .calibration_result import CalibrationResult
from .errors import UserError
from .expected_result import ExpectedResult
from .h5 import open_h5
from .reduced_model import ReducedModel
from .results import Result, command_of, read_summary
from .sheet_result import read_sheet
from .slip_result import SlipResult
from .study_table import StudyTable
from .waves_result import read_waves


def open_result(folder):
    """The results of a command in a folder.

    `run`: a Result, or a SlipResult if the bottom slipped or lifted; `study`: a StudyTable; `expected`: an
    ExpectedResult; `calibrate`: a CalibrationResult; `waves`, `sheet` and `reliability`: its summary, a
    dict. Raises UserError if the folder has
    none of these.
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise UserError(f"there is no folder '{folder}'")
    opened = {"study": StudyTable, "waves": read_waves, "reliability": read_summary, "expected": ExpectedResult,
              "calibrate": CalibrationResult, "sheet": read_sheet}.get(command_of(folder))
    if opened:
        return opened(folder)
    return SlipResult(folder) if slips(folder / "results.h5") else Result(folder)


def slips(path):
    """Whether a file has tables by node of the bottom."""
    try:
        with open_h5(path) as file:
            return "interface/slip" in file
    except OSError:
        return False  # Result then reports the fault of the file


def open_model(path):
    """The ReducedModel of a file that `upbead reduce` wrote, or of the folder with its reduced.h5."""
    path = Path(path)
    return ReducedModel(path / "reduced.h5" if path.is_dir() else path)
