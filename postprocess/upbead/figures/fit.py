"""A record and the fit to it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..least_squares import scipy_part
from .style import mosaic, plain, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..fit_result import Fit

WIDEST = np.log(10.0)  # largest axis of the ellipse, in logarithms


@styled
def fit(found: Fit) -> Figure:
    """Record, first guess and fit of a Fit, the residual, measured and computed modes, and for two parameters the
    ellipse that contains both with 95 %."""
    columns = [["record", "residual"]] * bool(found.time.size) + [["modes"] * 2] * bool(found.modes)
    columns += [["ellipse"] * 2] * (len(found.values) == 2)
    figure, axes = mosaic([list(row) for row in zip(*columns)], figsize=(3.0 + 3.3 * len(columns), 4.6), layout="constrained")
    if found.time.size:
        factor, unit = found.record.scale()
        draw_record(axes["record"], found, factor, unit)
        draw_residual(axes["residual"], found, factor, unit)
        axes["residual"].sharex(axes["record"])
        axes["record"].tick_params(labelbottom=False)
        figure.align_ylabels([axes["record"], axes["residual"]])
    if found.modes:
        draw_modes(axes["modes"], found)
    if "ellipse" in axes:
        draw_ellipse(axes["ellipse"], found)
    return figure


def draw_modes(axes, found):
    """Frequency and damping; a frequency without measured damping is drawn as a line."""
    for n, mode in enumerate(found.modes):
        measured, names = mode["measured"], ("measured", "first guess", "fit") if n == 0 else (None,) * 3
        f, error = measured["frequency"], 2 * measured["frequency_uncertainty"]
        if measured["damping_ratio"]:
            axes.errorbar(f, 100 * measured["damping_ratio"], xerr=error, yerr=200 * measured["damping_uncertainty"], fmt="o",
                          color="0.4", capsize=3, label=names[0] and "measured, 2 standard deviations")
        else:
            axes.axvspan(f - error, f + error, color="0.88", lw=0, label=names[0] and "measured, 2 standard deviations")
        for which, mark, color, name in (("first guess", "x", "tab:blue", names[1]), ("fit", "D", "tab:red", names[2])):
            axes.plot(mode[which]["frequency"], 100 * mode[which]["damping_ratio"], mark, color=color, ms=5, label=name)
    axes.set_xlabel("frequency (Hz)")
    axes.set_ylabel("damping (% of critical)")
    axes.set_ylim(min(0.0, axes.get_ylim()[0]), 1.3 * max(axes.get_ylim()[1], 1e-3))
    axes.legend(fontsize="small")


def draw_record(axes, found, factor, unit):
    axes.plot(found.time, factor * found.record.values, ".", color="0.55", ms=2.5, label="record")
    axes.plot(found.time, factor * found.first.values, "--", color="tab:blue", lw=1.0, label="first guess")
    axes.plot(found.time, factor * found.computed.values, color="tab:red", lw=1.4, label="fit")
    axes.axhline(0.0, color="black", lw=0.5)
    axes.set_ylabel(f"{plain(found.reading.replace('_', ' '))} ({plain(unit)})")
    axes.set_xlim(found.time[0], found.time[-1])
    axes.legend(fontsize="small", loc="best", markerscale=2.5)
    axes.set_title("\n".join(f"{plain(short(key))} = {value:.4g}" for key, value in found.values.items()), fontsize=9, loc="left")


def draw_residual(axes, found, factor, unit):
    axes.axhspan(-2 * factor * found.noise, 2 * factor * found.noise, color="0.9", lw=0, label="2 standard deviations")
    axes.plot(found.time, factor * found.residual.values, ".", color="0.35", ms=2.5)
    axes.axhline(0.0, color="black", lw=0.5)
    axes.set_xlabel("time (s)")
    axes.set_ylabel(f"record - fit ({unit})")
    axes.legend(fontsize="small", loc="upper right")


def draw_ellipse(axes, found):
    """Draws x^T C^-1 x <= 2 F(2, n - 2) for the covariance C of the logarithms (Seber and Wild 2003, ch. 5.2); with
    chi^2 if all uncertainties are given."""
    n, stats = found.time.size, scipy_part("stats")
    radius = np.sqrt(2 * stats.f.ppf(0.95, 2, n - 2) if n else stats.chi2.ppf(0.95, 2))
    size, vectors = np.linalg.eigh(found.covariance)
    angle = np.linspace(0.0, 2 * np.pi, 401)
    edge = radius * vectors @ (np.sqrt(np.maximum(size, 0.0))[:, None] * np.array([np.cos(angle), np.sin(angle)]))
    edge = np.exp(np.clip(edge, -WIDEST, WIDEST))
    (x_key, x), (y_key, y) = found.values.items()
    axes.fill(x * edge[0], y * edge[1], color="tab:red", alpha=0.15, lw=0)
    axes.plot(x * edge[0], y * edge[1], color="tab:red", lw=1.0, label="both with 95 %")
    bars = {axis: [[value - max(found.confidence[key][0], 0.1 * value)], [min(found.confidence[key][1], 10 * value) - value]]
            for axis, key, value in (("xerr", x_key, x), ("yerr", y_key, y))}
    axes.errorbar(x, y, **bars, fmt="o", color="black", ms=4, lw=1.0, capsize=3, label="each with 95 %")
    axes.set_xlabel(plain(short(x_key)))
    axes.set_ylabel(plain(short(y_key)))
    axes.legend(fontsize="small")


def short(key):
    """The last words of a key: seabed shear modulus.

    >>> short("regions.seabed.damping.ratio"), short("loads.impulse.pulse.duration")
    ('seabed damping ratio', 'impulse pulse duration')
    """
    parts = key.split(".")
    return " ".join(parts[1:] if len(parts) > 2 else parts).replace("_", " ")
