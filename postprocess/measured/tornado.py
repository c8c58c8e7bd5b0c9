"""How much each assumed input and each choice of the model moves F_T/P and S of the designer's section, one at a time: a study."""

import csv
import subprocess

from .runs import CASES, toml

CASE = CASES.parent / "designer/section.toml"
FIXED = {"regions.caisson.interface.kind": "bonded", "mesh.parameters.cells": 0.7}  # seconds; S as a whole on its ground
SPREADS = {  # name: (key, low, central, high) of all keys that go together
    "G of the mound, 40 to 160 MPa": [("regions.mound.shear_modulus", 40e6, 80e6, 160e6)],
    "G of the sand, 20 to 80 MPa": [("regions.seabed.shear_modulus", 20e6, 40e6, 80e6)],
    "G of the clay, 30 to 120 MPa": [("regions.subsoil.shear_modulus", 30e6, 60e6, 120e6)],
    "nu of the mound, 0.25 to 0.35": [("regions.mound.poissons_ratio", 0.25, 0.30, 0.35)],
    "k of the mound, 0.05 to 0.8 m/s": [("regions.mound.hydraulic_conductivity", 0.05, 0.2, 0.8)],
    "k of the sand, 1e-5 to 1e-3 m/s": [("regions.seabed.hydraulic_conductivity", 1e-5, 1e-4, 1e-3)],
    "air in the sand, 2 to 0 %": [("regions.seabed.saturation", 0.98, 1.0, 1.0)],
    "damping of the mound, 2 to 10 %": [("regions.mound.damping.ratio", 0.02, 0.05, 0.10)],
    "density of the caisson, 1950 to 2250 kg/m3": [
        ("regions.caisson.density", 1950.0, 2100.0, 2250.0),
        *((f"{table}.submerged_weight", 5.089e6, 5.589e6, 6.089e6) for table in ("sliding", "section")),
        ("section.weight", 6.504e6, 7.004e6, 7.504e6),
    ],
    "depth of the sand, 4 to 16 m": [("mesh.parameters.seabed_depth", 4.0, 8.0, 16.0)],
    "peak of P, +- 20 %": [("loads.wave.pulse.peak", 3.2e6, 4.0e6, 4.8e6)],
    "duration of the impulse, 0.2 to 0.5 s": [("loads.wave.pulse.duration", 0.2, 0.3, 0.5)],
    "slow part, 0.2 to 0.4 of the peak": [("loads.wave.pulse.plateau", 0.2, 0.3, 0.4)],
    "friction, 0.5 to 0.7": [("sliding.friction", 0.5, 0.6, 0.7), ("section.friction", 0.5, 0.6, 0.7)],
    "uplift, 0.5 to 1.5 of Goda's": [("sliding.uplift.peak", 332e3, 665e3, 998e3)],
    "uplift in phase or held": [("sliding.uplift.shape", "in_phase", "held", "held")],
    "water in the mound: Darcy or with inertia": [("regions.mound.flow", "darcy", "auto", "inertial")],
    "P measured on the moving wall or not": [("loads.wave.measured_on_wall", True, False, False)],
    "sea on both sides: soft or stiff (K_f 0.5 to 2.2 GPa)": [("fluid.bulk_modulus", 0.5e9, 2.2e9, 2.2e9)],
}
READ = ("response.shear_to_force_ratio", "sliding.sliding_coupled")


def study(folder):
    """A study of pairs: all central, then each at its low and its high value."""
    lines = ['title = "One at a time"', f"case = {toml(str(CASE))}", 'sample = "paired"', f"read = {toml(list(READ))}", "", "[set]"]
    lines += [f'"{key}" = {toml(value)}' for key, value in FIXED.items()]
    for name, keys in SPREADS.items():
        for key, low, central, high in keys:
            values = [central]
            for other in SPREADS:
                values += [low, high] if other == name else [central, central]
            lines += ["", f'[vary."{key}"]', f"values = [{', '.join(toml(value) for value in values)}]"]
    path = folder / "one-at-a-time.toml"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def predict(program, folder):
    """{name: {number: [low, high]}}, and the central values under ''."""
    done = subprocess.run([program, "study", study(folder), "--jobs", "2", "--out", folder / "out"], capture_output=True, text=True, check=False)
    with open(folder / "out/study.csv", encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    column = {number: next(name for name in table[0] if name.startswith(number)) for number in READ}
    values = [{number: float(row[column[number]]) if row[column[number]] else None for number in READ} for row in table]
    assert done.returncode in (0, 2, 3), done.stderr
    found = {"": values[0]}
    for place, name in enumerate(SPREADS):
        found[name] = {number: [values[1 + 2 * place][number], values[2 + 2 * place][number]] for number in READ}
    return found
