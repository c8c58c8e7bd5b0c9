"""The numbers of a design that a page needs: JSON of the input of `upbead waves`, with all defaults."""

import tempfile
import tomllib
from pathlib import Path

from ..commands import written
from ..errors import UserError
from ..results import read_summary

OWN_WAVE = ("height", "significant_height", "deep_water_height", "period", "angle")
MEASURED = ("force", "shear_to_force_ratio", "uplift", "pulse_duration")


def is_design(path):
    """Whether it is a design file, or a folder that `upbead waves` or `upbead expected` wrote without a model in
    it."""
    path = Path(path)
    return path.suffix == ".toml" or (path.is_dir() and not (path / "reduced.h5").exists() and (path / "case.toml").exists())


def effective(path, program=None):
    """((design with all defaults as a dict, the folder that its paths start from), the summary that goes with it)."""
    path = Path(path)
    if path.is_dir():
        return (parsed(path / "case.toml"), path), read_summary(path)
    with tempfile.TemporaryDirectory() as folder:
        written("waves", path, None, folder, program, "")
        design, summary = parsed(Path(folder) / "case.toml"), read_summary(folder)
        if "sea" in design:
            design["sea"]["states"] = str((Path(folder) / design["sea"]["states"]).resolve())
    return (design, path.parent), summary


def states_of(design, folder):
    """The file of its sea states, as a list of one or none."""
    return [Path(folder) / design["sea"]["states"]] if "sea" in design else []


def parsed(file):
    try:
        return tomllib.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise UserError(f"cannot read '{file}': {error.strerror}") from error
    except ValueError as error:
        raise UserError(f"'{file}' is no TOML: {error}; give the folder of 'upbead waves', or the design file") from error


def design_data(design, name):
    """The data of live/design.js as a dict; raises UserError if there is no section or no wave."""
    waves = design.get("waves")
    if "section" not in design or not waves or "duration" not in design:
        raise UserError(f"'{name}' is no design with a section and a wave, as 'upbead waves' reads it; give one, the folder of 'upbead waves', or a reduced model")
    if design["section"].get("harbour_level", 0.):
        raise UserError(f"'{name}' has sea and harbour at two levels, and the page knows one: the still water's push and lift would be missing; remove section.harbour_level, or see 'upbead waves'")
    return {
        "title": design.get("title") or "Design",
        "water": {"density": design["fluid"]["density"], "gravity": design["gravity"]},
        **{key: design.get(key, {}) for key in ("section", "duration", "combined", "levels")},
        "limits": {key: value for key, value in design.get("limits", {}).items() if key != "sliding"},
        "held_to": {key: value for key, value in design.get("limits", {}).items() if isinstance(value, (int, float))},
        "waves": {key: {word: wave[word] for word in OWN_WAVE if word in wave} for key, wave in waves.items()},
        "notes": notes_of(waves),
    }


def notes_of(waves):
    measured = [name for name, wave in waves.items() if any(key in wave for key in MEASURED)]
    if not measured:
        return []
    return [f"The measured force of {', '.join(measured)} is left out: here P and U are Goda's; upbead waves slides by the measured one."]
