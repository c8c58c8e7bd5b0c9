"""Every script of postprocess/ meets the results of every command: it makes what it is made for, or says in a sentence
why it does not; none ends in a traceback.

usage: test_scripts.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES [at_length]
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS, PROGRAM, CASES = (Path(argument).resolve() for argument in sys.argv[1:4])
os.environ["UPBEAD"] = str(PROGRAM)

import scripts  # noqa: E402
from report_results import COLUMN  # noqa: E402

DESIGN = """title = "Fifty years"
[section]
water_depth = 9.0
foundation_depth = 5.0
berm_depth = 3.5
crest = 8.0
width = 14.0
berm_width = 7.0
bed_slope = 0.01
weight = 3749382.0
submerged_weight = 3042081.0
[waves.design]
height = 7.0
period = 11.0
[levels]
low = -1.0
[limits]
base_pressure = 600e3
overturning = 1.2
"""
SEA = '[sea]\nstates = "states.csv"\nyears = 10\n'
STORMS = "[storms]\nlocation = 2.5\nscale = 1.0\nshape = 1.4\nsteepness = 0.03\n"
LIFE = "[life]\nyears = 50\nsimulated_lives = {lives}\n"
STUDY = 'case = "{case}"\nread = ["response.shear_to_force_ratio"]\n[set]\n"mesh.parameters.cells" = 0.8\n[vary."regions.seabed.shear_modulus"]\nvalues = [5e6, 20e6]\n'
CALIBRATION = """title = "k"
[section]
water_depth = 15.0
foundation_depth = 9.0
berm_depth = 9.0
crest = 7.0
width = 18.0
berm_width = 7.0
bed_slope = 0.01
weight = 5.933e6
submerged_weight = 4.296e6
[calibration]
relative_height = [0.4, 0.6]
period = [8.0, 12.0]
relative_berm_depth = [0.4, 0.6]
relative_berm_width = [0.1]
ratios = [1.05, 1.2]
[calibration.models.one]
model = "reduce/reduced.h5"
load = "impulse"
"""
MAKES = {  # script: the results that it is made for
    "report.py": {"run", "column", "slip", "study", "sea", "storms", "waves", "calibrate"},
    "page.py": {"reduce", "sea", "storms", "waves", "storms.toml"},
    "expected_sliding.py": {"sea", "storms"},
    "calibration.py": {"calibrate"},
    "study.py": {"study"},
    "wave_pressure.py": {"waves"},
    "slip_bottom.py": {"slip"},
}
QUICK = ("report.py", "page.py", "expected_sliding.py")


class Scripts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = folder = Path(cls.temporary.name)
        for name, text in (("column.toml", COLUMN), ("waves.toml", DESIGN), ("sea.toml", DESIGN + SEA + LIFE.format(lives=20)),
                           ("storms.toml", DESIGN + STORMS + LIFE.format(lives=60)), ("calibrate.toml", CALIBRATION),
                           ("study.toml", STUDY.format(case=CASES / "fig2b-model.toml")),
                           ("states.csv", "significant_height,period,waves\n3.9,11,1000\n3.5,10,3000\n")):  # fmt: skip
            (folder / name).write_text(text)
        coarse, model = ("--set", "mesh.parameters.cells=0.05"), CASES / "fig2b-model.toml"
        friction = ("--set", 'regions.caisson.interface.kind="friction"', "--set", "loads.impulse.factor=5")
        for name, words in (
            ("column", ("run", "column.toml")), ("run", ("run", model, *coarse)), ("slip", ("run", model, *coarse, *friction)),
            ("study", ("study", "study.toml", "--jobs", "1")), ("waves", ("waves", "waves.toml")), ("sea", ("expected", "sea.toml")),
            ("storms", ("expected", "storms.toml")), ("reduce", ("reduce", CASES / "fig2b-prototype.toml", "--set", "mesh.parameters.cells=1")),
            ("respond", ("respond", "reduce/reduced.h5", CASES / "fig2b-prototype-impulse.csv")), ("calibrate", ("calibrate", "calibrate.toml")),
        ):  # fmt: skip
            done = subprocess.run([PROGRAM, *words, "--out", name], cwd=folder, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                raise RuntimeError(f"{words}: {done.stderr}")
        (folder / "empty").mkdir()
        (folder / "broken").mkdir()
        (folder / "broken/summary.json").write_text("{")
        cls.things = [path for path in sorted(folder.iterdir()) if path.name != "states.csv"] + [folder / "reduce/reduced.h5", folder / "none"]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def meet(self, script, things, *more):
        for thing in things:
            output = self.folder / f"out-{Path(script).stem}.{'html' if script in ('report.py', 'page.py') else 'png'}"
            done = scripts.call(SCRIPTS / script, thing, *more, *(("-o", output) if "-o" not in more else ()))
            if "unrecognized arguments" in done.stderr:
                done = scripts.call(SCRIPTS / script, thing, *more)
            where = (script, thing.name, done.stderr)
            self.assertNotIn("Traceback", done.stderr, where)
            made = done.returncode == 0
            self.assertTrue(made or done.stderr.strip(), where)
            if script in MAKES and not more:
                self.assertEqual(made, thing.name in MAKES[script] or (script == "page.py" and thing.name in ("waves.toml", "sea.toml", "reduced.h5")), where)

    def test_report_page_and_lives(self):
        for script in QUICK:
            self.meet(script, self.things)

    def test_all_others_at_length(self):
        for path in sorted(SCRIPTS.glob("*.py")):
            if path.name not in ("common.py", *QUICK, "gallery.py", "output_tables.py", "dataset_tables.py", "verification.py", "validation.py", "reliability.py"):
                self.meet(path.name, self.things)
                self.meet(path.name, self.things, self.folder / "slip")  # for those that compare two

    def test_the_lives_of_storms_are_drawn(self):
        page = self.folder / "storms.html"
        done = scripts.call(SCRIPTS / "page.py", self.folder / "storms.toml", "-o", page)
        self.assertEqual(done.returncode, 0, done.stderr)
        data = json.loads(page.read_text().partition('class="design-model">')[2].partition("</script>")[0])["life"]
        summary = json.loads((self.folder / "storms/summary.json").read_text())
        self.assertEqual((data["waves"], data["laws"], data["years"]), (None, {}, 50))
        self.assertEqual(data["lives"]["mean"][data["widths"].index(14.0)], summary["monte_carlo"]["mean"])
        self.assertNotIn("summary", data)


if __name__ == "__main__":
    asked = [name for name in unittest.TestLoader().getTestCaseNames(Scripts) if name.endswith("at_length") == (sys.argv[4:] == ["at_length"])]
    unittest.main(argv=[sys.argv[0], *(f"Scripts.{name}" for name in asked)])
