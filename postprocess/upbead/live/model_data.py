"""The numbers of a reduced model that a page needs: JSON, arrays as doubles in base64."""

import base64

import numpy as np

from ..errors import ModelError
from ..h5 import open_h5
from ..reduced_model import ReducedModel
from ..results import text_of
from .case_wave import case_wave
from .scene import case_in

# Readings from which `upbead respond` takes P and F_T, and those of the forces on the bottom.
NEEDED = ("force", "shear_force")
OF_BASE = ("normal_force", "base_moment", "uplift", "uplift_moment")
UPLIFTS = ("none", "in_phase", "held", "computed", "history")


def model_data(path):
    """The data of live/respond.js as a dict; raises ModelError if the file is no reduced model of a caisson."""
    model = ReducedModel(path)
    missing = [name for name in NEEDED if name not in model.readings]
    if missing:
        raise ModelError(f"'{path}' has no reading '{missing[0]}': its mesh has no surface 'caisson'; reduce a case with one")
    with open_h5(path) as file:
        if "still_water" in file:
            raise ModelError(f"'{path}' has still water at two levels, and a page knows one: use 'upbead respond'")
        case, loads = file["case"].attrs, file["loads"]
        names, units = ([text_of(text) for text in loads[key][()]] for key in ("name", "unit"))
        numbers = zip(names, units, loads["peak"][()].tolist(), loads["duration"][()].tolist())
        return {
            "title": model.title,
            "warnings": model.warnings,
            "loads": [{**dict(zip(("name", "unit", "peak", "duration"), row)), "pulse": pulse_of(file, row[0])} for row in numbers],
            "validity": {key: float(value) for key, value in file["validity"].attrs.items()},
            "mass": float(case["caisson_mass"]),
            "end": float(case["end"]),
            "sliding": sliding_of(file),
            "base": base_of(file, model),
            "slips": "slip" in file,
            "contact": "contact" in file,
            "limits": {key: value for key, value in case_in(file).get("limits", {}).items() if isinstance(value, (int, float))},
            "wave": case_wave(case_in(file), names),
            "modes": modes_of(model, [name for name in NEEDED + OF_BASE if name in model.readings]),
            "circles": circles_of(file),
            "nested": model.nested and [modes_of(larger, ["shear_force"]) for larger in model.nested],
        }


def pulse_of(file, load):
    """The pulse of a load in the case, or None: the load may be a record or a wave."""
    return case_in(file).get("loads", {}).get(load, {}).get("pulse")


def sliding_of(file):
    """Table [sliding] of the case, or None."""
    if "sliding" not in file:
        return None
    given = file["sliding"].attrs
    uplift = text_of(given["uplift"])
    if uplift not in UPLIFTS:
        raise ModelError(f"the model's uplift '{uplift}' is none of {', '.join(UPLIFTS)}; make it again with 'upbead reduce'")
    numbers = {"friction": "friction", "weight": "buoyant_weight", "drag": "drag", "uplift_per_force": "uplift_per_force", "lag": "lag"}
    return {"uplift": uplift, **{key: float(given[name]) for key, name in numbers.items()}}


def base_of(file, model):
    """The forces on the bottom at rest, or None."""
    if "base" not in file:
        return None
    return {**dict(zip(("width", "weight", "weight_moment", "uplift_moment_per_force"), file["base"][()].tolist())), "upright": upright_of(file, model)}


def upright_of(file, model):
    """[downward force, moment] on the caisson per unit of each load that acts up or down alone, zeros of others, as
    src/respond/respond_waves.cc has it; None where there is one whose moment the file does not tell."""
    row = lambda name: model.feedthrough[model.readings.index(name)] if name in model.readings else np.zeros(len(model.loads))
    up, along = row("force_vertical"), row("force")
    upright = (up != 0) & (np.abs(along) <= 1e-9 * np.abs(up))
    if upright.any() and "loads/moment" not in file:
        return None
    moment = file["loads/moment"][()] if "loads/moment" in file else np.zeros(len(up))
    return np.column_stack([np.where(upright, -up, 0.0), np.where(upright, moment, 0.0)]).tolist()


def circles_of(file):
    """The slip circles, with their readings in the modes of the model, or None."""
    if "circles" not in file:
        return None
    group = file["circles"]
    if not np.array_equal(group["pole"][()], file["modes/pole"][()]) or not np.array_equal(group["load"][()], file["modes/load"][()]):
        raise ModelError("the slip circles of the model have other modes than it has; make it again with 'upbead reduce'")
    names = ("circle", "slice", "reading", "feedthrough", "impulse")
    return {"base": group["base"][()].tolist(), **{name: doubles(group[name][()]) for name in names}}


def modes_of(model, names):
    at = {name: model.readings.index(name) for name in names}
    return {
        "count": int(model.pole.size),
        "load_count": len(model.loads),
        "pole": doubles(model.pole),
        "load": doubles(model.load),
        "readings": {
            name: {
                "weight": doubles(model.reading[i]),
                "feedthrough": doubles(model.feedthrough[i]),
                "impulse": doubles(model.impulse[i]),
            }
            for name, i in at.items()
        },
    }


def doubles(values):
    """Complex numbers as pairs."""
    values = np.ascontiguousarray(values)
    kind = np.complex128 if np.iscomplexobj(values) else np.float64
    return base64.b64encode(values.astype(kind).view(np.float64).astype("<f8").tobytes()).decode()
