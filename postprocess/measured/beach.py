"""Guest and Hay (2017): waves of 0.1 Hz 50 cm below the surface of a beach, over those 15 cm below it."""

from pathlib import Path

import h5py
import numpy as np

from .column import amplitude
from .runs import CASES, run

CASE = CASES / "beach/beach.toml"
STATES = {  # what they measured: variance ratio, lag (degrees); the same in another place of their text; k (m/s) that they measured, or fitted after the storm
    "before the storm": {"conductivity": 7.6e-4, "ratio": 0.50, "lag": 20.0, "elsewhere": (0.55, 15.0)},
    "after the storm": {"conductivity": 1.9e-4, "ratio": 0.25, "lag": 40.0, "elsewhere": (0.35, 30.0)},
}
PUBLISHED = 0.90  # their saturation, with both values of k


def computed(program, conductivity, saturation, folder):
    """Variance ratio; lag in degrees; lag in radians over -ln of the amplitude ratio."""
    run(program, CASE, {"regions.soil.hydraulic_conductivity": conductivity, "regions.soil.saturation": saturation}, folder)
    with h5py.File(Path(folder) / "results.h5") as file:
        time = file["history/time"][:]
        upper, lower = (amplitude(time, file[f"history/probes/{name}/pressure"][:], 10.0) for name in ("z15", "z50"))
    ratio, lag = (lower[0] / upper[0]) ** 2, lower[1] - upper[1]
    return ratio, lag, shape(ratio, lag)


def shape(ratio, lag):
    """Lag over loss of amplitude: 1 where pressure diffuses with as much loss as lag, whatever k and S are."""
    return float(np.radians(lag) / -np.log(np.sqrt(ratio)))


def published(program, folder):
    """With their own S and k, nothing fitted here."""
    return {state: (PUBLISHED, known["conductivity"], *computed(program, known["conductivity"], PUBLISHED, folder)) for state, known in STATES.items()}


def fitted(program, folder):
    """One number is fitted to the variance ratio of each state, S before the storm and then k after it at that S; the lag is predicted."""
    before, after = STATES.values()
    saturation = where(lambda s: computed(program, before["conductivity"], s, folder)[0], before["ratio"], 0.80, 0.98)
    conductivity = np.exp(where(lambda k: computed(program, float(np.exp(k)), saturation, folder)[0], after["ratio"], np.log(5e-5), np.log(7.6e-4)))
    return {
        "before the storm": (saturation, before["conductivity"], *computed(program, before["conductivity"], saturation, folder)),
        "after the storm": (saturation, float(conductivity), *computed(program, float(conductivity), saturation, folder)),
    }


def where(function, value, low, high, steps=12):
    """Argument at which a growing function has a value, by bisection."""
    for _ in range(steps):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) < value else (low, middle)
    return (low + high) / 2
