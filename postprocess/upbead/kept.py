"""Input files are never overwritten."""

from __future__ import annotations

import os
from os import PathLike
from pathlib import Path

from .errors import UserError

RESULTS = ("results.h5", "reduced.h5", "responses.h5", "study.h5", "summary.json", "case.toml", "given.toml", "study.csv", "calibration.csv")


def files_of(path: str | PathLike[str]) -> list[Path]:
    """A file, or the files that a command of the program has written into a folder."""
    path = Path(path)
    return [path / name for name in RESULTS] if path.is_dir() else [path]


def keep_inputs(output: str | PathLike[str], *inputs: str | PathLike[str]) -> None:
    """Raises UserError if `output` is one of the input files, or a link to one.

    inputs: files, or folders of results.
    """
    for path in (file for given in inputs for file in files_of(given)):
        try:
            same = os.path.samefile(output, path)
        except (OSError, ValueError):
            continue  # one of the two does not exist
        if same:
            raise UserError(f"'{output}' would be written over '{path}', which is read; choose another file")
