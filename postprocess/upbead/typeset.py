"""Formulas as print has them: what the program writes in ASCII (alpha_1, mu W', x_G'', sqrt, <=, 1.4e-08, H_1/3) becomes Unicode
and subscripts, in every text of a page but in code and in what its author wrote: titles, names and texts of the class `written`."""

import re

LETTERS = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "eta": "η", "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ",
    "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "psi": "ψ", "omega": "ω", "Delta": "Δ", "Phi": "Φ", "Sigma": "Σ",
}  # fmt: skip
GREEK = re.compile(rf"(?<![A-Za-z0-9_./])({'|'.join(LETTERS)})(?![A-Za-z])(?!\.\w|_[A-Za-z]*_|_[a-z]{{4}})")
POWER = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)e([-+]?)0*(\d+)(?![\w.])")
QUOTE = "\ue000"  # stands for an escaped quotation mark, which stays one where it is no prime
DERIVED = re.compile(rf"(?<![A-Za-z0-9_])([xuyz])(_[A-Za-z])?(['{QUOTE}]{{1,2}})(?![A-Za-z'{QUOTE}])")
PRIME = re.compile(rf"(?<![A-Za-z0-9_'{QUOTE}])([A-Zcφhe])['{QUOTE}](?![A-Za-z'{QUOTE}])")
LOW = r"1/3|1/10|Smax|CAL|heel|toe|front|back|water(?:,front)?|[A-Za-z0-9]{1,3}"
SYMBOL = re.compile(rf"(?<![A-Za-z0-9_./])([A-Za-zαβγδεηθκλμνξπρστφψω][\u0307\u0308′]?)_({LOW})(?![A-Za-z0-9_]|\.\w)")
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
SIGNS = (("&lt;=", "≤"), ("&gt;=", "≥"), ("sqrt(", "√("), ("^2", "²"), ("^3", "³"), ("^-1", "⁻¹"))
DOTS = {1: "\u0307", 2: "\u0308"}
PIECE = re.compile(r"(<[^>]*>)")
TAG = re.compile(r"</?([a-zA-Z0-9]+)")
LEFT_ALONE = {"code", "pre", "script", "style", "title", "textarea"}
WRITTEN = re.compile(r'<[^>]*?\sclass="(?:[^"]*\s)?written[\s"]')  # a client may be "Delta Flume", a berth A_12


def letters(text: str) -> str:
    """Greek letters, powers and signs of an HTML text; no subscripts, which an SVG has no simple way for."""
    text = text.replace("&#x27;", QUOTE)
    for ascii_, sign in SIGNS:
        text = text.replace(ascii_, sign)
    text = GREEK.sub(lambda found: LETTERS[found[1]], text)
    text = POWER.sub(lambda found: f"{found[1]} × 10{('-' * (found[2] == '-') + found[3]).translate(RAISED)}", text)
    text = DERIVED.sub(lambda found: found[1] + DOTS[len(found[3])] + (found[2] or ""), text)
    return PRIME.sub(r"\1′", text).replace(QUOTE, "&#x27;")


def words(text: str) -> str:
    """An HTML text with its symbols set."""
    return SYMBOL.sub(r"<i>\1</i><sub>\2</sub>", letters(text))


def page(html: str) -> str:
    """All texts of a document."""
    kept: list[str] = []  # open elements of the name of the one that is left alone
    drawn, found = 0, []
    for piece in PIECE.split(html):
        if piece.startswith("<"):
            opened = TAG.match(piece)
            name, closes = (opened[1].lower() if opened else ""), piece.startswith("</")
            if kept and name == kept[0] or not kept and not closes and (name in LEFT_ALONE or WRITTEN.match(piece)):
                if not piece.endswith("/>"):
                    kept = kept[:-1] if closes else [*kept, name]
            elif name == "svg":
                drawn += -1 if closes else 1
            found.append(piece)
        elif kept:
            found.append(piece)
        else:
            found.append(letters(piece) if drawn else words(piece))
    return "".join(found)
