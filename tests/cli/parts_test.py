#!/usr/bin/python3
"""`upbead study --part K/N` and `--merge`: parts without contact give the tables of the whole study, whatever is killed,
full, cut, slow or started twice.

usage: parts_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pty
import signal
import subprocess
import unittest

from program import PROGRAM, main
from studies import MANY, RANDOM, SHORT, SMALL, STUDY, StudyTest, preloaded

SANITIZED = os.environ.get("UPBEAD_SANITIZE") == "ON"
LAUNCHERS = ("OMPI_", "PMI", "SLURM_")


def without_launcher(**more):
    return {**{name: text for name, text in os.environ.items() if not name.startswith(LAUNCHERS)}, **more}


class PartsTest(StudyTest):
    def part(self, part, *arguments, out="parts", code=0, **options):
        return self.study("--part", part, "--out", out, *arguments, code=code, jobs=None, **options)

    def merge(self, *arguments, out="parts", code=0):
        done = self.study("--merge", "--json", "--out", out, *arguments, code=code, jobs=None)
        return json.loads(done.stdout)

    def runs_in(self, out="parts"):
        """Numbers of runs in all journals, as often as they are there, of whole lines."""
        runs = []
        for path in (self.folder / out / "journal").glob("*.jsonl"):
            for line in path.read_text().split("\n")[1:-1]:
                runs += [json.loads(line)["run"]] if line.startswith('{"run"') and line.endswith("}") else []
        return sorted(runs)

    def expect_whole(self, out="parts", once=True):
        """The merged tables are those of the study run whole; no run was done twice."""
        self.study("--out", "whole")
        found, whole = self.merge(out=out), json.loads((self.folder / "whole/summary.json").read_text())
        self.assertEqual(self.table(out), self.table("whole"))
        for key in ("title", "program", "cases", "varied", "read", "runs", "missing", "failed", "checks", "warnings"):
            self.assertEqual(found[key], whole[key], key)
        if once:
            self.assertEqual(self.runs_in(out), list(range(whole["runs"])))
        return found


class Parts(PartsTest):
    def test_joined_they_are_the_whole_study_to_the_last_bit(self):
        told = [self.part(f"{k}/3").stdout for k in (3, 1, 2)]
        for text, k in zip(told, (3, 1, 2)):
            self.assertIn(f"part        {k}/3, 4 runs, 0 failed", text)
            self.assertIn("upbead study study.toml --out parts --merge", text)
        self.assertFalse((self.folder / "parts/study.csv").exists())
        self.expect_whole()
        self.assertEqual([path.name for path in (self.folder / "parts/journal").glob("*") if path.suffix != ".jsonl"], [])

    def test_of_several_processes_and_of_more_parts_than_runs(self):
        (self.folder / "study.toml").write_text(SHORT)
        for k in range(1, 7):
            self.part(f"{k}/6", "--jobs", "2")
        self.expect_whole()

    def test_what_is_missing_is_told_with_its_command(self):
        self.part("2/3", "--set", "title='new'")
        done = self.study("--merge", "--out", "parts", "--set", "title='new'", code=2, jobs=None)
        self.assertIn("8 of 12 runs have no result; the tables name them missing", done.stderr)
        self.assertRegex(done.stdout, r"missing     part 1/3: 4 runs \(0, 1, 2, 3\)\n +upbead study study.toml "
                         r"--set 'title='new'' --out parts --part 1/3\n")
        missing = json.loads((self.folder / "parts/summary.json").read_text())["missing"]
        self.assertEqual([(each["part"], each["runs"], each["works"]) for each in missing],
                         [("1/3", [0, 1, 2, 3], ""), ("3/3", [8, 9, 10, 11], "")])
        self.assertEqual([row["status"] for row in self.rows("parts")], ["missing"] * 4 + ["done"] * 4 + ["missing"] * 4)
        self.assertEqual(self.rows("parts")[0]["response.arm"], "")
        self.assertEqual(len(self.runs_in()), 4, "--merge computes nothing")

    def test_a_failed_run_is_a_row_of_its_part(self):
        (self.folder / "study.toml").write_text(STUDY.replace("[5, 6]", "[5, -5]"))
        self.assertEqual([self.part(f"{k}/2", "--json", code=2).returncode for k in (1, 2)], [2, 2])
        self.study("--out", "whole", code=2)
        self.assertEqual(len(self.merge(code=2)["failed"]), 6)
        self.assertEqual(self.table("parts"), self.table("whole"))

    def test_the_whole_study_and_other_divisions_go_on_from_parts(self):
        (self.folder / "study.toml").write_text(RANDOM.format(n=8))
        self.part("1/2")
        self.assertEqual(json.loads(self.part("1/4", "--json").stdout)["part"], "1/4")
        self.study("--out", "parts")
        self.expect_whole()

    def test_killed_in_the_middle_it_goes_on(self):
        process = self.start(MANY, "--part", "1/2", "--jobs", "1", "--no-sharing", out="parts")
        process.kill()
        process.communicate()
        before = self.runs_in()
        self.assertLess(len(before), MANY // 2)
        holder = self.merge(code=2)["missing"][0]
        self.assertEqual((holder["part"], holder["works"]), ("1/2", ""), "its process has ended")
        told = json.loads(self.part("1/2", "--no-sharing", "--json").stdout)
        self.assertGreaterEqual(told["resumed"], len(before))
        self.part("2/2", "--no-sharing")
        self.assertEqual(self.runs_in(), list(range(MANY)))
        self.study("--out", "whole", "--no-sharing")
        self.merge()
        self.assertEqual(self.table("parts"), self.table("whole"))

    def test_a_killed_worker_costs_the_run_alone(self):
        process = self.start(MANY, "--part", "1/2", "--json", out="parts")
        os.kill(self.processes_of(process)[0], signal.SIGKILL)
        text, errors = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, errors)
        self.assertRegex(errors, "another one does that run again|once it had written that run")
        self.assertEqual(json.loads(text)["lost_processes"], 1)
        self.part("2/2")
        self.assertEqual(self.expect_whole()["lost_processes"], 1)

    @unittest.skipIf(SANITIZED, "a sanitizer must be loaded before any other library")
    def test_a_worker_killed_once_it_has_written_its_run_costs_nothing(self):
        (self.folder / "study.toml").write_text(RANDOM.format(n=12))
        told = self.part("1/2", env={**os.environ, "LD_PRELOAD": preloaded(self.folder), "DISK": "ends"})
        self.assertIn("once it had written that run", told.stderr)
        self.part("2/2")
        self.assertEqual(self.expect_whole()["lost_processes"], 1)

    def start_and_stop(self, *arguments, **options):
        """The first of two parts of twelve runs, which has done one; it does nothing until it is continued."""
        first = self.start(12, "--part", "1/2", *arguments, done=1, **options)
        os.kill(first.pid, signal.SIGSTOP)
        self.addCleanup(first.kill)
        return first

    def go_on(self, process):
        os.kill(process.pid, signal.SIGCONT)
        self.assertEqual(process.communicate(timeout=300)[1], "")
        self.assertEqual(process.returncode, 0)

    def test_a_second_driver_of_the_same_part_is_refused(self):
        first = self.start_and_stop(out="parts")
        for part in ("1/2", "1/3"):
            done = self.part(part, code=1)
            self.assertIn(f"part-1-of-2 is at work in this folder, process {first.pid} on ", done.stderr)
            self.assertIn("wait until it has ended", done.stderr)
        self.assertIn("part-1-of-2", self.study("--out", "parts", code=1).stderr)
        self.part("2/2")
        self.assertIn(f"process {first.pid} on ", self.merge(code=2)["missing"][0]["works"])
        self.go_on(first)
        self.expect_whole()

    def test_one_that_may_work_on_another_machine_is_freed_by_hand(self):
        (self.folder / "study.toml").write_text(SHORT)
        lock = self.folder / "parts/journal/part-1-of-2.lock"
        lock.parent.mkdir(parents=True)
        lock.write_text("1 2 another-bootpid:[1] elsewhere\n")
        done = self.part("1/2", code=1)
        self.assertIn("process 1 on elsewhere", done.stderr)
        self.assertIn("remove parts/journal/part-1-of-2.lock", done.stderr)
        lock.unlink()
        self.part("1/2")
        self.part("2/2")
        self.expect_whole()

    def test_a_journal_cut_in_a_line_costs_that_run(self):
        (self.folder / "study.toml").write_text(RANDOM.format(n=6))
        for k in (1, 2):
            self.part(f"{k}/2")
        journal = next((self.folder / "parts/journal").glob("*part-1-of-2*"))
        journal.write_text(journal.read_text()[:-20])
        missing = self.merge(code=2)["missing"]
        self.assertEqual([(each["part"], len(each["runs"])) for each in missing], [("1/2", 1)])
        self.assertNotIn("not whole", self.part("2/2").stderr, "its own journal is whole")
        done = self.part("1/2", "--json")
        self.assertIn("lines of the journal that are not whole: 1; their runs are done again", done.stderr)
        told = json.loads(done.stdout)
        self.assertEqual((told["runs"], told["resumed"], told["torn_lines"]), (3, 2, 1))
        self.expect_whole()

    @unittest.skipIf(SANITIZED, "a sanitizer must be loaded before any other library")
    def test_a_full_disk_loses_no_run_that_was_done(self):
        (self.folder / "study.toml").write_text(RANDOM.format(n=12))
        disk = {**os.environ, "LD_PRELOAD": preloaded(self.folder)}
        done = self.part("1/2", code=1, env={**disk, "DISK": "full"})
        self.assertRegex(done.stderr, r"journal/0-part-1-of-2-0.jsonl: cannot be written; make room on the disk")
        self.assertEqual(len(self.runs_in()), 2)
        self.assertEqual(json.loads(self.part("1/2", "--json").stdout)["resumed"], 2)
        self.part("2/2")
        self.expect_whole()

    @unittest.skipIf(SANITIZED, "a sanitizer must be loaded before any other library")
    def test_slow_disks_and_those_without_links_change_nothing(self):
        library = preloaded(self.folder)
        for mode in ("slow", "no_links"):
            environment = {**os.environ, "LD_PRELOAD": library, "DISK": mode}
            first = self.start_and_stop(out=mode, env=environment)
            refused = self.part("1/2", out=mode, code=1, env=environment)
            self.assertIn("part-1-of-2 is at work", refused.stderr)
            self.part("2/2", out=mode, env=environment)
            self.go_on(first)
            self.expect_whole(mode)

    def test_parts_of_many_soils_share_one_model(self):
        (self.folder / "study.toml").write_text('share = "soils"\n' + RANDOM.format(n=24))
        both = [subprocess.Popen([PROGRAM, "study", "study.toml", "--out", "parts", "--part", f"{k}/2"], cwd=self.folder,
                                 stdout=subprocess.DEVNULL) for k in (1, 2)]
        self.assertEqual([process.wait(timeout=300) for process in both], [0, 0])
        self.expect_whole()
        self.assertIn("error_estimate", self.rows("parts")[0])
        self.assertEqual([path.name for path in (self.folder / "parts/journal").glob("soils*")], ["soils-0.h5"])

    def test_followed_until_all_is_done(self):
        (self.folder / "study.toml").write_text(SHORT)
        self.part("1/2")
        leader, terminal = pty.openpty()
        follower = subprocess.Popen([PROGRAM, "study", "study.toml", "--out", "parts", "--merge", "--follow", "--json"],
                                    cwd=self.folder, stdout=subprocess.PIPE, stderr=terminal, text=True)
        os.close(terminal)
        shown = b""
        while b"2 of 4 runs" not in shown:
            shown += os.read(leader, 4096)
        self.part("2/2")
        self.assertEqual(json.loads(follower.communicate(timeout=300)[0])["missing"], [])
        os.close(leader)
        self.assertEqual(follower.returncode, 0)
        self.expect_whole()

    def test_mistakes_leave_nothing(self):
        for arguments, words in ((["--part", "0/3"], "write K/N with K from 1 to N"), (["--part", "4/3"], "K/N"),
                                 (["--part", "1"], "K/N"), (["--part", "1/2x"], "K/N"),
                                 (["--part", "1/2", "--merge"], "leave out --part, or --merge"),
                                 (["--follow"], "add --merge"), (["--merge"], "holds no result of the study yet"),
                                 (["--part", "1/2", "--restart"], "remove the folder results/study/journal"),
                                 (["--part", "auto"], "neither mpirun, srun nor a Slurm array")):
            done = self.study(*arguments, code=1, jobs=None, env=without_launcher())
            self.assertIn(words, done.stderr)
        self.assertEqual(self.left_behind(), ["small.toml", "study.toml"])

    def test_of_another_study_is_refused(self):
        (self.folder / "study.toml").write_text(SHORT)
        self.part("1/2")
        (self.folder / "small.toml").write_text(SMALL.replace("2100", "2000"))
        for arguments in (["--part", "2/2"], ["--merge"]):
            self.assertIn("another study", self.study(*arguments, "--out", "parts", code=1, jobs=None).stderr)


class Launchers(PartsTest):
    """What launchers tell: mpirun itself, and others by the variables that they set."""

    def mpirun(self, n, *arguments, code=0):
        # a container may forbid binding to cores
        launch = ["mpirun", "--quiet", "-n", str(n), "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
        done = subprocess.run([*launch, PROGRAM, "study", "study.toml", "--out", "parts", *arguments], cwd=self.folder,
                              capture_output=True, text=True, timeout=300, env=without_launcher())
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_mpirun_divides_a_study_and_joins_it_once(self):
        for resumed in (False, True):
            summary = json.loads(self.mpirun(3, "--json").stdout)  # one object alone
            self.assertEqual((summary["runs"], summary["missing"], summary["resumed"], summary["timing"]["processes"]),
                             (12, [], None, 3), resumed)
            self.assertEqual(self.runs_in(), list(range(12)))
        self.assertEqual({path.name for path in (self.folder / "parts/journal").glob("*.jsonl")},
                         {f"0-part-{k}-of-3-0.jsonl" for k in (1, 2, 3)})
        self.expect_whole()
        self.assertEqual(json.loads(self.mpirun(2, "--merge", "--json").stdout)["missing"], [])

    def test_a_failed_run_ends_no_other_process_of_mpirun(self):
        (self.folder / "study.toml").write_text(STUDY.replace("[5, 6]", "[5, -5]"))
        self.mpirun(2, code=2)
        self.assertEqual([row["status"] for row in self.rows("parts")], (["done"] * 2 + ["failed"] * 2) * 3)

    def test_mpirun_tells_mistakes_once(self):
        (self.folder / "study.toml").write_text(SHORT)
        self.part("1/3")
        (self.folder / "small.toml").write_text(SMALL.replace("2100", "2000"))
        done = self.mpirun(2, code=1)
        self.assertEqual(done.stderr.count("another study"), 1, done.stderr)
        done = self.mpirun(2, "--restart", code=1)
        self.assertEqual(done.stderr.count("before all parts are started"), 1, done.stderr)

    def test_srun_divides_a_study(self):
        (self.folder / "study.toml").write_text(SHORT)
        step = {"SLURM_STEP_NUM_TASKS": "2", "SLURM_JOB_ID": "7", "SLURM_STEP_ID": "0", "SLURM_NODELIST": "here",
                "PMIX_RANK": "9"}
        first = self.study("--out", "parts", jobs=None, env=without_launcher(SLURM_PROCID="1", **step))
        self.assertEqual(first.stdout, "")
        self.assertRegex(first.stderr, r"part 2/2 has ended; 2 of 4 runs of the study have results; once all have, "
                         r"unless it is done then: upbead study study.toml --out parts --merge")
        last = self.study("--out", "parts", jobs=None, env=without_launcher(SLURM_PROCID="0", **step))
        self.assertIn("upbead: part 1/2, by SLURM_PROCID", last.stderr)
        self.assertIn("study       4 runs", last.stdout)
        self.expect_whole()

    def test_a_launcher_that_does_not_name_itself_tells_how_to_join(self):
        (self.folder / "study.toml").write_text(SHORT)
        for rank, told in (("0", "2 of 4 runs of the study have results; once all have"),
                           ("1", "4 of 4 runs of the study have results: upbead study study.toml --out parts --merge")):
            done = self.study("--out", "parts", jobs=None, env=without_launcher(PMI_RANK=rank, PMI_SIZE="2"))
            self.assertIn(told, done.stderr)
        self.expect_whole()

    def test_a_script_of_sbatch_alone_is_no_part(self):
        (self.folder / "study.toml").write_text(SHORT)
        script = {"SLURM_PROCID": "0", "SLURM_NTASKS": "8", "SLURM_ARRAY_TASK_ID": "3", "SLURM_ARRAY_TASK_COUNT": "9"}
        self.study("--out", "parts", env=without_launcher(**script))
        self.assertEqual(len(self.rows("parts")), 4)

    def test_an_array_tells_its_parts_where_asked(self):
        (self.folder / "study.toml").write_text(SHORT)
        for first in (0, 1):
            array = {"SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": str(first),
                     "SLURM_ARRAY_TASK_MAX": str(first + 1)}
            for k in (0, 1):
                done = self.part("auto", out=f"from{first}",
                                 env=without_launcher(SLURM_ARRAY_TASK_ID=str(first + k), **array))
                self.assertIn(f"upbead: part {k + 1}/2, by SLURM_ARRAY_TASK_ID", done.stderr)
            self.expect_whole(f"from{first}")
        again = without_launcher(SLURM_ARRAY_TASK_ID="3", SLURM_ARRAY_TASK_COUNT="2", SLURM_ARRAY_TASK_MIN="3",
                                 SLURM_ARRAY_TASK_MAX="7")
        self.assertIn("say so: --part $SLURM_ARRAY_TASK_ID/N", self.part("auto", code=1, env=again).stderr)

    def test_a_launcher_without_a_number_of_processes_is_told(self):
        done = self.study(code=1, jobs=None, env=without_launcher(PMIX_RANK="3"))
        self.assertIn("say --part K/N", done.stderr)
        self.assertEqual(self.left_behind(), ["small.toml", "study.toml"])


if __name__ == "__main__":
    main()
