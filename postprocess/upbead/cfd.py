"""Output of CFD programs as numpy arrays; the program itself reads it, so that there is only one reader."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from .h5 import open_h5
from .history import History
from .program import call, settings


class CfdRecord(dict[str, History]):
    """The columns of a record by their names, each a numpy array with `unit`; "time" among them.

    layout: the format of the record. notes: what was joined or left out. info: all information by the program. at:
    positions of the points, in the record's axes (m); None for forces.
    """

    def __init__(self, columns: Mapping[str, History], info: dict[str, Any]) -> None:
        super().__init__(columns)
        self.info, self.layout, self.notes = info, info["layout"], info["notes"]
        self.load = info.get("load")
        self.at = np.array(info["points"]["at"]) if "points" in info else None

    @property
    def time(self) -> History:
        return self["time"]


def read_cfd(path: str | PathLike[str], program: str | PathLike[str] | None = None, **keys: Any) -> CfdRecord:
    """Reads a folder or a file of OpenFOAM, DualSPHysics, Proteus or SWASH: `upbead read`.

    Parameters
    ----------
    path : path
        What the CFD program wrote.
    program : path, optional
        The program; default: see `upbead.program.find`.
    **keys
        Of a load `from` (docs/cfd.md), as landward="x", thickness=0.1. Without keys (but `file`) the columns are those of
        the record, in its own axes and units; with them those of the load: per metre, over still water.

    Returns
    -------
    CfdRecord
        Columns by name, shape (N,), each with its unit; "time" (s) among them.

    Raises
    ------
    CaseError
        Names the mistakes or the missing keys.
    """
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder) / "record.h5"
        info = json.loads(call(["read", path, "--json", "--out", table, *settings(keys)], program))
        with open_h5(table) as file:
            columns = {name: History(data[:], unit=text(data.attrs.get("unit", ""))) for name, data in file.items()
                       if isinstance(data, h5py.Dataset)}
    return CfdRecord(columns, info)


def text(value: object) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
