#!/usr/bin/python3
"""Under a real Slurm of this machine: an array does a study's parts, a job runs on two processes, and a part that is
killed and put into the queue again loses and repeats nothing. Skipped where Slurm cannot be started.

usage: slurm_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import shlex
import tempfile
import unittest

import slurm
from parts_test import PartsTest
from program import CASES, PROGRAM, main, upbead
from studies import RANDOM

WHY_NOT = slurm.missing()


@unittest.skipIf(WHY_NOT, WHY_NOT)
class UnderSlurm(PartsTest):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.slurm = cls.enterClassContext(slurm.Slurm(pathlib.Path(cls.place.name) / "slurm"))
        cls.addClassCleanup(cls.place.cleanup)

    def submit(self, *arguments, options=(), by=""):
        """A job in the study's folder; its output goes to slurm-NUMBER.out there."""
        line = f"{by} {shlex.join(map(str, (PROGRAM, *arguments)))}"
        return self.slurm.submit(line.replace("TASK", "$SLURM_ARRAY_TASK_ID"), *options, cwd=self.folder)

    def output(self, job):
        return "".join(path.read_text() for path in sorted(self.folder.glob(f"slurm-{job}*.out")))

    def test_an_array_does_the_parts_of_a_study(self):
        job = self.submit("study", "study.toml", "--out", "parts", "--part", "TASK/3", options=["--array=1-3"])
        self.slurm.wait_for(job)
        self.expect_whole()
        self.assertEqual(self.output(job).count("4 runs, 0 failed"), 3, self.output(job))

    def test_an_array_without_gaps_tells_the_parts_by_itself(self):
        job = self.submit("study", "study.toml", "--out", "parts", "--part", "auto", options=["--array=0-1"])
        self.slurm.wait_for(job)
        self.expect_whole()
        self.assertIn("part 2/2, by SLURM_ARRAY_TASK_ID", self.output(job))

    @unittest.skipIf((os.cpu_count() or 1) < 2, "one core")
    def test_a_job_of_two_processes(self):
        case = [CASES / "fig2b-prototype.toml", "--set", "mesh.parameters.cells=0.4", "--set", "time.scheme=sdirk4",
                "--set", "time.end=0.5", "--json"]
        job = self.submit("run", *case, "--out", "two", options=["--ntasks=2"], by="srun --mpi=pmix")
        self.slurm.wait_for(job)
        self.assertTrue((self.folder / "two/summary.json").exists(), self.output(job))
        upbead("run", *case, "--out", self.folder / "one", check=True)
        one, two = (json.loads((self.folder / name / "summary.json").read_text()) for name in ("one", "two"))
        peak = one["response"]["peak_shear"]
        self.assertAlmostEqual(two["response"]["peak_shear"] / peak, 1., delta=1e-10)
        self.assertEqual(two["discretisation"]["processes"], 2)

    def test_killed_and_put_into_the_queue_again(self):
        (self.folder / "study.toml").write_text(RANDOM.format(n=48))
        arguments = ["study", "study.toml", "--out", "parts", "--no-sharing", "--jobs", "1", "--part"]
        job = self.submit(*arguments, "1/2", options=["--requeue"])
        self.slurm.wait("no run was done", lambda: self.runs_in())
        self.slurm.tell("scontrol", "requeue", job)
        before = self.runs_in()
        if len(before) == 24:
            self.skipTest("the part ended before Slurm took it back")
        self.slurm.wait_for(self.submit(*arguments, "2/2"))
        self.slurm.tell("scontrol", "update", f"JobId={job}", "StartTime=now", check=False)
        self.slurm.wait_for(job)
        self.assertEqual(self.runs_in(), list(range(48)), self.output(job))
        self.study("--out", "whole", "--no-sharing")
        self.merge()
        self.assertEqual(self.table("parts"), self.table("whole"))


if __name__ == "__main__":
    main()
