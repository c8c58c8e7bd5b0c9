"""The page of a design in Chromium without a window against `upbead waves`: the same numbers to 1e-10, the same warnings.

Skipped (exit code 77) where there is no Chromium.

usage: test_page_design.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES [SECTIONS WAVES]

SECTIONS with WAVES each: 8 with 6 by default; the long tests have 20 with 10.
"""

import json
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import numpy as np
import page_models as made
from chromium import Browser

import upbead
from report import pdf
from upbead import typeset
from upbead.program import toml_value
from upbead.told import warning_text

SECTIONS, WAVES = map(int, sys.argv[4:6]) if len(sys.argv) > 5 else (8, 6)
EQUAL = 1e-10
NOT_OF_A_WAVE = ("water_depth", "submerged_weight")
# Types {key: text} one by one; returns the numbers, the warnings, the mistake, and the design as the page saves it.
TYPE = """async (settings) => {
  const saved = [], click = HTMLAnchorElement.prototype.click, address = URL.createObjectURL;
  HTMLAnchorElement.prototype.click = () => {};
  URL.createObjectURL = (blob) => { saved.push(blob.text()); return "data:,"; };
  for (const [key, text] of settings) {
    const field = document.querySelector(`[data-key="design-${key}"]`);
    field.value = text;
    field.dispatchEvent(new Event("input"));
  }
  const wrong = document.querySelector(".formulas .wrong").textContent, numbers = {}, told = {};
  for (const item of document.querySelectorAll(".formulas data")) numbers[item.dataset.key] = JSON.parse(item.value);
  for (const item of document.querySelectorAll("[data-warning]")) told[item.dataset.warning] = item.textContent;
  for (const button of document.querySelectorAll(".formulas .saves button")) button.click();
  HTMLAnchorElement.prototype.click = click;
  URL.createObjectURL = address;
  return {numbers, warnings: told, wrong, saved: await Promise.all(saved)};
}"""


def random_section(draw):
    """Fields of a section and a level, sometimes with unusual values."""
    h = draw.uniform(8, 30)
    bottom = h * draw.uniform(0.4, 1.05)
    sizes = {"water_depth": h, "foundation_depth": bottom, "berm_depth": bottom * draw.uniform(0.6, 1.1), "crest": draw.uniform(1, 12),
             "berm_width": draw.choice([0.0, draw.uniform(2, 30)]), "bed_slope": draw.uniform(0, 0.12), "width": draw.uniform(8, 28), "friction": draw.uniform(0.4, 0.8)}
    weight = draw.uniform(5e3, 12e3)
    rise = draw.choice([0.0, draw.uniform(-0.3, 0.9) * sizes["crest"]])
    typed = {**{key: f"{value:.5g}" for key, value in sizes.items()}, "weight": f"{weight:.5g}", "rise": f"{rise:.4g}"}
    return list(typed.items())


def random_wave(draw):
    kind = draw.choice(["height", "height", "deep_water_height"])
    typed = [("by", kind), ("period", f"{draw.uniform(4, 20):.5g}"), ("angle", f"{draw.choice([0.0, *draw.uniform(0, 60, 4)]):.4g}"), (kind, f"{10 ** draw.uniform(0, 1.2):.5g}")]
    return typed + ([("significant_height", draw.choice(["", f"{draw.uniform(1, 8):.4g}"]))] if kind == "height" else [])


def as_set(text):
    """Words with their symbols set, as text: alpha_I is αI."""
    return typeset.GREEK.sub(lambda found: typeset.LETTERS[found[1]], text).replace("_", "")


class Formulas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        file = cls.folder / "design.toml"
        text = (made.CASES / "designer/design.toml").read_text().split("[sea]")[0]
        text = text.replace("\nwidth = 20.0", "\ncentroid = 9.4\nwidth = 20.0", 1)  # so that a level and a width move it
        file.write_text(text + "[limits]\nbase_pressure = 500e3\noverturning = 1.2\n")
        cls.browser = Browser(pdf.browser(), pdf.options)
        cls.browser.open(upbead.page(file, cls.folder / "page.html", program=made.PROGRAM), 1200)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def type(self, settings):
        return self.browser.value(f"({TYPE})({json.dumps(list(settings))})")

    def test_settings_as_waves_tells_them(self):
        draw, worst, warned = np.random.default_rng(27), {}, set()
        for number in range(SECTIONS):
            self.compare_section(draw, number, worst, warned)
        told = ", ".join(f"{key} {value:.0e}" for key, value in sorted(worst.items(), key=lambda item: -item[1])[:5])
        print(f"{SECTIONS * WAVES} settings, largest differences: {told}; warnings met: {', '.join(sorted(warned))}", file=sys.stderr)
        self.assertLess(max(worst.values()), EQUAL)
        self.assertGreater(len(warned), 10)

    def compare_section(self, draw, number, worst, warned):
        while self.type(random_section(draw))["wrong"]:  # the level or W' is refused, which another test checks
            self.assertIn("No answer", self.type([])["wrong"])
        answers = {f"w{i}": self.type(random_wave(draw)) for i in range(WAVES)}
        designs = {name: tomllib.loads(answer["saved"][1]) for name, answer in answers.items()}
        design = next(iter(designs.values()))
        design["waves"] = {name: one["waves"]["page"] for name, one in designs.items()}
        file = self.folder / f"section{number}.toml"
        file.write_text("".join(f"{key} = {toml_value(value)}\n" for key, value in design.items()))
        exact = json.loads(made.call("waves", file, "--json", "--out", self.folder / f"out{number}"))["waves"]
        for name, answer in answers.items():
            self.assertEqual(answer["wrong"], "")
            self.compare(answer, exact[name]["levels"]["page"] if "levels" in design else exact[name], worst, warned)

    def compare(self, answer, exact, worst, warned):
        for key, value in answer["numbers"].items():
            if key in NOT_OF_A_WAVE:
                continue
            program = exact["without_alpha_I"]["force"] if key == "without_alpha_I.force" else exact[key]
            if value is None or program is None:  # p_e of a caisson that floats or overturns
                self.assertEqual(value, program, key)
                continue
            scale = max(abs(program), 1e-6 if key.startswith("sliding_") else 1e-300)
            worst[key] = max(worst.get(key, 0.0), abs(value - program) / scale)
        told = {warning["name"]: warning_text(warning) for warning in exact["warnings"] if "standing" not in warning["text"]}
        self.assertEqual({name: as_set(text) for name, text in answer["warnings"].items() if name in told}, {name: as_set(text) for name, text in told.items()})
        # warnings of the standing wave where it governs
        self.assertLessEqual(set(answer["warnings"]) - set(told), {"base_pressure", "overturning_limit"})
        warned.update(told)

    def test_sea_and_harbour_at_two_levels_are_refused(self):
        file = self.folder / "harbour.toml"
        file.write_text((self.folder / "design.toml").read_text().replace("\nwidth = ", "\nharbour_level = -1.0\nwidth = ", 1))
        with self.assertRaisesRegex(upbead.UserError, "two levels"):
            upbead.page(file, self.folder / "harbour.html", program=made.PROGRAM)

    def test_what_the_program_refuses_is_not_answered(self):
        self.browser.open(self.folder / "page.html", 1200)
        refused = {
            (("rise", "-7"),): "still water would fall to the sea bed",
            (("rise", "10.5"),): "above the crest",
            (("submerged_weight", "400"), ("rise", "3")): "would float",
            (("height", "0"),): "Highest wave H: give",
            (("angle", "90"),): "below 90 degrees",
            (("friction", ""), ("width", "-1")): "Width B: give",
            (("water_depth", "x"),): "Depth at the wall h: give",
        }
        for settings, words in refused.items():
            self.browser.open(self.folder / "page.html", 1200)
            said = self.type(settings)
            self.assertIn(words, said["wrong"], settings)
            self.assertEqual(said["saved"], [])
            self.assertEqual(self.browser.value("getComputedStyle(document.querySelector('.tables')).visibility"), "hidden")

    def test_weights_move_along(self):
        self.browser.open(self.folder / "page.html", 1200)
        value = lambda key: float(self.browser.value(f"""document.querySelector('[data-key="design-{key}"]').value"""))
        self.type([("width", "30")])
        self.assertAlmostEqual(value("weight"), 1.5 * 7004, places=6)
        self.assertAlmostEqual(value("submerged_weight"), 1.5 * 5589, places=6)
        self.type([("weight", "10000")])
        self.assertAlmostEqual(10000 - value("submerged_weight"), 1.5 * (7004 - 5589), places=6)

    def test_the_second_wave_of_the_design(self):
        self.browser.open(self.folder / "page.html", 1200)
        numbers = self.type([("wave", "1")])["numbers"]
        exact = json.loads(made.call("waves", self.folder / "design.toml", "--json", "--out", self.folder / "second"))["waves"]["storm"]
        self.assertLess(abs(numbers["force"] / exact["force"] - 1), EQUAL)


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
