"""Tables of all numbers of a summary, or of a part of it: whatever the program told, with its meaning, so that nothing is
left out."""

from .language import as_written, heads, say, spoken, told
from .markup import Markup, fold, join, prose, table, tag
from .units import plain, quantity
from .. import outputs

# the largest stress as solved is no pressure to judge by: under the edge of a bonded base it grows with finer cells
NOT_SHOWN = ("peak_computed_pressure", "peak_computed_pressure_at", "peak_computed_pressure_time")
ELSEWHERE = (*NOT_SHOWN, "warnings", "checks", "verdict", "versions", "timing", "skipped")  # they have tables of their own
EDGES = ("heel_pressure", "toe_pressure")  # null, and in older results negative, where the formula has no meaning
MOST_COLUMNS = 5
MOST_ROWS = 20  # of a list


def leaves(found, path=()):
    """[(path, value)] of all numbers and words; the items of a list of objects have their number as a name."""
    if isinstance(found, dict):
        return [leaf for key, value in found.items() if key not in ELSEWHERE for leaf in leaves(value, (*path, key))]
    if isinstance(found, list) and any(isinstance(value, (dict, list)) for value in found):
        return [leaf for number, value in enumerate(found[:MOST_ROWS], 1) for leaf in leaves(value, (*path, f"[{number}]"))]
    return [(path, found)]


def beside(columns, prefix, command, without=()):
    """Tables with a row for each key and a column for each of the objects {name: object}, whose paths begin with
    `prefix`; parts of the names `without` are left out."""
    names, tables = list(columns), []
    for first in range(0, len(names), MOST_COLUMNS):
        chosen = names[first : first + MOST_COLUMNS]
        found = [dict(leaves({key: value for key, value in columns[name].items() if key not in without})) for name in chosen]
        rows = [(label((*prefix, *path), path, command), *(cell(one, path, (*prefix, *path), command) for one in found))
                for path in sorted(dict.fromkeys(path for one in found for path in one), key=lambda path: len(path) > 1)]  # fmt: skip
        head = heads("quantity", *(as_written(name) for name in chosen))
        tables.append(table(head if any(chosen) else None, rows, "numbers keys"))
    return join(tables)


def alone(found, prefix, command, without=()):
    """The same of one object."""
    return beside({"": found}, prefix, command, without) if found else Markup("")


def label(path, shown, command):
    """Its meaning and its key; where the document's language has no word for it, the key alone."""
    words = outputs.label(plain_path(path), command).replace("`", "")
    name = tag("code", ".".join(shown))
    return join([prose(told(words)), " ", name]) if words and (spoken() == "en" or told(words) != words) else name


def plain_path(path):
    """The path without the numbers of items in lists, as the program declares it."""
    return tuple(part for part in path if not part.startswith("["))


def cell(found, path, full, command):
    if path not in found:
        return ""
    if path[-1].endswith(EDGES) and (found[path] is None or (isinstance(found[path], float) and found[path] < 0)):
        return tag("span", say("none: the resultant leaves the base"), class_="long")
    return value_of(found[path], outputs.unit(plain_path(full), command))


def value_of(value, unit):
    if value is None:
        return say("none")
    if isinstance(value, list):
        return tag("span", ", ".join(plain(part) if isinstance(part, (int, float)) else str(part) for part in value), class_="long")
    if isinstance(value, str):
        return tag("span", prose(told(value)), class_="long")
    return plain(value) if isinstance(value, bool) else quantity(value, unit)


def all_of(summary, command):
    """The whole summary, in a part that can be folded."""
    found = {key: value for key, value in summary.items() if key not in ("title", "program")}
    return tag("section", tag("h2", say("All numbers")), fold(say("summary.json, every number of it"), alone(found, (), command)), id="numbers")
