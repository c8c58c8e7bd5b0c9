#!/usr/bin/python3
"""Words that tests/checks/not_written.md bans are not used: in its table each row has the words and what is
written instead. Checked are README, CONTRIBUTING, docs, READMEs of cases and meshes (without their code), and the
sentences in strings of src and postprocess (a string without a space is a key).

    words.py FOLDER_OF_THE_PROJECT
"""

import io
import pathlib
import re
import sys
import tokenize

LITERAL = re.compile(r'R"\((.*?)\)"|"((?:[^"\\\n]|\\.)*)"', re.DOTALL)
CODE = re.compile(r"^(```.*?^```|    .*?$)|`[^`\n]+`|\]\([^)\n]*\)|<!--.*?-->", re.DOTALL | re.MULTILINE)


def banned(table):
    """{pattern: what is written instead}"""
    rows = re.findall(r"^\| (.+?) \| (.+?) \|$", table, flags=re.MULTILINE)[1:]
    listed = {re.compile(r"\b" + r"\s+".join(map(re.escape, words.split())) + r"\b", re.IGNORECASE): instead
              for phrases, instead in rows for words in phrases.split("; ")}
    assert len(listed) > 10, "not_written.md has no table"
    return listed


def blank(match):
    return re.sub(r"[^\n]", " ", match[0])


def prose_of_page(text):
    return [(1, CODE.sub(blank, text))]


def prose_of_cpp(text):
    """Adjacent literals are one sentence; its line is that of the first literal."""
    text = re.sub(r'#include "[^"\n]*"|^[ \t]*//.*$', "", text, flags=re.MULTILINE)
    text = re.sub(r'"(\s*\n\s*)"', lambda match: "\0" * match[1].count("\n"), text)
    for match in LITERAL.finditer(text):
        sentence = match[1] or match[2] or ""
        if " " in sentence:
            line = 1 + sum(text.count(mark, 0, match.start()) for mark in "\n\0")
            yield line, re.sub(r"`[^`]+`", " ", sentence.replace("\0", "").replace("\\n", " "))


def prose_of_python(text):
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.STRING and " " in token.string:
            yield token.start[0], re.sub(r"`[^`]+`", " ", token.string)


def sources(root):
    pages = [root / "README.md", root / "CONTRIBUTING.md", *root.glob("docs/**/*.md"), *root.glob("cases/**/*.md"), *root.glob("meshes/*.md")]
    for path in pages:
        yield path, prose_of_page
    for path in sorted(root.glob("src/**/*")):
        if path.suffix in (".cc", ".h"):
            yield path, prose_of_cpp
    for path in sorted(root.glob("postprocess/**/*.py")):
        yield path, prose_of_python


def main():
    root = pathlib.Path(sys.argv[1])
    words = banned((root / "tests/checks/not_written.md").read_text(encoding="utf-8"))
    found, n = [], 0
    for path, prose in sources(root):
        n += 1
        for line, text in prose(path.read_text(encoding="utf-8")):
            for pattern, instead in words.items():
                for match in pattern.finditer(text):
                    at = line + text.count("\n", 0, match.start())
                    found.append(f"{path.relative_to(root)}:{at}: '{match[0]}': write {instead}")
    print("\n".join(found) or f"words: {n} files without any of {len(words)} banned phrases")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
