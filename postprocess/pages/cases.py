"""The shipped cases, how each is solved for the gallery, and the figure of each."""

import json
import tomllib
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import upbead
from upbead import figures

ROOT = Path(__file__).resolve().parents[2]
SPECTRUM = ROOT / "tests/reference/ref5_lumped.json"


@dataclass
class Entry:
    """A section of the gallery: cases that one figure shows."""

    name: str  # of the figure
    command: str
    cases: list  # paths below cases/
    draw: Callable  # draws the results of the command, given in the order of the cases
    setting: dict = field(default_factory=dict)  # used if the case as shipped takes longer than a minute
    note: str = ""
    models: dict = field(default_factory=dict)  # {key of the case: case whose reduced model the key needs}
    title: str = ""  # default: that of the first case
    text: str = ""  # file#heading below cases/ with the paragraph; default: the leading comment of the first case


def response(results):
    return figures.response(results[0])


def study(tables):
    return figures.study(tables[0])


def pair(name, title):
    """Model and prototype of one study of docs/model-prototype.md."""

    def draw(tables):
        spectra = [s for s in json.loads(SPECTRUM.read_text())["sdof_spectrum"] if s["rise_fraction"] == 0.5]
        scales = {(name, "model"): tables[0], (name, "prototype"): tables[1]}
        return figures.model_prototype_panel(scales, spectra, name)

    folder = "study/model-prototype"
    cases = [f"{folder}/{name}-{scale}.toml" for scale in ("model", "prototype")]
    return Entry(f"model-prototype-{name}", "study", cases, draw, title=f"F_T / P by {title}",
                 text=f"{folder}/README.md#{name}")


def known():
    """Sections with a figure of their own."""
    model, prototype = "fig2b-model.toml", "fig2b-prototype.toml"
    return [
        Entry("fig2b-model", "run", [model], response),
        Entry("fig2b-prototype", "run", [prototype], response),
        Entry("one-soil-model", "run", ["one-soil/model.toml"], response),
        Entry("one-soil-prototype", "run", ["one-soil/prototype.toml"], response),
        Entry("fig7-9", "waves", ["fig7-9/impulsive.toml", "fig7-9/non_breaking.toml"], figures.wave_pressure,
              title="Figs. 7 and 9: pressure over the height of the wall"),
        Entry("fig10", "waves", ["fig10/impulsive.toml", "fig10/non_breaking.toml"], figures.sliding_safety,
              title="Fig. 10: sliding distance against safety factor"),
        Entry("section4", "expected", ["section4/hd10.toml", "section4/hd12.toml"],
              lambda results: figures.expected(results, ["paper"]), title="Section 4: expected sliding of nine years"),
        Entry("expected-prototype", "expected", ["expected/prototype.toml"], figures.expected,
              models={"dynamics.model": prototype}),
        Entry("calibration", "calibrate", ["calibration/fig2b.toml"], lambda results: figures.calibration(results[0]),
              models={"calibration.models.prototype.model": prototype, "calibration.models.model.model": model}),
        Entry("study-stiffness", "study", ["study/stiffness.toml"], study),
        Entry("study-scatter", "study", ["study/scatter.toml"], study, {"n": 200},
              "200 draws here; the 1,000 of the file take some minutes."),
        Entry("study-slip", "study", ["study/slip/prototype.toml", "study/slip/model.toml"],
              lambda tables: figures.slip_safety(tables, [1.0, 20.0]),
              title="Slip of prototype and model by safety factor"),
        pair("peak", "the peak of P"),
        pair("stiffness", "the stiffness of the soil"),
        pair("duration", "the duration of the pulse"),
        pair("rise", "the rise of the pulse"),
        pair("permeability", "the permeability of the rubble"),
        pair("mound", "the height of the mound"),
        pair("width", "the width of the caisson"),
    ]


def command_of(path):
    """The command that reads the file."""
    case = tomllib.loads(path.read_text(encoding="utf-8"))
    for key, command in (("mesh", "run"), ("reliability", "reliability"), ("calibration", "calibrate"), ("sea", "expected"), ("section", "waves"), ("vary", "study")):
        if key in case:
            return command
    return "run"


DRAW = {"run": response, "study": study, "waves": figures.wave_pressure, "expected": figures.expected,
        "calibrate": lambda results: figures.calibration(results[0]),
        "reliability": lambda results: figures.reliability(results[0])}


def entries(cases=ROOT / "cases"):
    """All sections, in the order of the page: the known ones, then all other shipped cases, each with the usual
    figure. Cases of validation have a page of their own, docs/validation.md."""
    sections = known()
    taken = {case for entry in sections for case in entry.cases}
    for path in sorted(cases.rglob("*.toml")):
        case = str(path.relative_to(cases))
        if case not in taken and not case.startswith("validation/"):
            command = command_of(path)
            sections.append(Entry(case.removesuffix(".toml").replace("/", "-"), command, [case], DRAW[command]))
    return sections


def solve(entry, folder, program, jobs, reuse):
    """Opens the results of the entry's command for each of its cases, below the folder; with `reuse`, results that
    exist are not made again."""
    opened = []
    for case in entry.cases:
        out = folder / Path(case).with_suffix("")
        if not (reuse and (out / "summary.json").is_file()):
            setting = entry.setting | {key: reduced(name, folder, program) for key, name in entry.models.items()}
            more = {"jobs": jobs} if entry.command == "study" else {}
            getattr(upbead, entry.command)(ROOT / "cases" / case, setting, out, program=program, **more)
        opened.append(upbead.open(out))
    return opened


def reduced(case, folder, program):
    """The file of a case's reduced model, made when it is first needed."""
    path = folder / "reduced" / Path(case).stem / "reduced.h5"
    if not path.is_file():
        upbead.reduce(ROOT / "cases" / case, out=path.parent, program=program)
    return path.resolve()
