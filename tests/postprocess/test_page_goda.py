"""Waves by Goda's formulas in the page of a reduced model, in Chromium: P and U as by `upbead waves`, the response as
by `upbead respond`.

Skipped (exit code 77) where there is no Chromium.

usage: test_page_goda.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES
"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
import page_models as made
from chromium import Browser

import upbead
from report import pdf

EQUAL, SETTINGS = 1e-10, 8
SMALL = [f"mesh.parameters.{key}" for key in ("seabed_front=60", "seabed_back=60", "sea_front=4", "sea_back=4")]
COURSES = ("church_roof", "triangle", "sine", "combined")
SAME = ("peak_force", "peak_shear", "peak_shear_seaward")


class Waves(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.model = made.reduced("design-wave/composite.toml", cls.folder / "model", *SMALL)
        cls.design = made.CASES / "design-wave/section.toml"
        cls.alone = upbead.page(cls.model)
        cls.both = upbead.page(cls.model, cls.folder / "both.html", cls.design, made.PROGRAM)
        cls.browser = Browser(pdf.browser(), pdf.options)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def waves(self, wave, rise, *settings):
        """(wave, section) in the summary of `upbead waves`."""
        words = [f"waves.storm.{key}={value}" for key, value in wave.items()] + [f"levels.page={rise}", *settings]
        text = made.call("waves", self.design, "--json", "--out", self.folder / "waves", *(word for pair in words for word in ("--set", pair)))
        summary = json.loads(text)["waves"]["storm"]["levels"]["page"]
        return summary, summary["section"]

    def responded(self, told, U, name, friction):
        """The response by `upbead respond` to the wave that the page saves, with the ratio of its uplift to its peak
        of P."""
        wave = self.folder / f"{name}.csv"
        wave.write_text(told["wave"])
        peak = np.loadtxt(wave, delimiter=",", skiprows=1)[:, 1].max()
        model = made.changed(self.model, self.folder / f"{name}.h5", uplift_per_force=U / peak)
        with h5py.File(model) as file:
            per = file["modes/feedthrough"][list(file["readings/name"][()]).index(b"force"), 0]
        self.assertAlmostEqual(per, 1.0, places=9)
        weight = repr(told["numbers"]["goda.submerged_weight"])
        return made.respond(model, [wave], self.folder / "out", "--friction", friction, "--buoyant-weight", weight)[0][name]

    def compare(self, numbers, exact, worst):
        for key in SAME:
            worst[key] = max(worst.get(key, 0.0), abs(numbers[key] - exact[key]) / exact["peak_force"])
        for key, least in (("sliding", 1e-3), ("peak_heel_pressure", 1.0), ("peak_toe_pressure", 1.0), ("error_estimate", 1.0)):
            self.assertEqual(numbers[key] is None, exact[key] is None, key)
            if exact[key] is not None:
                worst[key] = max(worst.get(key, 0.0), abs(numbers[key] - exact[key]) / max(abs(exact[key]), least))

    def test_height_period_level_and_angle(self):
        draw, worst = np.random.default_rng(28), {}
        self.browser.open(self.alone, 1200)
        for number in range(SETTINGS):
            wave = {"height": round(draw.uniform(3, 14), 3), "period": round(draw.uniform(6, 16), 3), "angle": round(draw.choice([0.0, draw.uniform(1, 50)]), 3)}
            rise = round(draw.choice([0.0, draw.uniform(-2, 3)]), 3)
            typed = {"shape": f"goda_{COURSES[number % 4]}", "uplift": ["held", "in_phase"][number // 4 % 2], "friction": "0.55", "lag": "0"}
            typed |= {f"wave_{key}": repr(float(value)) for key, value in {**wave, "rise": rise}.items()}
            self.browser.problems.clear()
            told = made.ask(self.browser, typed)
            self.assertFalse(told["wrong"], typed)
            goda, section = self.waves(wave, rise)
            numbers = told["numbers"]
            for key, exact in (("force", goda["force"]), ("uplift", goda["uplift"]), ("alpha_star", goda["alpha_star"]), ("submerged_weight", section["submerged_weight"])):
                worst[key] = max(worst.get(key, 0.0), abs(numbers[f"goda.{key}"] / exact - 1))
            self.assertAlmostEqual(numbers["peak_force"] / goda["force"], 1.0, places=4 if "sine" in typed["shape"] else 9)
            if typed["uplift"] == "held":  # the kind in the model's own [sliding.uplift]
                self.compare(numbers, self.responded(told, goda["uplift"], f"wave{number}", "0.55"), worst)
        print(f"{SETTINGS} waves, largest differences: " + ", ".join(f"{key} {value:.0e}" for key, value in worst.items()), file=sys.stderr)
        self.assertLess(max(worst.values()), EQUAL)
        self.assertEqual(self.browser.problems, [])

    def test_follows_the_design_above(self):
        self.browser.problems.clear()
        self.browser.open(self.both, 1200)
        type_above = """((key, text) => { const field = document.querySelector(`[data-key="design-${key}"]`); field.value = text;
          field.dispatchEvent(new Event("input")); })"""
        for key, text in (("height", "9"), ("rise", "1"), ("friction", "0.5")):
            self.browser.value(f"{type_above}({key!r}, {text!r})")
        told = made.ask(self.browser, {})
        goda, section = self.waves({"height": 9}, 1, "section.friction=0.5")
        self.assertLess(abs(told["numbers"]["peak_force"] / goda["force"] - 1), EQUAL)
        self.assertLess(abs(told["numbers"]["goda.submerged_weight"] / section["submerged_weight"] - 1), EQUAL)
        self.assertEqual(self.browser.value("""document.querySelector('[data-key="friction"]').value"""), "0.5")
        self.browser.value(f"{type_above}('rise', '50')")
        self.assertIn("above has no answer", self.browser.value("document.querySelector('.whatif:not(.formulas) .wrong').textContent"))
        self.browser.value(f"{type_above}('rise', '0')")
        self.browser.value(f"{type_above}('width', '22')")
        self.assertIn("22 m, the model's caisson is 18 m wide", self.browser.value("document.querySelector('.whatif:not(.formulas)').textContent"))
        self.assertEqual(self.browser.problems, [])

    def test_for_phones_wide_screens_and_all_readers(self):
        source = made.axe(self.folder)
        for width in (360, 1600):
            self.browser.problems.clear()
            self.browser.open(self.both, width)
            self.assertEqual(self.browser.problems, [])
            self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
            if source:
                self.assertEqual(made.violations(self.browser, source), [])


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
