"""The page as an instrument, in Chromium: an answer kept beside the next, soils beside each other, a link that opens with the
same values, limits and lifting beside the answer.

Skipped (exit code 77) where there is no Chromium.

usage: test_page_compare.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES
"""

import sys
import tempfile
import unittest
from pathlib import Path

import page_models as made
from chromium import Browser

import upbead
from report import pdf
from upbead.errors import UserError

COARSE = ("mesh.parameters.cells=0.5", "limits.sliding=0.05")
SETTLED = """(async () => { while (!document.querySelector('data[data-key="error_estimate"]'))
  await new Promise((done) => setTimeout(done, 10)); })()"""
TYPE = """(key, text) => { const field = document.querySelector(`[data-key="${key}"]`); field.value = text; field.dispatchEvent(new Event("input")); }"""
PRESS = """(words, of) => [...document.querySelectorAll(`${of} button`)].find((one) => one.textContent.startsWith(words)).click()"""
NUMBER = """(key) => Number(document.querySelector(`.whatif data[data-key="${key}"]`).value)"""
STATE = """[...document.querySelectorAll("select[data-key], input[data-key]")].map((one) => [one.dataset.key, one.value])"""
HEAD = "document.querySelector('.headline').textContent"


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        case = "fig2b-prototype.toml"
        cls.stiff = made.reduced(case, cls.folder / "stiff", *COARSE)
        cls.soft = made.reduced(case, cls.folder / "soft", *COARSE, "regions.seabed.shear_modulus=15e6")
        cls.one = upbead.page(cls.stiff)
        cls.two = upbead.page(cls.stiff, cls.folder / "two.html", beside=[cls.soft])
        design = made.CASES / "designer/design.toml"
        cls.both = upbead.page(cls.stiff, cls.folder / "both.html", design=design, program=made.PROGRAM)
        cls.browser = Browser(pdf.browser(), pdf.options)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def open(self, page):
        self.browser.problems.clear()
        self.browser.open(page, 1280)
        self.browser.value(SETTLED)

    def call(self, function, *arguments):
        return self.browser.value(f"({function})({', '.join(map(repr, arguments))})")

    def test_an_answer_is_kept_beside_the_next(self):
        self.open(self.one)
        before = self.call(NUMBER, "peak_shear")
        row = "document.querySelector('data[data-key=peak_shear]').parentNode.textContent"
        lines = "document.querySelectorAll('.whatif svg path[stroke-opacity]').length"
        self.assertEqual((self.browser.value(lines), "kept" in self.browser.value(HEAD)), (0, False))
        self.call(PRESS, "Keep", ".whatif")
        self.call(TYPE, "peak", "3200")  # twice that of the case
        self.browser.value(SETTLED)
        self.assertAlmostEqual(self.call(NUMBER, "peak_shear"), 2 * before, delta=1e-9 * before)
        self.assertIn("(now +100 %)", self.browser.value(row))
        self.assertIn("kept", self.browser.value(HEAD))
        self.assertGreater(self.browser.value(lines), 3)
        self.call(PRESS, "Drop", ".whatif")
        self.assertEqual((self.browser.value(lines), "kept" in self.browser.value(HEAD)), (0, False))
        self.assertEqual(self.browser.problems, [])

    def test_soils_beside_each_other(self):
        """The second soil answers the wave that the first was asked, with the numbers of its own page."""
        self.open(upbead.page(self.soft, self.folder / "alone.html"))
        self.call(TYPE, "peak", "2500")
        self.browser.value(SETTLED)
        wanted = self.call(NUMBER, "peak_shear")
        self.open(self.two)
        self.call(TYPE, "peak", "2500")
        self.browser.value(SETTLED)
        stiff = self.call(NUMBER, "peak_shear")
        self.call(PRESS, "Keep", ".whatif")
        self.call(TYPE, "soil", "1")
        self.browser.value(SETTLED)
        self.assertEqual(self.call(NUMBER, "peak_shear"), wanted)
        self.assertNotAlmostEqual(stiff, wanted, delta=0.05 * wanted)
        self.assertIn("Kept: stiff, ", self.browser.value("document.querySelector('.keeps p').textContent"))
        self.assertEqual(self.browser.problems, [])
        other = made.reduced("design-wave/composite.toml", self.folder / "other", "mesh.parameters.cells=0.4")
        with self.assertRaisesRegex(UserError, "other loads"):
            upbead.page(self.stiff, self.folder / "no.html", beside=[other])

    def test_a_link_opens_with_the_same_values(self):
        for page, asked in ((self.two, {"soil": "1", "shape": "church_roof", "peak": "2345.5", "plateau": "0.25", "friction": "0.55"}),
                            (self.both, {"design-wave": "1", "design-width": "23", "design-friction": "0.65", "peak": "1800"})):  # fmt: skip
            self.open(page)
            for key, text in asked.items():
                self.call(TYPE, key, text)
            self.browser.value(SETTLED)
            state, answer = self.browser.value(STATE), self.call(NUMBER, "peak_shear")
            self.assertLessEqual(set(asked.items()), set(map(tuple, state)))
            self.call(PRESS, "Link", ".whatif")
            self.browser.value("new Promise((done) => setTimeout(done, 100))")
            link = self.browser.value("location.href")
            self.assertIn("#ask:", link)
            self.browser.call("Page.navigate", url="about:blank")
            self.browser.events.clear()
            self.browser.call("Page.navigate", url=link)
            while "Page.loadEventFired" not in self.browser.events:
                self.browser._receive()
            self.browser.value(SETTLED)
            self.assertEqual(self.browser.value(STATE), state)
            self.assertEqual(self.call(NUMBER, "peak_shear"), answer)
            self.assertEqual(self.browser.problems, [])

    def test_limits_and_lifting_stand_beside_the_answer(self):
        self.open(self.one)
        checks = "[...document.querySelectorAll('.checks li')].map((one) => [one.dataset.holds, one.textContent])"
        self.assertEqual([holds for holds, _ in self.browser.value(checks)], ["true", "true"])
        self.assertNotIn("lifts", self.browser.value(HEAD))
        self.call(TYPE, "peak", "12000")
        self.browser.value(SETTLED)
        found = self.browser.value(checks)
        self.assertEqual([holds for holds, _ in found], ["false", "false"])
        self.assertRegex(found[1][1], r"S by eq\. \(4\): .* at most 50\smm DOES NOT HOLD")
        self.assertIn("the base liftsthe seaward edge", self.browser.value(HEAD))
        self.assertIn("shaded: after the base lifts", self.browser.value("document.querySelector('.whatif svg').textContent"))
        self.open(self.both)
        formulas = [words for _, words in self.browser.value(checks)]
        self.assertIn("S.F. against sliding", formulas[0])


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
