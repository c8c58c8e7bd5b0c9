"""Whether a reduced model is that of the scene of a run: all keys that determine its response are compared, without
the waves."""

import tomllib

import numpy as np

from ..h5 import open_h5
from ..results import text_of

SCENE = ("gravity", "fluid", "mesh", "regions", "boundaries", "initial", "sliding")
OF_WAVE = ("pulse", "history", "factor", "wave")  # keys that the user of a page sets


def case_of(path):
    """The case of a model, with all defaults, as a dict."""
    with open_h5(path) as file:
        return case_in(file)


def case_in(file):
    """The same for an open file; empty for lumped models."""
    return tomllib.loads(text_of(np.asarray(file["case"][()]).flat[0]))


def scene_of(case):
    loads = {name: {key: value for key, value in load.items() if key not in OF_WAVE} for name, load in case.get("loads", {}).items()}
    return {**{key: case.get(key) for key in SCENE}, "loads": loads}


def of_same_scene(path, case):
    """Whether the model is of the scene of the case; False also for a file that is no reduced model."""
    try:
        return scene_of(case_of(path)) == scene_of(case)
    except (OSError, KeyError, ValueError, AttributeError):
        return False
