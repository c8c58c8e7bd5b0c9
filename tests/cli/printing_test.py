#!/usr/bin/python3
"""What is printed: a full disk behind stdout ends every command with an error, a reader that went away is not told; and
files are read on a file system without locks.

usage: printing_test.py PROGRAM CASES_FOLDER
"""

import os
import resource
import shutil
import signal
import subprocess

from program import CASES, PROGRAM, ProgramTest, main

QUICK = ["--set", "mesh.parameters.cells=0.3", "--set", "time.end=0.05"]
MODEL = CASES / "fig2b-model.toml"
DESIGN = CASES / "gallery/goda-waves.toml"
FORCES = CASES / "cfd/bore/forces"
STUDY = f"""
case = "{MODEL}"
read = ["response.peak_shear"]
set = {{ "mesh.parameters.cells" = 0.3, "time.end" = 0.05 }}
[vary."loads.slow.factor"]
values = [1.0, 2.0]
"""
COMMANDS = {
    "help": ["--help"], "help of a command": ["run", "--help"], "version": ["--version"], "keys": ["explain", "--keys"],
    "schema": ["explain", "--schema"], "exclusions": ["explain", "--exclusions"], "outputs": ["explain", "--outputs"],
    "keys of a design": ["waves", "--keys"], "explain": ["explain", MODEL, *QUICK],
    "explain as JSON": ["explain", MODEL, *QUICK, "--json"], "run": ["run", MODEL, *QUICK, "--out", "out"],
    "reduce": ["reduce", MODEL, *QUICK, "--out", "model"],
    "respond": ["respond", "model/reduced.h5", CASES / "fig2b-model-impulse.csv", "--out", "answer"],
    "study": ["study", "study.toml", "--out", "study"], "waves": ["waves", DESIGN, "--out", "waves"],
    "expected": ["expected", CASES / "section4/hd10.toml", "--out", "expected"],
    "keys of a calibration": ["calibrate", "--keys"],
    "read": ["read", FORCES], "read as JSON": ["read", FORCES, "--json"], "new": ["new", "mine.toml"],
    "scale": ["scale", MODEL, "--factor", "2", "--out", "scaled"]}

NO_LOCKS = "#include <errno.h>\nint flock(int file, int operation) { errno = ENOLCK; return -1; }\n"


class Printing(ProgramTest):
    def end(self, arguments, **options):
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, stderr=subprocess.PIPE, text=True,
                              timeout=300, check=False, **options)
        return done.returncode, done.stderr

    def test_full_disk_behind_stdout(self):
        (self.folder / "study.toml").write_text(STUDY)
        for name, arguments in COMMANDS.items():
            with self.subTest(name), open("/dev/full", "w") as full:
                code, said = self.end(arguments, stdout=full)
                self.assertEqual(code, 1, said)
                self.assertIn("not all that was printed could be written to stdout", said)
                self.assertIn("make room there", said)
        self.assertTrue((self.folder / "out/summary.json").exists(), "files that were written are whole")

    def test_mistakes_keep_their_code_and_their_text(self):
        with open("/dev/full", "w") as full:
            code, said = self.end(["explain", "gone.toml"], stdout=full)
        self.assertEqual(code, 1)
        self.assertIn("gone.toml", said)
        self.assertNotIn("stdout", said)

    def test_reader_that_went_away(self):
        """With SIGPIPE as a shell gives it, and ignored as some servers do."""
        for name in ("keys", "outputs", "explain", "waves", "read", "help"):
            for ignored in (False, True):
                with self.subTest(name, ignored=ignored):
                    end, begin = os.pipe()
                    os.close(end)
                    prepare = (lambda: signal.signal(signal.SIGPIPE, signal.SIG_IGN)) if ignored else None
                    code, said = self.end(COMMANDS[name], stdout=begin, restore_signals=not ignored, preexec_fn=prepare)
                    os.close(begin)
                    self.assertIn(code, (-signal.SIGPIPE, 128 + signal.SIGPIPE))
                    self.assertNotIn("stdout", said)

    def test_full_disk_behind_files(self):
        """Links to a device that is always full, in place of the files that a command writes."""
        (self.folder / "table.csv").symlink_to("/dev/full")
        code, said = self.end(["read", FORCES, "--out", "table.csv"], stdout=subprocess.DEVNULL)
        self.assertEqual(code, 1)
        self.assertIn("table.csv", said)
        (self.folder / "mine.toml").symlink_to("/dev/full")
        code, said = self.end(["new", "mine.toml"], stdout=subprocess.DEVNULL)
        self.assertEqual(code, 1)
        self.assertIn("mine.toml", said)

    def test_files_appear_whole_or_not_at_all(self):
        (self.folder / "table.csv").write_text("older")
        for arguments in (["read", FORCES, "--out", "table.csv"], ["read", FORCES, "--out", "table.h5"], ["new", "mine.toml"]):
            code, said = self.end(arguments, stdout=subprocess.DEVNULL,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
            self.assertEqual(code, 1)
            self.assertIn(f"{arguments[-1]}: the file cannot be written", said)
        self.assertEqual(self.left_behind(), ["table.csv"])
        self.assertEqual((self.folder / "table.csv").read_text(), "older")

    def test_file_system_without_locks(self):
        compiler = shutil.which("cc") or shutil.which("gcc")
        if compiler is None:
            self.skipTest("no C compiler")
        (self.folder / "locks.c").write_text(NO_LOCKS)
        subprocess.run([compiler, "-shared", "-fPIC", "-o", "locks.so", "locks.c"], cwd=self.folder, check=True)
        there = dict(os.environ, LD_PRELOAD=str(self.folder / "locks.so"))
        self.assertEqual(self.end(COMMANDS["reduce"], stdout=subprocess.DEVNULL)[0], 0)
        code, said = self.end(COMMANDS["respond"], stdout=subprocess.DEVNULL, env=there)
        self.assertEqual(code, 0, said)
        script = "import sys; sys.path.insert(0, sys.argv[1]); import upbead; print(upbead.open_model(sys.argv[2]).loads)"
        scripts = CASES.parent / "postprocess"
        done = subprocess.run(["/usr/bin/python3", "-B", "-c", script, scripts, self.folder / "model"], env=there,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("impulse", done.stdout)


if __name__ == "__main__":
    main()
