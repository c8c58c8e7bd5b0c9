"""The slip of a caisson by every measure against its safety factor."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..study_table import StudyTable

MEASURES = [  # column, name, line
    ("sliding.equal_impulse.sliding_paper", "pulse of equal impulse, eq. (7)", "s:", "0.6"),
    ("sliding.equal_impulse.sliding_exact", "the same, integrated", "s-", "0.6"),
    ("sliding.sliding_history", "$F_T(t)$ of the bonded caisson, eq. (4)", "o-", "black"),
    ("sliding.sliding_coupled", "slips as a whole on its ground", "^-", "tab:blue"),
    ("contact.solved.slip", "node by node, mean", "o-", "tab:red"),
    ("contact.solved.least_slip", "node by node, least", "o:", "tab:red"),
]
LEAST = 0.03  # mm: slips below it are not shown


@styled
def slip_safety(tables: Sequence[StudyTable], scales: Sequence[float] | None = None) -> Figure:
    """A panel for each StudyTable of a study such as cases/study/slip; scales convert lengths to full size (default:
    1)."""
    scales = scales or [1.0] * len(tables)
    figure, places = subplots(1, len(tables), figsize=(4.6 * len(tables), 4.2), sharey=True, squeeze=False,
                              layout="constrained")
    for axes, table, scale in zip(places[0], tables, scales):
        draw(axes, table, scale)
    places[0, 0].set_ylabel("$S$ (mm)")
    places[0, 0].set_ylim(bottom=LEAST)
    places[0, 0].legend(fontsize=7.5)
    return figure


def draw(axes, table, scale):
    safety = 1.0 / table.sound("sliding.ratio")
    for key, name, line, colour in MEASURES:
        slip = 1e3 * scale * table.sound(key)
        shown = slip > LEAST
        axes.plot(safety[shown], slip[shown], line, color=colour, ms=3.5, lw=1.2, label=name)
    axes.set(yscale="log", xlabel=r"safety factor $\mu W' / F_{T,\mathrm{max}}$")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_title(plain(table.name) + (f", lengths times {scale:g}" if scale != 1 else ""), fontsize=9)
