"""Case C: p/p0 over the depth of a column of sand for several degrees of saturation."""

from pathlib import Path

import h5py
import numpy as np

from .column_theory import Soil, quasi_static, with_inertia
from .runs import CASES, design, interval, run, side_by_side

CASE = CASES / "column/column.toml"
HEIGHT = 1.8
DEPTHS = {"z02": 0.2, "z04": 0.4, "z06": 0.6, "z09": 0.9, "z12": 1.2, "z18": 1.8}
SATURATIONS = (0.90, 0.95, 0.975, 0.99, 0.996, 1.0)
PERIOD, LEVEL = 9.0, 2.0  # s; m of still water above the base
SPREADS = {  # what is assumed, or given without a scatter
    "period": (5.0, 15.0, "log"),
    "conductivity": (0.8, 1.25, "log"),
    "shear_modulus": (0.8, 1.25, "log"),
    "level": (1.8, 3.0, "linear"),
    "saturation": (-0.003, 0.003, "linear"),
}
POINTS = 24
CYCLES = 40


def amplitude(time, values, period):
    """Amplitude and lag (degrees behind sin(w t)) over the last five periods, by least squares."""
    last = time > time[-1] - 5 * period
    w = 2 * np.pi / period
    basis = np.column_stack([np.sin(w * time[last]), np.cos(w * time[last]), np.ones(last.sum())])
    sine, cosine, _ = np.linalg.lstsq(basis, values[last], rcond=None)[0]
    return float(np.hypot(sine, cosine)), float(np.degrees(np.arctan2(-cosine, sine)))


def keys_of(saturation, point):
    period = point.get("period", PERIOD)
    saturation = min(1.0, saturation + point.get("saturation", 0.0) * (saturation < 1))
    return {
        "regions.soil.saturation": saturation,
        "regions.soil.hydraulic_conductivity": 1.8e-4 * point.get("conductivity", 1.0),
        "regions.soil.shear_modulus": 12.7e6 * point.get("shear_modulus", 1.0),
        "initial.water_level": point.get("level", LEVEL),
        "loads.wave.pulse.frequency": 1 / period,
        "time.end": CYCLES * period,
        "time.step": period / 100,
    }


def computed(program, keys, folder):
    """{probe: (|p|/p0, lag in degrees)} by the program."""
    run(program, CASE, keys, folder)
    period = 1 / keys["loads.wave.pulse.frequency"]
    with h5py.File(Path(folder) / "results.h5") as file:
        time = file["history/time"][:]
        return {name: amplitude(time, file[f"history/probes/{name}/pressure"][:], period) for name in DEPTHS}


def soil_of(keys):
    absolute = 101325 + 1000 * 9.81 * (keys["initial.water_level"] - HEIGHT / 2)
    return Soil(keys["regions.soil.shear_modulus"], 0.3, 0.425, keys["regions.soil.hydraulic_conductivity"], keys["regions.soil.saturation"], absolute)


def theory(keys, form=with_inertia):
    """The same by the closed form."""
    heights = HEIGHT - np.array(list(DEPTHS.values()))
    found = form(soil_of(keys), HEIGHT, 1 / keys["loads.wave.pulse.frequency"], heights)
    return {name: (float(abs(p)), float(-np.degrees(np.angle(p)))) for name, p in zip(DEPTHS, found, strict=True)}


def worst(program, folder):
    """Largest difference of |p|/p0 to theory over it, with and without inertia, at each saturation."""
    rows = {}
    for saturation in SATURATIONS:
        keys = keys_of(saturation, {})
        found = computed(program, keys, Path(folder) / f"theory-{saturation}")
        rows[str(saturation)] = [max(abs(found[name][0] / exact[name][0] - 1) for name in DEPTHS) for exact in (theory(keys), theory(keys, quasi_static))]
    return rows


def predict(program, folder):
    """{saturation: {depth: {ratio, interval, lag}}}"""
    points = [{}, *design(SPREADS, POINTS)]
    prediction = {}
    for saturation in SATURATIONS:
        all_keys = [keys_of(saturation, point) for point in points]
        found = side_by_side(lambda number, keys: computed(program, keys, Path(folder) / f"column-{number}"), all_keys)
        prediction[str(saturation)] = {
            str(depth): {"ratio": found[0][name][0], "interval": interval([one[name][0] for one in found]), "lag": found[0][name][1]}
            for name, depth in DEPTHS.items()
        }
    return prediction
