"""What if: if the reduced model of the same scene is in the folder of the run, the page computes responses to other
waves."""

from .language import say, spoken
from .markup import Markup, tag
from .. import live
from ..errors import ModelError
from ..live.model_data import model_data
from ..live.scene import case_of, scene_of


def section(result):
    path = result.folder / "reduced.h5"
    if not path.is_file():
        return Markup("")
    try:
        data, case = model_data(path), case_of(path)
    except (ModelError, OSError, KeyError, ValueError) as error:
        return note(say("The reduced model beside this run cannot be shown: {why}.", why=error))
    if scene_of(case) != scene_of(result.case):
        return note(say("The reduced model beside this run is of another scene, and is not shown."))
    return tag("section", tag("h2", say("What if")), english(), Markup(live.section(data)), id="what-if")


def english():
    """A note that the calculator is only in English."""
    return tag("p", say("What follows is in English."), class_="quiet") if spoken() != "en" else Markup("")


def note(text):
    return tag("section", tag("h2", say("What if")), tag("p", text, class_="quiet"), id="what-if")
