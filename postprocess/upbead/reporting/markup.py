"""HTML from Python: a text that is not Markup is escaped."""

import html
import json

from .. import typeset


class Markup(str):
    """A text that is HTML."""


EMPTY = {"br", "meta", "link", "input", "circle", "line", "path", "rect", "polygon", "polyline", "col"}


def text(part):
    return part if isinstance(part, Markup) else Markup(html.escape(str(part)))


def join(parts, between=""):
    return Markup(text(between).join(text(part) for part in parts))


def tag(name, /, *parts, **attributes):
    """An element; class_ and for_ stand for class and for, other underscores for hyphens."""
    pairs = ((key.rstrip("_").replace("_", "-"), value) for key, value in attributes.items())
    inside = "".join(f' {key}="{html.escape(str(value))}"' for key, value in pairs if value not in (None, False))
    if name in EMPTY and not parts:
        return Markup(f"<{name}{inside}/>")
    return Markup(f"<{name}{inside}>{join(parts)}</{name}>")


def table(head, rows, class_=None):
    """A table in a box that scrolls on a narrow page; the first cell of a row is its name. Quantities of one unit have one prefix."""
    rows = alike(rows)
    titles = tag("thead", tag("tr", *(tag("th", cell, scope="col") if cell else tag("td") for cell in head))) if head else ""
    body = (tag("tr", tag("th", row[0], scope="row"), *(tag("td", cell) for cell in row[1:])) for row in rows)
    return tag("div", tag("table", titles, tag("tbody", *body), class_=class_), class_="table")


def alike(rows):
    """Rows whose cells with one unit are drawn in one."""
    rows, of_unit = [list(row) for row in rows], {}
    for row in rows:
        for cell in row:
            if hasattr(cell, "beside") and cell.unit:
                of_unit.setdefault(cell.unit, []).append(cell)
    mixed = {unit: cells for unit, cells in of_unit.items() if len({cell.drawn[1] for cell in cells}) > 1}
    return [[cell.beside(mixed[cell.unit]) if getattr(cell, "unit", None) in mixed else cell for cell in row] for row in rows]


def fold(summary, *parts, open_=False):
    return tag("details", tag("summary", summary), *parts, **({"open": "open"} if open_ else {}))


def data(value, class_):
    """A script element of JSON; no text in it can end the element."""
    safe = json.dumps(value, separators=(",", ":"), allow_nan=False)
    for sign in "<>&\u2028\u2029":
        safe = safe.replace(sign, f"\\u{ord(sign):04x}")
    return tag("script", Markup(safe), type="application/json", class_=class_)


def runs(symbol):
    """[(text, style)] of a symbol: F_T is F in italics with the subscript T; longer words are upright."""
    words = [word.partition("_") for word in symbol.split(" ")]
    are_symbols, found = all(len(name.strip("()−")) <= 2 and name < "\u3000" for name, _, _ in words), []
    for number, (name, _, below) in enumerate(words):
        found.append(((" " if number else "") + name, "i" if below or are_symbols else ""))
        found += [(below, "sub")] if below else []
    return found


def prose(words):
    """Plain text of the program with its symbols set: F_T, c_v, h^2."""
    return Markup(typeset.words(html.escape(words)))


def symbol(name):
    """F_T in HTML."""
    styles = {"i": "i", "sub": "sub"}
    return join(tag(styles[style], part) if style else part for part, style in runs(name))
