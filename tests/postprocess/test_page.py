"""The interactive page, in Chromium without a window, compared with `upbead respond`: the same numbers to 1e-10.

Skipped (exit code 77) where there is no Chromium.

usage: test_page.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES [GROUPS WAVES]

GROUPS of WAVES settings each: 5 of 4 by default, a group for each kind of uplift; the long tests have 20 of 10.
"""

import io
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

GROUPS, WAVES = map(int, sys.argv[4:6]) if len(sys.argv) > 5 else (5, 4)
EQUAL = 1e-10
SLIDING = [
    {"uplift": "none"},
    {"uplift": "in_phase", "lag": 0.0},
    {"uplift": "held", "lag": 0.01},
    {"uplift": "computed"},
    {"uplift": "none", "drag": 3e5},
]
SHAPES = ("triangle", "church_roof", "half_sine", "step")
SAME = ("peak_force", "peak_shear", "peak_shear_seaward")


def random_wave(draw, peak, duration):
    """Texts of the fields; rise and plateau are sometimes at the ends of their ranges."""
    long = duration * 10 ** draw.uniform(-1.2, 1.2)
    shape, within = draw.choice(SHAPES), draw.uniform(0, long)
    rise = draw.choice([0.0, long if shape == "triangle" else within, within, within])
    return {
        "shape": shape,
        "peak": f"{peak * draw.choice([-1, 1, 1, 1]) * 10 ** draw.uniform(-1, 0.7) / 1e3:.6g}",
        "rise": repr(float(rise)),
        "duration": repr(float(long)),
        "plateau": f"{draw.uniform(0.05, 0.95):.4g}",
        "plateau_duration": repr(float(long * draw.uniform(1.01, 10))),
        "start": draw.choice(["0", f"{draw.uniform(0, 3 * duration):.4g}"]),
    }


class Numbers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.model = made.reduced("fig2b-prototype.toml", cls.folder / "model", "mesh.parameters.cells=0.5")
        cls.browser = Browser(pdf.browser(), pdf.options)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def test_settings_as_respond_answers_them(self):
        draw, worst = np.random.default_rng(26), {}
        for group in range(GROUPS):
            self.compare_group(draw, group, worst)
        told = ", ".join(f"{key} {value:.1e}" for key, value in worst.items())
        print(f"{GROUPS * WAVES} settings, largest differences: {told}", file=sys.stderr)
        self.assertLess(max(worst.values()), EQUAL)

    def compare_group(self, draw, group, worst):
        folder = self.folder / f"group{group}"
        folder.mkdir()
        per_force = float(f"{draw.uniform(0.05, 0.6):.4g}")
        sliding = {**SLIDING[group % len(SLIDING)], "uplift_per_force": per_force}
        model = made.changed(self.model, folder / "model.h5", **sliding)
        self.browser.open(upbead.page(model), 1200)
        friction, weight = f"{draw.uniform(0.3, 0.9):.4g}", f"{10 ** draw.uniform(2.5, 3.8):.5g}"
        asked = {"friction": friction, "weight": weight}
        answers = {}
        for number in range(WAVES):
            settings = {**random_wave(draw, 1.6e6, 0.15), **asked}
            answers[f"wave{number}"] = told = made.ask(self.browser, settings)
            self.assertFalse(told["wrong"], settings)
            (folder / f"wave{number}.csv").write_text(told["wave"])
        options = ["--friction", friction, "--buoyant-weight", repr(float(weight) * 1e3)]
        exact, file = made.respond(model, sorted(folder.glob("wave*.csv")), folder / "out", *options)
        with h5py.File(file) as histories:
            for name, told in answers.items():
                self.compare(told, exact[name], histories[name], worst)

    def compare(self, told, exact, histories, worst):
        numbers = told["numbers"]
        text = "".join(line for line in told["histories"].splitlines(True) if not line.startswith("#"))
        table = np.genfromtxt(io.StringIO(text), delimiter=",", names=True, deletechars="")
        F, P, time = histories["shear_force"][0], histories["force"][0], histories["time"][()]
        self.assertEqual(table.shape, time.shape)
        peak = np.abs(F).max()
        self.assertGreater(peak, 0.0)
        note = lambda key, difference: worst.__setitem__(key, max(worst.get(key, 0.0), float(difference)))
        note("time", np.abs(table["time_(s)"] - time).max() / time[-1])
        note("P", np.abs(table["P_(N/m)"] - P).max() / np.abs(P).max())
        note("F_T", np.abs(table["F_T_(N/m)"] - F).max() / peak)
        for key in SAME:
            note(key, abs(numbers[key] - exact[key]) / peak)
        note("peak_shear_time", abs(numbers["peak_shear_time"] - exact["peak_shear_time"]) / time[-1])
        for key in ("beyond_band", "error_estimate", "ratio"):
            note(key, abs(numbers[key] - exact[key]) / max(1.0, abs(exact[key])))
        note("sliding", abs(numbers["sliding"] - exact["sliding"]) / max(abs(exact["sliding"]), 1e-3))
        for key in ("peak_heel_pressure", "peak_toe_pressure", "least_overturning_margin"):
            self.assertEqual(numbers[key] is None, exact[key] is None, key)
            if exact[key] is not None:
                note(key, abs(numbers[key] - exact[key]) / max(abs(exact[key]), 1.0))


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
