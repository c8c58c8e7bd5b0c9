"""Figures of errors against time and unknowns."""

import matplotlib
import matplotlib.ticker

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

from compare import of  # noqa: E402
from front import front, sure  # noqa: E402
from table import TARGETS  # noqa: E402

MARKERS = "osD^vPX<>"
LABELS = {"wall": "time of the whole process (s)", "unknowns": "unknowns", "solves": "solves",
          "peak_error": "error of the peak", "history_error": "largest error of the history"}
PANELS = [("damped", "wall", "history_error"), ("undamped", "wall", "history_error"),
          ("damped", "solves", "history_error"), ("inertial", "wall", "history_error"),
          ("inertial", "unknowns", "history_error"), ("darcy", "wall", "history_error"),
          ("strip", "wall", "history_error"), ("column", "wall", "history_error"),
          ("designer", "wall", "history_error"), ("train", "wall", "history_error")]
PROGRAMS = {"upbead, reduced": ("upbead, reduced", "C0"), "upbead, marched": (("upbead, sdirk4", "upbead, gen"), "C1"),
            "upbead, mesh by tolerance": ("upbead, by tolerance", "C4"),
            "lean upbead, reduced": ("lean upbead, reduced", "C5"), "FEniCSx": ("FEniCSx", "C2"), "FreeFEM": ("FreeFEM", "C3")}
START = {"upbead": "C0", "lean upbead": "C5", "FEniCSx": "C2", "FreeFEM": "C3"}


def groups(rows):
    found = {}
    for row in rows:
        found.setdefault(row["series"], []).append(row)
    return found


def decorate(ax, x, y):
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel(LABELS[x])
    ax.set_ylabel(LABELS[y])
    ax.grid(alpha=0.3)
    if x == "wall":
        ax.xaxis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
        ax.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
        ax.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def panel(ax, study, x, y):
    for marker, (series, rows) in zip(MARKERS, groups(study["rows"]).items()):
        style = dict(color="k", marker="*", markersize=12, linestyle="", zorder=5) if series == "default" else dict(
            marker=marker, markersize=5, linewidth=1)
        ax.plot([row[x] for row in rows], [row[y] for row in rows], label=series, **style)
    if x == "wall":
        best = front(study["rows"], y)
        ax.plot([row[x] for row in best], [row[y] for row in best], color="k", alpha=0.15, linewidth=6, zorder=0)
    ax.set_title(study["title"], fontsize="medium")
    decorate(ax, x, y)
    ax.legend(fontsize="x-small")


def draw_studies(studies, path):
    by_name = {study["name"]: study for study in studies}
    panels = [(by_name[name], x, y) for name, x, y in PANELS if name in by_name]
    columns = min(2, len(panels))
    rows = -(-len(panels) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(5 * columns, 3.6 * rows), squeeze=False)
    for ax in axes.flat[len(panels):]:
        ax.remove()
    for ax, (study, x, y) in zip(axes.flat, panels):
        panel(ax, study, x, y)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def draw_peers(study, floors, path):
    """Every run, and the front of each program; vertical lines: processes that do nothing."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.4), sharey=True)
    for ax, error in zip(axes, ("peak_error", "history_error")):
        for name, (prefix, colour) in PROGRAMS.items():
            rows = of(study["rows"], prefix)
            if not rows:
                continue
            ax.plot([r["wall"] for r in rows], [r[error] for r in rows], ".", color=colour, alpha=0.35, markersize=4)
            best = front(sure(rows, error), error)
            ax.plot([r["wall"] for r in best], [r[error] for r in best], "o-", color=colour, markersize=4, label=name)
        for name, wall in floors.items():
            ax.axvline(wall, color=START[name], linestyle=":", linewidth=1)
        for target in TARGETS:
            ax.axhline(target, color="k", alpha=0.3, linewidth=0.8)
        decorate(ax, "wall", error)
    axes[0].legend(fontsize="small")
    axes[1].yaxis.set_tick_params(labelleft=True)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
