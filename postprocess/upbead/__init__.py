"""upbead from Python: results as numpy arrays with units, reduced models, runs and studies, and every figure.

    import upbead
    result = upbead.run("cases/fig2b-model.toml")       # or upbead.open("results/fig2b-model")
    upbead.figures.response(result)

docs/python.md is a tutorial.
"""

from __future__ import annotations

import importlib
from typing import Any

from . import msh
from .commands import calibrate, expected, reduce, reliability, run, study, waves
from .cfd import read_cfd
from .errors import CaseError, ModelError, NumericsError, SoilError, UnknownName, UpbeadError, UserError
from .fit import fit
from .fit_result import Fit
from .fit_soils import SoilRecord, soil_posterior
from .history import History
from .live import page
from .opening import open_model
from .opening import open_result as open
from .reduced_model import ReducedModel
from .reports import report
from .results import Result
from .scene import Scene
from .sensitivity import KeyShare, Sensitivity, sensitivity
from .slip_result import SlipResult
from .soil_model import SoilModel
from .stress_law import SoilPoints, StressLaw
from .study_table import StudyTable
from .tables import MissingPackage
from .calibration_result import CalibrationResult
from .expected_result import ExpectedResult

__all__ = ["CalibrationResult", "CaseError", "ExpectedResult", "Fit", "History", "KeyShare", "MissingPackage", "ModelError", "NumericsError", "ReducedModel", "Result",
           "Scene", "Sensitivity", "SlipResult", "SoilError", "SoilModel", "SoilPoints", "SoilRecord", "StressLaw", "StudyTable", "UnknownName", "UpbeadError", "UserError", "calibrate", "expected",
           "figures", "fit", "msh", "open", "open_model", "page", "read_cfd", "reduce", "reliability", "report", "run", "sensitivity", "soil_posterior", "study", "waves"]


def __getattr__(name: str) -> Any:
    """Loads `figures` when it is first used, as matplotlib takes longer to load than the rest of the package."""
    if name == "figures":
        return importlib.import_module(".figures", __name__)
    raise AttributeError(f"module 'upbead' has no attribute '{name}'")
