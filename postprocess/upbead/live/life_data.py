"""Expected sliding distance over the caisson's width, computed by `upbead expected` for some widths of a design, for
a page."""

import json
import tempfile
from pathlib import Path

from ..commands import written
from ..errors import UserError
from ..program import toml_value

FACTORS = (0.7, 0.8, 0.9, 1.0, 1.1, 1.2)  # of the design's own width
LAWS = ("paper", "exact", "combined")
# A model is valid for one width; waves, levels and the report have no effect on lives.
LEFT_OUT = ("dynamics", "calibration", "report", "levels", "ground")


def with_life(data, design, folder, program=None):
    """The data of a page with `life`, if the design has a sea; with a note if `life` could not be computed."""
    if "sea" not in design and "storms" not in design:
        return data
    try:
        return {**data, "life": life_data(design, folder, program)}
    except UserError as error:
        return {**data, "notes": [*data["notes"], f"Expected sliding over the width is not shown: {error}"]}


def life_data(design, folder, program=None):
    """design: with all defaults; folder: to which its paths are relative. Raises UserError with the program's own
    text."""
    summaries = [expected_of(of_width(design, folder, factor), program) for factor in FACTORS]
    told, lives = ([one.get(key) for one in summaries] for key in ("expected", "monte_carlo"))
    of_sea = told[0] or {"years": lives[0]["years"], "waves": None, "limit": lives[0]["limit"]}  # storms have lives alone
    section = design["section"]
    return {
        "title": design.get("title") or "the design",
        "section": section,
        "widths": [factor * section["width"] for factor in FACTORS],
        **{key: of_sea[key] for key in ("years", "waves", "limit")},
        "laws": {law: [one[f"distance_{law}"] for one in told] for law in LAWS if (told[0] or {}).get(f"distance_{law}") is not None},
        "lives": lives[0] and {**{key: lives[0][key] for key in ("lives", "years", "law")}, "mean": [one["mean"] for one in lives]},
        "scatter": sorted(design.get("scatter", {})),
        "program": summaries[0]["program"],
        "summary": summaries[FACTORS.index(1.0)],
    }


def of_width(design, folder, factor):
    """The design with a caisson of another width and the same mean density."""
    changed = {key: value for key, value in design.items() if key not in LEFT_OUT}
    section = {**design["section"]}
    for key in ("width", "weight", "submerged_weight", "centroid"):
        if key in section:
            section[key] = factor * section[key]
    changed["section"] = section
    if "sea" in design:
        changed["sea"] = {**design["sea"], "states": str((Path(folder) / design["sea"]["states"]).resolve())}
    if design.get("life", {}).get("sliding") == "dynamic" or ("dynamics" in design and "life" in design):
        changed["life"] = {**design["life"], "sliding": "exact"}
    return changed


def expected_of(design, program):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "design.toml"
        file.write_text("".join(f"{toml_value(key)} = {toml_value(value)}\n" for key, value in design.items()), encoding="utf-8")
        out = written("expected", file, None, Path(folder) / "out", program, "")
        return json.loads((out / "summary.json").read_text(encoding="utf-8"))
