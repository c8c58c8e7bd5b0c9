"""One slide as Figs. 6 and 8 of Shimosako and Takahashi (1994): forces, displacement and slip over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..results import Result
    from ..slip_result import SlipResult

BONDED, COUPLED, NODES = "0.55", "tab:blue", "tab:red"


@styled
def slip_histories(slides: SlipResult, bonded: Result, until: float | None = None) -> Figure:
    """Draws a SlipResult, and the Result of the same case with a bonded caisson; until: end of the time axis (s)."""
    figure, rows = subplots(3, 1, sharex=True, figsize=(7, 8), layout="constrained")
    draw_forces(rows[0], slides, bonded)
    draw_displacement(rows[1], slides, bonded)
    draw_slip(rows[2], slides)
    mark_starts(rows, slides)
    rows[-1].set_xlabel("time (s)")
    rows[-1].set_xlim(slides.time[0], until or slides.time[-1])
    return figure


def draw_forces(axes, slides, bonded):
    scale = 1e-6 if slides.history("force").values.max() >= 1e6 else 1e-3
    resistance = scale * slides.number("sliding.resistance")
    axes.plot(slides.time, scale * slides.history("force").values, color="black", lw=0.9, label="$P$")
    axes.plot(bonded.time, scale * bonded.history("shear_force").values, color=BONDED, label="$F_T$, bonded")
    if slides.has_coupled():
        axes.plot(slides.array("coupled/time"), scale * slides.array("coupled/shear_force"), color=COUPLED,
                  label="$F_T$, slips as a whole")
    axes.plot(slides.time, scale * slides.history("shear_force").values, color=NODES,
              label="$F_T$, node by node")
    axes.axhline(resistance, color="black", ls=":", lw=0.9, label=r"$\mu W'$")
    axes.set_ylabel(f"force ({'M' if scale == 1e-6 else 'k'}N/m)")
    axes.legend(ncol=2, fontsize=7.5)


def residual(time, x):
    """The centre of the vibration in the last half of the run: a mean with weights that rise and fall smoothly."""
    late = x[time >= (time[0] + time[-1]) / 2]
    return np.average(late, weights=np.hanning(late.size + 2)[1:-1])


def draw_displacement(axes, slides, bonded):
    axes.plot(bonded.time, 1e3 * bonded.history("caisson/displacement_x").values, color=BONDED,
              label="$x_G$, bonded (elastic)")
    lines = [(slides.time, slides.history("caisson/displacement_x").values, NODES, "node by node")]
    if slides.has_coupled():
        coupled = slides.array("coupled/time"), slides.array("coupled/displacement_x")
        lines.insert(0, (*coupled, COUPLED, "slips as a whole"))
    for time, x, colour, name in lines:
        rest = 1e3 * residual(time, x)
        axes.plot(time, 1e3 * x, color=colour, label=f"$x_G$, {name}; residual {rest:.1f} mm")
        axes.axhline(rest, color=colour, ls=":", lw=0.9)
    axes.set_ylabel("displacement (mm)")
    axes.set_ylim(top=1.4 * axes.get_ylim()[1])
    axes.legend(fontsize=7.5, loc="upper center")


def draw_slip(axes, slides):
    if slides.has_coupled():
        axes.plot(slides.array("coupled/time"), 1e3 * slides.array("coupled/slip"), color=COUPLED, label="as a whole")
    axes.plot(slides.time, 1e3 * slides.history("interface/slip").values, color=NODES, label="node by node, mean")
    axes.fill_between(slides.time, 1e3 * slides.slip.min(axis=1), 1e3 * slides.slip.max(axis=1), color=NODES,
                      alpha=0.15, lw=0, label="node by node, least to largest")
    for key, style, label in (("sliding.sliding_history", "--", "$S$ by eq. (4) on $F_T(t)$"),
                              ("sliding.equal_impulse.sliding_paper", ":", "$S$ by eq. (7), pulse of equal impulse")):
        axes.axhline(1e3 * slides.number(key), color="black", ls=style, lw=0.9, label=label)
    axes.set_ylabel("slip (mm)")
    axes.set_ylim(top=1.3 * axes.get_ylim()[1])
    axes.legend(fontsize=7.5, ncol=2)


def mark_starts(rows, slides):
    """Marks the times at which the caisson as a whole and the first node begin to slip."""
    slips = slides.number("sliding.coupled.slips") if slides.has_coupled() else []
    starts = [(slips[0]["start"], COUPLED)] if slips else []
    starts.append((slides.number("contact.solved.first_slip"), NODES))
    for time, colour in starts:
        for axes in rows:
            axes.axvline(time, color=colour, ls="--", lw=0.8)
    lines = "broken vertical lines: the first node slips (red), slip as a whole begins (blue)"
    rows[0].set_title(f"{plain(slides.title)}\n{lines}", fontsize=9)
