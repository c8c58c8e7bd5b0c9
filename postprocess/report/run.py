"""How the run was made: discretisation, times, versions, files; and the case's text."""

import platform

import h5py
import numpy as np

from report.markup import Markup, fold, join, table, tag
from report.units import quantity
from upbead import outputs

SIZES = ("cells", "degree", "unknowns", "scheme", "time_step", "steps", "solves", "factorisations", "processes")


def section(result):
    summary = result.summary
    parts = [tag("h2", "The run"), tag("div", sizes(summary), times(summary), versions(summary), class_="side")]
    return tag("section", *parts, id="run")


def sizes(summary):
    found = summary.get("discretisation") or {}
    rows = [
        (outputs.label(path), found[key] if isinstance(found[key], str) else quantity(found[key], outputs.unit(path)))
        for key, path in ((key, f"discretisation.{key}") for key in SIZES)
        if found.get(key) is not None
    ]
    return tag("div", tag("h3", "Discretisation"), table(None, rows, "numbers")) if rows else Markup("")


def times(summary):
    rows = [(what, quantity(float(value), "s")) for what, value in (summary.get("timing") or {}).items()]
    return tag("div", tag("h3", "Wall time"), table(None, rows, "numbers")) if rows else Markup("")


def versions(summary):
    found = summary.get("versions") or {"program": summary.get("program", "not known")}  # older results name it alone
    rows = [(name, str(version)) for name, version in found.items()]
    rows.append(("this page", f"Python {platform.python_version()}, h5py {h5py.__version__}, numpy {np.__version__}"))
    return tag("div", tag("h3", "Versions"), table(None, rows, "words"))


def case_text(folder, source):
    """The effective case, and the author's file where it is known, each in a fold."""
    parts = []
    path = folder / "case.toml"
    if source is not None:
        parts.append(
            fold(f"The case as written: {source.path.name}", tag("pre", source.path.read_text(encoding="utf-8")))
        )
    if path.is_file():
        parts.append(fold("The case with every default: case.toml", tag("pre", path.read_text(encoding="utf-8"))))
    return tag("section", tag("h2", "The case"), join(parts), id="case") if parts else Markup("")
