"""A measured record, read by a run of the program or given as arrays, and cut to the time that a run computes."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .errors import UserError

NAME = "record_of_the_fit"  # of the table with which the program reads the file


@dataclass
class Record:
    """Times (s) and values in the SI unit of the reading."""

    time: np.ndarray
    value: np.ndarray
    source: str = "the record"


def named(record, reading, column, unit, start, zero):
    """The NAME of [measured.NAME] for `record`, and further keys of the case by which the program reads a file."""
    if isinstance(record, str) and not Path(record).is_file():
        return record, {}
    keys = {"file": str(Path(record).resolve()), "reading": reading, "record_start": start, "zero": zero, "column": column,
            "unit": unit}
    return NAME, {f"measured.{NAME}.{key}": value for key, value in keys.items() if value is not None}


def of_run(result, name):
    """The Record of [measured.NAME], and the path of its reading."""
    known = result.measured()
    if name not in known:
        raise UserError(f"'{name}' is no file, and no record of the case; these are: {', '.join(known) or 'none'}")
    found = known[name]
    return Record(found["time"].values, found["value"].values, f"measured.{name}"), found["reading"]


def of_arrays(record):
    """A Record of (time, values)."""
    time, value = (np.asarray(column, dtype=float) for column in record)
    if time.ndim != 1 or time.shape != value.shape:
        raise UserError("the record needs as many values as times")
    if not (np.isfinite(time).all() and np.isfinite(value).all()):
        raise UserError("the record: a time or a value is no finite number; cut the record there")
    if not (np.diff(time) > 0).all():
        raise UserError("the record: the times must ascend")
    return Record(time, value)


def cut(record, start=0.0, zero=0.0, until=np.inf):
    """The record from its time `start` (s), which becomes t = 0, to t = until.

    zero: length of its beginning (s) that is at rest; the mean of that part is subtracted, as for transducers
    (docs/records.md).
    """
    value = record.value
    if zero > 0:
        value = value - value[record.time <= record.time[0] + zero].mean()
    time = record.time - start
    kept = (time >= 0) & (time <= until * (1 + 1e-12))
    if not kept.any():
        raise UserError(f"{record.source}: nothing is left of it between 0 and {until:.4g} s of the run; it lasts from "
                        f"{time[0]:.4g} to {time[-1]:.4g} s, with its {start:.4g} s as t = 0; see start")
    return Record(time[kept], value[kept], record.source)
