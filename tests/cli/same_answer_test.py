#!/usr/bin/python3
"""Ways that promise the same answer give it: the whole summary, every key, every number to the last bit.

Ways: a study with and without sharing, on one process, on several, under mpirun, resumed after a part of its journals was
lost; `run`, on stdout and in its file; a march that was interrupted and resumed. tests/study/same_answer_test.cc varies the
scenes further, in one process.

usage: same_answer_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from program import PROGRAM, ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import scene  # noqa: E402

# What must differ: wall times; of a march that was resumed, the factorisations that it made again.
TIMES = {"timing"}
RESUMED = TIMES | {"discretisation.factorisations"}

COARSE = ("cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.3, grading = 4")
SECTION = scene(COARSE, ("peak = 1e6", "peak = 8e6"), ("end = 0.6", "end = 0.3"))
STATE = "[initial]\nwater_level = 15.0\n[limits]\nsliding = 0.05\nbase_pressure = 5e5\n"
SLIDING = "[sliding]\nsubmerged_weight = 4.3e6\n"
WAVE = scene(COARSE, ('kind = "force"', 'kind = "wave"'),
             ('pulse = { shape = "triangle", peak = 1e6, duration = 0.15 }',
              'wave = { course = "church_roof", height = 11, period = 13.6 }'), ("end = 0.6", "end = 0.5\nstep = 0.01"))
SECTION_TABLE = """[section]
water_depth = 15.0
foundation_depth = 9.0
berm_depth = 7.5
crest = 7.0
width = 18.0
berm_width = 7.0
bed_slope = 0.01
weight = 5.933088e6
submerged_weight = 4.296e6
"""
YIELDS = {"regions.seabed.law": '"hysteretic"', "regions.seabed.strength": "{ friction_angle = 38 }", "time.step": "0.01"}

# scene, what it sets, what the study varies
SCENES = {
    "sliding": (SECTION + STATE + SLIDING, {}, {"sliding.submerged_weight": "[4.3e6, 3e6]", "sliding.friction": "[0.6, 0.4]"}),
    "friction": (SECTION + STATE + SLIDING, {"regions.caisson.interface": '{ kind = "friction" }'},
                 {"sliding.submerged_weight": "[4.3e6, 3.6e6]"}),
    "wave": (WAVE + '[sliding]\nuplift = { kind = "wave" }\n' + SECTION_TABLE, {}, {"sliding.uplift.shape": '["held", "in_phase"]'}),
    "yielding": (SECTION + STATE + SLIDING, YIELDS, {"sliding.friction": "[0.6, 0.4]"}),
    "reduced": (SECTION + STATE + SLIDING, {"time.scheme": '"reduced"', "output.fields": "{ every = 0.1 }",
                                            "regions.mound.strength": "{ friction_angle = 40 }"},
                {"sliding.friction": "[0.6, 0.4]", "mesh.parameters.mound_height": "[6, 7]"}),
    "estimated": (SECTION + STATE + SLIDING, {"accuracy.estimate": "true"}, {"sliding.submerged_weight": "[4.3e6, 3e6]"}),
}


def without(summary, names):
    """The summary without the keys that must differ."""
    for name in names:
        at = summary
        *folders, last = name.split(".")
        for folder in folders:
            at = at[folder]
        at.pop(last)
    return summary


def flat(value, path=""):
    if isinstance(value, (dict, list)) and value:
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from flat(inner, f"{path}.{key}")
    else:
        yield path, value


class SameAnswer(ProgramTest):
    def expect_same(self, one, other, names, what):
        one, other = dict(flat(without(one, names))), dict(flat(without(other, names)))
        differences = {key: (one.get(key), other.get(key)) for key in one.keys() | other.keys() if one.get(key) != other.get(key)}
        self.assertEqual(differences, {}, what)

    def write(self, name):
        text, fixed, varied = SCENES[name]
        (self.folder / "case.toml").write_text(text)
        (self.folder / "study.toml").write_text(
            'case = "case.toml"\nsummaries = true\n' + "[set]\n" + "".join(f'"{k}" = {v}\n' for k, v in fixed.items())
            + "".join(f'[vary."{key}"]\nvalues = {values}\n' for key, values in varied.items()))

    def study(self, out, *arguments, launcher=()):
        environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        done = subprocess.run([*launcher, PROGRAM, "study", "study.toml", "--out", out, *arguments], cwd=self.folder,
                              capture_output=True, text=True, timeout=600, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.answers(out)

    def answers(self, out):
        """The study's tables, and the whole summary of each run."""
        folder = self.folder / out
        runs = [json.loads((folder / f"runs/{i}.json").read_text()) for i in range(len(os.listdir(folder / "runs")))]
        return (folder / "study.csv").read_text(), runs

    def resumed(self, out, of):
        """A study whose journal has lost its end, in the middle of a line."""
        shutil.copytree(self.folder / of, self.folder / out)
        journal = self.folder / out / "journal/0-0.jsonl"
        lines = journal.read_text().splitlines(keepends=True)
        journal.write_text("".join(lines[:2]) + lines[2][:30])
        for path in (self.folder / out / "runs").glob("*"):
            if path.stem != str(json.loads(lines[1])["run"]):
                path.unlink()
        return self.study(out, "--jobs", "1")

    def compare(self, name, *ways):
        self.write(name)
        table, runs = self.study("alone", "--no-sharing", "--jobs", "1")
        self.assertEqual(len({json.dumps(without(dict(run), TIMES)) for run in runs}), len(runs), "each run is another")
        for way in ways:
            found, others = way()
            self.assertEqual(found, table)
            self.assertEqual(len(others), len(runs))
            for i, (run, other) in enumerate(zip(runs, others)):
                self.expect_same(dict(run), dict(other), TIMES, f"{name}, run {i}")
        return runs

    def by_run(self, name, runs):
        """Each run of the study by the command that its settings make."""
        _, fixed, varied = SCENES[name]
        values = [json.loads(text) for text in varied.values()]
        for i, run in enumerate(runs):
            settings, rest = dict(fixed), i
            for key, list_of in reversed(list(zip(varied, values))):
                settings[key] = json.dumps(list_of[rest % len(list_of)])
                rest //= len(list_of)
            words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
            done = upbead("run", "case.toml", *words, "--json", "--out", "run", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout, (self.folder / "run/summary.json").read_text())
            self.expect_same(dict(run), json.loads(done.stdout), TIMES, f"{name}, run {i} by itself")

    def every_way(self, name):
        mpirun = ("mpirun", "--quiet", "-n", "2", "--oversubscribe")
        runs = self.compare(name, lambda: self.study("shared", "--jobs", "1"), lambda: self.study("two", "--jobs", "2"),
                            lambda: self.study("launched", launcher=mpirun), lambda: self.resumed("resumed", "shared"))
        self.by_run(name, runs)

    def test_of_a_caisson_that_slides(self):
        self.every_way("sliding")

    def test_by_a_reduced_model_with_fields(self):
        self.by_run("reduced", self.compare("reduced"))

    def test_of_every_scene_in_every_way_at_length(self):
        for name in SCENES:
            shutil.rmtree(self.folder)
            self.folder.mkdir()
            self.every_way(name)

    def interrupted(self, name, *march):
        """A run that is interrupted, keeps a checkpoint and goes on, beside one that was left alone."""
        self.write(name)
        words = [word for key, value in [*SCENES[name][1].items(), *(m.split("=") for m in march)]
                 for word in ("--set", f"{key}={value}")]
        whole = json.loads(upbead("run", "case.toml", *words, "--json", "--out", "whole", cwd=self.folder).stdout)
        process = subprocess.Popen([PROGRAM, "run", "case.toml", *words, "--out", "parts", "--checkpoint", "0.01"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while not (self.folder / "parts.checkpoint/state.h5").exists():
            self.assertIsNone(process.poll(), "it ended before it could be interrupted")
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        self.assertIn("kept at t = ", process.communicate()[1])
        done = upbead("run", "case.toml", *words, "--out", "parts", "--resume", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.expect_same(whole, json.loads(done.stdout), RESUMED, name)
        whole, parts = ((self.folder / out / "results.h5").read_bytes() for out in ("whole", "parts"))
        self.assertTrue(whole == parts, "results.h5")

    def test_of_a_march_that_goes_on(self):
        self.interrupted("sliding", 'time.scheme="sdirk4"', "time.step=0.0005")

    def test_of_ground_that_yields_and_goes_on_at_length(self):
        self.interrupted("yielding", "time.step=0.002")


if __name__ == "__main__":
    main()
