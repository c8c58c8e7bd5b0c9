"""Results of `upbead expected`: heights of the waves, S by height, and the part of each height in the expected
sliding distance."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..errors import UserError
from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..expected_result import ExpectedResult

LAWS = {"paper": "eq. (7)", "exact": "eqs. (4), (6)", "combined": "combined (1998)", "dynamic": "own dynamics"}
COLOURS = {"paper": "C0", "exact": "C1", "combined": "C2", "dynamic": "C3"}
STYLES = ["-", "--", ":", "-."]


@styled
def expected(results: Sequence[ExpectedResult], laws: Sequence[str] | None = None) -> Figure:
    """The three panels of Figs. 12-14 of Shimosako and Takahashi (1994); curves of several ExpectedResults together.

    laws: keys of LAWS; default: all.
    """
    if len(results) > len(STYLES):
        raise UserError(f"at most {len(STYLES)} folders can be told apart in one figure")
    if not all(result.height.size for result in results):
        return of_lives(results)
    laws = laws or list(LAWS)
    n = 3 if all(result.shear is None for result in results) else 4
    figure, panels = subplots(n, 1, figsize=(6.3, 2.5 * n), layout="constrained")
    top, middle, bottom = panels[:3]
    draw_heights(top, results)
    top.set_xlim(0, results[0].height[-1])
    if not slides(results, laws):
        return say_that_nothing_slides(figure, panels, results)
    draw_curves(middle, results, laws, lambda result: result.distance)
    middle.set_ylabel("S of one wave (m)")
    draw_curves(bottom, results, laws, lambda result: result.contribution, 100)
    bottom.set_ylabel("expected sliding\na metre of height (cm/m)")
    last = max(result.height[-1] for result in results)
    for axes in (middle, bottom):
        axes.set_xlim(first_height(results), last)
        axes.set_ylim(bottom=0)
        axes.legend(fontsize=7)
    if n == 4:  # with four laws the values differ by orders of magnitude
        for axes, least in ((middle, 1e-4), (bottom, 1e-3)):
            axes.set_yscale("log")
            axes.set_ylim(bottom=least)
        draw_ratios(panels[3], results, last)
    for axes in panels:
        axes.set_xlabel("height of the wave (m)")
    figure.suptitle(plain(results[0].summary["title"]) if len(results) == 1 else "", fontsize=9)
    return figure


def of_lives(results):
    """Share of the lives that slide farther, over S: storms were drawn for lives, and there is no record of heights."""
    if not all(result.lives.size for result in results):
        raise UserError("only some of these results have a record of sea states: draw those of [storms] apart")
    figure, axes = subplots(1, 1, figsize=(6.3, 3.2), layout="constrained")
    for result, style in zip(results, STYLES):
        distance = np.sort(result.lives)
        share = 1.0 - np.arange(distance.size) / distance.size
        axes.step(np.append(0.0, distance), np.append(1.0, share), style, where="pre", label=plain(result.name))
    axes.set(xlabel="sliding distance S of a life (m)", ylabel="share of the lives\nthat slide at least so far", ylim=(0, 1))
    if not any(result.lives.any() for result in results):
        axes.annotate(why_nothing_slides(results), (0.02, 0.92), xycoords="axes fraction", va="top")
    if len(results) > 1:
        axes.legend(fontsize=7)
    figure.suptitle(plain(results[0].summary["title"]) if len(results) == 1 else "", fontsize=9)
    return figure


def slides(results, laws):
    return any(values.any() for result in results for law, values in result.distance.items() if law in laws)


def why_nothing_slides(results):
    """The curves are of waves without scatter; lives with it may slide though they are zero."""
    slid = sum(int(np.count_nonzero(result.lives)) for result in results)
    if slid == 0:
        return "Nothing slides: no wave is high enough."
    return f"Without scatter nothing slides; with it {slid} of {sum(result.lives.size for result in results)} lives do."


def say_that_nothing_slides(figure, panels, results):
    """If all curves are zero, heel pressure by height is drawn instead, with a note."""
    axes, last = panels[1], max(result.height[-1] for result in results)
    told = [result for result in results if result.heel_pressure is not None]
    for result, style in zip(told, STYLES):
        axes.plot(result.height, result.heel_pressure / 1e3, style, color="C4", label=plain(result.name))
    axes.set_ylabel("heel pressure of one wave,\nby formulas (kPa)")
    if len(told) > 1:
        axes.legend(fontsize=7)
    axes.annotate(why_nothing_slides(results), (0.02, 0.92), xycoords="axes fraction", va="top")
    axes.set_xlim(0, last)
    axes.set_ylim(bottom=0)
    panels[2].remove()
    if len(panels) == 4:
        draw_ratios(panels[3], results, last)
    for shown in [*panels[:2], *panels[3:]]:
        shown.set_xlabel("height of the wave (m)")
    figure.suptitle(plain(results[0].summary["title"]) if len(results) == 1 else "", fontsize=9)
    return figure


def label(result, law, results):
    return LAWS[law] if len(results) == 1 else f"{plain(result.name)}, {LAWS[law]}"


def draw_heights(axes, results):
    result = results[0]
    edges = np.arange(0, np.ceil(result.height[-1]) + 1)
    fine = np.linspace(0, edges[-1], 40 * len(edges))
    waves = np.interp(fine, result.height, result.waves, left=0, right=0)
    counts = [np.trapz(waves[(fine >= a) & (fine <= b)], fine[(fine >= a) & (fine <= b)])
              for a, b in zip(edges, edges[1:])]
    axes.bar(edges[:-1], counts, 1.0, align="edge", color="0.8", edgecolor="0.5", linewidth=0.5)
    axes.set_yscale("log")
    axes.set_ylim(bottom=1e-2)
    axes.set_ylabel("waves a metre of height")
    asked = sorted((result.summary.get("exceedance") or {}).values(), key=lambda found: found["height"])
    for found in asked:
        right = found is asked[-1]  # the other labels are left of their lines
        axes.axvline(found["height"], color="0.4", linewidth=0.8)
        axes.annotate(f" {found['waves']:.3g} waves \n above {found['height']:g} m ", (found["height"], 1), fontsize=8,
                      xycoords=("data", "axes fraction"), va="top", ha="left" if right else "right")


def draw_curves(axes, results, laws, of, factor=1.0):
    for result, style in zip(results, STYLES):
        for law in LAWS:
            values = of(result).get(law)
            if law in laws and values is not None and values.any():
                axes.plot(result.height, factor * values, style, color=COLOURS[law], label=label(result, law, results))


def draw_ratios(axes, results, last):
    for result, style in zip(results, STYLES):
        if result.shear is not None:
            axes.plot(result.height, result.shear, style, color=COLOURS["dynamic"], label=plain(result.name))
    axes.set_xlim(first_height(results), last)
    axes.set_ylim(bottom=0)
    axes.set_ylabel("peak $F_T$ / peak $P$,\nown dynamics")
    if len(results) > 1:
        axes.legend(fontsize=7)


def first_height(results):
    thresholds = [height for result in results for height in result.thresholds()]
    return 0.85 * min(thresholds) if thresholds else 0
