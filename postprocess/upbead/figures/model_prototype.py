"""Study 1, model against prototype: F_T / P by the peak of P, stiffness, pulse, permeability, mound and caisson."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TYPE_CHECKING

from .style import styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..study_table import StudyTable

SCALES = {"model": (20.0, "tab:blue"), "prototype": (1.0, "tab:red")}
RATIO = "response.shear_to_force_ratio"
PANELS = [  # study, varied key, label of the x axis, power of the length scale by which model and prototype agree
    ("peak", "loads.impulse.factor", "peak of P / that of Fig. 2b", 0),
    ("stiffness", "regions.seabed.shear_modulus.reference", "G of the sand at 98 kPa (MPa)", 0),
    ("rise", "loads.impulse.pulse.rise", "rise / duration", 0.5),
    ("permeability", "regions.mound.hydraulic_conductivity", "k of the rubble, at full scale (m/s)", 0.5),
    ("mound", "mesh.parameters.mound_height", "height of the mound, at full scale (m)", 1),
    ("width", "mesh.parameters.caisson_width", "width of the caisson, at full scale (m)", 1),
]
STUDIES = [study for study, *_ in PANELS] + ["duration"]


@styled
def model_prototype(tables: Mapping[tuple[str, str], StudyTable], spectra: Sequence[Mapping[str, Any]]) -> Figure:
    """tables: {(study, scale): StudyTable} of the studies STUDIES at the scales SCALES.

    spectra: shock spectra of one degree of freedom, [{"zeta", "td_over_Tn", "peak_FT"}].
    """
    figure, axes = subplots(2, 4, figsize=(13, 6.2), layout="constrained")
    draw_duration(axes[0, 2], tables, spectra)
    places = [axes[0, 0], axes[0, 1], axes[0, 3], axes[1, 0], axes[1, 1], axes[1, 2]]
    for axis, panel in zip(places, PANELS):
        draw_panel(axis, tables, panel)
    for axis in axes[:, 0]:
        axis.set_ylabel("peak $F_T$ / peak $P$")
    axes[0, 0].legend()
    axes[1, 3].axis("off")
    return figure


@styled
def model_prototype_panel(tables: Mapping[tuple[str, str], StudyTable], spectra: Sequence[Mapping[str, Any]], study: str) -> Figure:
    """Only one of the studies; arguments as for model_prototype."""
    figure, axis = subplots(figsize=(5.2, 3.6), layout="constrained")
    if study == "duration":
        draw_duration(axis, tables, spectra)
    else:
        draw_panel(axis, tables, next(panel for panel in PANELS if panel[0] == study))
        axis.legend()
    axis.set_ylabel("peak $F_T$ / peak $P$")
    return figure


def draw_panel(axis, tables, panel):
    study, key, label, power = panel
    for scale, (length, colour) in SCALES.items():
        table = tables[study, scale]
        x = table[key] * length**power
        x = x / 0.15 if study == "rise" else x / 1e6 if study == "stiffness" else x
        axis.plot(x, table.sound(RATIO), "o-", ms=3, color=colour, label=scale)
    if study in ("peak", "stiffness", "permeability"):
        axis.set_xscale("log")
    axis.set_xlabel(label)
    axis.set_ylim(bottom=0)


def draw_duration(axis, tables, spectra):
    """F_T / P against pulse duration over the period of an oscillator with the same limit for short pulses."""
    for spectrum in spectra:
        if spectrum["zeta"] in (0.05, 0.2):
            line = "-" if spectrum["zeta"] == 0.05 else "--"
            axis.plot(spectrum["td_over_Tn"], spectrum["peak_FT"], line, color="0.6",
                      label=f"one degree of freedom, {100 * spectrum['zeta']:.0f} %")
    damped = next(s for s in spectra if s["zeta"] == 0.1)
    limit = damped["peak_FT"][0] / damped["td_over_Tn"][0]
    for scale, (_, colour) in SCALES.items():
        table = tables["duration", scale]
        for sea, style in ((6.0, "o-"), (0.0, "x:")):
            rows = table["mesh.parameters.sea_front"] == sea
            td, ratio = table["loads.impulse.pulse.duration"][rows], table.sound(RATIO)[rows]
            period = limit * td[0] / ratio[0]
            axis.plot(td / period, ratio, style, ms=3, color=colour,
                      label=f"{scale}, {'sea' if sea else 'no sea'}, T = {1e3 * period:.3g} ms")
    axis.set_xscale("log")
    axis.set_xlabel("duration of the pulse / T of the impulsive limit")
    axis.legend(fontsize=6)
    axis.set_ylim(bottom=0)
