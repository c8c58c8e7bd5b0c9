"""The pages made by gallery.py and reference.py are up to date, and their checks fail if they are not.

usage: test_pages.py FOLDER_OF_THE_SCRIPTS PROGRAM FOLDER_OF_THE_PROJECT
"""

import doctest
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS, PROGRAM, PROJECT = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(SCRIPTS))
from pages import numbers, page, reference, text  # noqa: E402
from pages.cases import entries, solve  # noqa: E402
from upbead.errors import UserError  # noqa: E402

CASES, DOCS = PROJECT / "cases", PROJECT / "docs"


def script(name, *arguments):
    return subprocess.run(["/usr/bin/python3", "-B", SCRIPTS / name, *arguments], capture_output=True, text=True,
                          check=False)


class Current(unittest.TestCase):
    def test_reference_of_keys(self):
        self.assertEqual(reference.check(PROGRAM, DOCS), [], "run postprocess/reference.py build/upbead docs")

    def test_datasets_at_length(self):
        self.assertEqual(script("dataset_tables.py", PROGRAM, DOCS, "--check").returncode, 0, "run postprocess/dataset_tables.py build/upbead docs")

    def test_every_shipped_case_is_in_the_gallery(self):
        wrong = page.check(CASES, entries(CASES), DOCS)
        self.assertEqual(wrong, [], "run postprocess/gallery.py build/upbead docs")

    def test_files_that_scripts_name_are_there(self):
        """Pages of docs, and files of the package that the comments of others name."""
        named = re.compile(r"(?<![\w./-])(?:docs(?=/[\w/-]+\.md)|report(?:ing)?|live)/[\w/-]+\.(?:md|py|js)\b")
        found = {(path.name, one) for path in sorted((SCRIPTS / "upbead").rglob("*.*")) if path.suffix in (".py", ".js")
                 for one in named.findall(path.read_text(encoding="utf-8"))}  # fmt: skip
        self.assertGreater(len(found), 20)
        places = (PROJECT, SCRIPTS / "upbead")
        missing = [(name, one) for name, one in found if not any((place / one).exists() for place in places) and "COMMAND" not in one]
        self.assertEqual(missing, [])


class Reference(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.docs = Path(temporary.name)
        (self.docs / "reference").mkdir()
        for name in (*reference.KEYS, *reference.PRINTED):
            shutil.copy(DOCS / "reference" / name, self.docs / "reference")

    def test_older_page_is_seen_and_made_anew(self):
        case = self.docs / "reference/case.md"
        older = case.read_text().replace("\n| `gravity`", "\n| `gravitation`").replace("# The case file", "# My head")
        case.write_text(older)
        done = script("reference.py", PROGRAM, self.docs, "--check")
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"'{case}' is not what the program prints", done.stderr)
        self.assertNotIn("design.md", done.stderr)
        self.assertEqual(case.read_text(), older)
        self.assertEqual(script("reference.py", PROGRAM, self.docs).returncode, 0)
        self.assertEqual(case.read_text(), (DOCS / "reference/case.md").read_text().replace("# The case file", "# My head"))

    def test_page_without_a_place_for_the_keys(self):
        (self.docs / "reference/study.md").write_text("# The study file\n")
        done = script("reference.py", PROGRAM, self.docs, "--check")
        self.assertEqual(done.returncode, 1)
        self.assertIn("below which the program's own text is printed", done.stderr)


class Gallery(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def test_section_of_a_pair(self):
        entry = next(entry for entry in entries(CASES) if entry.name == "fig7-9")
        opened = solve(entry, self.folder, PROGRAM, 1, False)
        lines = "\n".join(page.section(CASES, entry, opened, self.folder / "docs"))
        first = opened[0]["waves"]["impulsive"]
        self.assertIn(f"| P | {first['force'] / 1e6:.2f} MN/m |", lines)
        self.assertIn("build/upbead waves cases/fig7-9/non_breaking.toml", lines)
        self.assertIn("[cases/fig10/README.md](", lines)
        figure = (self.folder / "docs/figures/gallery/fig7-9.png").read_bytes()
        self.assertTrue(figure.startswith(b"\x89PNG"))
        self.assertLess(len(figure), page.LARGEST)

    def test_check_sees_a_new_case_and_an_older_paragraph(self):
        cases = self.folder / "cases"
        shutil.copytree(CASES, cases)
        (cases / "mine.toml").write_text("# What it shows.\n[section]\n[waves.a]\n")
        model = cases / "fig2b-model.toml"
        model.write_text("# Another paragraph.\n" + model.read_text())
        sections = entries(cases)
        self.assertEqual([(e.command, e.cases) for e in sections if e.name == "mine"], [("waves", ["mine.toml"])])
        wrong = page.check(cases, sections, DOCS)
        self.assertIn("cases/mine.toml is not on the page", wrong)
        self.assertIn("the paragraph of fig2b-model is an older one", wrong)
        (cases / "fig10/impulsive.toml").unlink()
        self.assertIn("there is no cases/fig10/impulsive.toml", page.check(cases, sections, DOCS))

    def test_paragraph_of_a_comment(self):
        case = self.folder / "cases/a.toml"
        case.parent.mkdir()
        case.write_text("# What it shows, see a.toml. Make:\n#   upbead reduce a.toml\n# More.\n\n# not this\nx = 1\n")
        found = text.with_links(text.leading_comment(case), case.parent, case.parent, self.folder / "docs")
        self.assertEqual(found, "What it shows, see [cases/a.toml](../cases/a.toml). Make:\n\n"
                                "    upbead reduce a.toml\n\nMore.")
        with self.assertRaisesRegex(UserError, "has no section '## none'"):
            text.section_of(CASES / "study/model-prototype/README.md", "none")

    def test_examples_in_docstrings(self):
        found = doctest.testmod(numbers)
        self.assertEqual(found.failed, 0)
        self.assertGreater(found.attempted, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
