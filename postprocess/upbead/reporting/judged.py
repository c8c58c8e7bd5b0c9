"""What the checks and the warnings of a summary say, for the first page of every document."""

from .language import listed, named, phrase, say, sentences, spoken
from .language import told as words_of
from .markup import Markup, join, prose, tag
from .units import digits_between, plain, quantity
from .. import told
from ..prefixes import pretty, scale


def verdict(summary):
    """Sentences, and a list of all checks that fail; it says that all hold only where nothing speaks against it."""
    checks = told.checks(summary)
    words = sentences([void(summary), rest(summary), checked(summary), unjudged(summary), doubt(summary)])
    return join([tag("p", words) if words else "", failing(checks)])


def failing(checks):
    """A list of the checks that fail, worst first; empty if none does."""
    items = [tag("li", in_words(check), said(told.check_text(check))) for check in checks if told.fails(check)]
    return tag("ul", *items, class_="fails") if items else ""


def in_words(check):
    """The check in the language of the document, where that is not the program's own."""
    if spoken() == "en" or check.get("capacity") is None:
        return ""
    digits = digits_between(check.get("demand"), check["capacity"])
    demand, capacity = (shown(check.get(key), check.get("unit") or "", digits) for key in ("demand", "capacity"))
    return phrase("{name}: {demand}, limit {capacity}: does not hold.", name=prose(words_of(check["name"])), demand=demand, capacity=capacity)


def shown(value, unit, digits=4):
    """A number for prose: its exact value stands in the table of the checks."""
    if value is None:
        return say("without bound")
    factor, name = scale(unit, value, 10.0)
    return f"{plain(value * factor, digits)} {pretty(name)}".strip()


def said(text):
    """The program's own words, marked as English where the document is not."""
    return text if spoken() == "en" else tag("span", text, lang="en", class_="remark english")


def void(summary):
    why = None if told.is_partly_void(summary) else told.void(summary)  # a study tells of its runs
    return tag("strong", phrase("No verdict may be drawn: {why}.", why=why.rstrip(".")), class_="fails") if why else ""


def unreliable(summary):
    """Stands before numbers of which no verdict may be drawn."""
    return tag("p", tag("strong", say("No number that follows may be relied on."), class_="fails")) if told.is_all_void(summary) else ""


def unjudged(summary):
    names = listed(dict.fromkeys(prose(words_of(check["name"])) for check in told.unjudged(summary)))
    return tag("strong", phrase("Limits that were given and not judged: {names}.", names=names), class_="fails") if names else ""


def rest(summary):
    """Whether the ground stands at all, where strength was reduced."""
    found = summary.get("safety") or {}
    lower, upper = (found.get(key) for key in ("lower", "upper"))
    if lower is None and upper is None:
        return ""
    least, most = (say("none") if value is None else quantity(value, digits=4) for value in (lower, upper))
    words = phrase("At rest the ground stands with its strength divided by {least}; divided by {most} no equilibrium was found.", least=least, most=most)
    if min(value for value in (lower, upper) if value is not None) >= 1:
        return words
    fails = tag("strong", say("The ground does not stand under its own weight and what stands on it."), class_="fails")
    return sentences([fails, words])


def checked(summary):
    """A sentence on the results of the checks against limits."""
    checks = told.checks(summary)
    asked = [check for check in checks if told.is_judged(check)]
    failed = [check for check in asked if told.fails(check)]
    if not asked:
        return say("No check has a limit.") if checks and not told.unjudged(summary) else ""
    if failed and all("worst_run" in check for check in failed):
        return tag("strong", in_runs(failed, summary), class_="fails")
    unjudged = [check for check in asked if check.get("unjudged")]
    if unjudged and not failed:
        counts = [phrase("{name} in {count}", name=prose(words_of(check["name"])), count=check["unjudged"]) for check in unjudged]
        words = phrase("Given limits could not be judged in some of {runs} runs: {names}.", runs=summary["runs"], names=listed(counts))
        return tag("strong", words, class_="fails")
    if failed:
        names = listed(dict.fromkeys(prose(words_of(check["name"])) for check in failed))
        words = phrase("Checks beyond their limit, {failed} of {asked}: {names}.", asked=len(asked), failed=len(failed), names=names)
        return tag("strong", words, class_="fails")
    if told.void(summary) or told.warnings(summary) or told.unjudged(summary):
        return say("Of {asked} checks with a limit none fails; what is said against that stands here and below.", asked=len(asked))
    return say("Of {asked} checks with a limit all hold.", asked=len(asked))


def in_runs(failed, summary):
    """Checks of a study that fail, each with the number of its runs."""
    counts = [phrase("{name} in {count}", name=prose(words_of(check["name"])), count=check["failing"]) for check in failed]
    return phrase("Checks beyond their limit in some of {runs} runs: {names}. Below is each in the run in which it is worst.",
                  runs=summary["runs"], names=listed(counts))  # fmt: skip


def doubt(summary):
    """A sentence on the warnings of the program, which make the statements above less certain."""
    names = listed(dict.fromkeys(named(name) for name, _ in told.warnings(summary)))
    if not names:
        return Markup("")
    return tag("strong", phrase("The program warns of: {names}. All numbers here stand under these warnings.", names=names))
