"""Texts of the document in English or in Japanese: the English texts are in the code, the Japanese ones in the tables
of words/.

In a phrase `$F_T$` is a symbol, `` `case` `` is code, and `{name}` is a value.
"""

import re
import tomllib
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from pathlib import Path

from .markup import Markup, join, symbol, tag, text

LANGUAGES = ("en", "ja")
PIECE = re.compile(r"\$([^$]+)\$|`([^`]+)`|\{(\w+)\}")
_spoken = ContextVar("language", default="en")


@contextmanager
def speaking(language):
    """A context within which the document is in that language."""
    token = _spoken.set(language)
    try:
        yield
    finally:
        _spoken.reset(token)


def spoken():
    return _spoken.get()


@cache
def table():
    """{English: Japanese}."""
    files = sorted((Path(__file__).parent / "words").glob("*.toml"))
    return {english: word for file in files for english, word in tomllib.loads(file.read_text(encoding="utf-8")).items()}


def say(english, **values):
    """Fixed words as plain text, with values in their places."""
    word = told(english)
    return word.format(**values) if values else word


def told(english):
    """Words of the program in the document's language, or unchanged if the table does not have them."""
    return table().get(english, english) if spoken() == "ja" else english


def phrase(english, **values):
    """Fixed words as HTML, with symbols, code and values in their places."""
    word, parts, end = told(english), [], 0
    for found in PIECE.finditer(word):
        parts.append(word[end : found.start()])
        name, code, value = found.groups()
        parts.append(symbol(name) if name else tag("code", code) if code else text(values[value]))
        end = found.end()
    return join([*parts, word[end:]])


def listed(parts):
    """A list of things, with the separator of the language."""
    return join(parts, "、" if spoken() == "ja" else ", ")


def named(name):
    """A name that the program gives or knows: a region, a side, a check."""
    return told(spaced(name))


def spaced(name):
    """A name that the author gives, as plain text."""
    return name.replace("_", " ")


def as_written(name):
    """A name that the author gives: a load, a wave, a record. In HTML, where nothing in it is taken for a formula."""
    return tag("span", spaced(name), class_="written")


def sentences(parts):
    """Sentences as one text; Japanese has no space between them."""
    return join([part for part in parts if part], "" if spoken() == "ja" else Markup(" "))


def heads(*cells):
    """The head of a table; HTML is left unchanged."""
    return [cell if isinstance(cell, Markup) else phrase(cell) for cell in cells]
