"""Runs docs/python.md and the examples in the docstrings of the package, and compares their output with the text.

usage: test_python_page.py FOLDER_OF_THE_SCRIPTS PROGRAM CASES_FOLDER PAGE
"""

import contextlib
import doctest
import importlib
import io
import os
import pkgutil
import re
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS, PROGRAM, CASES, PAGE = (Path(argument).resolve() for argument in sys.argv[1:5])
sys.path.insert(0, str(SCRIPTS))
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks(text):
    """[(line, code, what it prints)] of a page: blocks of python, with the block of text that follows each."""
    found = []
    for match in BLOCK.finditer(text):
        language, content = match.groups()
        if language == "python":
            found.append([text.count("\n", 0, match.start()) + 2, content, ""])
        elif language == "text":
            found[-1][2] = content
    return found


class PythonPage(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(temporary.name)
        os.symlink(CASES, "cases")
        os.environ["UPBEAD"] = str(PROGRAM)

    def test_every_block_prints_what_the_page_shows(self):
        names = {}
        found = blocks(PAGE.read_text(encoding="utf-8"))
        self.assertGreater(len(found), 5)
        for line, code, shown in found:
            printed = io.StringIO()
            with self.subTest(line=line):
                with contextlib.redirect_stdout(printed):
                    exec(compile("\n" * (line - 1) + code, PAGE.name, "exec"), names)
                self.assertEqual(printed.getvalue(), shown, f"{PAGE.name}:{line}")

    def test_every_figure_is_on_the_page(self):
        text = PAGE.read_text(encoding="utf-8")
        figures = importlib.import_module("upbead.figures")
        of_own_pages = {"stability", "verification"}
        for name in set(figures.__all__) - of_own_pages - {"save"}:
            self.assertTrue(f"`{name}`" in text, name)

    def test_examples_in_docstrings(self):
        package = importlib.import_module("upbead")
        tried = 0
        for module in pkgutil.walk_packages(package.__path__, "upbead."):
            found = doctest.testmod(importlib.import_module(module.name))
            self.assertEqual(found.failed, 0, module.name)
            tried += found.attempted
        self.assertGreater(tried, 5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
