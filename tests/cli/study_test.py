#!/usr/bin/python3
"""`upbead study` and `upbead scale` as a user runs them: tables, failures, resuming, processes.

usage: study_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

import h5py
import numpy as np

from program import CASES, PROGRAM, ProgramTest, main, on_a_terminal, upbead
from studies import MANY, RANDOM, SHORT, SMALL, STUDY, StudyTest, preloaded


class Study(StudyTest):
    def test_grid_is_one_table(self):
        summary = json.loads(self.study("--json", jobs=None).stdout)
        rows = self.rows()
        self.assertEqual(len(rows), 12)
        self.assertEqual([row["run"] for row in rows], [str(i) for i in range(12)])
        self.assertEqual({row["status"] for row in rows}, {"done"})
        self.assertEqual(rows[1]["sliding.friction"], "0.6")
        self.assertEqual(rows[11]["regions.seabed.shear_modulus"], "60000000")
        self.assertGreater(float(rows[0]["sliding.sliding_history"]), float(rows[1]["sliding.sliding_history"]))
        self.assertEqual(summary["runs"], 12)
        self.assertEqual(summary["failed"], [])
        self.assertTrue(any("solution" in item["what"] for item in summary["skipped"]))
        with h5py.File(self.folder / "results/study/study.h5") as file:
            ratio = file["read/response.shear_to_force_ratio/value"][:]
            np.testing.assert_array_equal(ratio, [float(row["response.shear_to_force_ratio"]) for row in rows])
            np.testing.assert_array_equal(file["varied/mesh.parameters.mound_height"][:], [5, 5, 6, 6] * 3)
            for doubt in ("checks_failing", "warnings", "void"):
                self.assertEqual([text.decode() for text in file[f"runs/{doubt}"][:]], [row[doubt] for row in rows])
            self.assertIn(b"force against friction", file["runs/checks_failing"][0])

    def test_too_many_steps_are_told_where_they_are_asked_for(self):
        (self.folder / "study.toml").write_text(
            'case = "small.toml"\nread = ["response.peak_shear"]\n[vary."time.step"]\nvalues = [1e-9, 1e-10]\n')
        upbead("study", "study.toml", cwd=self.folder)
        for row, step in zip(self.rows(), ("1e-9", "1e-10")):
            self.assertTrue(row["message"].startswith(f"--set time.step={step}: "), row["message"])

    def test_a_row_is_what_the_run_finds_alone(self):
        self.study()
        row = self.rows()[6]
        done = upbead("run", "small.toml", "--set", "regions.seabed.shear_modulus=40e6", "--set",
                      "regions.mound.shear_modulus=60e6", "--set", "mesh.parameters.mound_height=6", "--set",
                      "sliding.friction=0.5", "--json", cwd=self.folder)
        alone = json.loads(done.stdout)
        self.assertEqual(float(row["response.shear_to_force_ratio"]), alone["response"]["shear_to_force_ratio"])
        self.assertEqual(float(row["sliding.sliding_history"]), alone["sliding"]["sliding_history"])
        failing = [check["name"] for check in alone["checks"] if check["holds"] is False]
        self.assertIn("force against friction", failing)
        self.assertEqual(row["checks_failing"].split("; "), failing)
        self.assertEqual(row["warnings"].split("; "), list(dict.fromkeys(warning["name"] for warning in alone["warnings"])))

    def test_what_fails_and_warns_in_some_runs_is_told(self):
        (self.folder / "study.toml").write_text(
            'case = "small.toml"\nread = ["response.peak_shear"]\n[vary."loads.impulse.factor"]\nvalues = [0.01, 1.0, 1.5]\n')
        summary = json.loads(self.study("--json").stdout)
        friction = next(check for check in summary["checks"] if check["name"] == "force against friction")
        self.assertEqual((friction["failing"], friction["first_run"]), (2, 1))
        self.assertIn("DOES NOT HOLD", friction["text"])
        self.assertNotIn("force against friction", self.rows()[0]["checks_failing"].split("; "))
        self.assertTrue(summary["warnings"])
        told = self.study("--restart").stdout
        self.assertEqual({check["judged"] for check in summary["checks"]}, {3})
        for check in summary["checks"]:
            self.assertEqual(check["failing"] > 0, check["holds"] is False)
        alone = json.loads(upbead("run", "small.toml", "--set", "loads.impulse.factor=1.5", "--json", cwd=self.folder).stdout)
        self.assertEqual({key: friction[key] for key in ("demand", "capacity", "margin", "text")},
                         {key: check[key] for check in alone["checks"] if check["name"] == friction["name"]
                          for key in ("demand", "capacity", "margin", "text")}, "that of the worst run")
        self.assertEqual(friction["worst_run"], 2)
        for found in [check for check in summary["checks"] if check["failing"]] + summary["warnings"]:
            self.assertIn(f"{found['name']}: in {found.get('failing') or found['runs']} of 3 runs", told)
            self.assertIn(found["text"], told)

    def test_a_varied_key_that_changes_nothing_is_told(self):
        (self.folder / "study.toml").write_text(
            'case = "small.toml"\nread = ["response.peak_shear"]\n'
            '[vary."fluid.viscosity"]\nvalues = [1e-3, 2e-3]\n[vary."regions.seabed.shear_modulus"]\nvalues = [2e7, 3e7]\n')
        told = [w["text"] for w in json.loads(self.study("--json").stdout)["warnings"] if w["name"] == "varied_unfelt"]
        self.assertEqual(len(told), 1, told)
        self.assertIn("'fluid.viscosity' is varied", told[0])

    def test_sharing_and_processes_change_no_bit(self):
        (self.folder / "study.toml").write_text(STUDY.replace("n = 3", "n = 2"))
        self.study("--out", "two", jobs="2")
        self.assertEqual(len(os.listdir(self.folder / "two/journal")), 2)
        self.study("--out", "one")
        summary = json.loads(self.study("--out", "alone", "--no-sharing", "--json").stdout)
        self.assertEqual(summary["skipped"], [])
        self.assertEqual(self.table("one"), self.table("two"))
        self.assertEqual(self.table("one"), self.table("alone"))

    def test_paired(self):
        self.study("--set", 'sample="paired"', "--set", 'vary."mesh.parameters.mound_height".values=[5, 5.5, 6]', "--set",
                   'vary."sliding.friction".values=[0.5, 0.6, 0.7]')
        self.assertEqual([row["sliding.friction"] for row in self.rows()], ["0.5", "0.6", "0.7"])

    def test_more_draws_keep_the_first_ones(self):
        (self.folder / "study.toml").write_text(RANDOM.format(n=4))
        self.study("--out", "four")
        self.study("--out", "six", "--set", "n=6")
        four, six = self.rows("four"), self.rows("six")
        self.assertEqual(six[:4], four)
        self.assertEqual(len({row["regions.seabed.shear_modulus"] for row in six}), 6)

    def test_a_failed_run_is_a_row(self):
        done = self.study("--set", 'vary."regions.seabed.shear_modulus".values=[20e6, -1, 40e6]', "--set",
                          'vary."mesh.parameters.mound_height".values=[5]', "--set",
                          'vary."sliding.friction".values=[0.6]', code=1)
        self.assertIn("values of more than one kind", done.stderr)
        text = STUDY.replace("from = 20e6\nto = 60e6\nn = 3", "values = [20e6, -1, 40e6]").replace("[5, 6]", "[5, -5]")
        (self.folder / "study.toml").write_text(text)
        done = self.study(code=2)
        self.assertIn("8 failed", done.stdout)
        rows = self.rows()
        self.assertEqual([row["status"] for row in rows],
                         ["done"] * 2 + ["failed"] * 6 + ["done"] * 2 + ["failed"] * 2)
        self.assertEqual(rows[2]["response.shear_to_force_ratio"], "")
        self.assertIn("mound_height is -5", rows[2]["message"])
        self.assertIn("shear_modulus = -1 is outside (0, inf)", rows[4]["message"])
        summary = json.loads((self.folder / "results/study/summary.json").read_text())
        self.assertEqual([item["run"] for item in summary["failed"]], [2, 3, 4, 5, 6, 7, 10, 11])
        self.assertIn("--set 'mesh.parameters.mound_height=-5'", summary["failed"][0]["command"])
        with h5py.File(self.folder / "results/study/study.h5") as file:
            self.assertEqual(file["read/response.arm/run"][:].tolist(), [0, 1, 8, 9])
            self.assertEqual(file["runs/done"][:].sum(), 4)

    def kill_in_the_middle(self, n, how, group, *arguments):
        """Starts a study of n runs and ends it after some of them."""
        (self.folder / "study.toml").write_text(RANDOM.format(n=n))
        process = subprocess.Popen([PROGRAM, "study", "study.toml", "--out", "killed", *arguments], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)
        while self.journal_lines("killed") < 5:
            self.assertIsNone(process.poll(), "it ended before it could be killed")
            time.sleep(0.01)
        (os.killpg if group else os.kill)(process.pid, how)
        errors = process.communicate()[1].decode()
        done = self.journal_lines("killed")
        self.assertTrue(5 <= done < n, done)
        return process.returncode, errors

    def test_killed_and_resumed_it_is_the_same_to_the_last_bit(self):
        self.expect_the_same_after_a_kill("1", 12)

    def test_processes_killed_and_resumed_are_the_same_to_the_last_bit_at_length(self):
        self.expect_the_same_after_a_kill("2", 24)

    def expect_the_same_after_a_kill(self, jobs, n):
        (self.folder / "study.toml").write_text(RANDOM.format(n=n))
        self.study("--out", "whole")
        self.kill_in_the_middle(n, signal.SIGKILL, True, "--jobs", jobs)
        self.assertFalse((self.folder / "killed/study.csv").exists())
        journal = next(path for path in (self.folder / "killed/journal").glob("*.jsonl") if self.lines(path) > 2)
        text = journal.read_text()
        journal.write_text(text[:-20])  # as if killed while it wrote
        resumed = json.loads(self.study("--out", "killed", "--json", jobs=jobs).stdout)
        self.assertGreaterEqual(resumed["resumed"], 4)
        self.assertEqual(self.table("killed"), self.table("whole"))
        again = json.loads(self.study("--out", "killed", "--json").stdout)
        self.assertEqual(again["resumed"], n)

    @staticmethod
    def lines(path):
        return len(path.read_text().splitlines())

    def test_interrupted_it_says_how_to_go_on(self):
        code, errors = self.kill_in_the_middle(400, signal.SIGINT, False, "--jobs", "1")
        self.assertEqual(code, 130)
        self.assertRegex(errors, r"interrupted; \d+ of 400 runs are done, the same command goes on")

    def test_interrupted_processes_leave_no_half_table(self):
        code, errors = self.kill_in_the_middle(2000, signal.SIGINT, False, "--jobs", "2")
        self.assertEqual(code, 130)
        self.assertRegex(errors, r"interrupted; \d+ of 2000 runs are done")
        self.assertFalse((self.folder / "killed/study.csv").exists())

    def test_a_changed_file_in_a_folder_that_is_varied_does_not_resume(self):
        shutil.copytree(CASES / "cfd", self.folder / "cfd")
        shutil.copytree(CASES / "cfd/bore", self.folder / "cfd/other")
        (self.folder / "study.toml").write_text(
            'case = "cfd/bore.toml"\nread = ["response.peak_shear"]\n[vary."loads.forces.from"]\nvalues = ["bore/forces", "other/forces"]\n')
        self.study()
        forces = self.folder / "cfd/other/forces/0/force.dat"
        forces.write_text(forces.read_text() + "# more\n")
        self.assertIn("add --restart to forget them", self.study(code=1).stderr)

    def test_a_void_run_is_told(self):
        text = (CASES / "design-wave/composite.toml").read_text()
        (self.folder / "harbour.toml").write_text(
            text.replace("water_depth = 15\n", "water_depth = 15\nwater_depth_back = 15\n").replace("cells = 0.4", "cells = 0.6"))
        (self.folder / "study.toml").write_text(
            'case = "harbour.toml"\nread = ["sliding.design.value"]\n[vary."mesh.parameters.water_depth_back"]\nvalues = [15, 13]\n')
        done = self.study()
        rows, summary = self.rows(), json.loads((self.folder / "results/study/summary.json").read_text())
        self.assertEqual([row["void"] for row in rows], ["", "harbour_level"])
        self.assertEqual([{"runs": [1], "why": "harbour_level"}], summary["void"])
        self.assertIn("VOID        1 run (1), as the warnings say: harbour_level\n", done.stdout)

    def test_a_changed_study_does_not_resume(self):
        (self.folder / "study.toml").write_text(SHORT)
        self.study()
        (self.folder / "small.toml").write_text(SMALL.replace("2100", "2000"))
        done = self.study(code=1)
        self.assertIn("add --restart to forget them", done.stderr)
        before = self.table("results/study")
        self.study("--restart")
        self.assertNotEqual(self.table("results/study"), before)

    def test_cases_side_by_side(self):
        (self.folder / "stiff.toml").write_text(SMALL.replace("50e6", "90e6"))
        (self.folder / "study.toml").write_text(STUDY.replace('case = "small.toml"', 'cases = ["small.toml", "stiff.toml"]')
                                                .replace("n = 3", "n = 2").replace("[5, 6]", "[5]")
                                                .split("[follow")[0])
        self.study()
        rows = self.rows()
        self.assertEqual([row["case"] for row in rows], ["small.toml"] * 4 + ["stiff.toml"] * 4)
        self.assertNotEqual(rows[0]["response.shear_to_force_ratio"], rows[4]["response.shear_to_force_ratio"])

    def test_mistakes_leave_nothing(self):
        done = self.study("--set", 'sample="net"', "--set", "n=3", code=1)
        self.assertIn("none of grid, paired, random, sobol", done.stderr)
        self.assertEqual(self.left_behind(), ["small.toml", "study.toml"])

    def test_under_a_launcher_mistakes_are_told_once(self):
        environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        done = subprocess.run(["mpirun", "--quiet", "-n", "2", "--oversubscribe", PROGRAM, "study", "study.toml",
                               "--set", 'sample="net"'], cwd=self.folder, capture_output=True, text=True, timeout=60,
                              env=environment)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count("none of grid, paired, random, sobol"), 1, done.stderr)

    def test_without_mpirun_it_runs_all_the_same(self):
        (self.folder / "study.toml").write_text(SHORT)
        environment = {**os.environ, "PATH": str(self.folder)}
        done = self.study(jobs="2", env=environment)
        self.assertIn("on 2 processes", done.stdout)
        self.assertEqual(len(self.rows()), 4)

    def test_a_killed_process_costs_its_run_alone(self):
        process = self.start(MANY, "--jobs", "2", "--json")
        os.kill(self.processes_of(process)[0], signal.SIGKILL)
        text, errors = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, errors)
        self.assertRegex(errors, r"the process of run \d+ was ended by signal 9 \(Killed\).*(does that run again|had written that run)")
        summary = json.loads(text)
        self.assertEqual((summary["lost_processes"], summary["failed"]), (1, []))
        self.study("--out", "whole")
        self.assertEqual(self.table("killed"), self.table("whole"))

    def test_a_run_that_ends_every_process_fails_alone(self):
        process = self.start(MANY, "--jobs", "2", "--json")
        until = time.monotonic() + 60
        while process.poll() is None and time.monotonic() < until:  # whoever computes dies, but for one process
            for other in self.processes_of(process)[1:]:
                os.kill(other, signal.SIGKILL)
            time.sleep(0.05)
        text, errors = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 2, errors)
        failed = json.loads(text)["failed"]
        self.assertTrue(failed)
        self.assertIn("its process was ended twice, by signal 9 (Killed)", failed[0]["message"])
        self.assertEqual([row["status"] for row in self.rows("killed")].count("failed"), len(failed))

    def test_a_killed_study_leaves_no_process(self):
        process = self.start(400, "--jobs", "2")
        workers = self.processes_of(process)
        process.kill()
        process.communicate()
        self.assertEqual(len(workers), 2)
        time.sleep(0.5)
        self.assertEqual([n for n in workers if pathlib.Path(f"/proc/{n}/cmdline").exists()
                          and b"study" in pathlib.Path(f"/proc/{n}/cmdline").read_bytes()], [])

    def test_a_second_study_in_the_folder_is_refused(self):
        first = self.start(40, "--jobs", "1")
        os.kill(first.pid, signal.SIGSTOP)  # else it may have ended before the last one looks
        self.addCleanup(first.kill)
        for arguments in ([], ["--jobs", "2"], ["--restart"]):
            done = self.study("--out", "killed", *arguments, code=1, jobs=None)
            self.assertIn(f"another process works in this folder, process {first.pid} on ", done.stderr)
            self.assertIn("choose another folder with --out DIR", done.stderr)
        os.kill(first.pid, signal.SIGCONT)
        errors = first.communicate(timeout=300)[1]
        self.assertEqual(first.returncode, 0, errors)
        self.assertEqual(self.journal_lines("killed"), 40)
        self.assertEqual(json.loads(self.study("--out", "killed", "--json").stdout)["resumed"], 40)

    @unittest.skipIf(os.environ.get("UPBEAD_SANITIZE") == "ON", "a sanitizer must be loaded before any other library")
    def test_neither_slow_disks_nor_missing_links_let_a_second_one_in(self):
        library = preloaded(self.folder)
        for mode in ("slow", "no_links"):
            environment = {**os.environ, "LD_PRELOAD": library, "DISK": mode}
            first = self.start(12, "--jobs", "2", out=mode, env=environment)
            os.kill(first.pid, signal.SIGSTOP)  # else it may have ended before the second one looks
            self.addCleanup(first.kill)
            done = self.study("--out", mode, code=1, env=environment)
            self.assertIn("another process works in this folder", done.stderr)
            os.kill(first.pid, signal.SIGCONT)
            errors = first.communicate(timeout=300)[1]
            self.assertEqual(first.returncode, 0, errors)
            self.assertEqual(self.journal_lines(mode), 12)
            killed = self.start(400, "--jobs", "2", out="killed-" + mode, env=environment)
            killed.kill()
            killed.communicate()
            (self.folder / "study.toml").write_text(RANDOM.format(n=400))
            self.study("--out", "killed-" + mode, "--restart", "--set", "n=2", env=environment)

    def test_a_torn_line_is_told_and_its_run_is_done_again(self):
        (self.folder / "study.toml").write_text(RANDOM.format(n=3))
        self.study()
        before = self.table("results/study")
        journal = self.folder / "results/study/journal/0-0.jsonl"
        lines = journal.read_text().splitlines(keepends=True)
        journal.write_text("".join([*lines[:2], lines[2][:40], lines[3]]))
        done = self.study("--json")
        self.assertIn("lines of the journal that are not whole: 1; their runs are done again", done.stderr)
        summary = json.loads(done.stdout)
        self.assertEqual((summary["torn_lines"], summary["resumed"]), (1, 1))  # the line behind it is torn with it
        self.assertEqual(self.table("results/study"), before)

    def test_progress_is_shown_on_a_terminal(self):
        (self.folder / "study.toml").write_text(SHORT)
        for jobs in ("1", "2"):
            code, text = on_a_terminal("study", "study.toml", "--jobs", jobs, "--restart", cwd=self.folder)
            self.assertEqual(code, 0)
            self.assertIn(b"of 4 runs", text)

    def test_figures_of_a_grid_and_of_draws_at_length(self):
        script = CASES.parent / "postprocess/study.py"
        self.study()
        (self.folder / "other.toml").write_text(SMALL.replace("50e6", "90e6"))
        (self.folder / "study.toml").write_text(RANDOM.format(n=10).replace('case = "small.toml"',
                                                                            'cases = ["small.toml", "other.toml"]'))
        self.study("--out", "drawn")
        for arguments in (["results/study"], ["results/study", "--read", "response.arm", "--x", "sliding.friction"], ["drawn"]):
            done = subprocess.run(["/usr/bin/python3", script, *arguments, "-o", "figure.png"], cwd=self.folder,
                                  capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (0, "figure.png\n"), done.stderr)
            self.assertGreater((self.folder / "figure.png").stat().st_size, 10000)
            (self.folder / "figure.png").unlink()
        done = subprocess.run(["/usr/bin/python3", script, "results/study", "--x", "gravity"], cwd=self.folder,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("the study has no key 'gravity'", done.stderr)

    def test_help_teaches_by_example(self):
        self.assertIn("upbead study cases/study/", upbead("study", "--help").stdout)
        text = (CASES.parent / "docs/reference/study.md").read_text()
        keys = upbead("study", "--keys").stdout.replace("](", "](../")
        self.assertTrue(text.endswith(keys), "run postprocess/reference.py build/upbead docs")
        self.assertEqual(upbead("study").returncode, 1)

    def test_shipped_studies_are_sound(self):
        for path in sorted((CASES / "study").glob("*.toml")):
            done = upbead("study", path, "--jobs", "1", "--out", "out", "--set", "case=nowhere.toml", cwd=self.folder)
            self.assertIn("cannot read", done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)  # the only message


class Scale(ProgramTest):
    def test_model_becomes_the_similar_prototype(self):
        done = upbead("scale", CASES / "fig2b-model.toml", "--factor", "20", "--set", "mesh.parameters.cells=0.3",
                      cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        folder = self.folder / "results/fig2b-model-scaled"
        self.assertEqual(sorted(os.listdir(folder)), ["case.toml", "impulse.csv", "slow.csv"])
        ratios = []
        for case, more in ((CASES / "fig2b-model.toml", ["--set", "mesh.parameters.cells=0.3"]), (folder / "case.toml", [])):
            run = upbead("run", case, *more, "--json", cwd=self.folder)
            self.assertEqual(run.returncode, 0, run.stderr)
            ratios.append(json.loads(run.stdout)["response"]["shear_to_force_ratio"])
        self.assertAlmostEqual(ratios[0], ratios[1], delta=1e-8 * ratios[0])

    def test_same_soil_tells_what_is_kept(self):
        done = upbead("scale", CASES / "fig2b-model.toml", "--factor", "20", "--soil", "same", "--ratio",
                      "regions.seabed.shear_modulus=4.47", "--json", cwd=self.folder)
        found = json.loads(done.stdout)
        self.assertEqual(found["factors"]["force"], 400)
        self.assertIn("regions.mound.shear_modulus", found["kept"])
        self.assertNotIn("regions.seabed.shear_modulus", found["kept"])

    def test_mistakes_leave_nothing(self):
        for options, words in ((["--factor", "-1"], "not a positive number"), ([], "--factor"),
                               (["--factor", "2", "--soil", "clay"], "clay"),
                               (["--factor", "2", "--ratio", "gravty=1"], "did you mean 'gravity'?")):
            done = upbead("scale", CASES / "fig2b-model.toml", *options, cwd=self.folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn(words, done.stderr + done.stdout)
        self.assertEqual(self.left_behind(), [])


if __name__ == "__main__":
    main()
