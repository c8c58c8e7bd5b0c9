"""Case O: how much a parapet lowers the first natural frequency of a caisson of full scale."""

from pathlib import Path

from .runs import CASES, design, interval, run, side_by_side

CASE = CASES / "parapet/parapet.toml"
CENTRAL = {
    "width": 16.0,
    "slenderness": 13 / 16,
    "freeboard": 3.5,
    "mound": 5.0,
    "sand": 12.0,
    "sand_modulus": 80e6,
    "rubble_modulus": 150e6,
    "density": 2050.0,
    "parapet_height": 4.0,
    "parapet_share": 1 / 3,
}
SPREADS = {
    "width": (12.0, 22.0, "linear"),
    "slenderness": (0.65, 1.05, "linear"),  # height over width
    "freeboard": (2.0, 5.0, "linear"),
    "mound": (2.0, 10.0, "log"),
    "sand": (5.0, 25.0, "log"),
    "sand_modulus": (30e6, 150e6, "log"),
    "rubble_modulus": (60e6, 300e6, "log"),
    "density": (1900.0, 2200.0, "linear"),
    "parapet_height": (3.5, 4.5, "linear"),
    "parapet_share": (0.25, 0.40, "linear"),
}
CONCRETE = 2300.0
POINTS = 32


def body(point, parapet):
    """Mass, centre of gravity (x from the middle, z above the bottom) and moment of inertia about it."""
    width, height = point["width"], point["width"] * point["slenderness"]
    parts = [(width, height, 0.0, height / 2, point["density"])]
    if parapet:
        share, top = point["parapet_share"] * width, point["parapet_height"]
        parts.append((share, top, (share - width) / 2, height + top / 2, CONCRETE))
    mass = sum(b * h * rho for b, h, _, _, rho in parts)
    x = sum(b * h * rho * at for b, h, at, _, rho in parts) / mass
    z = sum(b * h * rho * at for b, h, _, at, rho in parts) / mass
    inertia = sum(b * h * rho * ((b**2 + h**2) / 12 + (at - x) ** 2 + (up - z) ** 2) for b, h, at, up, rho in parts)
    return mass, x, z, inertia


def keys_of(point, parapet):
    mass, x, z, inertia = body(point, parapet)
    width, mound = point["width"], point["mound"]
    height = width * point["slenderness"]
    parameters = {
        "seabed_depth": point["sand"],
        "mound_height": mound,
        "mound_crest_front": width / 2 + 9,
        "mound_crest_back": width / 2 + 7,
        "caisson_width": width,
        "caisson_height": height,
        "water_depth": mound + height - point["freeboard"],
    }
    return {f"mesh.parameters.{key}": value for key, value in parameters.items()} | {
        "regions.seabed.shear_modulus": point["sand_modulus"],
        "regions.mound.shear_modulus": point["rubble_modulus"],
        "regions.caisson": {"kind": "rigid", "mass": mass, "centre_of_gravity": [x, mound + z], "moment_of_inertia": inertia},
        "loads.knock.at": [0.0, mound + height],
    }


def as_part(point):
    """The parapet as a part of the caisson, with its wall in the mesh."""
    width, height, mound = point["width"], point["width"] * point["slenderness"], point["mound"]
    share, top = point["parapet_share"] * width, point["parapet_height"]
    keys = keys_of(point, False)
    rectangle = {"x": [-width / 2, share - width / 2], "y": [mound + height, mound + height + top], "density": CONCRETE}
    return keys | {"mesh.parameters.parapet_width": share, "mesh.parameters.parapet_height": top,
                   "regions.caisson": {"kind": "rigid", "density": point["density"], "parts": {"parapet": rectangle}}}  # fmt: skip


def frequency(program, keys, folder):
    """The lowest one of all modes that take a quarter of the largest part in F_T: what a vibration test sees as the first peak."""
    modes = run(program, CASE, keys, folder)["periods"]
    return 1 / max(mode["period"] for mode in modes if mode["share"] > modes[0]["share"] / 4)


def change(program, point, folder):
    """Frequency without the parapet (Hz), and its change by the parapet (per cent)."""
    without, with_it = (frequency(program, keys_of(point, parapet), Path(folder) / f"parapet-{parapet}") for parapet in (False, True))
    return without, 100 * (with_it / without - 1)


def predict(program, folder):
    points = [CENTRAL, *(CENTRAL | point for point in design(SPREADS, POINTS))]
    found = side_by_side(lambda number, point: change(program, point, Path(folder) / str(number)), points)
    changes = [percent for _, percent in found]
    return {"frequency": found[0][0], "change": changes[0], "interval": interval(changes), "frequencies": interval([f for f, _ in found]),
            "points": [[*found_at] for found_at in found]}
