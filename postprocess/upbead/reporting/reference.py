"""Unit, default and meaning of a key of a case, from the reference docs/reference/case.md."""

import re
import tomllib
from dataclasses import dataclass

from .. import places

SECTION = re.compile(r"^## `\[(.+)\]`")
UNIT = re.compile(r"\(([^()]+)\)")
OPTION = re.compile(r"^(?!true: )\w+: ")


@dataclass
class Key:
    unit: str
    default: str
    meaning: str

    def is_default(self, value):
        """Whether a value is the default of the reference. A text without quotes explains it, and may end in the value
        where nothing else is given: "that of the contact, else 0.6"."""
        try:
            return tomllib.loads("value = " + self.default.strip("`").rpartition(" else ")[2])["value"] == value
        except tomllib.TOMLDecodeError:
            return False


def read(path=None):
    """{(section, key): Key}, sections as 'regions.NAME.damping'; empty if there is no reference."""
    path = path or places.docs() / "reference/case.md"
    if not path.is_file():
        return {}
    found, section = {}, ""
    for line in path.read_text(encoding="utf-8").splitlines():
        head = SECTION.match(line)
        section = head[1] if head else section
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        if len(cells) == 5 and cells[0].startswith("`"):
            unit = UNIT.search(cells[1])
            found[section, cells[0].strip("`")] = Key(unit[1] if unit else "", cells[3], short(cells[4]))
    return found


def short(meaning):
    """The meaning of a key, without the conditions and alternatives."""
    if OPTION.match(meaning):
        return ""  # this explains one of the values
    return re.split(r"; |: | \(only |, so ", meaning.removeprefix("true: ").replace(" with a header line, then", ":"))[
        0
    ].strip()


def find(known, path):
    """The Key of a path such as ('regions', 'seabed', 'damping', 'ratio'), or None.

    A table of the reference may have a name of the case in it (NAME), and one whose keys are free names has one Key for
    all its keys.
    """
    *tables, key = path
    for length in (len(tables), len(tables) - 1):
        wanted = key if length == len(tables) else tables[-1] if tables else None
        for (section, name), found in known.items():
            parts = section.split(".") if section else []
            if name == wanted and len(parts) == length and all(part.isupper() or part == own for part, own in zip(parts, tables)):
                return found
    return None
