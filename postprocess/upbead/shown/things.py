"""Display of each kind of result in a notebook: inputs and results as a table, a figure, and the interactive page."""

from functools import singledispatch

from .. import figures, outputs, told
from ..calibration_result import CalibrationResult
from ..errors import UserError
from ..expected_result import ExpectedResult
from ..figures.expected import LAWS
from ..fit_result import Fit, interval_text
from ..live.document import document
from ..live.model_data import model_data
from ..live.scene import of_same_scene
from ..lumped_model import Source
from ..reduced_model import ReducedModel
from ..results import Result
from ..slip_result import SlipResult
from ..study_table import StudyTable
from ..waves_result import WavesSummary
from .parts import Markup, block, element, page, picture, quantity, quiet, table

READ = ("peak_force", "peak_force_time", "peak_shear", "peak_shear_time", "shear_to_force_ratio", "peak_displacement", "error_estimate")
# the histories that figures.response draws
FIGURE = ("force", "inertia_force", "shear_force", "caisson/displacement_x")
OF_WAVE = ("height", "period", "alpha_star", "force", "uplift", "safety_sliding", "sliding_paper", "sliding_exact")


@singledispatch
def html_of(thing):
    raise TypeError(f"{type(thing).__name__} has no picture of itself")


@html_of.register
def _(result: Result):
    response = result.summary.get("response") or {}
    rows = [(outputs.label(f"response.{key}"), quantity(response[key], outputs.unit(f"response.{key}"))) for key in READ if response.get(key) is not None]
    design = (result.summary.get("sliding") or {}).get("design") or {}
    if (slip := design.get("value")) is not None:
        bound = "without bound, till the end " if not design.get("rests", True) else "at least " if design.get("why_not_all") else ""
        rows.append(("sliding distance S", bound + quantity(slip, "m")))
    draw = figures.response if all(name in result for name in FIGURE) else figures.probes if result.probes() else None
    drawn = [picture(lambda: draw(result), f"histories of {result.title}")] if draw else []
    if isinstance(result, SlipResult):
        drawn.append(picture(lambda: figures.slip_bottom(result), f"the caisson's bottom over time, {result.title}"))
    return block(result.title, judged(result.summary), table(None, rows) if rows else "", *drawn, what_if(result))


def judged(summary):
    """The checks that fail, and the warnings."""
    return Markup(told.listed(summary))


def what_if(result):
    """The page of the reduced model of the same scene, if it is in the folder of the run."""
    path = result.folder / "reduced.h5"
    if not path.is_file() or not of_same_scene(path, result.case):
        return ""
    return element("div", element("h5", "What if"), of_model(path, result.title))


def of_model(path, title):
    try:
        return page(document(model_data(path)), f"what if: {title}")
    except (UserError, OSError, KeyError, ValueError) as error:
        return quiet(f"The page that answers cannot be made: {error}.")


@html_of.register
def _(model: ReducedModel):
    return block(model.title or "Reduced model", of_model(model.path, model.title))


@html_of.register
def _(study: StudyTable):
    names = [*study.keys, *study.reads]
    head = [f"{name} ({unit})" if (unit := study.units.get(name) or outputs.unit(name)) else name for name in names]
    failed = quiet(f"{len(study.failed)} more runs failed: " + "; ".join(row["message"] for row in study.failed[:3])) if study.failed else ""
    rows = ([short(row[name]) for name in names] for row in study.rows)
    return block(f"{study.name}: {len(study)} runs", judged(study.summary), table(head, rows), failed, picture(lambda: figures.study(study), f"{study.reads[0]} by what was varied"))


def short(cell):
    """A cell of study.csv to four digits, words unchanged."""
    try:
        return f"{float(cell):.4g}"
    except ValueError:
        return cell


@html_of.register
def _(summary: WavesSummary):
    waves = summary["waves"]
    shown = [key for key in OF_WAVE if any(wave.get(key) is not None for wave in waves.values())]
    head = ["wave", *(outputs.label(f"waves.NAME.{key}", "waves") or key for key in shown)]
    rows = ([name, *(quantity(wave.get(key), outputs.unit(f"waves.NAME.{key}", "waves")) for key in shown)] for name, wave in waves.items())
    highest = max(waves, key=lambda name: waves[name].get("force") or 0.0)
    drawn = picture(lambda: figures.wave_pressure([summary], highest), f"pressure of the wave {highest} over the wall")
    return block(summary.get("title") or "Waves", judged(summary), table(head, rows), drawn)


@html_of.register
def _(result: ExpectedResult):
    found, lives = (result.summary.get(key) or {} for key in ("expected", "monte_carlo"))
    threshold, sliding = (found.get(key) or {} for key in ("threshold_height", "waves_that_slide"))
    rows = [(LAWS.get(law, law), quantity(found.get(f"distance_{law}"), "m"), quantity(sliding.get(law)), quantity(threshold.get(law), "m")) for law in result.distance]
    rows += [(f"mean of {lives['lives']} lives of {lives['years']:g} years, {LAWS.get(lives['law'], '')}", quantity(lives["mean"], "m"), "", "")] if lives else []
    head = ("law of S", f"expected sliding in {found['years']:g} years" if found else "S", "waves that slide", "from a height of")
    drawn = picture(lambda: figures.expected([result]), "waves, S and expected sliding by height")
    return block(result.summary["title"], judged(result.summary), table(head, rows), drawn)


@html_of.register
def _(result: CalibrationResult):
    found = ((name, *(quantity((model.get("recommended") or {}).get(key)) for key in ("a", "b", "residual_deviation"))) for name, model in result.models.items())
    given = ("given", quantity(result.given["a"]), quantity(result.given["b"]), "")
    head = ("k = (alpha*^a + 1)^-b", "a", "b", "deviation of k from it")
    return block(result.summary["title"], judged(result.summary), table(head, [given, *found]), picture(lambda: figures.calibration(result), "k by alpha*, and the fits"))


@html_of.register
def _(found: Fit):
    rows = ((key, quantity(value), interval_text(found.confidence[key]), quantity(found.guess.get(key))) for key, value in found.values.items())
    cautions = [quiet(f"Caution: {words}") for words in found.cautions]
    head = ("key", "fitted", "95 %", "first guess")
    return block(f"Fit by {found.n_runs} runs", table(head, rows), *cautions, picture(lambda: figures.fit(found), "record and fit"))


@html_of.register
def _(source: Source):
    rows = [
        ("load", source.load),
        ("natural frequency", quantity(source.frequency, "Hz")),
        ("of critical damping", f"{100 * source.damping:.3g} %"),
        ("mass", quantity(source.case["caisson_mass"], "kg/m")),
    ]
    return block(f"One mass on a spring and a dashpot for: {source.title}", table(None, rows))
