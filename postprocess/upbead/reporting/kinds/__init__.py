"""Documents of the results of study, expected, calibrate and waves, in the same style as that of `run`."""

from .. import page
from . import calibration, expected, frame, one_sheet, study, waves
from ...calibration_result import CalibrationResult
from ...expected_result import ExpectedResult
from ...errors import UserError
from ...opening import open_result
from ...results import Result, command_of
from ...sheet_result import SheetSummary
from ...study_table import StudyTable

DOCUMENTS = ((StudyTable, study), (ExpectedResult, expected), (CalibrationResult, calibration), (SheetSummary, one_sheet), (dict, waves))


def build(folder, case_file=None, language=None):
    """The HTML of a folder of results, of any command."""
    found = open_result(folder)
    if isinstance(found, Result):
        return page.build(found, case_file, language)
    if (command := command_of(folder)) == "reliability":
        raise UserError(f"'{folder}' holds results of 'upbead {command}': of these 'upbead sheet' makes a part of its document")
    document = next(document for kind, document in DOCUMENTS if isinstance(found, kind))
    return frame.build(folder, found, document, case_file, language)
