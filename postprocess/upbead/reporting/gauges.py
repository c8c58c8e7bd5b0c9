"""Records of transducers along the wall or the bottom, and how accurately their number and positions give the
force."""

from .language import as_written, heads, say
from .markup import Markup, fold, table
from .units import percent, quantity

HEAD = (
    "record",
    "transducers",
    "samples",
    "largest pressure",
    "at",
    "largest force",
    "arm",
    "error by interpolation: force",
    "arm, of the row's length",
    "load cell",
)


def records(summary):
    """A fold with one row for each record; empty if there are none."""
    rows = [
        (
            as_written(name),
            quantity(row.get("gauges")),
            quantity(row.get("samples")),
            quantity(row.get("peak_pressure"), "Pa"),
            f"{row.get('peak_gauge', '')}",
            quantity(row.get("peak_force"), "N/m"),
            quantity(row.get("arm"), "m"),
            percent(row.get("force_error")),
            percent(row.get("arm_error")),
            quantity(row.get("load_cell"), "N/m"),
        )
        for name, row in (summary.get("gauges") or {}).items()
    ]
    return fold(say("Records of transducers"), table(heads(*HEAD), rows, "numbers"), open_=True) if rows else Markup("")
