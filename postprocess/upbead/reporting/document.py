"""The HTML document around the sections: style, scripts, and the words that the scripts show."""

from pathlib import Path

from .language import say, spoken
from .markup import Markup, data, tag
from .. import typeset

HERE = Path(__file__).parent
SCRIPTS = ("clock.js", "plot.js", "raster.js", "deformed.js", "animation.js", "tables.js")
OF_SCRIPTS = (
    "reset",
    "show all",
    "play",
    "pause",
    "time",
    "colour",
    "pore pressure",
    "strength mobilised",
    "deformed section",
    "plot; arrow keys move through time",
    "Drag or arrow keys: move through time.",
    "plot that can be zoomed",
    "Drag across to zoom, pinch, double tap to reset; tap to read off.",
    "Drag to zoom, double click to reset; after a click the wheel zooms and arrow keys move. Point to read off.",
)


def in_css(text):
    """A text as a string of a style sheet; no sign in it can end the string or the sheet."""
    return '"' + "".join(letter if letter.isalnum() or letter in " .,-" else f"\\{ord(letter):06x}" for letter in text) + '"'


def document(title, body, void=False):
    """void: a mark lies over each card and figure."""
    foot = f"@page {{ @bottom-left {{ content: {in_css(title)}; font: 8pt 'DejaVu Sans', sans-serif; color: #5c6773; }} }}"
    foot += f"body {{ --void: {in_css(say('VOID'))}; }}"
    style = tag("style", Markup((HERE / "page.css").read_text(encoding="utf-8") + foot))
    scripts = (tag("script", Markup((HERE / name).read_text(encoding="utf-8"))) for name in SCRIPTS)
    meta = (
        tag("meta", charset="utf-8"),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("link", rel="icon", href="data:,"),
    )
    words = data({word: say(word) for word in OF_SCRIPTS}, "words")
    inside = tag("head", *meta, tag("title", title), style), tag("body", tag("main", Markup(typeset.page(body))), words, *scripts, class_="void" if void else None)
    return "<!DOCTYPE html>\n" + tag("html", *inside, lang=spoken()) + "\n"
