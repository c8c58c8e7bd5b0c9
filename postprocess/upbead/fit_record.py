"""A measured record: read as a laboratory wrote it, and cut to what a run computes."""

import csv
import gzip
import re
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

from .errors import UserError
from .results import text_of

G = 9.80665
UNITS = {  # by SI unit: as written, without blanks and ^, and its size; as docs/records.md has them
    "s": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0},
    "N/m": {"N/m": 1.0, "kN/m": 1e3, "MN/m": 1e6, "N/cm": 1e2, "gf/cm": 0.1 * G, "kgf/cm": 1e2 * G, "kgf/m": G, "tf/m": 1e3 * G},
    "Pa": {"Pa": 1.0, "hPa": 1e2, "kPa": 1e3, "MPa": 1e6, "bar": 1e5, "mbar": 1e2, "N/m2": 1.0, "kN/m2": 1e3, "N/cm2": 1e4,
           "N/mm2": 1e6, "gf/cm2": 10 * G, "kgf/cm2": 1e4 * G, "tf/m2": 1e3 * G, "psi": 6894.757293168, "mH2O": 1e3 * G,
           "mAq": 1e3 * G},
    "m": {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6},
    "m/s": {"m/s": 1.0, "cm/s": 1e-2, "mm/s": 1e-3},
    "m/s2": {"m/s2": 1.0, "cm/s2": 1e-2, "mm/s2": 1e-3, "gal": 1e-2, "g": G},
    "rad": {"rad": 1.0, "mrad": 1e-3, "deg": np.pi / 180},
}
NAME = re.compile(r"\s*(.*?)\s*(?:[(\[]([^)\]]*)[)\]])?\s*")  # name (unit)


@dataclass
class Record:
    """Times (s) and values; the values' unit as it was written, "" where it is the SI unit of what was read."""

    time: np.ndarray
    value: np.ndarray
    unit: str = ""
    source: str = "the record"

    def in_si(self, unit):
        """The values in the SI unit of the reading; UserError where theirs is no unit of that quantity."""
        return self.value * factor(self.unit, unit, self.source)


def factor(written, unit, source):
    """What values in the written unit are multiplied with.

    >>> factor("kN / m", "N/m", "lab.csv"), factor("", "Pa", "lab.csv")
    (1000.0, 1.0)
    """
    name = re.sub(r"[\s^*.]", "", written).replace("²", "2").replace("µ", "u")
    known = UNITS.get(unit, {unit: 1.0})
    if not name:
        return 1.0
    if name not in known:
        raise UserError(f"{source}: the unit '{written}' is no unit of what is compared ({unit}); use one of {', '.join(known)}")
    return known[name]


def read_record(path, column=None, unit=None):
    """A Record of a file: CSV (or .gz of it), or HDF5 with /time and a dataset for each column.

    column: its name, needed where there are several. unit: in place of the one in the header.
    """
    path = Path(path)
    try:
        names, units, columns = read_hdf5(path) if path.suffix in (".h5", ".hdf5") else read_csv(path)
    except (OSError, ValueError) as error:
        raise UserError(f"'{path}' cannot be read as a record: {error}") from error
    if column is None and len(names) == 2:
        column = names[1]
    if column not in names[1:]:
        what = f"no column '{column}'" if column else "several columns, give the name of one"
        raise UserError(f"'{path}' has {what}; it has {', '.join(names[1:])}")
    i = names.index(column)
    time = columns[0] * factor(units[0], "s", path)
    return Record(time, columns[i], units[i] if unit is None else unit, f"'{path}', column '{column}'")


def read_hdf5(path):
    with h5py.File(path) as file:
        names = ["time"] + [name for name in file if name != "time" and isinstance(file[name], h5py.Dataset)]
        if "time" not in file:
            raise ValueError("it has no dataset /time")
        units = [text_of(file[name].attrs.get("unit", "")) for name in names]
        return names, units, [file[name][()].astype(float) for name in names]


def read_csv(path):
    """Names, units and columns; commas, semicolons or tabs, with the latter two decimal commas as well."""
    opened = gzip.open if path.suffix == ".gz" else open
    with opened(path, "rt", newline="", encoding="utf-8-sig") as file:
        lines = [line for line in file if line.strip() and not line.startswith(("#", "%"))]
    if len(lines) < 3:
        raise ValueError("it needs a header line and rows of numbers")
    mark = next((mark for mark in ";\t" if mark in lines[0]), ",")
    head, *rows = csv.reader(lines, delimiter=mark)
    names, units = zip(*(NAME.fullmatch(cell).groups("") for cell in head))
    if not is_number(rows[0][0]):  # a row of units
        units, rows = [cell.strip(" ()[]") for cell in rows[0]], rows[1:]
    if mark != ",":
        rows = [[cell.replace(",", ".") for cell in row] for row in rows]
    if any(len(row) != len(names) for row in rows):
        raise ValueError("not all rows have as many cells as the header")
    return list(names), list(units), np.array(rows, dtype=float).T


def is_number(text):
    try:
        float(text.replace(",", "."))
    except ValueError:
        return False
    return True


def as_record(record, column=None, unit=None):
    """A Record of a file's path, of (time, values) or of one."""
    if isinstance(record, (str, Path)):
        record = read_record(record, column, unit)
    elif not isinstance(record, Record):
        time, value = record
        record = Record(np.asarray(time, dtype=float), np.asarray(value, dtype=float), unit or "")
    if record.time.ndim != 1 or record.time.shape != record.value.shape:
        raise UserError(f"{record.source}: needs as many values as times")
    if not (np.isfinite(record.time).all() and np.isfinite(record.value).all()):
        raise UserError(f"{record.source}: a time or a value is no finite number; cut the record there")
    if not (np.diff(record.time) > 0).all():
        raise UserError(f"{record.source}: the times must ascend")
    return record


def cut(record, start=0.0, zero=0.0, until=np.inf):
    """The record from its time `start` (s), which becomes t = 0, to t = until.

    zero: how much of its beginning (s) is at rest; the mean of that is taken off, as of transducers (docs/records.md).
    """
    value = record.value
    if zero > 0:
        value = value - value[record.time <= record.time[0] + zero].mean()
    time = record.time - start
    kept = (time >= 0) & (time <= until * (1 + 1e-12))
    if not kept.any():
        raise UserError(f"{record.source}: nothing is left of it between 0 and {until:.4g} s of the run; it lasts from "
                        f"{time[0]:.4g} to {time[-1]:.4g} s, with its {start:.4g} s as t = 0; see start")
    return Record(time[kept], value[kept], record.unit, record.source)
