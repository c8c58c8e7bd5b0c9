#!/usr/bin/python3
"""External faults: the program killed at any moment, two runs at once, no room on the disk, odd paths, other locales,
huge files.

usage: faults_test.py PROGRAM CASES_FOLDER [--kills N] [--facts FILE]
"""

import argparse
import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest

import h5py

from program import CASES, PROGRAM, ProgramTest, upbead

QUICK = ["--set", "mesh.parameters.cells=0.5", "--set", "time.end=0.05"]
MARCHED = [*QUICK, "--set", "time.scheme=sdirk4", "--set", "time.step=1e-4"]
KILLS = 10
facts = []


def fact(what, tried, came_out):
    facts.append({"what": what, "tried": str(tried), "came_out": came_out})


def contents(folder):
    """{path below the folder: hash} of every file."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(folder.rglob("*")) if path.is_file()}


class Faults(ProgramTest):
    def run_model(self, *arguments, **options):
        return upbead("run", CASES / "fig2b-model.toml", *arguments, cwd=self.folder, **options)

    def whole_results(self, result):
        """The peak that all three files have; fails if they belong to different runs."""
        summary = json.loads((result / "summary.json").read_text())
        with h5py.File(result / "results.h5") as file:
            largest = max(file["history/shear_force"])
            force = max(file["history/force"])
        self.assertLessEqual(largest, summary["response"]["peak_shear"] * (1 + 1e-9))
        self.assertGreater(largest, summary["response"]["peak_shear"] * 0.98)
        self.assertAlmostEqual(force / summary["response"]["peak_force"], 1., 2)
        factor = float([line for line in (result / "case.toml").read_text().splitlines()
                        if line.startswith("factor")][0].split("=")[1])
        self.assertAlmostEqual(summary["response"]["peak_force"] / factor / self.peak_per_factor, 1., 6)
        return factor

    def test_killed_at_any_moment(self):
        """The folder holds either the previous complete result or the new one, fields included."""
        fields = ["--set", "output.fields.every=0.025"]
        run = lambda factor: [PROGRAM, "run", CASES / "fig2b-model.toml", *QUICK, *fields, "--set",
                              f"loads.impulse.factor={factor}", "--set", f"loads.slow.factor={factor}", "--out", "out"]
        begin = time.time()
        subprocess.run(run(1.), cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
        duration = time.time() - begin
        result = self.folder / "out"
        self.peak_per_factor = json.loads((result / "summary.json").read_text())["response"]["peak_force"]
        names = set(contents(result))
        dice, held, replaced = random.Random(1), 1., 0
        for i in range(KILLS):
            factor = 2. + i
            process = subprocess.Popen(run(factor), cwd=self.folder, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            if i % 2:
                time.sleep(dice.uniform(0., duration))
            else:  # while it writes
                written = self.folder / f".out.partial-{process.pid}/fields/fields_0002.vtu"
                while not written.exists() and process.poll() is None:
                    pass
                time.sleep(dice.uniform(0., 0.05))
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.assertEqual(set(contents(result)), names, f"kill {i}")
            now = self.whole_results(result)
            self.assertIn(now, (held, factor), f"kill {i}")
            replaced += now == factor
            held = now
        fact("killed by SIGKILL at random moments", f"{KILLS} times, half of them while it writes; {replaced} after the new one had taken the old one's place",
             "the folder always held the previous complete result or the new complete one")

    def test_killed_runs_leave_nothing_for_long(self):
        process = subprocess.Popen([PROGRAM, "run", CASES / "fig2b-model.toml", *MARCHED, "--set", "time.step=1e-6"],
                                   cwd=self.folder, stdout=subprocess.PIPE)
        process.stdout.readline()
        process.kill()
        process.communicate()
        left = [path for path in (self.folder / "results").iterdir() if ".partial-" in path.name]
        self.assertEqual(len(left), 1)
        os.utime(left[0], (0, 0))
        self.assertEqual(self.run_model(*QUICK).returncode, 0)
        self.assertEqual(sorted(os.listdir(self.folder / "results")), ["fig2b-model"])

    def test_two_runs_into_one_folder(self):
        for factors in ((2., 3.), (4., 5.), (6., 7.)):
            both = [subprocess.Popen([PROGRAM, "run", CASES / "fig2b-model.toml", *QUICK, "--out", "out", "--set",
                                      f"loads.impulse.factor={factor}", "--set", f"loads.slow.factor={factor}"],
                                     cwd=self.folder, stdout=subprocess.DEVNULL) for factor in factors]
            self.assertEqual([process.wait() for process in both], [0, 0])
            summary = json.loads((self.folder / "out/summary.json").read_text())
            self.peak_per_factor = getattr(self, "peak_per_factor", 0.) or summary["response"]["peak_force"] / next(
                factor for factor in factors if f"factor = {factor}" in (self.folder / "out/case.toml").read_text())
            self.assertIn(self.whole_results(self.folder / "out"), factors)
            self.assertEqual(os.listdir(self.folder), ["out"])
        fact("two runs into one folder at once", 3, "both end well; the folder holds the files of one of them")

    def test_input_that_vanishes(self):
        (self.folder / "case.toml").write_text((CASES / "fig2b-model.toml").read_text())
        done = upbead("run", "case.toml", cwd=self.folder)  # without the histories
        self.assertEqual(done.returncode, 1)
        self.assertIn("fig2b-model-impulse.csv", done.stderr)
        self.assertIn("case.toml:", done.stderr, "the key that names it")
        done = upbead("run", "gone.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("gone.toml", done.stderr)
        self.assertEqual(self.left_behind(), ["case.toml"])
        fact("a case or a history that is not there", 2, "exit 1, the file and the key that names it")

    def test_blanks_and_letters_of_the_world_in_paths(self):
        odd = self.folder / "波 浪 été 'x' $HOME"
        odd.mkdir()
        for path in CASES.glob("fig2b-model*"):
            shutil.copy(path, odd)
        case = odd / "Fall ä; 1.toml"
        (odd / "fig2b-model.toml").rename(case)
        done = upbead("run", case, *QUICK, "--out", odd / "Ergebnis – 1", "--set", "output.fields.every=0.05")
        self.assertEqual(done.returncode, 0, done.stderr)
        result = odd / "Ergebnis – 1"
        self.assertEqual(sorted(os.listdir(result)), ["case.toml", "fields", "fields.pvd", "results.h5", "summary.json"])
        again = upbead("run", result / "case.toml", "--out", odd / "again")
        self.assertEqual(again.returncode, 0, again.stderr)
        fact("blanks, quotes and letters beyond ASCII in every path", 2, "run, results and effective case as elsewhere")

    def test_locale_with_a_decimal_comma(self):
        locales = self.folder / "locales"
        locales.mkdir()
        made = shutil.which("localedef") and subprocess.run(
            ["localedef", "-i", "de_DE", "-f", "UTF-8", locales / "de_DE.UTF-8"], capture_output=True).returncode in (0, 1)
        if not made or not (locales / "de_DE.UTF-8").exists():
            self.skipTest("this machine cannot make a German locale")
        there = dict(os.environ, LOCPATH=str(locales), LC_ALL="de_DE.UTF-8", LANG="de_DE.UTF-8")
        here = self.run_model(*QUICK, "--out", "here")
        comma = self.run_model(*QUICK, "--out", "comma", env=there)
        self.assertEqual((here.returncode, comma.returncode), (0, 0), comma.stderr)
        here, comma = contents(self.folder / "here"), contents(self.folder / "comma")
        for name in ("results.h5", "case.toml"):
            self.assertEqual(here[name], comma[name], name)
        self.assertEqual(upbead("explain", CASES / "fig2b-prototype.toml", env=there).stdout,
                         upbead("explain", CASES / "fig2b-prototype.toml").stdout)
        fact("locale with a decimal comma (de_DE)", 2, "the same bytes in results.h5 and case.toml")

    def test_history_of_ten_gigabytes(self):
        for path in CASES.glob("fig2b-model*"):
            shutil.copy(path, self.folder)
        with open(self.folder / "fig2b-model-impulse.csv", "r+b") as file:
            file.truncate(10 * 10**9)  # takes no room on the disk
        done = upbead("run", "fig2b-model.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("fig2b-model-impulse.csv' holds 10000 MB; at most 1000 MB are read", done.stderr)
        self.assertLess(len(done.stderr), 2000)
        self.assertFalse((self.folder / "results").exists())
        fact("a history file of 10 GB", 1, "refused at once, by its size")

    def test_folder_without_the_right_to_write(self):
        if os.geteuid() == 0:
            self.skipTest("root may write anywhere")
        (self.folder / "out").mkdir()
        (self.folder / "out").chmod(0o500)
        done = self.run_model(*QUICK, "--out", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--out DIR", done.stderr)
        self.assertEqual(os.listdir(self.folder / "out"), [])

    def killed_after_a_checkpoint(self, command, state):
        """Kills the run once it has kept a new checkpoint; whether it was still running then."""
        kept = lambda: state.stat().st_mtime_ns if state.exists() else 0
        before = kept()
        process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and kept() == before:
            time.sleep(0.01)
        process.kill()
        return process.wait() == -signal.SIGKILL

    def test_resumed_run_is_equal_to_the_last_bit(self):
        """Killed again and again, each time after it has kept a checkpoint; fields included."""
        fields = ["--set", "output.fields.every=0.01", "--set", "time.end=0.1"]
        for scheme, step in (("sdirk4", 5e-5), ("generalised_alpha", 1.25e-5)):
            long = [*QUICK, *fields, "--set", f"time.scheme={scheme}", "--set", f"time.step={step}"]
            self.assertEqual(self.run_model(*long, "--out", "whole").returncode, 0)
            resumed = [PROGRAM, "run", CASES / "fig2b-model.toml", *long, "--out", "parts", "--checkpoint", "0.05", "--resume"]
            kills = sum(self.killed_after_a_checkpoint(resumed, self.folder / "parts.checkpoint/state.h5") for _ in range(4))
            process = subprocess.Popen(resumed, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            output, errors = process.communicate()
            self.assertEqual(process.returncode, 0, errors)
            self.assertIn("resumed     at t =", output)
            self.assertGreater(kills, 0, "the march ended before it kept anything")
            whole, parts = contents(self.folder / "whole"), contents(self.folder / "parts")
            self.assertEqual(set(whole), set(parts))
            for name in whole:
                if name != "summary.json":  # which contains times
                    self.assertEqual(whole[name], parts[name], name)
            for key in ("response", "energy", "loads"):
                self.assertEqual(*(json.loads((self.folder / name / "summary.json").read_text())[key]
                                   for name in ("whole", "parts")), key)
            self.assertFalse((self.folder / "parts.checkpoint").exists(), "removed in the end")
            fact(f"long march by {scheme}, killed and resumed", f"{kills} kills",
                 "results.h5 and all fields equal to the last bit")

    def test_interrupted_run_keeps_a_checkpoint(self):
        long = [*MARCHED, "--set", "time.step=5e-6", "--checkpoint", "1000"]
        process = subprocess.Popen([PROGRAM, "run", CASES / "fig2b-model.toml", *long], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        process.stdout.readline()
        time.sleep(0.5)
        process.send_signal(signal.SIGTERM)
        errors = process.communicate()[1]
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)
        self.assertIn("go on with --resume", errors)
        changed = self.run_model(*long, "--set", "regions.seabed.porosity=0.41", "--resume")
        self.assertEqual(changed.returncode, 1)
        self.assertIn("another case", changed.stderr)
        state = self.folder / "results/fig2b-model.checkpoint/state.h5"
        state.write_bytes(state.read_bytes()[:2000])
        damaged = self.run_model(*long, "--resume")
        self.assertEqual(damaged.returncode, 1)
        self.assertIn("state.h5", damaged.stderr)

    def test_no_room_for_a_checkpoint(self):
        """Its file is a device that is always full: the run warns, continues, and gives the same result."""
        self.assertEqual(self.run_model(*MARCHED, "--out", "whole").returncode, 0)
        folder = self.folder / "parts.checkpoint"
        folder.mkdir()
        (folder / "state.h5.partial").symlink_to("/dev/full")
        done = self.run_model(*MARCHED, "--out", "parts", "--checkpoint", "0.01")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("no checkpoint was kept, the run goes on: cannot write", done.stderr)
        self.assertIn("No space left on device", done.stderr)
        whole, parts = contents(self.folder / "whole"), contents(self.folder / "parts")
        self.assertEqual(whole["results.h5"], parts["results.h5"])
        self.assertFalse(folder.exists())
        fact("no room for checkpoints", "1", "warned, the run goes on to the same results")

    def test_checkpoints_are_refused_where_they_are_not_kept(self):
        done = self.run_model(*QUICK, "--resume", "--set", "regions.caisson.interface.kind=friction")
        self.assertEqual(done.returncode, 1)
        self.assertIn("leave out --checkpoint and --resume", done.stderr)
        self.assertEqual(self.left_behind(), [])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=KILLS)
    parser.add_argument("--facts", help="writes what was found there, as docs/reliability/faults.json")
    arguments, rest = parser.parse_known_args(sys.argv[3:])
    KILLS = arguments.kills
    result = unittest.main(argv=[sys.argv[0], *rest], exit=False).result
    if arguments.facts and result.wasSuccessful():
        with open(arguments.facts, "w") as file:
            json.dump({"title": "Faults", "text": "Processes killed, files that vanish, disks that are full: what was "
                       "there stays, what is new is whole. The full disk, missing rights, too little memory and "
                       "interrupts besides are in tests/cli/cli_test.py.",
                       "command": "tests/cli/faults_test.py build/upbead cases --kills 100 --facts "
                       "docs/reliability/faults.json", "figure": None, "rows": facts}, file, indent=1, ensure_ascii=False)
            file.write("\n")
    sys.exit(not result.wasSuccessful())
