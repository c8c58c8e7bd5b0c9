#!/usr/bin/python3
"""`upbead expected --part K/N` and `--merge`: lives in parts give the files of the whole, whatever is killed, cut, lost or
started twice.

usage: expected_parts_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import time

from program import CASES, PROGRAM, ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from hand_made_model import write_oscillator  # noqa: E402

HD10, PROTOTYPE = CASES / "section4/hd10.toml", CASES / "expected/prototype.toml"
LIVES = ["--set", "life.simulated_lives=300", "--set", "scatter.force.cov=0.1", "--set", "scatter.friction.cov=0.1"]
MANY = ["--set", "life.simulated_lives=40000", "--set", "scatter.force.cov=0.1"]


class ExpectedParts(ProgramTest):
    def expected(self, *arguments, design=HD10, out="parts", code=0, **options):
        done = upbead("expected", design, *arguments, "--out", out, cwd=self.folder, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def part(self, part, *arguments, **options):
        return json.loads(self.expected("--part", part, "--json", *arguments, **options).stdout)

    def files(self, out):
        """All but the times that were taken."""
        folder = self.folder / out
        summary = json.loads((folder / "summary.json").read_text())
        del summary["timing"]
        return summary, (folder / "results.h5").read_bytes(), (folder / "case.toml").read_text()

    def expect_whole(self, *arguments, once=True, **options):
        self.expected("--merge", *arguments, **options)
        self.expected(*arguments, out="whole", **options)
        self.assertEqual(self.files("parts"), self.files("whole"))
        lives = self.lives()
        if once:
            self.assertEqual(sorted(lives), list(range(len(lives))), "each once")

    def lives(self):
        lives = []
        for path in (self.folder / "parts/journal").glob("*.jsonl"):
            lives += [json.loads(line)["life"] for line in path.read_text().split("\n")
                      if line.startswith('{"life"') and line.endswith("}")]
        return lives

    def start(self, part, *arguments):
        """A part that has written some lives, and has stopped."""
        process = subprocess.Popen([PROGRAM, "expected", HD10, "--part", part, *arguments, "--out", "parts"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        while len(self.lives()) < 10:
            self.assertIsNone(process.poll(), "it ended too soon")
            time.sleep(0.01)
        os.kill(process.pid, signal.SIGSTOP)
        state = pathlib.Path(f"/proc/{process.pid}/stat")
        while (now := state.read_text().rsplit(")", 1)[1].split()[0]) not in "TZ":
            time.sleep(0.01)
        self.assertEqual(now, "T", "it ended too soon")
        return process

    def test_joined_they_are_the_whole_to_the_last_bit(self):
        told = [self.part(f"{k}/7", *LIVES) for k in (3, 1, 2, 7, 6, 5, 4)]
        self.assertEqual(sum(each["lives"] for each in told), 300)
        self.assertEqual({each["resumed"] for each in told}, {0})
        self.assertFalse((self.folder / "parts/summary.json").exists())
        self.expect_whole(*LIVES)
        self.assertEqual(self.part("3/7", *LIVES)["resumed"], told[0]["lives"])

    def test_lives_by_own_dynamics_have_those_by_formulas_beside_them(self):
        write_oscillator(self.folder / "model.h5", mass=5.933088e6 / 9.81)
        keys = ["--set", f"dynamics.model={self.folder / 'model.h5'}", "--set", "dynamics.load=impact", "--set",
                "life.simulated_lives=20", "--set", "life.years=1"]
        for k in range(1, 4):
            self.part(f"{k}/3", *keys, design=PROTOTYPE)
        self.expect_whole(*keys, design=PROTOTYPE)
        self.assertIn("by_formulas", self.files("parts")[0]["monte_carlo"])

    def test_more_parts_than_lives(self):
        few = ["--set", "life.simulated_lives=3"]
        self.assertEqual([self.part(f"{k}/5", *few)["lives"] for k in range(1, 6)], [0, 1, 0, 1, 1])
        self.expect_whole(*few)

    def test_a_lost_part_is_told_with_its_command(self):
        for k in (1, 3):
            self.part(f"{k}/3", *LIVES)
        told = self.expected("--merge", *LIVES, code=1).stderr
        self.assertIn("part 2/3: 100 lives have no result; upbead expected ", told)
        self.assertIn("--set 'scatter.force.cov=0.1'", told)
        self.assertIn("--out parts --part 2/3", told)
        self.assertFalse((self.folder / "parts/summary.json").exists())
        self.part("2/3", *LIVES)
        self.expect_whole(*LIVES)

    def test_killed_it_goes_on_and_does_nothing_twice(self):
        process = self.start("1/2", *MANY)
        process.kill()
        process.communicate()
        resumed = self.part("1/2", *MANY)["resumed"]
        self.assertTrue(9 <= resumed < 20000, resumed)
        self.part("2/2", *MANY)
        self.expect_whole(*MANY)

    def test_interrupted_it_tells_what_is_done(self):
        process = self.start("1/2", *MANY)
        process.send_signal(signal.SIGINT)
        os.kill(process.pid, signal.SIGCONT)
        told = process.communicate(timeout=300)[1]
        self.assertEqual(process.returncode, 128 + signal.SIGINT, told)
        self.assertRegex(told, r"upbead: interrupted; \d+ of 20000 lives of the part are done, the same command goes on with the rest")
        self.part("1/2", *MANY)
        self.part("2/2", *MANY)
        self.expect_whole(*MANY)

    def test_a_second_driver_is_refused(self):
        first = self.start("1/2", *MANY)
        for part in ("1/2", "1/3"):
            told = self.expected("--part", part, *MANY, code=1).stderr
            self.assertIn(f"part-1-of-2 is at work in this folder, process {first.pid} on ", told)
        self.part("2/2", *MANY)
        self.assertIn(f"process {first.pid} on ", self.expected("--merge", *MANY, code=1).stderr)
        os.kill(first.pid, signal.SIGCONT)
        self.assertEqual(first.communicate(timeout=300)[1], "")
        self.expect_whole(*MANY)

    def test_a_journal_cut_in_a_line_costs_that_life(self):
        for k in (1, 2):
            self.part(f"{k}/2", *LIVES)
        journal = next((self.folder / "parts/journal").glob("*part-1-of-2*"))
        journal.write_text(journal.read_text()[:-20])
        self.assertIn("part 1/2: 1 lives have no result", self.expected("--merge", *LIVES, code=1).stderr)
        done = self.expected("--part", "1/2", *LIVES)
        self.assertIn("lines of the journal that are not whole: 1; their lives are done again", done.stderr)
        self.assertIn("part        1/2, 150 lives, 149 of them done before", done.stdout)
        self.expect_whole(*LIVES)

    def test_of_another_design_is_refused(self):
        self.part("1/2", *LIVES)
        for arguments in (["--part", "2/2"], ["--merge"]):
            told = self.expected(*arguments, *LIVES, "--set", "section.friction=0.5", code=1).stderr
            self.assertIn("the results there are of other work, or of this design before it", told)
            self.assertIn("remove parts/journal", told)

    def test_mistakes_leave_nothing(self):
        alone = {name: text for name, text in os.environ.items() if not name.startswith(("OMPI_", "PMI", "SLURM_"))}
        for arguments, words in ((["--part", "0/3", *LIVES], "write K/N with K from 1 to N"),
                                 (["--part", "1/2", "--merge", *LIVES], "leave out --part, or --merge"),
                                 (["--merge", *LIVES], "holds no life of the design yet"),
                                 (["--part", "1/2"], "add a table [life]"), (["--merge"], "add a table [life]"),
                                 (["--part", "auto", *LIVES], "neither mpirun, srun nor a Slurm array")):
            self.assertIn(words, self.expected(*arguments, code=1, env=alone).stderr)
        self.assertEqual(self.left_behind(), [])

    def test_an_array_tells_the_part(self):
        array = {**os.environ, "SLURM_ARRAY_TASK_ID": "2", "SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "1",
                 "SLURM_ARRAY_TASK_MAX": "2"}
        self.assertEqual(self.part("auto", *LIVES, env=array)["part"], "2/2")


if __name__ == "__main__":
    main()
