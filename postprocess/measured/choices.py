"""Choices of the model, one at a time: for F_T/P and S of the designer's section, a first frequency, and the pore pressure in a column of sand."""

import dataclasses

import numpy as np

from . import column, parapet
from .column_theory import quasi_static, with_inertia
from .runs import run, side_by_side
from .tornado import CASE, FIXED, READ

SOFT = {"reference_strain": 1e-3}  # of sand and rubble, Hardin and Drnevich
SOFTER = {f"regions.{name}.strain": SOFT for name in ("mound", "seabed")}
OF_SLIP = {
    "soil: softer by its strain, or linear": SOFTER,
    "soil: it yields along that curve, or linear": SOFTER | {f"regions.{name}.law": "hysteretic" for name in ("mound", "seabed")},
    "slip: node by node, or as a whole": {"regions.caisson.interface": {"kind": "friction"}},
    "drag of the sliding caisson: 120 kN s/m2, or none": {"sliding.drag": 1.2e5},  # long waves that it sends out on both sides, 2 rho h' (g h)^(1/2)
}
OF_FREQUENCY = {  # keys, and their values at both ends
    "water in the mound: Darcy, or with inertia": ("regions.mound.flow", "darcy", "inertial"),
    "k of the rubble, 0.05 to 0.8 m/s": ("regions.mound.hydraulic_conductivity", 0.05, 0.8),
    "air in the sand, 2 to 0 %": ("regions.seabed.saturation", 0.98, 1.0),
    "nu of the sand, 0.25 to 0.45": ("regions.seabed.poissons_ratio", 0.25, 0.45),
    "under the sand: rock without end, or rigid": ("boundaries.base.displacement", "absorbing", "fixed"),
    "damping of the soil, 2 to 10 %": ("regions.seabed.damping.ratio", 0.02, 0.10),
    "a stroke of 1 s, or of 0.05 s": ("loads.knock.pulse.duration", 1.0, 0.05),
}
GAS = 1.4  # of air that is compressed without exchange of heat
GRAIN, PRESSURE, VISCOSITY = 2e-4, 1e4, 1e-6  # m, Pa, m2/s: d of the sand and p_0, for the drag


def numbers_of(summary):
    """F_T/P, and S: node by node where it is solved so, else as a whole where the ground is linear, else by eq. (4)."""
    sliding, contact = summary["sliding"], summary["contact"]
    slip = contact["solved"]["slip"] if contact else sliding["sliding_coupled"]
    return {"ratio": summary["response"]["shear_to_force_ratio"], "slip": sliding["sliding_history"] if slip is None else slip, "by_history": sliding["sliding_history"]}


def of_slip(program, folder):
    """{choice: {number: [with it, central]}} as tornado.predict gives, and S by eq. (4) on the bonded F_T(t)."""
    central = numbers_of(run(program, CASE, FIXED, folder / "central"))
    found = {}
    for name, keys in OF_SLIP.items():
        here = numbers_of(run(program, CASE, FIXED | keys, folder / "choice"))
        slip = central["slip"] * here["by_history"] / central["by_history"] if "sliding.drag" in keys else here["slip"]  # eq. (4) alone has drag
        found[name] = {READ[0]: [here["ratio"], central["ratio"]], READ[1]: [slip, central["slip"]]}
    found["S: by eq. (4) on F_T(t), or on ground that answers"] = {READ[0]: [central["ratio"]] * 2, READ[1]: [central["by_history"], central["slip"]]}
    return found


def of_frequency(program, folder):
    base = parapet.keys_of(parapet.CENTRAL, False)
    runs = [base | {key: value} for key, *ends in OF_FREQUENCY.values() for value in ends]
    values = side_by_side(lambda number, keys: parapet.frequency(program, keys, folder / f"choice{number}"), runs)
    return {name: values[2 * place : 2 * place + 2] for place, name in enumerate(OF_FREQUENCY)}


def drag_share(soil):
    """Share of the resistance that grows with velocity, by Ergun's equation (1952), at the velocity that p_0 makes where pressure diffuses."""
    c = soil.mobility / (soil.storage + 1 / soil.oedometric)
    velocity = soil.mobility * PRESSURE / np.sqrt(c * column.PERIOD / np.pi)
    return 1.75 * velocity * GRAIN / VISCOSITY / (150 * (1 - soil.porosity))


def of_pore_pressure():
    soil = column.soil_of(column.keys_of(0.99, {}))

    def ratio(form=with_inertia, height=column.HEIGHT, **changed):
        return float(np.abs(form(dataclasses.replace(soil, **changed), height, column.PERIOD, np.zeros(1)))[0])

    top, base = (soil.absolute_pressure + sign * 1000 * 9.81 * column.HEIGHT / 2 for sign in (-1, 1))
    return {
        "air at the pressure of the top, or of the base": [ratio(absolute_pressure=top), ratio(absolute_pressure=base)],
        "air keeps its heat, or its temperature": [ratio(absolute_pressure=GAS * soil.absolute_pressure), ratio()],
        "depth of the sand, 1.6 to 2.0 m": [ratio(height=1.6), ratio(height=2.0)],
        "porosity, 0.40 to 0.45": [ratio(porosity=0.40), ratio(porosity=0.45)],
        "nu, 0.25 to 0.35": [ratio(poissons_ratio=0.25), ratio(poissons_ratio=0.35)],
        "without mass, or with it": [ratio(quasi_static), ratio()],
        "drag that grows with velocity, or none": [ratio(conductivity=soil.conductivity / (1 + drag_share(soil))), ratio()],
    }
