"""The page of a design in Chromium without a window: display and typing, and its storms and lives.

Skipped (exit code 77) where there is no Chromium; the test with axe-core is skipped if npm cannot fetch it.

usage: test_page_design_browser.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES
"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

import page_models as made
from chromium import Browser

import upbead
from report import pdf

LARGEST_PAGE = 1.5e6
LIFE = '[life]\nyears = 9\nsimulated_lives = 20\n[scatter.force]\ncov = 0.1\nlow = 0.2\n'
TYPE = """((key, text) => { const field = document.querySelector(`[data-key="design-${key}"]`); field.value = text;
  field.dispatchEvent(new Event("input")); return document.querySelector(".wrong").textContent; })"""


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        case = made.CASES / "section4"
        (cls.folder / "sea_states.csv").write_bytes((case / "sea_states.csv").read_bytes())
        cls.design = cls.folder / "design.toml"
        title, rest = (case / "hd10.toml").read_text().split("[section]", 1)
        cls.design.write_text(title + f"levels = {{ high = 1.5 }}\n[section]{rest}\n{LIFE}")
        cls.page = upbead.page(cls.design, cls.folder / "page.html", program=made.PROGRAM)
        cls.browser = Browser(pdf.browser(), pdf.options)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def show(self, width=1280, **options):
        self.browser.problems.clear()
        self.browser.open(self.page, width, **options)
        return self.browser.value

    def type(self, key, text):
        return self.browser.value(f"{TYPE}({json.dumps(key)}, {json.dumps(text)})")

    def text(self, selector):
        return self.browser.value(f"document.querySelector({json.dumps(selector)}).textContent")

    def test_from_phones_to_wide_screens(self):
        for width in (360, 640, 861, 1280, 1600):
            for dark in (False, True):
                value = self.show(width, dark=dark)
                self.assertEqual(self.browser.problems, [], f"{width} px, dark: {dark}")
                self.assertLessEqual(value("document.documentElement.scrollWidth"), width)

    def test_asks_for_nothing(self):
        self.browser.call("Network.enable")
        self.browser.requests.clear()
        self.show()
        self.type("height", "12")
        asked = [address for address in self.browser.requests if not address.startswith("data:")]
        self.browser.call("Network.disable")
        self.assertEqual(asked, [self.page.resolve().as_uri()])

    def test_size(self):
        size = len(self.page.read_bytes())
        print(f"page of a design with lives: {size} bytes", file=sys.stderr)
        self.assertLess(size, LARGEST_PAGE)

    def test_a_slider_by_keys(self):
        self.show()
        before = float(self.browser.value("""document.querySelector('data[data-key="force"]').value"""))
        self.browser.value("""document.querySelector('[data-key="design-height"]').parentNode.querySelector("input[type=range]").focus()""")
        for kind in ("rawKeyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key="PageUp", code="PageUp", windowsVirtualKeyCode=33)
        self.assertGreater(float(self.browser.value("""document.querySelector('data[data-key="force"]').value""")), 1.05 * before)

    def test_levels_of_the_design(self):
        self.show()
        self.type("level", "1")
        self.assertEqual(self.browser.value("""document.querySelector('[data-key="design-rise"]').value"""), "1.5")

    def test_classes_of_expected_sliding(self):
        self.show()
        data = json.loads(self.text("script.design-model"))["life"]
        at = data["widths"].index(18.0)
        exact = json.loads(made.call("expected", self.design, "--json", "--out", self.folder / "own"))
        for law in ("paper", "exact", "combined"):
            self.assertAlmostEqual(data["laws"][law][at] / exact["expected"][f"distance_{law}"], 1.0, places=12)
        self.assertAlmostEqual(data["lives"]["mean"][at] / exact["monte_carlo"]["mean"], 1.0, places=12)
        for values in data["laws"].values():
            self.assertEqual(values, sorted(values, reverse=True))
        self.assertIn("Computed beforehand by upbead", self.text(".life"))
        self.assertIn("Section 4 of Shimosako", self.text(".life"))

    def test_classes_are_greyed_where_they_are_of_other_values(self):
        self.show()
        stale = "document.querySelector('.life').classList.contains('stale')"
        for key, text in (("height", "12"), ("period", "11"), ("rise", "1"), ("angle", "20"), ("width", "20.5")):
            self.type(key, text)
            self.assertFalse(self.browser.value(stale), key)
        self.type("friction", "0.55")
        self.assertTrue(self.browser.value(stale))
        self.assertIn("μ is 0.55, in the classes 0.6", self.text(".life .warned"))
        self.type("friction", "0.6")
        self.assertFalse(self.browser.value(stale))
        self.type("submerged_weight", "4000")
        self.assertIn("W′ is", self.text(".life .warned"))

    def test_of_a_folder_of_results(self):
        made.call("waves", made.CASES / "fig10/impulsive.toml", "--out", self.folder / "waves")
        written = upbead.page(self.folder / "waves")
        self.assertEqual(written, self.folder / "waves/page.html")
        self.browser.problems.clear()
        self.browser.open(written, 1280)
        self.assertEqual(self.browser.problems, [])
        self.assertEqual(self.text(".wrong"), "")

    def test_what_is_no_design_is_told(self):
        wrong = self.folder / "wrong.toml"
        wrong.write_text("[section]\nwater_depth = -1\n")
        with self.assertRaisesRegex(upbead.CaseError, "water_depth"):
            upbead.page(wrong, self.folder / "wrong.html", program=made.PROGRAM)
        before = self.design.read_text()
        with self.assertRaisesRegex(upbead.UserError, "which is read"):
            upbead.page(self.design, self.design, program=made.PROGRAM)
        self.assertEqual(self.design.read_text(), before)

    def test_for_all_readers(self):
        source = made.axe(self.folder)
        if source is None:
            self.skipTest("npm does not bring axe-core")
        for width, dark in ((360, False), (1280, True)):
            self.show(width, dark=dark)
            self.type("friction", "0.55")
            self.assertEqual(made.violations(self.browser, source), [], f"{width} px, dark: {dark}")


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
