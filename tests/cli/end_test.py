#!/usr/bin/python3
"""The end of a run: what still acts after it is told, without time.end all loads and their echo are covered, and a march
is taken up to a later end.

usage: end_test.py PROGRAM CASES_FOLDER
"""

import json
import pathlib
import re
import signal
import subprocess
import sys
import time

import h5py
import numpy

from program import CASES, PROGRAM, ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import scene  # noqa: E402

PULSE = 'pulse = { shape = "triangle", peak = 1e6, duration = 0.15 }'
WIDE = ("seabed_front = 60, seabed_back = 60", "seabed_front = 200, seabed_back = 200")
BED = """
[mesh]
geometry = "column"
parameters = { height = 20, cells = 20 }
[regions.soil]
kind = "porous"
flow = "inertial"
shear_modulus = 50e6
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 1.0
[boundaries]
base = { displacement = "fixed", pressure = "sealed" }
left = { displacement = "roller", pressure = "sealed" }
right = { displacement = "roller", pressure = "sealed" }
top = { pressure = "open" }
[loads.q]
boundary = "top"
kind = "normal"
pulse = { shape = "triangle", peak = 1000.0, duration = 0.05 }
[probes.c]
at = [0.5, 10.0]
[time]
end = 0.4
"""


class End(ProgramTest):
    def ask(self, command, text, *settings, name="scene"):
        """The warnings by their name, the summary, and stdout."""
        (self.folder / f"{name}.toml").write_text(text)
        out = ["--out", self.folder / name] if command == "run" else []
        arguments = [part for setting in settings for part in ("--set", setting)]
        done = upbead(command, self.folder / f"{name}.toml", *out, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        warnings = dict(re.findall(r"^warning: (\w+): (.*\n.*)$", done.stderr, re.M))
        summary = json.loads((self.folder / name / "summary.json").read_text()) if out else {}
        return warnings, summary, done.stdout

    def test_a_record_whose_peak_comes_late(self):
        time_ = numpy.arange(0, 3.001, 0.01)
        force = 3e5 * numpy.exp(-((time_ - 0.5) / 0.1) ** 2) + 1.5e6 * numpy.exp(-((time_ - 1.5) / 0.1) ** 2)
        (self.folder / "force.csv").write_text(
            "time (s),F (N/m)\n" + "".join(f"{t:.3f},{f:.1f}\n" for t, f in zip(time_, force)))
        text = scene((PULSE, 'history = "force.csv"'), ("\n[time]\nend = 0.6", ""), WIDE)
        warnings, summary, _ = self.ask("run", text)
        self.assertNotIn("load_cut", warnings)
        self.assertAlmostEqual(summary["response"]["peak_force"], 1.5e6, delta=1)
        whole = summary["response"]["peak_shear"]
        _, summary, _ = self.ask("run", text, "time.end=5")
        self.assertAlmostEqual(summary["response"]["peak_shear"] / whole, 1, 2)
        warnings, summary, _ = self.ask("run", text, "time.end=1")
        self.assertLess(summary["response"]["peak_shear"], 0.5 * whole)
        self.assertIn("ITS LARGEST VALUE, which comes at 1.5 s", warnings["load_cut"])
        warnings, _, text = self.ask("explain", text)
        self.assertIn("as time.end is not given: the loads are over at 1.7", text)
        end = float(re.search(r"until ([0-9.]+) s, as time.end", text).group(1))
        written = (self.folder / "scene/case.toml").read_text()
        self.assertIn("end = 1.0", written, "of the run that was given one")
        self.assertGreater(end, 2)

    def test_a_normal_load_is_the_traction_that_it_is(self):
        normal, _, _ = self.ask("explain", BED)
        traction, _, _ = self.ask("explain", BED.replace('kind = "normal"', 'kind = "traction"\ndirection = [0, -1]'))
        self.assertEqual(normal, traction)
        self.assertIn("slow_wave_unresolved", normal)
        self.assertNotIn("shear wave", " ".join(normal.values()))
        sheared, _, _ = self.ask("explain", BED.replace('kind = "normal"', 'kind = "traction"\ndirection = [1, 0]'))
        self.assertNotIn("slow_wave_unresolved", sheared)

    def test_a_dry_block(self):
        dry = scene(("end = 0.6", "end = 0.9"), ("[time]", "[sliding]\nfriction = 0.6\nsubmerged_weight = 5.933088e6\nweight = 5.933088e6\n[time]"))
        warnings, summary, _ = self.ask("run", dry)
        self.assertEqual(warnings, {})
        self.assertAlmostEqual(summary["sliding"]["submerged_weight"], 5.933088e6)
        done = upbead("explain", self.folder / "scene.toml", "--set", "sliding.submerged_weight=6e6")
        self.assertEqual(done.returncode, 1)
        self.assertIn("above weight", done.stderr)

    MARCH = ("mesh.parameters.cells=0.5", "time.scheme=sdirk4", "time.step=1e-4", "mesh.full_domain=true",
             "regions.seabed.flow=darcy", "regions.mound.flow=inertial")

    def march(self, *arguments, end, out, title="march"):
        settings = [part for setting in (*self.MARCH, f"time.end={end}", f"title={title}") for part in ("--set", setting)]
        return [PROGRAM, "run", CASES / "fig2b-model.toml", *settings, "--out", self.folder / out, *arguments]

    def run_march(self, *arguments, **options):
        return subprocess.run(self.march(*arguments, **options), capture_output=True, text=True)

    def interrupted(self, *arguments, end):
        """Interrupts a march; returns the time that it has reached."""
        process = subprocess.Popen(self.march("--checkpoint", "1000", *arguments, end=end, out="parts"),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        process.stdout.readline()
        time.sleep(0.2)
        process.send_signal(signal.SIGTERM)
        return float(re.search(r"kept at t = (\S+) s", process.communicate()[1]).group(1))

    def test_a_march_is_taken_up_to_another_end_by_another_title(self):
        reached = self.interrupted(end=0.2236)
        while reached < 4e-4:  # on a busy machine it had hardly begun
            reached = self.interrupted("--resume", end=0.2236)
        done = self.run_march("--resume", end=0.5 * reached, out="parts")
        self.assertEqual(done.returncode, 1)
        self.assertIn("after time.end", done.stderr)
        done = self.run_march("--resume", "--set", "time.step=2e-4", end=0.2236, out="parts")
        self.assertEqual(done.returncode, 1, "another step is another march")
        end = max(0.06, 1.01 * reached) + 3.7e-5
        done = self.run_march("--resume", end=end, out="parts", title="later")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("resumed     at t =", done.stdout)
        self.assertEqual(json.loads((self.folder / "parts/summary.json").read_text())["title"], "later")
        self.assertEqual(self.run_march(end=end, out="whole").returncode, 0)
        histories = []
        for name in ("whole", "parts"):
            with h5py.File(self.folder / name / "results.h5") as file:
                histories.append((file["history/time"][:], file["history/shear_force"][:]))
        (t, whole), (s, parts) = histories
        self.assertAlmostEqual(s[-1], end, 12)
        self.assertTrue((numpy.diff(s) > 0).all())
        self.assertLess(abs(numpy.interp(t, s, parts) - whole).max(), 1e-4 * abs(whole).max())


if __name__ == "__main__":
    main()
