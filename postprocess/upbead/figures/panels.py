"""The plots of the reports, drawn by matplotlib: what a panel shows is described once, in reporting.plot."""

from __future__ import annotations

from typing import Any

from .. import prefixes
from ..reporting.markup import runs
from ..reporting.plot import Plot
from ..reporting.units import plain as number
from .style import plain, subplots

COLOURS = ["#0b62a4", "#2a7f3f", "#c0392b", "#1c2430", "#d98200", "#7b4fa3"]  # --c0 to --c5 of reporting/page.css, light
DOTS = {"ẍ": r"\ddot{x}"}


def drawn(plot: Plot, title: str = "") -> Any:
    """A figure with a panel below the other, in the units of the report."""
    figure, axes = subplots(len(plot.panels), 1, sharex=True, figsize=(6.5, 1.0 + 1.5 * len(plot.panels)), squeeze=False)
    rows: list[Any] = list(axes[:, 0])
    groups: dict[object, list[Any]] = {}
    for row, panel in zip(rows, plot.panels):
        draw_panel(row, panel, *plot.factor(panel))
        groups.setdefault(panel.group or id(panel), []).append(row)
    for peers in groups.values():  # that they can be compared at a glance
        low, high = min(row.get_ylim()[0] for row in peers), max(row.get_ylim()[1] for row in peers)
        for row in peers:
            row.set_ylim(low, high)
    rows[-1].set_xlabel(f"{plot.axis[0]} ({plot.axis[1]})")
    rows[0].set_xlim(plot.window or plot.extent())
    rows[0].set_title(title, pad=name_lines(rows, plot.panels))
    figure.align_ylabels()
    return figure


def draw_panel(axes: Any, panel: Any, factor: float, unit: str) -> None:
    unit, own = prefixes.pretty(unit), "" if panel.title else symbol(panel.lines[0].symbol)
    for place, line in enumerate(panel.lines):
        name = own if own and place == 0 else plain(line.symbol)  # those below a title are the author's, no symbols
        axes.plot(line.x, factor * line.values, line.dash, color=COLOURS[line.colour], lw=1.2 if line.dash == "-" else 0.8, label=name)
    axes.axhline(0.0, color="black", lw=0.5)
    for x, value in panel.marks:
        axes.plot(x, factor * value, "o", color="black", ms=3)
        axes.annotate(f"{number(factor * value)} {unit}", (x, factor * value), xytext=(6, 3), textcoords="offset points")
    axes.set_ylabel(f"{plain(panel.title)}\n({unit})" if panel.title else f"{own} ({unit})")
    axes.yaxis.set_major_formatter(lambda value, _: number(value))


def name_lines(rows: list[Any], panels: list[Any]) -> float:
    """A legend of lines that share a panel, or whose panel is called by something else; above all panels where several have one. Returns the
    room for it below a title (pt)."""
    several = [row for row, panel in zip(rows, panels) if len(names_in(row)) > (0 if panel.title else 1)]
    if len(several) == 1:
        several[0].legend(fontsize=7.5, loc="upper right")
    if len(several) < 2:
        return 6.0
    found = {line.get_label(): line for row in rows for line in names_in(row)}
    rows[0].legend(handles=list(found.values()), fontsize=7.5, ncol=4, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    return 10.0 + 12.0 * -(-len(found) // 4)


def names_in(axes: Any) -> list[Any]:
    """Its lines that have a name: matplotlib calls all others _child0, _child1."""
    return [line for line in axes.lines if not line.get_label().startswith("_")]


def symbol(name: str) -> str:
    """A name as the reports set it: F_T with its subscript, words of others as they are."""
    parts = runs(name)
    if not any(style for _, style in parts):
        return plain(name)
    set_as = {"i": "{}", "sub": r"_{{\mathrm{{{}}}}}", "": r"\mathrm{{{}}}"}
    text = "".join(set_as[style].format(part.replace(" ", r"\ ")) for part, style in parts)
    for letter, mathematics in DOTS.items():
        text = text.replace(letter, mathematics)
    return f"${text}$"
