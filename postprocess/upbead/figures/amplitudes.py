"""F_T over P and displacements by the size of the force: linear, equivalent-linear and hysteretic soil."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from .style import styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..results import Result

WAYS = [("elastic", "linear", ":", "0.5"), ("equivalent", "equivalent-linear", "s--", "tab:blue"), ("hysteretic", "hysteretic", "o-", "tab:red")]


@styled
def amplitudes(rows: Mapping[str, Sequence[tuple[float, Result]]]) -> Figure:
    """rows: {way: [(factor of P, Result)]}, ways as in WAYS; missing ones are left out."""
    figure, (ratio, moved) = subplots(1, 2, figsize=(8.6, 3.6), layout="constrained")
    for way, name, line, colour in WAYS:
        if way not in rows:
            continue
        factors = [factor for factor, _ in rows[way]]
        found = [result.summary for _, result in rows[way]]
        ratio.plot(factors, [s["response"]["shear_to_force_ratio"] for s in found], line, color=colour, ms=4, label=name)
        peak = [1e3 * s["response"]["peak_displacement"] for s in found]
        moved.plot(factors, peak, line, color=colour, ms=4, label=f"{name}, largest")
        rest = [1e3 * s["residual"]["displacement_x"] if s["residual"] else 0.0 for s in found]
        if any(rest):
            moved.plot(factors, rest, "o:", color=colour, ms=4, label=f"{name}, residual")
    ratio.set(xscale="log", xlabel="factor of $P$", ylabel="peak $F_T$ / peak $P$", ylim=(0, None))
    moved.set(xscale="log", yscale="log", xlabel="factor of $P$", ylabel="$x_G$ (mm)")
    for axes in (ratio, moved):
        axes.legend(fontsize=7.5)
        axes.xaxis.set_major_formatter("{x:g}")
    return figure
