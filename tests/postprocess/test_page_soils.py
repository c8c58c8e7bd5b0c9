"""The page of a model of soils in Chromium: F_T of any soil is that of `respond --soil` within the page's tolerance; sliders, sizes.

Skipped (exit code 77) where there is no Chromium.

usage: test_page_soils.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES
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
from upbead.errors import ModelError, UserError
from upbead.live import soil_data

LARGEST_PAGE = 2.5e6
G, K, RATIO = "regions.mound.shear_modulus", "regions.mound.hydraulic_conductivity", "regions.seabed.damping.ratio"
BOX = {G: (2e7, 1.2e8, "log_uniform"), K: (0.03, 0.6, "log_uniform"), RATIO: (0.03, 0.08, "uniform")}
TYPE = """(values) => { for (const key in values) { const field = document.querySelector(`[data-key="${key}"]`); field.value = values[key];
  field.dispatchEvent(new Event("input")); } return document.querySelector(".wrong").textContent; }"""
NUMBER = """Number(document.querySelector('.whatif data[data-key="peak_shear"]').value)"""
ANSWER = """(soil) => { const start = performance.now(), {time, F} = document.querySelector(".whatif").answerOf(soil);
  return {took: performance.now() - start, time: Array.from(time), F: Array.from(F)}; }"""


class PageOfSoils(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        box = "".join(f'[vary."{key}"]\ndistribution = "{kind}"\nlow = {low}\nhigh = {high}\n' for key, (low, high, kind) in BOX.items())
        (cls.folder / "box.toml").write_text(box)
        made.call("reduce", made.CASES / "fig2b-prototype.toml", "--soils", cls.folder / "box.toml", "--set", "mesh.parameters.cells=0.5",
                  "--out", cls.folder)
        cls.model = cls.folder / "soils.h5"
        cls.page = upbead.page(cls.model)
        cls.browser = Browser(pdf.browser(), pdf.options)

    def setUp(self):
        self.browser.open(self.page, 1280)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def call(self, function, *arguments):
        return self.browser.value(f"({function})({', '.join(map(json.dumps, arguments))})")

    def test_shear_force_is_that_of_the_program(self):
        rng, took = np.random.default_rng(5), []
        for _ in range(6):
            soil = {key: low * (high / low) ** rng.random() for key, (low, high, _) in BOX.items()}
            options = [word for key, value in soil.items() for word in ("--soil", f"{key}={value}")]
            _, told = made.respond(self.model, [made.CASES / "fig2b-prototype-impulse.csv"], self.folder / "told", *options)
            with h5py.File(told) as file:
                [group] = [one for one in file.values() if isinstance(one, h5py.Group)]
                times, exact = group["time"][()], group["shear_force"][0]
            answer = self.call(ANSWER, soil)
            F = np.interp(times, answer["time"], answer["F"])
            inside = times <= answer["time"][-1]
            self.assertLess(np.abs(F - exact)[inside].max(), soil_data.TOLERANCE * np.abs(exact).max(), soil)
            self.assertEqual(self.call(TYPE, soil), "")
            self.assertAlmostEqual(self.browser.value(NUMBER), max(answer["F"]), delta=1e-9 * max(answer["F"]))
            took.append(answer["took"])
        print(f"a soil: median {np.median(took):.1f} ms of {len(took)}; page of {self.page.stat().st_size} bytes", file=sys.stderr)

    def test_size(self):
        self.assertLess(self.page.stat().st_size, LARGEST_PAGE)
        self.assertEqual(self.browser.problems, [])

    def test_a_slider_moves_the_answer(self):
        before = self.browser.value(NUMBER)
        self.browser.value(f"""(() => {{ const slider = document.querySelector('[data-key="{G}"]').parentNode.querySelector("input[type=range]");
          slider.value = slider.value > 500 ? 0 : 1000; slider.dispatchEvent(new Event("input")); return 0; }})()""")
        self.assertGreater(abs(self.browser.value(NUMBER) / before - 1), 0.01)

    def test_a_soil_beyond_the_box_has_no_answer(self):
        self.assertIn("No answer: mound shear modulus is outside", self.call(TYPE, {G: 2e9}))
        self.assertEqual(self.call(TYPE, {G: 5e7}), "")

    def test_from_phones_to_wide_screens(self):
        for width, dark in ((360, False), (1280, True)):
            self.browser.open(self.page, width, dark=dark)
            self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)

    def test_a_void_scene_is_told_beside_every_number(self):
        page = upbead.page(made.voided(self.model, self.folder / "void.h5"), self.folder / "void.html")
        self.browser.open(page, 1280)
        for place in (".headline", ".whatif figure"):
            self.assertIn("VOID: implausible", self.browser.value(f"document.querySelector('{place}').textContent"))

    def test_refuses_what_it_cannot_answer(self):
        other = self.folder / "other.h5"
        other.write_bytes(self.model.read_bytes())
        with h5py.File(other, "a") as file:
            file["family/factors"][1, 0] *= 1.3
        with self.assertRaisesRegex(ModelError, "no products of powers of its keys"):
            upbead.page(other)
        with self.assertRaisesRegex(UserError, "neither a design nor models beside it"):
            upbead.page(self.model, beside=[self.model])


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
