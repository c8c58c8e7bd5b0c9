"""No text of a report or page lies on another or leaves its figure: the boxes of all texts in Chromium, of unlike sections at three
widths, and no finding of axe-core.

Skipped (exit code 77) where there is no Chromium.

usage: test_text_boxes.py FOLDER_OF_THE_SCRIPTS PROGRAM CASES_FOLDER [at_length]
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from chromium import Browser
from page_models import CASES, PROGRAM, SCRIPTS, axe, violations
from text_boxes import boxes

from report import pdf

WIDTHS = (360, 800, 1600)
SUPPORT = Path(__file__).parents[1] / "support"
COARSE = ("mesh.parameters.cells=0.4",)
FIELDS = (*COARSE, "output.fields={ every = 0.3 }")
SECTIONS = {  # name: command, case, settings
    "trench": ("run", SUPPORT / "trench.toml", ("output.fields={ every = 0.3 }",)),
    "study": ("study", CASES / "study/stiffness.toml", ()),
    "design": ("waves", CASES / "designer/design.toml", ()),
}
AT_LENGTH = {
    "prototype": ("run", CASES / "fig2b-prototype.toml", (*FIELDS, "loads.impulse.factor=5")),
    "levels": ("run", CASES / "gallery/two-levels.toml", COARSE),
    "designer": ("run", CASES / "designer/section.toml", (*COARSE, "time.end=1", "output.fields={ every = 0.2 }")),
    "clay": ("run", CASES / "gallery/replaced-clay.toml", FIELDS),
    "berm": ("run", CASES / "gallery/wide-berm.toml", COARSE),
    "mound": ("run", CASES / "gallery/high-mound.toml", COARSE),
    "yielding": ("run", CASES / "gallery/yielding-mound.toml", (*COARSE, "output.fields={ every = 0.1 }", "initial.bounds=false")),
    "stages": ("run", CASES / "construction/designer.toml", COARSE),
    "flume": ("run", CASES / "validation/flume/flume.toml", ()),
    "sheet": ("sheet", CASES / "designer/section.toml", (*COARSE, 'regions.caisson.interface.kind="bonded"')),
    "years": ("expected", CASES / "section4/hd10.toml", ()),
}
ANSWERS = {"model": ("fig2b-prototype.toml", None), "design": (None, "designer/design.toml"), "both": ("design-wave/composite.toml", "design-wave/section.toml")}


def done(*command):
    made = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    if made.returncode != 0:
        raise RuntimeError(made.stderr)


class TextBoxes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.browser = Browser(pdf.browser(), pdf.options)
        cls.axe = axe(cls.folder) if at_length else None

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def report(self, name, command, case, settings):
        """The report of a section in English, and at length in Japanese."""
        out = self.folder / name
        if not out.is_dir():
            done(PROGRAM, command, case, "--out", out, *(word for setting in settings for word in ("--set", setting)))
        for language in ("en", "ja") if at_length else ("en",):
            target = out / f"{language}.html"
            done("/usr/bin/python3", "-B", SCRIPTS / "report.py", out, "-o", target, "--language", language)
            yield target

    def stands(self, page):
        for width in WIDTHS:
            self.browser.open(page, width, dark=width == 800)
            found = boxes(self.browser)
            where = f"{page.parent.name}/{page.name} at {width} px"
            self.assertGreater(found["texts"], 50, where)
            self.assertEqual(found["over"], [], where)
            self.assertEqual(found["outside"], [], where)
            if self.axe and width > WIDTHS[0]:  # light, and dark
                self.assertEqual(violations(self.browser, self.axe), [], where)

    def test_reports(self):
        for name, parts in (SECTIONS | AT_LENGTH if at_length else SECTIONS).items():
            for page in self.report(name, *parts):
                with self.subTest(name, page=page.name):
                    self.stands(page)

    def test_an_own_mesh_is_drawn_without_gmsh(self):
        out = next(self.report("trench", *SECTIONS["trench"])).parent
        environment = os.environ | {"PATH": "/nowhere"}
        subprocess.run(["/usr/bin/python3", "-B", SCRIPTS / "report.py", out, "-o", out / "page.html"], env=environment, capture_output=True, check=True)
        self.browser.open(out / "page.html", 1000)
        texts = self.browser.value("[...document.querySelectorAll('#drawing .wide text')].map((text) => text.textContent)")
        for words in ("wave", "caisson", "mound", "sand fill", "soft clay", "stiff clay", "18\u00a0m", "1 : 2", "10\u00a0m"):
            self.assertIn(words, texts)
        self.assertEqual(self.browser.value("document.querySelectorAll('#drawing .wide .level').length"), 2)
        self.assertEqual(self.browser.value("new Set([...document.querySelectorAll('#drawing .wide .area')].map((one) => getComputedStyle(one).fill)).size"), 6)

    def test_pages(self):
        for name, (model, design) in ANSWERS.items() if at_length else ():
            with self.subTest(name):
                out = self.folder / f"page-{name}"
                if model:
                    done(PROGRAM, "reduce", CASES / model, "--out", out)
                out.mkdir(exist_ok=True)
                source = [out, *(["--design", CASES / design] if design else [])] if model else [CASES / design]
                done("/usr/bin/python3", "-B", SCRIPTS / "page.py", *source, "-o", out / "page.html")
                self.stands(out / "page.html")


if __name__ == "__main__":
    at_length = "at_length" in sys.argv
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
