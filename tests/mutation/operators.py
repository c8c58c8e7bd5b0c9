"""Mutants of a C++ source text: one small change each, of the kinds that change numbers.

Not changed are strings, comments and lines of the preprocessor, tolerances (constants below 1e-5), as no test can
tell a result with slightly different digits to be wrong, and `if constexpr`, which the compiler decides."""

import re
from dataclasses import dataclass

SKIPPED = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*', re.MULTILINE | re.DOTALL)
SWAPS = {  # kind: pairs (pattern, replacement)
    "relational": [(r" <= ", " < "), (r" >= ", " > "), (r" < ", " <= "), (r" > ", " >= "), (r" == ", " != "),
                   (r" != ", " == ")],
    "arithmetic": [(r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "), (r" \+= ", " -= "),
                   (r" -= ", " += "), (r" \*= ", " /= "), (r" /= ", " *= ")],
    "sign": [(r"(?<=return )-(?=[\w(])|(?<=[(,=?:] )-(?=[a-z(])|(?<=\()-(?=[a-z(])", "")],
    "logical": [(r" && ", " || "), (r" \|\| ", " && ")],
    "function": [(r"\bstd::min\b", "std::max"), (r"\bstd::max\b", "std::min"), (r"\bstd::sin\b", "std::cos"),
                 (r"\bstd::cos\b", "std::sin"), (r"\bstd::sinh\b", "std::cosh"), (r"\bstd::cosh\b", "std::sinh"),
                 (r"\bstd::abs(?=\()", ""), (r"\bstd::sqrt(?=\()", ""), (r"\bstd::exp(?=\()", "")],
}
NUMBER = re.compile(r"(?<![\w.])(?:\d+\.\d*|\d+)(?:e[-+]?\d+)?(?![\w.])")
CONDITION = re.compile(r"\b(?:if|while) \(")
# an assignment, a call or a jump on a line of its own; not a declaration, without which the file would not compile
STATEMENT = re.compile(r"^[ ]+(?!return\b|throw\b|using\b|const\b|auto\b|static\b|double\b|int\b)"
                       r"(?:break|continue|[\w.\[\]\->]+(?:\([^\n;]*\)[\w.]*)*(?: (?:[-+*/]?=) [^\n;]*)?);$", re.MULTILINE)


@dataclass(frozen=True)
class Mutant:
    file: str
    kind: str
    start: int
    end: int
    new: str

    def apply(self, text):
        return text[:self.start] + self.new + text[self.end:]

    def told(self, text):
        """The number of the changed line, the line before and after the change."""
        begin = text.rfind("\n", 0, self.start) + 1
        stop = text.find("\n", self.end)
        becomes = text[begin:self.start] + self.new + text[self.end:stop]
        return text.count("\n", 0, self.start) + 1, text[begin:stop].strip(), becomes.strip()


def masked(text):
    """The text with blanks in place of the parts not to be changed; quotes stay, so that a line with a message is
    recognised."""
    def blank(match):
        keep = match[0][0] if match[0][0] in "\"'" else " "
        return keep + re.sub(r"[^\n]", " ", match[0][1:])
    return SKIPPED.sub(blank, text)


def other_number(number):
    """0 -> 1, 2 -> 3, 0.5 -> 0.6, 2. -> 3., 1e5 -> 1.5e5; none for tolerances."""
    if re.fullmatch(r"\d+", number):
        return str(int(number) + 1)
    value = float(number)
    if 0 < value < 1e-5:
        return None
    return repr(value + 1. if value == int(value) and value < 100 else round(value * 1.2, 12))


def closing(text, opening):
    """Position at which the parenthesis at `opening` closes; -1 if it does not."""
    depth = 0
    for i in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return -1


def mutants(file, text):
    """All mutants of one file, in the order of the text."""
    code = masked(text)
    found = []
    for kind, swaps in SWAPS.items():
        for pattern, new in swaps:
            found += [Mutant(file, kind, m.start(), m.end(), new) for m in re.finditer(pattern, code)]
    for m in NUMBER.finditer(code):
        if (other := other_number(m[0])) is not None:
            found.append(Mutant(file, "constant", m.start(), m.end(), other))
    for m in CONDITION.finditer(code):
        stop = closing(code, m.end() - 1)
        if stop > 0 and ";" not in code[m.end():stop]:
            found.append(Mutant(file, "condition", m.end(), stop, f"!({text[m.end():stop]})"))
    for m in STATEMENT.finditer(code):
        if code[:m.start()].rstrip()[-1:] in ";{})" and m[0].count("(") == m[0].count(")"):
            found.append(Mutant(file, "statement", m.start(), m.end(), re.match(" *", m[0])[0] + ";"))
    return sorted((m for m in found if not in_message(code, m)), key=lambda m: (m.start, m.end, m.kind))


def in_message(code, mutant):
    """Whether the mutant changes a text for the user, not a number: a sum or constant in a statement with a
    string."""
    begin = max(code.rfind(mark, 0, mutant.start) for mark in ";{}")
    stop = code.find(";", mutant.end)
    return '"' in code[begin + 1:stop] and mutant.kind in ("arithmetic", "constant", "statement")
