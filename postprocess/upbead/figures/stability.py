"""Scenes and results of the stability map."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from .style import styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEAST = 1e-18  # smaller values are drawn at this value
MEASURES = [  # column, label, bound
    ("reaction", "both routes to $F_T$", 1e-7),
    ("energy", "energy account", 1e-6),
    ("growth", "energy gained\nwithout work", 1e-9),
    ("residual", "residual of a solve", 1e-10),
]
PARAMETERS = [  # values of a row, label
    (lambda r: value(r["k_min"]), "least $k$ (m/s)"),
    (lambda r: value(r["G_max"]) / value(r["G_min"]), "contrast of $G$"),
    (lambda r: min(value(r["K_f"]), 1e13), "$K_f$ (Pa; right: infinite)"),
    (lambda r: 0.5 - value(r["nu_max"]), r"$0.5 - \nu$"),
    (lambda r: value(r["step"]), "step (s)"),
    (lambda r: value(r["aspect"]), "aspect of cells"),
]


@styled
def stability(rows: Sequence[Mapping[str, str]]) -> Figure:
    """A point for each scene of the map, rows of scenes.csv; the red line is the bound that must hold."""
    figure, axes = subplots(len(MEASURES), len(PARAMETERS), figsize=(13, 8.2), sharex="col", sharey="row")
    for i, (column, label, bound) in enumerate(MEASURES):
        answered = measured(rows, column)
        values = [max(size(r, column), LEAST) for r in answered]
        for j, (parameter, name) in enumerate(PARAMETERS):
            ax = axes[i, j]
            ax.scatter([parameter(r) for r in answered], values, s=2, alpha=0.35, linewidths=0, rasterized=True)
            ax.axhline(bound, color="tab:red", linewidth=1)
            ax.set(xscale="log", yscale="log", ylim=(LEAST / 3, 1e-4))
            if i + 1 == len(MEASURES):
                ax.set_xlabel(name)
        axes[i, 0].set_ylabel(label)
        axes[i, -1].text(1.03, 0.5, f"{len(answered)} scenes\nworst {max(values):.1e}\nbound {bound:.0e}",
                         transform=axes[i, -1].transAxes, va="center")
    verdicts = Counter(r["verdict"] for r in rows)
    figure.suptitle(f"{len(rows)} random scenes: {verdicts['passed']} hold every bound (above it: with a warning), "
                    f"{verdicts['contradictory']} contradict themselves, {verdicts['refused']} are refused with a reason, "
                    f"{verdicts['failed']} fail", y=0.94)
    figure.subplots_adjust(hspace=0.12, wspace=0.1)
    return figure


def is_answered(row):
    return row["verdict"] in ("passed", "failed")


def size(row, column):
    """A measure; for the gained energy, the part above the noise of the balance at both ends of a step."""
    size = value(row[column])
    return max(size - 2 * value(row["noise"]), 0.0) if column == "growth" else size


def value(text):
    return float(text) if text else float("nan")


def measured(rows, column):
    """The solved scenes that have the measure. For generalised_alpha the bound on energy is a different one."""
    answered = [r for r in rows if is_answered(r) and value(r[column]) == value(r[column])]
    if column == "reaction":
        answered = [r for r in answered if "caisson" in r["reading"] or r["reading"] in ("shear_force", "normal_force")]
    if column in ("energy", "growth"):
        answered = [r for r in answered if r["solved_by"] != "reduced"]
    if column == "growth":
        answered = [r for r in answered if r["loads_end"] == "1" and r["solved_by"] != "generalised_alpha"]
    return answered
