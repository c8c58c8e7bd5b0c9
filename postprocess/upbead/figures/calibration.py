"""Results of `upbead calibrate`: k = tau_0/tau_0F against alpha*, the fits, and the confidence of their a and b."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib
import numpy as np

from .style import new_figure, plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..calibration_result import CalibrationResult

MEASURES = {"paper": "eq. (7)", "exact": "eqs. (4), (6)", "excess": "time above $\\mu W'$"}


@styled
def calibration(results: CalibrationResult, measure: str = "exact") -> Figure:
    """A column for each model of a CalibrationResult.

    Above, a panel per r: the waves by their period, the fit with its 95 % band, and the given k (the paper's a = 0.3,
    b = 2). Below: the 95 % ellipses of (a, b) and the given point.
    """
    figure = draw_fits(results, measure)
    figure.suptitle(plain(results.summary["title"]), fontsize=9)
    return figure


@styled
def calibration_spectrum(results: CalibrationResult) -> Figure:
    """Peak F_T over peak P of every wave by the rise of its force."""
    return draw_spectrum(results)


def duration_factor(alpha_star, a, b):
    return (alpha_star**a + 1) ** -b


def ellipse_size(fit):
    """q of (p - p_best)^T C^-1 (p - p_best) = q, from its long axis: q is the same in every direction."""
    return fit["ellipse"]["long_axis"] ** 2 / np.linalg.eigvalsh(fit["covariance"])[-1]


def half_width(alpha_star, fit):
    """Half the width of the band that contains the whole curve in 95 % of all samples (Scheffe)."""
    a, b = fit["a"], fit["b"]
    s, k = alpha_star**a, duration_factor(alpha_star, a, b)
    gradient = np.stack([-b * k * s * np.log(alpha_star) / (1 + s), -k * np.log1p(s)])
    return np.sqrt(ellipse_size(fit) * np.einsum("in,ij,jn->n", gradient, np.array(fit["covariance"]), gradient))


def draw_fit(axes, results, model, fit, measure, colour):
    """Draws one r. Returns the points, for their colour bar."""
    alpha_star = np.linspace(1e-3, 2, 400)
    x, k, period = results.points(model, fit["ratio"], measure)
    points = axes.scatter(x, k, 2, period, cmap="viridis_r", linewidths=0, rasterized=True)
    if fit["a"] is not None:
        curve = duration_factor(alpha_star, fit["a"], fit["b"])
        sure = fit["covariance"] is not None
        axes.plot(alpha_star, curve, "-" if sure else ":", color=colour,
                  label=f"a = {fit['a']:.2g}, b = {fit['b']:.2g}" + ("" if sure else "\n(not identifiable)"))
        if sure:
            width = half_width(alpha_star, fit)
            axes.fill_between(alpha_star, curve - width, curve + width, color=colour, alpha=0.3, linewidth=0)
    a, b = results.given["a"], results.given["b"]
    axes.plot(alpha_star, duration_factor(alpha_star, a, b), "k--", label=f"given: {a:g}, {b:g}")
    axes.set_xlim(0, 2)
    axes.set_ylim(0, results.highest(measure))
    axes.legend(fontsize=7, title=f"r = {fit['ratio']:g}", title_fontsize=8, frameon=True, framealpha=0.85,
                loc="upper right")
    return points


def outline(fit):
    """The ellipse of (a, b)."""
    turn = np.linspace(0, 2 * np.pi, 200)
    factor = np.linalg.cholesky(ellipse_size(fit) * np.array(fit["covariance"]))
    return np.array([[fit["a"]], [fit["b"]]]) + factor @ np.stack([np.cos(turn), np.sin(turn)])


def draw_ellipses(axes, results, model, measure, colours):
    for fit, colour in zip(results.fits(model, measure), colours):
        if fit["covariance"] is None or fit["ellipse"]["short_axis"] == 0:
            continue
        a, b = outline(fit)
        axes.fill(a, b, color=colour, alpha=0.3)
        axes.plot(a, b, color=colour)
        axes.annotate(f"{fit['ratio']:g}", (a.max(), b[a.argmax()]), xytext=(3, 0), textcoords="offset points",
                      color=colour, fontsize=8, va="center")
    axes.plot(results.given["a"], results.given["b"], "kx")
    axes.annotate("given", (results.given["a"], results.given["b"]), xytext=(5, 0), textcoords="offset points",
                  fontsize=8, va="center")
    axes.set_xscale("log")
    axes.set_xlabel("a")


def draw_fits(results, measure):
    models = list(results.models)
    n = max(len(results.fits(model, measure)) for model in models)
    colours = matplotlib.colormaps["plasma"](np.linspace(0, 0.75, n))
    figure = new_figure((1.3 + 2.9 * len(models), 2 + 1.7 * n), "constrained")
    panels = figure.subplots(n + 1, len(models), sharex="row", sharey="row", squeeze=False,
                             height_ratios=[1] * n + [1.5])
    for column, model in zip(panels.T, models):
        for axes, fit, colour in zip(column, results.fits(model, measure), colours):
            points = draw_fit(axes, results, model, fit, measure, colour)
        column[0].set_title(f"{plain(model)}, scale {results.models[model]['scale']:g}", fontsize=9)
        column[n - 1].set_xlabel("$\\alpha^*$")
        draw_ellipses(column[n], results, model, measure, colours)
    for row in panels[:n]:
        row[0].set_ylabel("$\\tau_0/\\tau_{0F}$")
    panels[n, 0].set_ylabel("b")
    bar = figure.colorbar(points, ax=panels[:n, :], aspect=60, fraction=0.03)
    bar.set_label(f"T at the size of [section] (s); $\\tau_0$ by {MEASURES[measure]}")
    return figure


def draw_spectrum(results):
    """A panel per size; lumped models are in the panel of their size."""
    sizes = sorted({model["scale"] for model in results.models.values()})
    figure, panels = subplots(1, len(sizes), figsize=(1.3 + 2.9 * len(sizes), 3), layout="constrained",
                              sharey=True, squeeze=False)
    for axes, size in zip(panels[0], sizes):
        for name, model in results.models.items():
            rows = results.model_of_row == name
            if model["scale"] == size:
                ratio = results.columns["peak_shear"][rows] / results.columns["peak_force"][rows]
                axes.plot(results.columns["rise"][rows], ratio, ".", markersize=1.5, label=plain(name), rasterized=True)
        axes.set_title(f"scale {size:g}", fontsize=9)
        axes.set_xlabel("rise $t_r$ (s)")
        axes.set_xlim(left=0)
        axes.set_ylim(bottom=0)
        axes.legend(fontsize=7, markerscale=6)
    panels[0, 0].set_ylabel("peak $F_T$ / peak $P_I$")
    return figure
