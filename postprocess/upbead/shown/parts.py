"""Pieces of HTML for a notebook. Titles and names come from input files, so all text is escaped."""

import base64
import html

from ..errors import UserError
from ..figures.style import render
from ..history import SCALES

MOST_ROWS = 20
HEIGHT = 900  # px of a page within the notebook; it scrolls


class Markup(str):
    """A text that is HTML."""


def text(part):
    return part if isinstance(part, Markup) else Markup(html.escape(str(part)))


def element(name, *parts, **attributes):
    inside = "".join(f' {key}="{html.escape(str(value))}"' for key, value in attributes.items())
    return Markup(f"<{name}{inside}>{''.join(map(text, parts))}</{name}>")


def block(title, *parts):
    return element("div", element("h4", title), *filter(None, parts))


def quiet(words):
    return element("p", words, style="opacity: 0.7")


def quantity(value, unit=""):
    """A number with a suitable prefix: 634.6 kN/m.

    >>> quantity(634570.0, "N/m"), quantity(0.006, "m"), quantity(None), quantity("stops")
    ('634.6 kN/m', '6 mm', '', 'stops')
    """
    if value is None or isinstance(value, (str, bool)):
        return "" if value is None else str(value)
    scales = SCALES.get(unit, [(1.0, unit)]) if value and not (unit in ("m", "rad") and abs(value) >= 1.0) else [(1.0, unit)]
    factor, name = next(((f, n) for f, n in scales if abs(value) * f >= 1.0), scales[-1])
    return f"{value * factor:.4g} {'' if name == '1' else name}".strip()


def table(head, rows):
    """A table; if it has more than MOST_ROWS rows, rows in the middle are left out, with a note."""
    rows = list(rows)
    left_out = len(rows) - MOST_ROWS
    if left_out > 0:
        half = MOST_ROWS // 2
        rows = [*rows[:half], [f"… {left_out} more"] + [""] * (len(rows[0]) - 1), *rows[-half:]]
    top = [element("thead", element("tr", *(element("th", cell, scope="col") for cell in head)))] if head else []
    body = (element("tr", element("th", row[0], scope="row"), *(element("td", cell) for cell in row[1:])) for row in rows)
    return element("div", element("table", *top, element("tbody", *body)), style="overflow-x: auto")


def picture(draw, alt):
    """The figure that draw() makes, as an embedded PNG; if it cannot be drawn, the reason."""
    try:
        image = base64.b64encode(render(draw())).decode()
    except UserError as error:
        return quiet(f"Not drawn: {error}.")
    return Markup(f'<img src="data:image/png;base64,{image}" alt="{html.escape(alt)}" style="max-width: 100%">')


def page(document, title):
    """A separate page in a frame: its scripts run, but have no access to the notebook or anything else."""
    kept = {"sandbox": "allow-scripts allow-downloads", "title": title, "style": f"width: 100%; height: {HEIGHT}px; border: 1px solid #8888"}
    return element("iframe", srcdoc=document, **kept)
