"""Details of the run: discretisation, times, versions, files; and the text of the case."""

import platform

import h5py
import numpy as np

from . import source_case
from .language import named, say, told
from .markup import Markup, fold, join, table, tag
from .units import quantity
from .. import outputs

SIZES = ("cells", "degree", "unknowns", "scheme", "time_step", "steps", "solves", "factorisations", "processes")


def section(result):
    return section_of(result.summary)


def section_of(summary):
    parts = [tag("h2", say("The run")), tag("div", sizes(summary), times(summary), versions(summary), class_="side")]
    return tag("section", *parts, id="run")


def sizes(summary):
    found = summary.get("discretisation") or {}
    rows = [
        (told(outputs.label(path)), told(found[key]) if isinstance(found[key], str) else quantity(found[key], outputs.unit(path)))
        for key, path in ((key, f"discretisation.{key}") for key in SIZES)
        if found.get(key) is not None
    ]
    return tag("div", tag("h3", say("Discretisation")), table(None, rows, "numbers")) if rows else Markup("")


def times(summary):
    rows = [(named(what), quantity(float(value), "s")) for what, value in (summary.get("timing") or {}).items()
            if value is not None and what != "processes" and not what.endswith("_per_second")]
    return tag("div", tag("h3", say("Wall time")), table(None, rows, "numbers")) if rows else Markup("")


def versions(summary):
    # older results name only the program
    found = summary.get("versions") or {"program": summary.get("program", say("not known"))}
    rows = [(name, str(version)) for name, version in found.items()]
    rows.append((say("this page"), f"Python {platform.python_version()}, h5py {h5py.__version__}, numpy {np.__version__}"))
    return tag("div", tag("h3", say("Versions")), table(None, rows, "words"))


def case_text(folder, source):
    """The effective case, and the author's file if it is known, each in a part that can be folded."""
    parts = []
    path = folder / "case.toml"
    if source is not None:
        parts.append(
            fold(say("The case as written: {file}", file=source.path.name), tag("pre", source_case.shown(source.path)))
        )
    if path.is_file():
        parts.append(fold(say("The case with every default: {file}", file="case.toml"), tag("pre", path.read_text(encoding="utf-8"))))
    return tag("section", tag("h2", say("The case")), join(parts), id="case") if parts else Markup("")
