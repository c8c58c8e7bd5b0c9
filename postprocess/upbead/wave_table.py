"""A wave as a table, for files that this package reads without the program: the rules are those of the program
(docs/records.md)."""

import csv
import re

import numpy as np

from .errors import ModelError

HEADING = re.compile(r"^\s*\"?(.*?)\"?\s*(?:[(\[]([^()\[\]]*)[)\]]|\s/\s*([^/\s]+(?:/m2?)?))?\s*$")
TIMES = re.compile(r"^(time|t|zeit|temps|tiempo|tempo|tijd|tid|sec|seconds|elapsed time|simulation time)$", re.IGNORECASE)
COUNTERS = re.compile(r"^(|#|part|step|steps|no\.?|nr\.?|index|i|n|id|sample|samples|row|count|counter|frame|time ?step)$", re.IGNORECASE)
OF_TIME = {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0, "": 1.0}
OF_LOAD = {"N/m": {"N/m": 1.0, "kN/m": 1e3, "MN/m": 1e6, "": 1.0}, "Pa": {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "": 1.0}}
# a unit of a force or a pressure as a part of a name; here it is refused, where the program reads it at the end of a name
UNREAD = re.compile(r"[\s_/.-]([kMG]?N|[kKMGhH]?Pa|KN|MPA|KPA|m?bar|psi|kgf|tf|gf|lbf|kips?|mH2O|mAq)([\s_/.-]|$)")


def headings(row):
    """[(name, unit)] of "p1 (kPa)", "p1 [kPa]", "p1 / kPa" or "p1"."""
    found = []
    for cell in row:
        name, bracketed, behind = HEADING.match(cell[:200]).groups()
        found.append((name.strip(), (bracketed or behind or "").strip()))
    return found


def time_column(names, columns, path):
    """The column whose header says that it is the time; else the first, if that is no counter."""
    said = [c for c, name in enumerate(names) if TIMES.match(name)]
    said = [c for c in said if names[c].lower() != "t"] or said
    if len(said) > 1 and any(not np.array_equal(columns[c], columns[said[0]]) for c in said[1:]):
        raise ModelError(f"'{path}': the columns {', '.join(names[c] for c in said)} are times that differ; keep one of them")
    if not said and is_counter(names[0], columns[0]):
        raise ModelError(f"'{path}': no column says that it is the time, and the first one is a counter; call it 'time (s)'")
    return said[0] if said else 0


def is_counter(name, column):
    return bool(COUNTERS.match(name)) and np.array_equal(column, np.floor(column)) and bool(np.all(np.diff(column) > 0))


def read_wave(path, model):
    """Times and {load: values} of a CSV file with a header, as 'upbead respond' reads it; SI units."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            header, *rows = [[cell.strip() for cell in row] for row in csv.reader(file) if row]
        columns = np.array(rows, dtype=float).T
    except (OSError, ValueError) as error:
        raise ModelError(f"'{path}' cannot be read as a table of numbers below a header: {error}") from error
    if len(columns) < 2 or len(columns) != len(header):
        raise ModelError(f"'{path}': give a time (s) and a load in every row")
    names, units = zip(*headings(header))
    columns = [OF_TIME.get(unit, 1.0) * column if TIMES.match(name) else column for name, unit, column in zip(names, units, columns)]
    time = time_column(names, columns, path)
    values = [c for c in range(len(names)) if c != time and not is_counter(names[c], columns[c]) and not TIMES.match(names[c])]
    of = {c: model.loads[0] if len(values) == len(model.loads) == 1 else names[c] for c in values}
    if len(set(of.values())) < len(of):
        raise ModelError(f"'{path}': two columns are called alike: {', '.join(names[c] for c in values)}; give each load once")
    if not TIMES.match(names[time]):
        columns[time] = OF_TIME.get(units[time], 1.0) * columns[time]
    factor_of(names[time], units[time], OF_TIME, path)
    known = getattr(model, "load_units", {})
    factors = {c: factor_of(names[c], units[c], OF_LOAD.get(known.get(name, ""), OF_LOAD["N/m"] | OF_LOAD["Pa"]), path, model.loads) for c, name in of.items()}
    return columns[time], {name: factors[c] * columns[c] for c, name in of.items()}


def factor_of(name, unit, units, path, own=()):
    """To SI; a unit that is none of these, or that the name hides, is refused."""
    hidden = name not in own and UNREAD.search(name)
    if unit not in units or (unit == "" and hidden):
        said = f"the unit '{unit}' of" if unit else f"the unit '{hidden.group(1)}' in the name"
        raise ModelError(f"'{path}': {said} '{name}' is not read; write one of {', '.join(filter(None, units))} in brackets behind it")
    return units[unit]
