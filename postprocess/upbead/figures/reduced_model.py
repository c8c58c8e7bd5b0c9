"""Response of a reduced model: P and F_T of a wave, and |F_T / P| over frequency."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from .style import plain, styled, subplots

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

    from ..reduced_model import ReducedModel


@styled
def reduced_model(model: ReducedModel, time: ArrayLike, loads: Mapping[str, ArrayLike], reading: str = "shear_force") -> Figure:
    """Draws a ReducedModel under {load: values} at times (s); reading: the reading drawn with P."""
    answer = model.respond(time, loads)
    figure, (history, spectrum) = subplots(2, 1, figsize=(6.5, 5.5))
    if "force" in answer:
        history.plot(time, answer["force"] / 1e3, color="tab:blue", lw=1.2, label=r"$P$ (kN/m)")
    in_kilo = model.units[reading] == "N/m"
    unit = "kN/m" if in_kilo else model.units[reading]
    symbol = r"$F_T$" if reading == "shear_force" else plain(reading)
    values = answer[reading] / (1e3 if in_kilo else 1.0)
    history.plot(time, values, color="tab:red", lw=1.2, label=f"{symbol} ({unit})")
    history.set_xlabel("time (s)")
    history.legend()
    history.set_title(plain(model.title))
    frequency = np.linspace(0.0, model.validity["highest_frequency"], 1001)[1:]
    for load in loads:
        size = np.abs(model.transfer(reading, load, frequency))
        name = f"{symbol} / {plain(load)}"
        if reading == "shear_force" and "force" in answer:
            force = np.abs(model.transfer("force", load, frequency))
            if not np.all(force > 0):
                continue  # this load does not act on the caisson
            size, name = size / force, f"$F_T / P$, {plain(load)}"
        spectrum.plot(frequency, size, lw=1.2, label=name)
    spectrum.set_xlabel("frequency (Hz), up to the highest that was checked")
    spectrum.set_ylabel(r"$|H(f)|$")
    spectrum.set_ylim(bottom=0.0)
    if spectrum.lines:
        spectrum.legend()
    figure.tight_layout()
    return figure
