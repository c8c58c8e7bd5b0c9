"""A wave as a table, for files that this package reads without the program: by the program's rules (docs/records.md), or refused
with place and cure."""

import gzip
import re

import numpy as np

from .errors import ModelError

HEADING = re.compile(r"^\s*\"?(.*?)\"?\s*(?:[(\[]([^()\[\]]*)[)\]]|\s/\s*([^/\s]+(?:/m2?)?))?\s*$")
OF_TIME = {"s": 1.0, "sec": 1.0, "seconds": 1.0, "ms": 1e-3, "msec": 1e-3, "us": 1e-6, "min": 60.0, "h": 3600.0, "": 1.0}
TIMES = re.compile(r"^(time|t|zeit|temps|tiempo|tempo|tijd|tid|sec|seconds|elapsed time|simulation time)(?:[_ .-]+(s|sec|ms|us|min))?$", re.IGNORECASE)
COUNTERS = re.compile(r"^(|#|part|step|steps|no\.?|nr\.?|index|i|n|id|sample|samples|row|count|counter|frame|time ?step)$", re.IGNORECASE)
G = 9.80665
OF_LOAD = {  # as src/base/units.cc has them
    "N/m": {"N/m": 1.0, "kN/m": 1e3, "MN/m": 1e6, "N/cm": 1e2, "N/mm": 1e3, "gf/cm": 0.1 * G, "kgf/cm": 1e2 * G, "kgf/m": G, "tf/m": 1e3 * G},
    "Pa": {"Pa": 1.0, "hPa": 1e2, "kPa": 1e3, "MPa": 1e6, "bar": 1e5, "mbar": 1e2, "N/m2": 1.0, "kN/m2": 1e3, "MN/m2": 1e6, "N/cm2": 1e4, "N/mm2": 1e6,
           "gf/cm2": 10 * G, "kgf/cm2": 1e4 * G, "kgf/m2": G, "tf/m2": 1e3 * G, "psi": 6894.757293168, "mH2O": 1e3 * G, "cmH2O": 10 * G, "mmH2O": G,
           "mAq": 1e3 * G},
}
ANY = {**OF_LOAD["N/m"], **OF_LOAD["Pa"]}
# a unit of a force or a pressure as a part of a name, which is none at its end: refused
UNREAD = re.compile(r"[\s_/.-]([kMG]?N|[kKMGhH]?Pa|KN|MPA|KPA|m?bar|psi|kgf|tf|gf|lbf|kips?|mH2O|mAq)([\s_/.-]|$)")
GROUPED = re.compile(r"^[+-]?[1-9]\d{0,2}[.,]\d{3}$")  # 1.250: a decimal sign, or one that groups thousands


def refuse(place, what, cure):
    raise ModelError(f"{place}: {what}; {cure}")


def text_of(path):
    try:
        data = path.read_bytes() if hasattr(path, "read_bytes") else open(path, "rb").read()
        data = gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
        text = data.decode("utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
    except (OSError, EOFError, ValueError) as error:
        refuse(f"'{path}' cannot be read as a table of numbers below a header", error, "'upbead respond' reads HDF5 and more")
    return text


def separator_of(line):
    """Of a row of numbers; a comma between digits of cells that blanks part is a decimal sign."""
    for sign in "\t;":
        if sign in line:
            return sign
    return "," if "," in line and not any(" " in cell.strip() for cell in line.split(",")) else None


def numbers_of(cells):
    """The numbers of a row, in which a point is the decimal sign; None where a cell holds none."""
    try:
        return [float(re.sub("[dD]", "e", cell)) for cell in cells]
    except ValueError:
        return None


def rows_of(path):
    """[(number, cells)] of all lines but empty ones and rulers, with points as decimal signs, and the number of the first row."""
    lines = [(n, line.strip()) for n, line in enumerate(text_of(path).splitlines(), 1)]
    lines = [(n, line) for n, line in lines if line.strip("-=_+|*~#%:.,; \t")]
    if not lines:
        refuse(f"'{path}' cannot be read as a table of numbers below a header", "it is empty", "give a time (s) and a load in every row")
    sign = lines[0][1][4:5] if lines[0][1].startswith("sep=") else separator_of(lines[-1][1])
    rows = [(n, [cell.strip().strip('"').strip() for cell in line.split(sign)], line[0] in "#%") for n, line in lines if not line.startswith("sep=")]
    if sign != ",":
        signed = [(n, cell) for n, cells, _ in rows for cell in cells if re.fullmatch(r"[+-]?\d*[.,]\d*(?:[eE][+-]?\d+)?", cell)]
        if {"." in cell for _, cell in signed} == {True, False} or signed and all(GROUPED.match(cell) for _, cell in signed):
            refuse(f"'{path}':{signed[0][0]}", f"in '{signed[0][1]}' point and comma may be decimal signs or group thousands", "write decimal points, and no groups")
        if any("," in cell for _, cell in signed):
            rows = [(n, [cell.replace(",", ".") if re.match(r"[+-]?\d*,\d", cell) else cell for cell in cells], comment) for n, cells, comment in rows]
    return rows


def table(path):
    """(names, units, columns, line of each row)."""
    rows = rows_of(path)
    first = next((i for i, (_, cells, comment) in enumerate(rows) if not comment and len(cells) > 1 and numbers_of(cells)), None)
    if first is None:
        refuse(f"'{path}' cannot be read as a table of numbers below a header", "no row holds two numbers", "give a time (s) and a load in every row")
    width, lines, data = len(rows[first][1]), [], []
    for n, cells, comment in rows[first:]:
        if comment:
            continue
        found = numbers_of(cells)
        if found is None or len(cells) != width or not np.isfinite(found).all():
            what = f"{len(cells)} cells where other rows have {width}" if len(cells) != width else f"a cell of {', '.join(cells)} is no finite number"
            refuse(f"'{path}':{n}", what, "give a time (s) and a load in every row")
        lines.append(n)
        data.append(found)
    above = [[cell.lstrip("#% ") for cell in cells] for _, cells, _ in rows[:first] if len(cells) == width]
    below = above.pop() if len(above) > 1 and all(bare(cell) in ANY or bare(cell) in OF_TIME for cell in above[-1]) else [""] * width
    names, units = zip(*headings(above[-1])) if above else ([f"column {c + 1}" for c in range(width)], [""] * width)
    return list(names), [unit or bare(under) for unit, under in zip(units, below)], np.array(data).T, lines


def bare(cell):
    return cell.strip().strip("[]()").strip()


def headings(row):
    """[(name, unit)] of "p1 (kPa)", "p1 [kPa]", "p1 / kPa" or "p1"."""
    found = []
    for cell in row:
        name, bracketed, behind = HEADING.match(cell[:200]).groups()
        found.append((name.strip(), (bracketed or behind or "").strip().replace("^", "").replace("²", "2")))
    return found


def unit_at_end(name):
    """(name, unit) of "impact_kN_per_m", "impact_KN_M"; (name, "") where none stands there."""
    for at in re.finditer(r"[_ .-]+", name):
        unit = re.sub(r"_per_| per |_p_|_", "/", name[at.end():])
        one_case = {known.lower(): known for known in ("kPa", "Pa", "hPa", "kN/m", "N/m", "kN/m2", "N/m2")} if unit in (unit.lower(), unit.upper()) else {}
        unit = unit if unit in ANY else one_case.get(unit.lower(), "")
        if unit and name[:at.start()].strip("0123456789.,"):
            return name[:at.start()], unit
    return name, ""


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
    """Times and {load: values} of a table, as 'upbead respond' reads it; SI units."""
    names, units, columns, lines = table(path)
    units = [unit or (found[2] or "" if (found := TIMES.match(name)) else "") for name, unit in zip(names, units)]
    columns = [OF_TIME.get(unit, 1.0) * column if TIMES.match(name) else column for name, unit, column in zip(names, units, columns)]
    time = time_column(names, columns, path)
    values = [c for c in range(len(names)) if c != time and not is_counter(names[c], columns[c]) and not TIMES.match(names[c])]
    of, units = {}, list(units)
    for c in values:
        name, unit = unit_at_end(names[c]) if names[c] not in model.loads and not units[c] else (names[c], "")
        units[c] = units[c] or unit
        of[c] = model.loads[0] if len(values) == len(model.loads) == 1 else name
    if len(set(of.values())) < len(of):
        raise ModelError(f"'{path}': two columns are called alike: {', '.join(names[c] for c in values)}; give each load once")
    if not TIMES.match(names[time]):
        columns[time] = OF_TIME.get(units[time], 1.0) * columns[time]
    factor_of(names[time], units[time], OF_TIME, path)
    check_times(columns[time], lines, path)
    known = getattr(model, "load_units", {})
    factors = {c: factor_of(names[c], units[c], OF_LOAD.get(known.get(name, ""), ANY) | {"": 1.0}, path, model.loads) for c, name in of.items()}
    return columns[time], {name: factors[c] * columns[c] for c, name in of.items()}


def check_times(time, lines, path):
    if time[0] < 0:
        refuse(f"'{path}':{lines[0]}", f"the wave starts at t = {time[0]:g} s, before the response", "let it start at 0 or later")
    back = np.flatnonzero(np.diff(time) <= 0)
    if len(time) < 2 or back.size:
        n = back[0] + 1 if back.size else 0
        refuse(f"'{path}':{lines[n]}", f"t = {time[n]:g} s follows no earlier time", "give two times or more, which ascend strictly")


def factor_of(name, unit, units, path, own=()):
    """To SI; a unit that is none of these, or that the name hides, is refused."""
    hidden = name not in own and UNREAD.search(name)
    if unit not in units or (unit == "" and hidden):
        said = f"the unit '{unit}' of" if unit else f"the unit '{hidden.group(1)}' in the name"
        raise ModelError(f"'{path}': {said} '{name}' is not read; write one of {', '.join(filter(None, units))} in brackets behind it")
    return units[unit]
