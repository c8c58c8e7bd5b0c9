"""The pictures of docs/validation.md."""

import numpy as np
from matplotlib.figure import Figure

from .column import HEIGHT, PERIOD, keys_of, soil_of
from .column_theory import with_inertia

COLOURS = ("#7a1f5c", "#b5423a", "#d98b2b", "#5b8c3e", "#2b7a8c", "#27408b")


def of_column(said, now):
    """p/p0 over depth: theory as lines, the program as dots, the predicted interval as bands."""
    figure = Figure(figsize=(6.4, 5.2), layout="constrained")
    axes = figure.add_subplot()
    heights = np.linspace(0, HEIGHT, 200)
    for colour, (saturation, depths) in zip(COLOURS, said["column"].items(), strict=True):
        exact = np.abs(with_inertia(soil_of(keys_of(float(saturation), {})), HEIGHT, PERIOD, heights))
        axes.plot(exact, HEIGHT - heights, color=colour, lw=1.4, label=f"S = {saturation}")
        places = [float(depth) for depth in depths]
        axes.fill_betweenx(places, *np.array([value["interval"] for value in depths.values()]).T, color=colour, alpha=0.13, lw=0)
        axes.plot([pair[0] for pair in now["column"][saturation]["computed"].values()], places, "o", color=colour, ms=4)
    axes.set(xlabel="|p| / p_0", ylabel="depth below the top (m)", xlim=(0, 1.02), ylim=(HEIGHT, 0))
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, loc="lower center", ncols=2, title="lines: theory; dots: upbead; bands: 90 %", title_fontsize=8)
    return figure


def bars(axes, centre, ends, label):
    """One bar for each input or choice from the central value to those at its two ends, the widest on top."""
    order = sorted(ends, key=lambda name: max(abs(end - centre) for end in ends[name]))
    for place, name in enumerate(order):
        for end, colour in zip(ends[name], ("#b5423a", "#27408b"), strict=True):
            axes.barh(place, end - centre, left=centre, color=colour, height=0.7, alpha=0.85)
    axes.set_yticks(range(len(order)), order, fontsize=8)
    axes.axvline(centre, color="black", lw=0.8)
    axes.set_xlabel(label)
    axes.grid(axis="x", alpha=0.3)


def of_more(now):
    """E, a first frequency and a pore pressure."""
    figure = Figure(figsize=(14, 4.4), layout="constrained")
    labels = {"E": "E of nine years (m)", "frequency": "first frequency (Hz)", "pore pressure": "|p| / p_0 at the base, 1 % of air"}
    for axes, (name, label) in zip(figure.subplots(1, 3), labels.items(), strict=True):
        values = now["more tornados"][name]
        bars(axes, values[""], {key: ends for key, ends in values.items() if key}, label)
    figure.suptitle("One at a time: red the first value, blue the second", fontsize=10)
    return figure


def of_tornado(now):
    """F_T/P and S of the designer's section."""
    rows = {name: value for name, value in now["tornado"].items() if name} | now["choices"]
    figure = Figure(figsize=(11.5, 7.4), layout="constrained")
    panels = figure.subplots(1, 2)
    for axes, number, scale, label in zip(panels, ("response.shear_to_force_ratio", "sliding.sliding_coupled"), (1, 1e3), ("F_T / P", "S as a whole on its ground (mm)"), strict=True):
        centre = scale * now["tornado"][""][number]
        known = {name: [scale * end if end is not None else centre for end in value[number]] for name, value in rows.items()}
        bars(axes, centre, known, label)
    figure.suptitle("The designer's section, one at a time: red the first value, blue the second", fontsize=10)
    return figure


def of_flume(said):
    """Slip after five waves by each way, beside the interval."""
    ways, interval = said["flume"]["ways"], said["flume"]["interval"]
    figure = Figure(figsize=(7.6, 3.2), layout="constrained")
    axes = figure.add_subplot()
    names = list(ways)[::-1]
    axes.axvspan(1e3 * interval[0], 1e3 * interval[1], color="#27408b", alpha=0.1, lw=0)
    axes.plot([1e3 * max(ways[name], 2e-5) for name in names], range(len(names)), "o", color="#27408b", ms=6)
    for place, name in enumerate(names):
        axes.annotate("none" if ways[name] == 0 else f"{1e3 * ways[name]:.1f}", (1e3 * max(ways[name], 2e-5), place), xytext=(6, 3), textcoords="offset points", fontsize=8)
    axes.set_yticks(range(len(names)), names, fontsize=8)
    axes.set(xscale="log", xlim=(0.015, 100), ylim=(-0.6, len(names) - 0.3), xlabel="slip after five waves (mm); shaded: the predicted 90 %")
    axes.grid(axis="x", alpha=0.3)
    return figure
