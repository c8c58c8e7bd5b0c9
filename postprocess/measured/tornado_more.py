"""One at a time, for E of nine years, the first frequency of a caisson and the pore pressure at the base of a column of sand."""

import json
import subprocess
import tomllib

import numpy as np

from . import choices, column, parapet
from .column_theory import with_inertia
from .runs import CASES, side_by_side, toml

LIFE = CASES.parent / "section4/hd10.toml"
LIFE_SPREADS = {  # name: keys, and their values at both ends
    "friction, 0.55 to 0.65": [("section.friction", 0.55, 0.65)],
    "W' and W, -5 to +5 %": [("section.submerged_weight", 0.95, 1.05), ("section.weight", 0.95, 1.05)],
    "highest wave: 1.8 H_1/3 or no limit": [("sea.highest", 1.8, "none")],
    "law: eq. (7) or with added mass": [("life.sliding", "paper", "combined")],
    "uplift, 0.8 to 1.2 of Goda's": [("section.lambda_3", 0.8, 1.2)],
    "a of k(alpha*), 0.2 to 0.4": [("duration.a", 0.2, 0.4)],
    "b of k(alpha*), 1.6 to 2.4": [("duration.b", 1.6, 2.4)],
    "berm in front, 6 to 12 m": [("section.berm_width", 6.0, 12.0)],
    "slope of the bed, 1/200 to 1/50": [("section.bed_slope", 0.005, 0.02)],
    "P, 0.65 to 1.15 of Goda's": [("section.lambda_1", 0.65, 1.15), ("section.lambda_2", 0.65, 1.15), ("section.lambda_3", 1.0, 1.0)],  # measured: 0.90 with a scatter of 0.25
    "still water, 1 m lower to 1 m higher": [
        ("section.water_depth", 21.0, 23.0),
        ("section.foundation_depth", 12.0, 14.0),
        ("section.berm_depth", 10.5, 12.5),
        ("section.crest", 11.0, 9.0),
        ("section.submerged_weight", 1 + 181.9e3 / 4.115817e6, 1 - 181.9e3 / 4.115817e6),  # rho_w g B times 1 m
    ],
}
FREQUENCY_WORDS = {
    "width": "width, 12 to 22 m, as high over it",
    "slenderness": "height over width, 0.65 to 1.05",
    "freeboard": "crest above the water, 2 to 5 m",
    "mound": "mound, 2 to 10 m",
    "sand": "sand on rock, 5 to 25 m",
    "sand_modulus": "G of the sand, 30 to 150 MPa",
    "rubble_modulus": "G of the rubble, 60 to 300 MPa",
    "density": "density, 1900 to 2200 kg/m3",
}
PORE_WORDS = {
    "period": "period, 5 to 15 s",
    "conductivity": "k, 0.8 to 1.25 of it",
    "shear_modulus": "G, 0.8 to 1.25 of it",
    "level": "still water above the base, 1.8 to 3 m",
    "saturation": "air, 1.3 to 0.7 %",
}
SCALED = ("section.submerged_weight", "section.weight")


def life(program, folder, keys):
    """E (m) by the exact law, or by another one that is asked for."""
    law = dict(keys).pop("life.sliding", "exact")
    words = [word for key, value in keys.items() if key != "life.sliding" for word in ("--set", f"{key}={toml(value)}")]
    done = subprocess.run([program, "expected", LIFE, *words, "--out", folder, "--json"], capture_output=True, text=True, check=False)
    return json.loads(done.stdout)["expected"][f"distance_{law}"]


def of_life(program, folder):
    base = tomllib.loads(LIFE.read_text(encoding="utf-8"))["section"]
    found = {"": life(program, folder / "life", {})}
    for name, keys in LIFE_SPREADS.items():
        ends = [{key: pair[end] * base[key.split(".")[1]] if key in SCALED else pair[end] for key, *pair in keys} for end in (0, 1)]
        found[name] = [life(program, folder / "life", keys_of_end) for keys_of_end in ends]
    return found


def of_frequency(program, folder):
    """First frequency (Hz) of the caisson of case O without its parapet."""
    names = [name for name in parapet.SPREADS if not name.startswith("parapet")]
    points = [parapet.CENTRAL, *(parapet.CENTRAL | {name: parapet.SPREADS[name][end]} for name in names for end in (0, 1))]
    values = side_by_side(lambda number, point: parapet.frequency(program, parapet.keys_of(point, False), folder / f"f{number}"), points)
    return {"": values[0]} | {FREQUENCY_WORDS[name]: values[1 + 2 * place : 3 + 2 * place] for place, name in enumerate(names)}


def of_pore_pressure():
    """|p|/p_0 at the base of case C with 1 % of air, by the closed form that the program keeps to."""

    def ratio(point):
        keys = column.keys_of(0.99, point)
        return float(np.abs(with_inertia(column.soil_of(keys), column.HEIGHT, 1 / keys["loads.wave.pulse.frequency"], np.zeros(1)))[0])

    return {"": ratio({})} | {PORE_WORDS[name]: [ratio({name: spread[end]}) for end in (0, 1)] for name, spread in column.SPREADS.items()}


def all_of(program, folder):
    frequency, pressure = of_frequency(program, folder) | choices.of_frequency(program, folder), of_pore_pressure() | choices.of_pore_pressure()
    return {"E": of_life(program, folder), "frequency": frequency, "pore pressure": pressure}
