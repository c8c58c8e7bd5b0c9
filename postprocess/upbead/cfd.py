"""Output of CFD programs as numpy arrays; the program itself reads it, so that there is only one reader."""

import json
import tempfile
from pathlib import Path

import h5py
import numpy as np

from .h5 import open_h5
from .history import History
from .program import call, settings


class CfdRecord(dict):
    """The columns of a record by their names, each a numpy array with `unit`; "time" among them.

    layout: the format of the record. notes: what was joined or left out. info: all information by the program. at:
    positions of the points, in the record's axes (m); None for forces.
    """

    def __init__(self, columns, info):
        super().__init__(columns)
        self.info, self.layout, self.notes = info, info["layout"], info["notes"]
        self.load = info.get("load")
        self.at = np.array(info["points"]["at"]) if "points" in info else None

    @property
    def time(self):
        return self["time"]


def read_cfd(path, program=None, **keys):
    """Reads a folder or a file of OpenFOAM, DualSPHysics, Proteus or SWASH: `upbead read`. Returns a CfdRecord.

    Without keys (but `file`) the columns are those of the record, in its own axes and units. With the keys of a load
    `from` (docs/cfd.md), as landward="x", thickness=0.1, they are those of the load: per metre, over still water.
    Raises CaseError, which names the mistakes or the missing keys.
    """
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder) / "record.h5"
        info = json.loads(call(["read", path, "--json", "--out", table, *settings(keys)], program))
        with open_h5(table) as file:
            columns = {name: History(data[:], unit=text(data.attrs.get("unit", ""))) for name, data in file.items()
                       if isinstance(data, h5py.Dataset)}
    return CfdRecord(columns, info)


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)
