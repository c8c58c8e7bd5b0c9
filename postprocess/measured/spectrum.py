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


THEIRS = {"saturation": 0.90, "conductivity": 7.6e-4, "depth": 1.8}  # with which their theory meets all four sensors at all frequencies
WITHIN = 0.10  # relative root-mean-square error of that, as they say


def own_decay(depth, period, below):
    """Share of the variance that waves of this length lose by themselves at a depth below the bed: 1 - exp(-2 k z), w^2 = g k tanh(k h)."""
    square = (2 * np.pi / period) ** 2 / 9.81
    k = square
    for _ in range(200):
        k = (k + square / np.tanh(k * depth)) / 2
    return 1 - float(np.exp(-2 * k * below))


def against_theirs(program, folder):
    """Predicted before the storm over their theory with their S and k, and what the waves' own decay explains of the loss in 50 cm."""
    point = CENTRAL | {"growth": 0.0}
    soil = soil_of(point, THEIRS["conductivity"], THEIRS["saturation"], THEIRS["depth"])
    ours, ratios, lags = numbers(central()), [], []
    for frequency in FREQUENCIES:
        for place, pair in PLACES.items():
            theirs, here = passed(soil, frequency, *pair), ours[f"before the storm, 2 m, {frequency} Hz, {place}"]
            ratios.append(here[0] / theirs[0])
            lags.append(here[1] / theirs[1])
    lost = 1 - passed(soil, 0.1, 0.0, 0.5)[0]
    return {"variance": float(np.mean(ratios)), "lag": float(np.mean(lags)), "own share": own_decay(THEIRS["depth"], 10.0, 0.5) / lost,
            "lags": [ours[f"before the storm, 2 m, {f} Hz, {p}"][1] for f in FREQUENCIES for p in PLACES]}  # fmt: skip
