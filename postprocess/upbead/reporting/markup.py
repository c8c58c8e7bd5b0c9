"""HTML from Python: a text that is not Markup is escaped."""

import html
import json
import re


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
    """A table in a box that scrolls on a narrow page; the first cell of a row is its name."""
    titles = tag("thead", tag("tr", *(tag("th", cell, scope="col") for cell in head))) if head else ""
    body = (tag("tr", tag("th", row[0], scope="row"), *(tag("td", cell) for cell in row[1:])) for row in rows)
    return tag("div", tag("table", titles, tag("tbody", *body), class_=class_), class_="table")


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
    are_symbols, found = all(len(name) <= 2 and name < "\u3000" for name, _, _ in words), []
    for number, (name, _, below) in enumerate(words):
        found.append(((" " if number else "") + name, "i" if below or are_symbols else ""))
        found += [(below, "sub")] if below else []
    return found


# Not within a longer Latin word; Japanese text may follow a symbol without a space.
SYMBOL = re.compile(r"(?<![A-Za-z0-9_])([A-Za-zτ])_([A-Za-z0-9]{1,3})(?![A-Za-z0-9_])")


def prose(words):
    """Plain text of the program with its symbols set: F_T, c_v, h^2."""
    escaped = html.escape(words).replace("^2", "²").replace("tau_0", "τ_0")
    return Markup(SYMBOL.sub(r"<i>\1</i><sub>\2</sub>", escaped))


def symbol(name):
    """F_T in HTML."""
    styles = {"i": "i", "sub": "sub"}
    return join(tag(styles[style], part) if style else part for part, style in runs(name))
