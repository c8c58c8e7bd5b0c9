"""The author's entries in [report] of a case: client, author, question, a text, a logo.

Files may come from unknown sources: HTML in the text is shown as text, and nothing in it is fetched or run.
"""

from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urlsplit

from . import logo
from .language import LANGUAGES
from .markup import Markup
from ..errors import UserError

WORDS = ("project", "client", "author", "revision", "question", "text", "logo", "language")
LINKS = ("http", "https", "mailto")


@dataclass
class Author:
    """`words` by key; `logo` is the address of a picture within the page, or empty."""

    words: dict = field(default_factory=dict)
    logo: str = ""

    @property
    def language(self):
        return self.words.get("language", "en")

    def get(self, key):
        return self.words.get(key, "")


def read(effective, source, effective_path):
    """The Author of a run: keys of its effective case, and keys that only the author's own file has.

    The path of the logo is relative to the file that names it; the author's own file takes precedence. All mistakes
    are reported at once.
    """
    own = (source.values.get("report") if source else None) or {}
    found, mistakes = {}, []
    for key in WORDS:
        places = [(effective.get("report") or {}, effective_path), (own, source.path if source else None)]
        values, place = next((pair for pair in (reversed(places) if key == "logo" else places) if key in pair[0]), ({}, None))
        if key in values:
            found[key] = (values[key], place)
    for key, (value, place) in found.items():
        if not isinstance(value, str):
            mistakes.append(f"'{place}': report.{key} is no string; write it between quotes")
        elif key == "language" and value not in LANGUAGES:
            mistakes.append(f"'{place}': report.language is '{value}'; it can be {' or '.join(map(repr, LANGUAGES))}")
    picture = ""
    if isinstance(found.get("logo", (None,))[0], str):
        try:
            value, place = found["logo"]
            picture = logo.address(Path(place).parent / value, f"'{place}': report.logo")
        except UserError as error:
            mistakes.append(str(error))
    if mistakes:
        raise UserError("\n".join(mistakes))
    return Author({key: value for key, (value, _) in found.items()}, picture)


def html(text):
    """Markdown as HTML: without HTML from the author, without pictures, with links only to pages and mail."""
    if not text:
        return Markup("")
    try:
        from markdown_it import MarkdownIt
    except ImportError as error:
        raise UserError("report.text needs the package markdown-it-py (Debian: python3-markdown-it)") from error
    reader = MarkdownIt("commonmark", {"html": False}).enable("table").disable("image")
    reader.validateLink = is_harmless
    return Markup(f'<div class="author written">{reader.render(text)}</div>')


def is_harmless(address):
    try:
        return urlsplit(address).scheme.lower() in LINKS
    except ValueError:
        return False
