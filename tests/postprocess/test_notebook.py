"""Display of results in a notebook: tables, figures, the interactive page; the notebooks of docs, where Jupyter is
installed.

usage: test_notebook.py FOLDER_OF_THE_SCRIPTS PROGRAM CASES_FOLDER [TEST ...]
"""

import html
import importlib.util
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

SCRIPTS, PROGRAM, CASES = (Path(argument).resolve() for argument in sys.argv[1:4])
NOTEBOOK = SCRIPTS.parent / "docs/notebook.ipynb"
NOTEBOOKS = sorted(NOTEBOOK.parent.glob("notebook*.ipynb"))
JUPYTER = all(importlib.util.find_spec(name) for name in ("nbclient", "nbformat", "ipykernel"))
TITLE = '<b>&"</b><script>alert(1)</script>'
os.environ["UPBEAD"] = str(PROGRAM)
sys.path.insert(0, str(SCRIPTS))

import upbead  # noqa: E402
from chromium import Browser  # noqa: E402
from report import pdf  # noqa: E402
from upbead.fit_directions import Identifiable  # noqa: E402
from upbead.lumped_model import Source, write_lumped  # noqa: E402
from upbead.shown import parts  # noqa: E402

ASKED = {"mesh.parameters.cells": 0.4, "title": TITLE}


class Shown(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        case = CASES / "fig2b-model.toml"
        cls.model = upbead.reduce(case, set=ASKED, out=cls.folder / "run")
        cls.result = upbead.run(case, set=ASKED, out=cls.folder / "run")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def shown(self, thing):
        """The HTML of a thing; no text from input files becomes an element, and its repr in a terminal is short."""
        self.assertLess(len(repr(thing)), 300)
        self.assertNotIn("\n", repr(thing))
        text = thing._repr_html_()
        self.assertNotIn("<script", text)
        self.assertNotIn("<b>", text)
        for src in re.findall(r'(?:src|href)="([^"]*)"', text):
            self.assertTrue(src.startswith("data:image/png;base64,"), src[:60])
        return text

    def test_a_run_shows_what_was_found_and_answers_where_its_model_lies_beside_it(self):
        text = self.shown(self.result)
        self.assertIn(html.escape(TITLE), text)
        self.assertIn(f"<td>{parts.quantity(self.result.summary['response']['peak_shear'], 'N/m')}</td>", text)
        self.assertEqual((text.count("<img "), text.count("<iframe ")), (1, 1))

    def test_a_model_of_another_scene_does_not_answer_for_a_run(self):
        other = upbead.run(CASES / "fig2b-model.toml", set=ASKED | {"mesh.parameters.cells": 0.5}, out=self.folder / "other")
        (self.folder / "other/reduced.h5").write_bytes((self.folder / "run/reduced.h5").read_bytes())
        self.assertNotIn("<iframe ", self.shown(other))

    def test_a_model_is_a_page_in_a_sandbox(self):
        text = self.shown(self.model)
        frame = re.search(r"<iframe ([^>]*)>", text)[1]
        self.assertIn('sandbox="allow-scripts allow-downloads"', frame)
        page = html.unescape(re.search(r'srcdoc="([^"]*)"', frame)[1])
        self.assertEqual(page, upbead.page(self.folder / "run").read_text(encoding="utf-8"))

    def test_a_model_that_is_gone_says_so(self):
        path = self.folder / "gone.h5"
        path.write_bytes((self.folder / "run/reduced.h5").read_bytes())
        model = upbead.open_model(path)
        path.unlink()
        self.assertIn("cannot be made", self.shown(model))

    def test_one_mass_on_a_spring(self):
        source = Source(self.folder / "run/reduced.h5", None)
        self.assertIn(f"<td>{source.frequency:.4g} Hz</td>", self.shown(source))
        self.assertEqual(write_lumped(self.folder / "lumped.h5", source), (source.frequency, source.damping))
        self.assertIn("<iframe ", self.shown(upbead.open_model(self.folder / "lumped.h5")))

    def test_waves(self):
        waves = upbead.waves(CASES / "designer/design.toml", out=self.folder / "waves")
        self.assertEqual(json.loads(json.dumps(waves)), dict(waves))
        text = self.shown(waves)
        self.assertEqual((text.count("<tr>"), text.count("<img ")), (1 + len(waves["waves"]), 1))

    def test_expected_sliding(self):
        folder = self.folder / "expected"
        folder.mkdir()
        told = {"years": 50.0, "distance_paper": 0.004, "waves_that_slide": {"paper": 1.5}, "threshold_height": {"paper": 3.0}}
        summary = {"title": TITLE, "expected": told, "exceedance": {}}
        (folder / "summary.json").write_text(json.dumps(summary))
        with h5py.File(folder / "results.h5", "w") as file:
            for name in ("height", "waves", "distance/paper", "contribution/paper"):
                file[f"heights/{name}"] = np.linspace(0.0, 5.0, 11)
        text = self.shown(upbead.open(folder))
        self.assertIn(">eq. (7)</th><td>4 mm</td><td>1.5</td><td>3 m</td>", text)
        self.assertEqual(text.count("<img "), 1)

    def test_a_calibration(self):
        folder = self.folder / "calibration"
        folder.mkdir()
        fit = {"measure": "exact", "ratio": 1.2, "points": 3, "a": 0.4, "b": 1.1, "covariance": None}
        model = {"title": TITLE, "scale": 1.0, "recommended": {"a": 0.4, "b": 1.1, "residual_deviation": 0.2}, "fits": [fit]}
        (folder / "summary.json").write_text(json.dumps({"title": TITLE, "given": {"a": 0.3, "b": 2.0}, "models": {TITLE: model}}))
        with h5py.File(folder / "results.h5", "w") as file:
            file["model"] = [TITLE.encode()] * 3
            for name in ("ratio", "k_exact", "alpha_star", "period"):
                file[name] = [1.2, 1.2, 1.2] if name == "ratio" else [0.5, 0.6, 0.7]
        text = self.shown(upbead.open(folder))
        self.assertIn("<td>0.4</td><td>1.1</td><td>0.2</td>", text)

    def test_a_fit(self):
        time = np.linspace(0.0, 1.0, 5)
        record = upbead.History(time, "N/m")
        found = upbead.Fit({"a.b": 2e6}, {"a.b": (1e6, 3e6)}, np.eye(1), np.eye(1), record, Identifiable([], [], [], np.eye(1)), 0.1, 7,
                           "shear_force", {"a.b": 1e6}, time, record, record, record, cautions=["<b>"])
        text = self.shown(found)
        self.assertIn(">a.b</th><td>2e+06</td><td>(1e+06 to 3e+06)</td><td>1e+06</td>", text)
        self.assertIn("Caution: &lt;b&gt;", text)

    def test_a_study_leaves_out_rows_of_its_middle(self):
        folder = self.folder / "study"
        folder.mkdir()
        rows = [f"{i},{1e6 * (i + 1)},{0.1 * i},{'done' if i < 30 else 'failed'},<i>why</i>" for i in range(32)]
        (folder / "study.csv").write_text("run,regions.seabed.shear_modulus,response.peak_shear,status,message\n" + "\n".join(rows) + "\n")
        with h5py.File(folder / "study.h5", "w") as file:
            file["varied/regions.seabed.shear_modulus"], file["read/response.peak_shear"] = np.arange(32.0), np.arange(32.0)
        text = self.shown(upbead.open(folder))
        self.assertIn("… 10 more", text)
        self.assertIn("2 more runs failed: &lt;i&gt;why", text)
        self.assertEqual((text.count("<tr>"), text.count("<img ")), (1 + 20 + 1, 1))

    def test_what_cannot_be_drawn_says_why(self):
        def draw():
            raise upbead.UserError("<no> numbers")

        self.assertIn("Not drawn: &lt;no&gt; numbers.", parts.picture(draw, "x"))

    def test_the_package_loads_neither_matplotlib_nor_jupyter(self):
        code = f"import sys; sys.path.insert(0, {str(SCRIPTS)!r}); import upbead; print([n for n in ('matplotlib', 'IPython') if n in sys.modules])"
        done = subprocess.run(["/usr/bin/python3", "-B", "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), "[]")

    @unittest.skipIf(pdf.browser() is None, "no Chromium")
    def test_sliders_answer_within_the_notebook(self):
        page = self.folder / "cell.html"
        page.write_text(f'<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,"><body>{self.model._repr_html_()}', encoding="utf-8")
        with Browser(pdf.browser(), pdf.options) as browser:
            browser.open(page, 1000)
            frame = browser.frame()
            told = """new Promise((done) => { const look = () => {
              const found = document.querySelector('data[data-key="peak_shear"]');
              if (found) done(+found.value); else setTimeout(look, 20); }; look(); })"""
            before = browser.value(told, frame)
            self.assertEqual(browser.value("window.origin", frame), "null")  # it has no access to the notebook
            x, y = browser.value("(({left, top}) => [left, top])(document.querySelector('iframe').getBoundingClientRect())")
            left, top, width, height = browser.value(
                "(({left, top, width, height}) => [left, top, width, height])(document.querySelector('input[type=range]').getBoundingClientRect())", frame)
            for kind in ("mousePressed", "mouseReleased"):
                browser.mouse(kind, x + left + 0.9 * width, y + top + height / 2, clickCount=1)
            browser.value("new Promise((done) => setTimeout(done, 500))", frame)
            self.assertNotEqual(browser.value(told, frame), before)
            self.assertEqual(browser.problems, [])


class Notebooks(unittest.TestCase):
    def test_they_are_small_and_hold_no_outputs(self):
        for path in NOTEBOOKS:
            cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
            self.assertLess(path.stat().st_size, 10_000)
            self.assertFalse([cell for cell in cells if cell.get("outputs") or cell.get("execution_count")], path)

    def executed(self, path, folder):
        """(what each cell shows, what all print) of a notebook that runs in a folder with the cases."""
        nbformat, nbclient = (importlib.import_module(name) for name in ("nbformat", "nbclient"))
        book = nbformat.read(path, as_version=4)
        os.symlink(CASES, Path(folder) / "cases")
        os.environ["PYTHONPATH"] = str(SCRIPTS)
        nbclient.NotebookClient(book, timeout=600, kernel_name="python3", resources={"metadata": {"path": folder}}).execute()
        nbformat.validate(book)
        outputs = [output for cell in book.cells for output in cell.get("outputs", [])]
        return [output["data"] for output in outputs if "data" in output], "".join(output["text"] for output in outputs if "text" in output)

    @unittest.skipUnless(JUPYTER, "no nbclient, nbformat or ipykernel")
    def test_fig_2b(self):
        with tempfile.TemporaryDirectory() as folder:
            shown, printed = self.executed(NOTEBOOK, folder)
            summary = json.loads((Path(folder) / "results/notebook/prototype/summary.json").read_text())
        self.assertEqual(len(shown), 3)
        self.assertIn("<table", shown[0]["text/html"])
        self.assertLess(len(shown[0]["text/plain"]), 300)
        self.assertIn("image/png", shown[1])  # Fig. 2b itself
        self.assertIn("<iframe ", shown[2]["text/html"])
        self.assertIn(f"prototype: peak F_T / peak P = {summary['response']['shear_to_force_ratio']:.2f}\n", printed)
        told = re.search(r"0\.15 s: peak F_T / peak P = ([\d.]+)", printed)  # the wave of the case itself
        self.assertAlmostEqual(float(told[1]), summary["response"]["shear_to_force_ratio"], delta=0.006)

    @unittest.skipUnless(JUPYTER and importlib.util.find_spec("pandas"), "no nbclient, nbformat, ipykernel or pandas")
    def test_stiffness(self):
        with tempfile.TemporaryDirectory() as folder:
            shown, printed = self.executed(NOTEBOOK.with_name("notebook-stiffness.ipynb"), folder)
            study = upbead.open(Path(folder) / "results/notebook/stiffness")
        self.assertIn("9 runs", shown[0]["text/html"])
        self.assertIn("<table", shown[1]["text/html"])
        self.assertTrue(printed.startswith("Pa\n"), printed)
        told = re.search(r"at G = ([\d.]+) MPa; from ([\d.]+) to ([\d.]+)", printed)
        self.assertAlmostEqual(float(told[1]), 6.57, delta=0.3)  # the calibrated sand of the case, whose ratio is 0.75
        ratio = study["response.shear_to_force_ratio"]
        self.assertEqual([float(told[2]), float(told[3])], [round(ratio.min(), 2), round(ratio.max(), 2)])
        longer = [[float(x) for x in row.split(",")] for row in re.findall(r"ms: (.*)", printed)]
        self.assertEqual(len(longer), 3)
        self.assertTrue(all(soft < stiff for soft, stiff in longer[:2]), longer)  # a short pulse reaches less through soft sand

    @unittest.skipUnless(JUPYTER, "no nbclient, nbformat or ipykernel")
    def test_calibration(self):
        with tempfile.TemporaryDirectory() as folder:
            shown, printed = self.executed(NOTEBOOK.with_name("notebook-calibration.ipynb"), folder)
            found = upbead.open(Path(folder) / "results/notebook/calibration")
        self.assertIn("<iframe ", shown[0]["text/html"])
        self.assertIn("<table", shown[1]["text/html"])
        self.assertIn("image/png", shown[2])
        for name, model in found.models.items():
            self.assertIn(f"{name}: a = {model['recommended']['a']:.2f}, b = {model['recommended']['b']:.2f}", printed)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
