"""Documents of the results of study, expected, calibrate and waves, in the same style as that of `run`."""

from report import page
from report.kinds import calibration, expected, frame, one_sheet, study, waves
from upbead.calibration_result import CalibrationResult
from upbead.expected_result import ExpectedResult
from upbead.opening import open_result
from upbead.results import Result
from upbead.sheet_result import SheetSummary
from upbead.study_table import StudyTable

DOCUMENTS = ((StudyTable, study), (ExpectedResult, expected), (CalibrationResult, calibration), (SheetSummary, one_sheet), (dict, waves))


def build(folder, case_file=None, language=None):
    """The HTML of a folder of results, of any command."""
    found = open_result(folder)
    if isinstance(found, Result):
        return page.build(found, case_file, language)
    document = next(document for kind, document in DOCUMENTS if isinstance(found, kind))
    return frame.build(folder, found, document, case_file, language)
