"""The inputs of a case as tables, group by group: regions, loads, boundaries and the rest."""

from .inputs import written_as
from .language import listed, named, say, spaced, told
from .markup import Markup, fold, join, prose, tag
from .source_case import PATHS

TITLES = {
    "": "General",
    "fluid": "Water",
    "mesh": "Mesh",
    "mesh.parameters": "Section",
    "time": "Time",
    "accuracy": "Accuracy",
    "output": "Output",
    "sliding": "Sliding",
    "initial": "State before the waves",
    "section": "Section",
    "waves": "Waves",
    "sea": "Sea",
    "duration": "Duration of the pulse",
    "combined": "Pulse beside a standing wave",
    "impact": "Course of impulsive forces",
    "calibration": "Calibration",
    "life": "Lives",
    "limits": "Limits",
    "cycles": "Waves of a storm",
}
KINDS = ("regions", "loads", "probes", "boundaries")
ORDER = [
    "mesh.parameters",
    "regions",
    "loads",
    "sliding",
    "fluid",
    "",
    "initial",
    "boundaries",
    "probes",
    "mesh",
    "time",
    "accuracy",
    "output",
]


def show(row):
    """A row's value; of a path only its last part, as folders do not matter to a client."""
    if row.path[-1] in PATHS:
        return row.value.replace("\\", "/").rpartition("/")[2]
    return told(row.value) if isinstance(row.value, str) else written_as(row.value, row.unit)


def group_of(path):
    """The group of a row: a region, a load, or a table."""
    tables = path[:-1]
    if tables and tables[0] in KINDS:
        return (tables[0], tables[1]) if tables[0] != "boundaries" and tables[0] != "probes" else (tables[0],)
    return (".".join(tables[:2]) if tables[:2] == ("mesh", "parameters") else (tables[0] if tables else ""),)


def title_of(group, members):
    """A group's name; followed by a region's kind, or by a note that a load is off."""
    own = {row.path[-1]: row.value for row in members if len(row.path) == 3}
    if group[0] == "regions" and "kind" in own:
        return f"{named(group[1])}, {told(own['kind'])}"
    if group[0] == "loads" and own.get("factor") == 0:
        return say("Load {name}, switched off", name=spaced(group[1]))
    if group[0] == "boundaries":
        return say("Boundaries")
    if group[0] == "probes":
        return say("Points read")
    if len(group) == 2:
        return say("Load {name}", name=spaced(group[1])) if group[0] == "loads" else named(group[1])
    return told(TITLES.get(group[0], group[0].replace("_", " ")))


def grouped(found):
    groups = {}
    for row in found:
        groups.setdefault(group_of(row.path), []).append(row)
    return sorted(groups.items(), key=lambda item: ORDER.index(item[0][0]) if item[0][0] in ORDER else len(ORDER))


def label_of(row):
    """The meaning and the key, and the author's remark below."""
    inner = row.path[2:-1] if row.path[0] in KINDS else row.path[1:-1] if row.path[:2] != ("mesh", "parameters") else ()
    key = tag("code", ".".join([*inner, row.path[-1]]))
    return join([prose(told(row.what)), " ", key, tag("div", row.remark, class_="remark written") if row.remark else ""])


def tables(found):
    """Given values, group by group, then the defaults in a part that can be folded."""
    given = [row for row in found if row.mark != "default"]
    taken = [row for row in found if row.mark == "default"]
    return join([columns(given), fold(say("{count} defaults", count=len(taken)), columns(taken)) if taken else Markup("")])


def columns(found):
    return tag("div", *(group_table(group, members) for group, members in grouped(found)), class_="columns")


def group_table(group, members):
    rows_of = {"boundaries": boundary_rows, "probes": point_rows}.get(group[0], value_rows)
    return tag(
        "div",
        tag("h3", title_of(group, members), class_="written"),
        tag("table", tag("tbody", *rows_of(members)), class_="inputs"),
        class_="group",
    )


def value_rows(members):
    shown = [row for row in members if row.path[0] != "regions" or row.path[2:] != ("kind",)] or members
    return [
        tag(
            "tr", tag("th", label_of(row), scope="row"), value_cell(row), mark_cell(row.mark)
        )
        for row in shown
    ]


def value_cell(row):
    """Numbers are not wrapped, words may be."""
    shown = show(row)
    breaks = isinstance(row.value, (str, list)) and len(shown) > 24 or isinstance(row.value, str) and len(row.value) > 12
    is_file = " written" if row.path[-1] in PATHS else ""
    return tag("td", shown, class_=("text" if breaks else "number") + is_file)


def mark_cell(mark):
    return tag("td", told(mark), class_="mark-" + mark)


def boundary_rows(members):
    """One row for each boundary: both of its conditions."""
    found = {}
    for row in members:
        found.setdefault(row.path[1], []).append(row)
    return [
        tag(
            "tr",
            tag("th", named(name), scope="row", class_="written"),
            tag(
                "td",
                listed(
                    say("{condition} for water", condition=told(row.value)) if row.path[-1] == "pressure" else told(row.value)
                    for row in conditions
                ),
            ),
            mark_cell(conditions[0].mark),
        )
        for name, conditions in found.items()
    ]


def point_rows(members):
    return [
        tag(
            "tr",
            tag("th", named(row.path[1]), scope="row", class_="written"),
            value_cell(row),
            mark_cell(row.mark),
        )
        for row in members
    ]
