"""The comments of a TOML file, by the key or the table that they stand with, and what they say of a number's source.

A comment belongs to what it stands behind: a key, or the head of a table. One on lines of its own belongs to the key or
head on the next line; if it speaks of what follows ("these values are assumed:"), to all keys up to the next empty line.
"""

import re
import tomllib

TABLE = re.compile(r"^\[\[?\s*([^\[\]]+?)\s*\]\]?\s*(?:#\s*(.*))?$")
KEY = re.compile(r"""^((?:[\w-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[\w-]+|"[^"]*"|'[^']*'))*)\s*=\s*(.*)$""")
# By what authors say it, the doubtful first: of several words in a comment it decides. A Japanese word has no ends.
WORDS = {
    "assumed": r"assum(?:ed|es?|ing|ptions?)\b|estimat(?:ed|es?|ions?)\b|guess(?:ed|es)?\b|typical(?:ly)?\b|typ\.|to be (?:measured|checked|determined|replaced)\b|presum(?:ed|ably)\b|provisional(?:ly)?\b|"
    r"preliminary\b|placeholder\b|tentative(?:ly)?\b|tb[cd]\b|to be confirmed\b|unknown\b|our own\b|made[- ]up\b|invented\b|"
    r"not (?:yet )?(?:measured|known|tested|confirmed)\b|rule of thumb\b|仮定|推定|想定|仮(?:の|に|値|置)|暫定|概算|概略|目安|一般的|標準的|経験的|経験値|未定|不明|未計測|未測定",
    "calibrated": r"calibrat(?:ed|ion)\b|fitted\b|back[- ]?(?:calculat|analys|analyz)(?:ed|is)\b|同定|逆解析|較正|校正",
    "measured": r"measured\b|measurements?\b|surveyed\b|実測|計測|測定|観測",
    "derived": r"derived\b|calculated\b|computed\b|算定|算出|計算",
    "given": r"given\b|specified\b|as built\b|drawings?\b|与条件|設計条件|図面",
}
OF = {mark: re.compile(r"(?<![A-Za-z])(?:" + words + r")(?!\s*(?:では|でな))", re.IGNORECASE) for mark, words in WORDS.items()}
NEGATED = re.compile(r"\b(?:not|no longer|never|nothing|none)(?: (?:is|are|yet|been|longer))*\s*$", re.IGNORECASE)
QUOTED = re.compile(r'"[^"]*"|“[^”]*”|`[^`]*`|「[^」]*」')
BEGINNING = re.compile(r"^(?:[^\w]*)(" + "|".join(WORDS) + r")\b[:,;.]?\s*", re.IGNORECASE)
ALL = r"\b(?:all (?:the )?(?:other )?|(?:its|the) (?:other )?)(?:numbers|values|inputs|parameters|dimensions)(?: and \w+)? are (?:all )?"
OTHERS = re.compile(ALL + r"(\w+(?: own)?)|(?:その他|ほか|他|それ以外|すべて|全て)の?(?:数値|値|諸元|パラメータ)は(?:すべて|全て|いずれも)?([^。、\s]+)", re.IGNORECASE)
UNSET = re.compile(r"^(?!(?:" + "|".join(WORDS) + r")\b)[\w.\"-]+\s*[:=]", re.IGNORECASE)  # a key that is left out, as the program writes it
FOLLOWS = re.compile(r":$|\b(?:following|below|these)\b|以下|次の", re.IGNORECASE)


def path_of(name):
    """The path of a key or table; a quoted part may have dots."""
    try:
        found, path = tomllib.loads(f"{name} = 0"), ()
    except tomllib.TOMLDecodeError:
        return (name,)
    while isinstance(found, dict):
        (key, found), = found.items()
        path += (key,)
    return path


def scanned(line, quote="", depth=0):
    """(comment, open multi-line quote, open brackets) at the end of a line that begins within `quote` and `depth`."""
    place = 0
    while place < len(line):
        sign = line[place]
        if quote:
            if sign == "\\" and quote[0] == '"':
                place += 1
            elif line.startswith(quote, place):
                place, quote = place + len(quote) - 1, ""
        elif sign in "\"'":
            quote = 3 * sign if line.startswith(3 * sign, place) else sign
            place += len(quote) - 1
        elif sign == "#":
            return line[place + 1 :].strip(), "", depth
        else:
            depth += (sign in "[{") - (sign in "]}")
        place += 1
    return "", quote if len(quote) == 3 else "", depth


class Reader:
    """Goes through the lines; `remarks` by path, `head` the lines above all keys."""

    def __init__(self, behind_only):
        self.behind_only = behind_only
        self.remarks, self.head = {}, []
        self.table, self.path = (), None  # the key whose value goes on
        self.above, self.group, self.begun = [], "", False
        self.quote, self.depth = "", 0

    def line(self, line):
        stripped = line.strip()
        if self.quote or self.depth > 0:
            comment, self.quote, self.depth = scanned(line, self.quote, self.depth)
            self.note(self.path, comment)
        elif not stripped:
            self.above, self.group = [], ""
        elif stripped.startswith("#"):
            self.comment(stripped)
        elif opened := TABLE.match(stripped):
            self.table = path_of(opened[1])
            self.group = ""
            self.ends(self.table, opened[2] or "")
        elif key := KEY.match(stripped):
            self.path = self.table + path_of(key[1])
            comment, self.quote, self.depth = scanned(key[2])
            self.ends(self.path, comment)

    def comment(self, stripped):
        if not self.begun and not stripped.startswith(("#:", "#!")):
            self.head.append(stripped.lstrip("# ").rstrip())
        if not self.above:
            self.group = ""
        if not UNSET.match(stripped.lstrip("# ")) and not self.behind_only:
            self.above.append(stripped.lstrip("# ").strip())

    def ends(self, path, comment):
        """A key or a head of a table, with its own comment."""
        above = " ".join(self.above) if self.begun or len(self.head) < 2 else ""
        if FOLLOWS.search(above):
            self.group = above
        elif above:
            self.group = ""
        self.remarks[path] = ""
        for words in (comment, above or self.group):
            self.note(path, words)
        self.above, self.begun = [], True

    def note(self, path, comment):
        if comment:
            self.remarks[path] = f"{self.remarks[path]}; {comment}" if self.remarks.get(path) else comment


def read(text, behind_only=False):
    """({path: comment}, the comment above all keys); `behind_only`: without comments on lines of their own."""
    reader = Reader(behind_only)
    for line in text.splitlines():
        reader.line(line)
    return reader.remarks, "\n".join(reader.head)


def marked(comment, anywhere=True):
    """(mark, the comment without it); the mark is "" where there is none.

    A comment that begins with a mark has it; else, where `anywhere`, the first of WORDS that is in it and is not denied.
    """
    begins = BEGINNING.match(comment)
    if begins:
        return begins[1].lower(), comment[begins.end() :]
    words = OTHERS.sub("", QUOTED.sub("", comment))
    for mark, pattern in OF.items() if anywhere else ():
        if any(not NEGATED.search(words[: found.start()]) for found in pattern.finditer(words)):
            return mark, comment
    return "", comment


def of_the_rest(head):
    """The mark that the head of a file gives to all numbers without one of their own, or ""."""
    for found in OTHERS.finditer(" ".join(head.split())):
        mark = marked(found[1] or found[2])[0]
        if mark:
            return mark
    return ""
