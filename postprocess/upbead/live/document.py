"""One HTML file: numbers of a model, of a design or of both, the modules that compute with them, and their style."""

from __future__ import annotations

import html
import json
import re
from collections.abc import Sequence
from os import PathLike
from pathlib import Path

from .. import told, typeset
from ..errors import UserError
from ..kept import keep_inputs
from ..results import read_case, read_summary
from .case_wave import of_design
from .design_data import design_data, effective, is_design, states_of
from .life_data import with_life
from .model_data import model_data
from .scene import of_same_scene
from .soil_data import is_of_soils, soil_data

HERE = Path(__file__).parent
# Each module after those that it imports, as one script needs no imports.
SHARED = ("phi", "grid", "modes", "step", "slide", "numbers", "plot", "element", "field", "choice", "save", "link", "kept", "checks")
OF_FORMULAS = ("root", "heights", "goda", "distance", "combined", "validity", "formulas")
OF_MODEL = ("fft", "trust", "base", "circles", "respond", "pulse", "impact", "course", "goda_wave", "record", "controls", "told", "whatif")
OF_SOILS = ("numbers", "plot", "element", "field", "soil_system", "soils")
OF_DESIGN = ("profile", "design_fields", "design_controls", "design_told", "design_save", "life", "design")
IMPORT = re.compile(r"^import .*;\n", re.MULTILINE)


def page(model: str | PathLike[str], output: str | PathLike[str] | None = None, design: str | PathLike[str] | None = None,
         program: str | PathLike[str] | None = None, beside: Sequence[str | PathLike[str]] = ()) -> Path:
    """Writes the page of a reduced model, of a design, or of both, which answers other waves while one drags.

    Parameters
    ----------
    model : path
        reduced.h5 of `upbead reduce`, or its folder; soils.h5 of `upbead reduce --soils`; or a design file, or the
        folder of `upbead waves`.
    output : path, optional
        The page; default: page.html beside the model, or in the folder of the results (results/NAME for a design file).
    design : path, optional
        A design in addition to the model.
    program : path, optional
        The program, which reads design files.
    beside : paths
        Further models of the same loads, as of another soil, among which the page chooses.

    Returns
    -------
    Path
        The page, which contains everything that it shows, and needs no network.
    """
    given = Path(model)
    if is_of_soils(given):
        if design or beside:
            raise UserError(f"'{given}' is a model of soils: its page has neither a design nor models beside it")
        output = Path(output) if output else given.parent / "page.html"
        keep_inputs(output, given)
        return written(output, document_of_soils(soil_data(given)))
    if is_design(given):
        model, design = None, design or given
    else:
        model = given / "reduced.h5" if given.is_dir() else given
    output = Path(output) if output else default_output(given, model)
    known, summary = effective(design, program) if design else (None, {})
    beside = [path / "reduced.h5" if path.is_dir() else path for path in map(Path, beside)]
    keep_inputs(output, *(path for path in (model, design, *beside) if path), *(states_of(*known) if known else ()))
    data = known and with_life(design_data(known[0], design), *known, program)
    summaries = [of_run(model) if model else {}, summary, (data or {}).get("life", {}).pop("summary", {})]
    return written(output, document(*data_of(model, data, beside), summaries))


def written(output, text):
    try:
        output.parent.mkdir(parents=True, exist_ok=True)
        output.write_text(text, encoding="utf-8")
    except OSError as error:
        raise UserError(f"cannot write '{output}': {error.strerror}") from error
    return output


def of_run(model):
    """The summary beside a model, if it is of a run of the same scene; else empty."""
    return read_summary(model.parent) if of_same_scene(model, read_case(model.parent)) else {}


def default_output(given, model):
    if model:
        return model.parent / "page.html"
    return given / "page.html" if given.is_dir() else Path("results") / given.stem / "page.html"


def data_of(model, design, beside=()):
    """(numbers of a model's file, numbers of the design), each None if it is not given."""
    if beside and not model:
        raise UserError("models stand beside a model: give one, not a design alone")
    model = model and among(model, beside) if beside else model and model_data(model)
    if model and design and not model["wave"]:
        used = {key: design[key] for key in ("water", "section", "duration", "combined", "limits")}
        model["wave"] = of_design(used, next(iter(design["waves"].values())), 0)
    return model, design


def among(path, beside):
    """The numbers of a model with those of others, each with a name of its own."""
    first, *others = (model_data(one) for one in (path, *beside))
    loads = [load["name"] for load in first["loads"]]
    for other, file in zip(others, beside):
        if [load["name"] for load in other["loads"]] != loads:
            raise UserError(f"'{file}' has other loads than '{path}' ({', '.join(loads)}): models beside each other answer one wave")
    models = (first, *others)
    for one, name in zip(models, names_of([one["title"] for one in models], (path, *beside))):
        one["soil"] = name
    return {**first, "others": others}


def names_of(titles, files):
    """A name for each model: its title; where others have it, too, its folder; then its folder and file; at last its title and number."""
    places, names = [file.resolve() for file in files], list(titles)
    folders, paths = [place.parent.name for place in places], [f"{place.parent.name}/{place.stem}" for place in places]
    for other in (folders, paths, [f"{title} ({number})" for number, title in enumerate(titles, 1)]):
        names = [name if names.count(name) == 1 else instead for name, instead in zip(names, other)]
    return names


def document(model=None, design=None, summaries=()):
    """The page; `summaries` are those of the program for what it was made of: their failing checks and warnings stand
    first."""
    title = (design or model)["title"] or "Reduced model"
    if model and not any(summary and "response" in summary for summary in summaries):  # else a run of the same scene has told them
        summaries = [of_scene(model), *(summary for summary in summaries if summary)]
    summaries = [*summaries, *(of_scene(other, f"{other['soil']}: ") for other in (model or {}).get("others", ()))]
    before = judged_by(summaries)
    parts = ([formulas(design)] if design else []) + ([of_model(model)] if model else [])
    several = len(parts) > 1
    inside = "".join((f"<h2>{name}</h2>\n" if several else "") + f'<p class="quiet">{facts}</p>\n{text}' for name, facts, text in parts)
    return whole(title, before + inside, script(model, design))


# as src/respond/respond_warnings.cc tells it
UPLIFT_LEFT_OUT = {
    "name": "uplift_left_out",
    "cure": "choose an uplift above the answer, or solve the wave by 'upbead run'",
    "text": "[sliding.uplift] of the case is a record of its own wave, which no answer here has: S, pressures and factors are without uplift until one is chosen",
    "voids": False,
}


def of_scene(model, name=""):
    """What a summary would tell of the scene of a model, by its warnings; name: that of one among several."""
    warnings = [*model.get("warnings", []), *([UPLIFT_LEFT_OUT] if (model.get("sliding") or {}).get("uplift") == "history" else [])]
    return told.of_warnings([{**one, "name": name + one["name"]} for one in warnings])


def judged_by(summaries):
    judged = typeset.page("".join(dict.fromkeys(told.listed(summary) for summary in summaries)))
    head = '<section class="judged"><h2>Checks that fail or were not judged, and warnings</h2><p class="quiet">By upbead, of the case as it was given.</p>'
    return f"{head}{judged}</section>" if judged else ""


def document_of_soils(data):
    """A slider for each key of the soils."""
    facts = (
        f"F_T of the case's own loads on any soil between the ends of the sliders, by {data['size']} equations; within {100 * data['error']:.2g} % "
        "of the model of soils on soils that it was not made of. S, pressures and other waves: upbead respond --soil. Nothing is sent anywhere."
    )
    facts = html.escape(facts).replace("F_T", "<i>F</i><sub>T</sub>")
    inside = f'<p class="quiet">{facts}</p>\n{element("What if, by soils", "whatif-soils", data)}'
    return whole(data["title"] or "Model of soils", judged_by([of_scene(data)]) + inside, joined(OF_SOILS))


def whole(title, inside, modules):
    title = html.escape(title)
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">'
        f"<title>{title}: what if</title><style>{read('page.css')}</style><style>{read('whatif.css')}</style></head>\n"
        f'<body><main><h1>{title}</h1>{inside}</main><script type="module">\n{modules}</script>\n</body></html>\n'
    )


def of_model(data):
    facts = html.escape(facts_of(data)).replace("F_T", "<i>F</i><sub>T</sub>")
    return "By the reduced model", facts, element("What if", "whatif-model", data)


def formulas(data):
    facts = (
        "Pressures after Goda (2000) with the impulsive coefficient of Takahashi, Tanimoto and Shimosako (1994), sliding after Shimosako and "
        "Takahashi (1994): the formulas and numbers of upbead waves. Nothing is sent anywhere."
    )
    return "By formulas", facts, element("What if, by formulas", "design-model", data)


def section(data):
    """The interactive section, for any page that has the colours of page.css."""
    return (
        f"<style>{read('whatif.css')}</style>\n" + element("What if", "whatif-model", data) + f'<script type="module">\n{script(data)}</script>\n'
    )


def element(name, kind, data):
    """The element in which a module finds its numbers and shows its results."""
    classes = "whatif formulas" if kind == "design-model" else "whatif"
    return (
        f'<section class="{classes}" aria-label="{name}"><noscript><p>This page answers by a script, and scripts are off.</p></noscript>'
        f'<script type="application/json" class="{kind}">{as_json(data)}</script></section>\n'
    )


def script(model=None, design=None):
    """The modules that the model and the design need, joined to one script."""
    return joined(SHARED + OF_FORMULAS + (OF_MODEL if model else ()) + (OF_DESIGN if design else ()))


def joined(names):
    return "".join(IMPORT.sub("", read(f"{name}.js")).replace("\nexport ", "\n") for name in names)


def read(name):
    return (HERE / name).read_text(encoding="utf-8")


def as_json(data):
    """JSON in which no text can end the script element."""
    return re.sub("[<>&\u2028\u2029]", lambda sign: f"\\u{ord(sign[0]):04x}", json.dumps(data, allow_nan=False, separators=(",", ":")))


def facts_of(data):
    validity = data["validity"]
    return (
        f"The scene as a sum of {data['modes']['count']} modes, exact for loads that are straight between times. F_T of the case's own loads within "
        f"{100 * validity['error']:.2g} %, checked up to {validity['highest_frequency']:.3g} Hz. Nothing is sent anywhere."
    )
