"""The slip circles of the interactive page, in Chromium without a window, compared with `upbead respond`: the same least
factor, to 1e-9, of waves that stand, of some that leave the base, and seaward ones.

Skipped (exit code 77) where there is no Chromium.

usage: test_page_circles.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES
"""

import sys
import tempfile
import unittest
from pathlib import Path

import page_models as made
from chromium import Browser

import upbead
from report import pdf

EQUAL = 1e-9
SECTION = Path(__file__).parents[1] / "support/section.toml"
CHANGES = {
    "[regions.seabed]\n": "[regions.seabed]\nstrength = { friction_angle = 35, cohesion = 0 }\n",
    "[regions.mound]\n": "[regions.mound]\nstrength = { friction_angle = 40, cohesion = 20e3 }\n",
    "[boundaries]": "[sliding]\nfriction = 0.6\nsubmerged_weight = 2.2e6\n[initial]\nwater_level = 6\n[boundaries]",
    "peak = 1e6": "peak = 2e5",
}
WAVES = [("triangle", 50, 0.15), ("church_roof", 120, 0.4), ("half_sine", -90, 0.5), ("triangle", 200, 0.08), ("triangle", 9e3, 0.3)]


class Circles(unittest.TestCase):
    def test_the_page_has_the_circles_of_respond(self):
        with tempfile.TemporaryDirectory() as temporary, Browser(pdf.browser(), pdf.options) as browser:
            folder, text = Path(temporary), SECTION.read_text()
            for before, after in CHANGES.items():
                self.assertIn(before, text)
                text = text.replace(before, after, 1)
            (folder / "strong.toml").write_text(text)
            model = made.reduced(folder / "strong.toml", folder / "model")
            browser.open(upbead.page(model), 1200)
            answers = {}
            for number, (shape, peak, duration) in enumerate(WAVES):
                settings = {"shape": shape, "peak": str(peak), "rise": repr(0.3 * duration), "duration": repr(duration),
                            "plateau": "0.4", "plateau_duration": repr(2 * duration), "start": "0"}
                answers[f"wave{number}"] = told = made.ask(browser, settings)
                self.assertFalse(told["wrong"], settings)
                (folder / f"wave{number}.csv").write_text(told["wave"])
            exact, _ = made.respond(model, sorted(folder.glob("wave*.csv")), folder / "out")
            worst, zeros, ways = 0.0, 0, set()
            for name, told in answers.items():
                circle = exact[name]["circle"]
                worst = max(worst, abs(told["numbers"]["circle_factor"] - circle["factor"]))
                zeros += circle["factor"] == 0
                ways.add(circle["slips"])
            print(f"{len(WAVES)} waves, largest difference of F {worst:.1e}", file=sys.stderr)
            self.assertLess(worst, EQUAL)
            self.assertEqual(zeros, 1, "one wave turns the caisson over")
            self.assertTrue({"landward", "seaward"} <= ways, ways)


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
