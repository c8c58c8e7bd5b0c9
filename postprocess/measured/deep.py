"""The first two natural frequencies of a breakwater in 63 m of water: with its mound, and of the caisson on its mound."""

from pathlib import Path

from .runs import CASES, design, interval, run, side_by_side

CASE = CASES / "deep/deep.toml"
SPREADS = {
    "mesh.parameters.caisson_width": (20.0, 30.0, "linear"),
    "mesh.parameters.seabed_depth": (2.0, 30.0, "log"),
    "regions.seabed.shear_modulus": (60e6, 400e6, "log"),
    "reference": (120e6, 250e6, "log"),
    "exponent": (0.4, 0.6, "linear"),
    "regions.caisson.density": (1900.0, 2200.0, "linear"),
    "mesh.parameters.mound_slope": (1.7, 2.5, "linear"),
}
POINTS = 24


def keys_of(point):
    rest = {key: value for key, value in point.items() if "." in key}
    modulus = {"reference": point["reference"], "exponent": point["exponent"]} if "reference" in point else None
    return rest | ({"regions.mound.shear_modulus": modulus} if modulus else {})


def frequencies(program, keys, folder):
    """The lowest mode that takes a quarter of the largest part in F_T, and the largest one at least 1.3 times as high."""
    modes = run(program, CASE, keys, folder)["periods"]
    first = 1 / max(mode["period"] for mode in modes if mode["share"] > modes[0]["share"] / 4)
    return [first, next((1 / mode["period"] for mode in modes if 1 / mode["period"] > 1.3 * first), None)]


def predict(program, folder):
    points = [{}, *(keys_of(point) for point in design(SPREADS, POINTS))]
    found = side_by_side(lambda number, keys: frequencies(program, keys, Path(folder) / str(number)), points)
    first, second = ([pair[i] for pair in found if pair[i]] for i in (0, 1))
    return {"first": first[0], "first_interval": interval(first), "second": second[0], "second_interval": interval(second), "points": found}
