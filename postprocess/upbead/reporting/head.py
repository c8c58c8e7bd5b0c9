"""The beginning of a document: logo, title, client and author, and the question."""

from . import author
from .language import phrase, say
from .markup import join, table, tag

NAMES = {"project": "project", "client": "client", "author": "author", "revision": "revision"}


def title(words, kind, heading):
    """`words` is the Author, `kind` names the kind of document, `heading` is the title of the case."""
    mark = tag("img", src=words.logo, alt=say("logo"), class_="logo") if words.logo else ""
    rows = [(say(name), words.get(key)) for key, name in NAMES.items() if words.get(key)]
    who = table(None, rows, "words written") if rows else ""
    return join([mark, tag("p", say(kind), class_="kind"), tag("h1", heading, class_="written"), who])


def question(words, asked):
    """The author's question, or else the question that such a run answers; then the author's text."""
    told = tag("p", words.get("question") or asked, class_="asked written" if words.get("question") else "asked")
    return tag("section", tag("h2", say("Question")), told, author.html(words.get("text")), id="question")


def card(name, value, below):
    return tag(
        "div",
        tag("div", name, class_="name"),
        tag("div", value, class_="value"),
        tag("div", below, class_="below"),
        class_="card",
    )


def trust(warnings, *told):
    """One line on the reliability of the results above, with a link to the warnings; `warnings`: their number."""
    words = say("no warnings") if not warnings else say("1 warning") if warnings == 1 else say("{count} warnings", count=warnings)
    return tag("p", join([tag("a", words, href="#quality", class_="warned" if warnings else None), *told], " · "), class_="verdict")


def appendix(*sections):
    """The sections on the solution, below a heading of their own."""
    return tag("div", tag("p", phrase("Appendix: how it was solved"), class_="part"), *sections, class_="appendix")
