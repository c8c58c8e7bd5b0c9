"""Results of `upbead study`: a number read from each run against every varied key."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from .. import outputs
from ..errors import UserError
from ..study_axes import default_axes, in_words, is_drawn, rank_correlation, spreads
from .doubt import RED
from .style import mathematics, plain, scaled, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..study_table import StudyTable

MOST_LINES = 8


@styled
def study(table: StudyTable, read: str | None = None, x: Sequence[str] | None = None) -> Figure:
    """A panel for each varied key of a StudyTable.

    Keys that were varied over a few values give lines, one for each combination of the other keys; random draws give
    points, with their rank correlation, and the distribution of the number. Several cases have a colour each. Void runs are
    crosses, which no number counts.
    read: the number to draw (default: the first); x: the keys to draw it against (default: all).
    """
    read = chosen(table.reads, [read], "number")[0] if read else table.reads[0]
    y = numbers(table, read)
    if not np.isfinite(y).any():
        raise UserError(f"no run has the number '{read}'")
    across = chosen(table.keys, x, "key") if x else default_axes(table)
    drawn = [key for key in across if is_drawn(table, key) and table.numbers(key) is not None]
    figure, panels = grid(len(across) + bool(drawn))
    for axes, key in zip(panels, across):
        if key in drawn:
            draw_points(axes, table, key, y)
        else:
            others = [other for other in table.keys if other != key and not is_drawn(table, other)]
            draw_lines(axes, table, key, others, y)
        axes.set_xlabel(label(table, key))
    for axes in panels[:len(across):min(len(panels), 3)]:
        axes.set_ylabel(label(table, read))
    if drawn:
        draw_distribution(panels[len(across)], y[~table.void], label(table, read))
    failed = f", {len(table.failed)} more failed" if table.failed else ""
    failed += f", {table.void.sum()} void (crosses)" if table.void.any() else ""
    figure.suptitle(f"{plain(table.name)}: {len(table)} runs{failed}", fontsize=9)
    return figure


def grid(n):
    """A figure of n panels, at most three in a row."""
    columns = min(n, 3)
    rows = -(-n // columns)
    figure, panels = subplots(rows, columns, figsize=(0.6 + 3.6 * columns, 3.0 * rows), layout="constrained",
                              squeeze=False)
    panels = list(itertools.chain(*panels))
    for axes in panels[n:]:
        axes.remove()
    return figure, panels[:n]


def label(table, name):
    """What a key or number is, with its unit as it is drawn."""
    unit = drawn_in(table, name)[1]
    words = outputs.label(name) or in_words(name)
    return mathematics(wrapped(f"{words} ({unit})" if unit else words))


def wrapped(words, letters=44):
    return "\n".join(textwrap.wrap(words, letters))


def drawn_in(table, name):
    """(factor, unit) in which a key or number is drawn: with the prefix that suits its largest value."""
    unit, values = table.units.get(name) or outputs.unit(name), table.numbers(name)
    peak = 0.0 if values is None or not np.isfinite(values).any() else np.nanmax(np.abs(values))
    return scaled(unit, float(peak))


def numbers(table, name):
    values = table.numbers(name)
    return None if values is None else values * drawn_in(table, name)[0]


def scale_axis(axes, values):
    if spreads(values):
        axes.set_xscale("log")
        ticker = LogLocator(subs=(1, 2, 5))
        axes.xaxis.set_major_locator(ticker)
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.xaxis.set_minor_formatter(NullFormatter())


def draw_points(axes, table, key, y):
    x = numbers(table, key)
    cases = table.words("case") if "case" in table.keys else [""] * len(x)
    for case in dict.fromkeys(cases):
        good = np.isfinite(y) & ~table.void & np.array([found == case for found in cases])
        if not good.any():
            continue
        correlation = round(rank_correlation(x[good], y[good]), 2) + 0.0
        axes.plot(x[good], y[good], ".", markersize=3, alpha=0.5, label=f"{plain(Path(case).stem)} {correlation:.2f}")
        axes.set_title(f"rank correlation {correlation:.2f}", fontsize=8)
    draw_void(axes, x, y, table.void)
    if len(set(cases)) > 1:
        axes.set_title("rank correlation", fontsize=8)
        axes.legend(fontsize=7)
    scale_axis(axes, x)


def draw_void(axes, x, y, void):
    if void.any():
        axes.plot(x[void], y[void], "x", color=RED, markersize=5, label="void")


def draw_lines(axes, table, key, others, y):
    x = numbers(table, key)
    words = sorted(set(table.words(key))) if x is None else []
    x = np.array([words.index(word) for word in table.words(key)]) if x is None else x
    combinations = list(zip(*(table.words(other) for other in others))) or [()] * len(x)
    different = sorted(set(combinations), key=combinations.index)
    crowded = len(different) > MOST_LINES
    for combination in different:
        chosen = ~table.void & np.array([found == combination for found in combinations])
        order = np.argsort(x[chosen], kind="stable")
        name = ", ".join(f"{in_words(other)} {value}" for other, value in zip(others, combination))
        axes.plot(x[chosen][order], y[chosen][order], "o-", markersize=3, linewidth=1, alpha=0.4 if crowded else 1,
                  color="C0" if crowded else None, label=None if crowded else plain(name))
    draw_void(axes, x, y, table.void)
    if words:
        axes.set_xticks(range(len(words)), words)
    else:
        scale_axis(axes, x)
    if others and not crowded:
        axes.legend(fontsize=7)


def draw_distribution(axes, y, words):
    y = y[np.isfinite(y)]
    if not y.size:
        return axes.set_title("all runs are void", fontsize=8)
    low, middle, high = np.percentile(y, [5, 50, 95])
    axes.hist(y, bins=min(40, max(8, len(y) // 20)), color="0.8", edgecolor="0.5", linewidth=0.5)
    for value in (low, middle, high):
        axes.axvline(value, color="C3", linewidth=1)
    axes.set_title(f"5 %: {low:.3g}, median {middle:.3g}, 95 %: {high:.3g}", fontsize=8)
    axes.set_xlabel(words)
    axes.set_ylabel("runs")


def chosen(known, asked, what):
    for name in asked:
        if name not in known:
            raise UserError(f"the study has no {what} '{name}'; it has {', '.join(known)}")
    return list(asked)