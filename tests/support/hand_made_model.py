"""A reduced model made by hand: a caisson on a spring and a dashpot, and a mode without physical meaning."""

import h5py
import numpy as np


def pairs(values):
    values = np.asarray(values, dtype=complex)
    return np.stack([values.real, values.imag], axis=-1)


def write_oscillator(path, loads=("impact",), mass=604.8e3, frequency=2.0, ratio=0.15, highest=50.0, tolerance=0.01,
                     nested=(1.0, 1.0)):
    """Every load is a force P on the caisson, in N/m. `nested`: F_T of the middle and the reference model over that
    of the model; None: a file of an older version. Texts have variable length, as other programs write HDF5."""
    rate = 2 * np.pi * frequency
    pole = -ratio * rate + 1j * rate * np.sqrt(1 - ratio**2)
    x = -1j / ((mass or 1.0) * pole.imag)  # a model without a caisson has no mass
    shear = (mass or 1.0) * (rate**2 + 2 * ratio * rate * pole) * x
    n = len(loads)
    with h5py.File(path, "w") as file:
        file.attrs.update(title="oscillator", program="by hand", kind="upbead reduced model", format_version=1)
        file["case"] = 'title = "oscillator"\n'
        file["case"].attrs.update(caisson_mass=mass, end=4.0, unknowns=3, solves=10, factorisations=2)
        file["loads/name"], file["loads/unit"] = list(loads), ["N/m"] * n
        file["loads/peak"], file["loads/duration"] = np.full(n, 1e6), np.full(n, 0.15)
        file["readings/name"] = ["force", "shear_force", "caisson/displacement_x"]
        file["readings/unit"] = ["N/m", "N/m", "m"]
        file["readings/description"] = ["P", "F_T", "x_G"]
        file["modes/pole"] = pairs([pole, -60 + 200j])
        file["modes/load"] = pairs(np.ones((2, n)))
        file["modes/reading"] = pairs([[0, 0], [shear, 0.5 - 1j], [x, 0]])
        file["modes/feedthrough"] = np.outer([1.0, 0.0, 0.0], np.ones(n))
        file["modes/impulse"] = np.zeros((3, n))
        for name, factor in zip(("middle", "reference"), nested or ()):
            for part in ("pole", "load"):
                file[f"nested/{name}/{part}"] = file[f"modes/{part}"][()]
            for part in ("reading", "feedthrough", "impulse"):
                file[f"nested/{name}/{part}"] = factor * file[f"modes/{part}"][1:2]
        if nested:
            file["nested"].attrs.update(solves=30, factorisations=3)
        validity = file.create_group("validity")
        validity.attrs.update(highest_frequency=highest, tolerance=tolerance, error=0.004, error_peak=0.003)
