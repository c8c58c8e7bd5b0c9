"""Shared by the tests of the program: how it is called, and a separate folder for each test.

A script that uses this is called as: SCRIPT PROGRAM CASES_FOLDER [at_length]

Tests with at_length in their names take so long that only `ctest -C long` runs them, by that word as the last argument.
"""

import json
import os
import pathlib
import pty
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, CASES = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
AT_LENGTH = sys.argv[3:] == ["at_length"]


def upbead(*arguments, cwd=None, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, timeout=300, **options)


def on_a_terminal(*arguments, cwd):
    """The exit code of the program whose errors go to a terminal, and what it wrote there."""
    leader, follower = pty.openpty()
    process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=cwd, stdout=subprocess.DEVNULL, stderr=follower)
    os.close(follower)
    text = b""
    try:
        while chunk := os.read(leader, 4096):
            text += chunk
    except OSError:  # the terminal closes when the program ends
        pass
    return process.wait(), text


def with_keys(keys):
    """KEY=VALUE ... as words of a command line."""
    return [word for key in keys for word in ("--set", key)]


def wait_until_it_catches(signal, process):
    """Waits until the program has installed its handler of the signal; before that, the signal just ends it."""
    status = pathlib.Path(f"/proc/{process.pid}/status")
    while process.poll() is None:
        caught = next(line for line in status.read_text().splitlines() if line.startswith("SigCgt:"))
        if int(caught.split()[1], 16) & (1 << (signal - 1)):
            return
        time.sleep(0.01)


class ProgramTest(unittest.TestCase):
    def setUp(self):
        if "at_length" in self.id() and not AT_LENGTH:
            self.skipTest("only with ctest -C long")
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def json_of(self, command, case, *keys):
        """What a command tells of a case with those keys; its checks may fail."""
        done = upbead(command, case, *with_keys(keys), "--json", "--out", "out", cwd=self.folder)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return json.loads(done.stdout)

    def left_behind(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))


def main():
    """All tests of the script, or those at length."""
    unittest.main(argv=[sys.argv[0], *(["-k", "at_length"] if AT_LENGTH else [])], verbosity=2)
