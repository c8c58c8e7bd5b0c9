#!/usr/bin/python3
"""The program does not destroy the user's files, waste hours, or read tables wrongly without a message.

usage: limits_test.py PROGRAM CASES_FOLDER
"""

import gzip
import json
import os
import pathlib
import shutil
import sys
import unittest

import numpy

from program import CASES, ProgramTest, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import SCENE  # noqa: E402

HEAD, TAIL = SCENE.split("[loads.impulse]")
REST = "[time]" + TAIL.split("[time]")[1]
TIME = numpy.arange(601) / 1000.0
FORCE = numpy.interp(TIME, [0.05, 0.1, 0.2], [0, 1e6, 0])


def scene(history, kind="force"):
    return HEAD + f'[loads.wall]\nboundary = "front"\nkind = "{kind}"\nhistory = "{history}"\n' + REST


class Limits(ProgramTest):
    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def explain(self, history, text, kind="force"):
        self.write(history, text)
        return upbead("explain", self.write("case.toml", scene(history, kind)), "--json")

    def refusal(self, *arguments, cwd=None):
        done = upbead(*arguments, cwd=cwd or self.folder)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        return done.stderr

    def keeps(self, files, *arguments, cwd=None):
        """The command is refused before anything is solved or written, and the files are as they were."""
        before = {file: (self.folder / file).read_bytes() for file in files}
        there = self.left_behind()
        self.assertIn("is the same file; choose another folder with --out DIR", self.refusal(*arguments, cwd=cwd))
        self.assertEqual({file: (self.folder / file).read_bytes() for file in files}, before)
        self.assertEqual(self.left_behind(), there)

    def test_run_keeps_its_case(self):
        self.write("case.toml", SCENE)
        self.keeps(["case.toml"], "run", "case.toml", "--out", ".")
        self.keeps(["case.toml"], "run", "case.toml", "--out", self.folder)
        self.write("other/case.toml", SCENE)
        os.link(self.folder / "other/case.toml", self.folder / "hard.toml")
        self.keeps(["other/case.toml"], "run", "hard.toml", "--out", "other")
        os.symlink("other/case.toml", self.folder / "soft.toml")
        self.keeps(["other/case.toml"], "run", "soft.toml", "--out", "other")

    def test_run_keeps_its_records(self):
        rows = "".join(f"{t},{f}\n" for t, f in zip(TIME, FORCE))
        self.write("out/summary.json", "time,force\n" + rows)
        self.write("a.toml", scene("out/summary.json"))
        self.keeps(["out/summary.json"], "run", "a.toml", "--out", "out")

    def test_designs_scales_and_studies_keep_what_they_read(self):
        shutil.copy(CASES / "fig10/impulsive.toml", self.folder / "case.toml")
        self.keeps(["case.toml"], "waves", "case.toml", "--out", ".")
        self.write("case.toml", SCENE)
        self.keeps(["case.toml"], "scale", "case.toml", "--factor", 2, "--out", ".")
        self.write("study.csv", 'case = "case.toml"\n[vary."time.end"]\nvalues = [0.1, 0.2]\n')
        self.keeps(["study.csv", "case.toml"], "study", "study.csv", "--out", ".")
        shutil.copy(self.folder / "case.toml", self.folder / "reduced.h5")
        self.keeps(["reduced.h5"], "reduce", "reduced.h5", "--out", ".")

    def test_a_long_cell_is_no_long_message(self):
        for text in ("time,force\n0,0\n0.1," + "x" * 5_000_000 + "\n", "time," + "y" * 5_000_000 + " (parsec)\n0,0\n1,1\n"):
            done = self.explain("cell.csv", text)
            self.assertEqual(done.returncode, 1)
            self.assertLess(len(done.stderr), 1000)
        self.write("case.toml", SCENE + '["' + "k" * 1_000_000 + '"]\na = 1\n')
        self.assertLess(len(self.refusal("explain", "case.toml")), 1000)
        self.write("case.toml", SCENE.replace('geometry = "composite"', 'geometry = "' + "g" * 1_000_000 + '"'))
        self.assertLess(len(self.refusal("explain", "case.toml")), 1000)

    def test_what_fills_the_memory_ends_early(self):
        done = self.explain("wide.csv", "time" + ",p" * 200_000 + "\n0" + ",1" * 200_000 + "\n")
        self.assertIn("200001 columns; at most 10000 are read", done.stderr)
        bomb = gzip.compress(b"time,force\n" + b"0,0\n" * 50_000_000, 9)
        done = self.explain("bomb.csv.gz", bomb)
        self.assertIn("unpacks to more than 100 times its size", done.stderr)
        probes = "".join(f"[probes.p{i}]\nat = [0.0, 1.0]\n" for i in range(5001))
        self.write("case.toml", SCENE + probes)
        self.assertIn("5001 probes; at most 5000 are followed", self.refusal("explain", "case.toml"))

    def test_only_files_are_read(self):
        os.mkfifo(self.folder / "pipe")
        for text, arguments in ((scene("pipe"), ()), (SCENE, ("--set", "mesh.geometry=composite"))):
            self.write("case.toml", text)
            if not arguments:
                self.assertIn("is a pipe", self.refusal("explain", "case.toml"))
        self.assertIn("is a pipe", self.refusal("explain", "pipe"))
        self.assertIn("is a pipe", self.refusal("respond", "pipe", "pipe"))
        self.assertIn("is a device", self.refusal("run", "/dev/zero"))
        os.rename(self.folder / "pipe", self.folder / "pipe.h5")
        self.write("case.toml", scene("pipe.h5"))
        self.assertIn("is a pipe", self.refusal("explain", "case.toml"))

    def test_the_time_is_the_column_that_says_so(self):
        plain = self.explain("force.csv", "time,force\n" + "".join(f"{t!r},{f!r}\n" for t, f in zip(TIME.tolist(), FORCE.tolist())))
        self.assertEqual(plain.returncode, 0, plain.stderr)
        rows = [f"{i};{1e3 * t:.6f};{1e-3 * f:.6f};0" for i, (t, f) in enumerate(zip(TIME, FORCE))]
        text = "\r\n".join(["Part;Time [ms];Force_0 [kN/m];Force_1 [kN/m]", *rows]).replace(".", ",")
        done = self.explain("force.csv", b"\xef\xbb\xbf" + text.encode())
        self.assertEqual(done.returncode, 0, done.stderr)
        skipped = {item["what"]: item["why"] for item in json.loads(done.stdout)["skipped"]}
        self.assertEqual(skipped.pop("column 'Part' of force.csv"), "a counter; the time is 'Time'")
        self.assertEqual(skipped.pop("column 'Force_1' of force.csv"), "a history has one value, here 'Force_0'")
        self.assertEqual(skipped, {item["what"]: item["why"] for item in json.loads(plain.stdout)["skipped"]})

        def shear(folder):
            done = upbead("run", "case.toml", "--json", "--out", folder, "--set", "time.end=0.3", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads(done.stdout)["response"]["peak_shear"]

        counted = shear("counted")
        self.explain("force.csv", "time,force\n" + "".join(f"{t!r},{f!r}\n" for t, f in zip(TIME.tolist(), FORCE.tolist())))
        self.assertAlmostEqual(counted / shear("plain"), 1, 6)

    def test_a_load_that_stays_zero_is_told(self):
        text = "time (s),force\n" + "".join(f"{20 + t!r},{f!r}\n" for t, f in zip(TIME.tolist(), FORCE.tolist()))
        done = self.explain("late.csv", text)
        self.assertEqual(done.returncode, 0, done.stderr)
        warnings = {w["name"]: w for w in json.loads(done.stdout)["warnings"]}
        self.assertIn("load_zero", warnings)
        self.assertAlmostEqual(warnings["load_zero"]["value"], 20.05)
        pulse = upbead("explain", self.write("case.toml", SCENE), "--json", "--set", "loads.impulse.pulse.start=50")
        self.assertIn("load_zero", {w["name"] for w in json.loads(pulse.stdout)["warnings"]}, pulse.stderr)
        sound = upbead("explain", self.write("case.toml", SCENE), "--json")
        self.assertNotIn("load_zero", {w["name"] for w in json.loads(sound.stdout)["warnings"]}, sound.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
