"""Shared by the scripts: how they end, and how they write a figure."""

import importlib.util
from pathlib import Path

# read by its path: to import it as a part of the package would import numpy before its absence is told
_spec = importlib.util.spec_from_file_location("ending", Path(__file__).parent / "upbead/scripts/ending.py")
ending = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(ending)
ending.watch()

from upbead.errors import UserError  # noqa: E402: a module that it lacks is told by ending
from upbead.kept import keep_inputs  # noqa: E402
from upbead.scripts.figure import save  # noqa: E402

__all__ = ["UserError", "beside", "figure_argument", "keep_inputs", "save"]


def figure_argument(parser, name):
    parser.add_argument("-o", "--output", type=Path, help=f"figure (.png, .pdf, .svg); default: {name}, by the results")


def beside(results, name):
    """The path of a file in the folder of results, or in the folder of a file of results; never in the working
    folder."""
    return (results if results.is_dir() else results.parent) / name
