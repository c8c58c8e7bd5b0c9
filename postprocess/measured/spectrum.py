"""Other frequencies, depths and places of the beach of Guest and Hay (2017), from what is fitted at 0.1 Hz in 2 m of water."""

from pathlib import Path

import h5py
import numpy as np

from . import beach
from .beach import CASE, where
from .column import amplitude
from .column_theory import Soil, with_inertia
from .runs import design, interval, run

HEIGHT = 5.0
FREQUENCIES = (0.05, 0.1, 0.15, 0.2, 0.3)  # Hz
PLACES = {"15 to 30 cm": (0.15, 0.30), "15 to 50 cm": (0.15, 0.50), "30 to 50 cm": (0.30, 0.50)}
DEPTHS = (1.0, 2.0, 3.0)  # m of water, where air has another pressure
FITTED = {"before the storm": ((0.48, 0.57), 7.6e-4), "after the storm": ((0.22, 0.38), 1.9e-4)}  # variance ratio at 0.1 Hz, both readings of the text; k
SPREADS = {"ratio": (0.0, 1.0, "linear"), "conductivity": (0.78, 1.22, "log"), "porosity": (0.164, 0.270, "linear"), "shear_modulus": (1e8, 1e9, "log"), "growth": (0.0, 0.034, "linear")}
POINTS = 24
CENTRAL = {"conductivity": 1.0, "porosity": 0.217, "shear_modulus": 4e8, "growth": 0.016}


def soil_of(point, conductivity, saturation, depth):
    """S grows with depth of water; the air has the pressure of 0.325 m below the bed."""
    absolute = 101325 + 1025 * 9.81 * (depth + 0.325)
    air = min(1.0, saturation + point["growth"] * (depth - 2))
    return Soil(point["shear_modulus"], 0.3, point["porosity"], conductivity * point["conductivity"], air, absolute, 1025.0)


def passed(soil, frequency, upper, lower):
    """Variance ratio and lag in degrees of the lower place over the upper one, by the closed form."""
    one, two = with_inertia(soil, HEIGHT, 1 / frequency, np.array([HEIGHT - upper, HEIGHT - lower]))
    return float(abs(two / one) ** 2), float(np.degrees(np.angle(one / two)))


def fit(point, conductivity, target):
    return where(lambda s: passed(soil_of(point, conductivity, s, 2.0), 0.1, 0.15, 0.50)[0], target, 0.5, 0.9999, 30)


def states(point):
    """Soil of each state: S is fitted to the ratio at 0.1 Hz and 2 m with that state's k."""
    for name, ((low, high), conductivity) in FITTED.items():
        target = point["target"][name] if "target" in point else low + point["ratio"] * (high - low)
        yield name, conductivity, fit(point, conductivity, target)


def numbers(point):
    found = {}
    for name, conductivity, saturation in states(point):
        for frequency in FREQUENCIES:
            for place, pair in PLACES.items():
                found[f"{name}, 2 m, {frequency} Hz, {place}"] = passed(soil_of(point, conductivity, saturation, 2.0), frequency, *pair)
        for depth in DEPTHS:
            found[f"{name}, {depth:g} m, 0.1 Hz, 15 to 50 cm"] = passed(soil_of(point, conductivity, saturation, depth), 0.1, 0.15, 0.50)
    return found


def by_program(program, conductivity, saturation, frequency, folder):
    """The same from a run: variance ratio and lag of 50 cm over 15 cm."""
    keys = {"regions.soil.hydraulic_conductivity": conductivity, "regions.soil.saturation": saturation, "loads.wave.pulse.frequency": frequency,
            "time.end": 30 / frequency, "time.step": 0.01 / frequency}  # fmt: skip
    run(program, CASE, keys, folder)
    with h5py.File(Path(folder) / "results.h5") as file:
        time = file["history/time"][:]
        upper, lower = (amplitude(time, file[f"history/probes/{name}/pressure"][:], 1 / frequency) for name in ("z15", "z50"))
    return (lower[0] / upper[0]) ** 2, (lower[1] - upper[1]) % 360


def central():
    return CENTRAL | {"target": {name: known["ratio"] for name, known in beach.STATES.items()}}


def predict(program, folder):
    """{where: {ratio, lag, and the intervals of both}}; the program beside the closed form."""
    middle, points = numbers(central()), [numbers(point) for point in design(SPREADS, POINTS)]
    found = {
        name: {"ratio": ratio, "lag": lag, "ratio_interval": interval([one[name][0] for one in points]), "lag_interval": interval([one[name][1] for one in points])}
        for name, (ratio, lag) in middle.items()
    }
    found["program"] = {f"{name}, 2 m, {frequency} Hz, 15 to 50 cm": by_program(program, k, s, frequency, folder / "beach") for name, k, s in states(central()) for frequency in FREQUENCIES}
    return found
