#!/usr/bin/python3
"""Runs the commands of the README and of the tutorials in their order, as a user in a fresh clone does.

usage: readme_test.py PROGRAM CASES_FOLDER
"""

import re
import shlex
import shutil
import subprocess

from program import CASES, PROGRAM, ProgramTest, main

ROOT = CASES.parent


def commands():
    """The commands of the block under "## Use"."""
    block = (ROOT / "README.md").read_text().split("## Use", 1)[1].split("```sh\n", 1)[1].split("```", 1)[0]
    return [shlex.split(line, comments=True) for line in block.splitlines() if line.strip()]


def tutorial(name):
    """The commands of all blocks of a tutorial but those that build; without --pdf where there is no Chromium."""
    blocks = re.findall(r"^```sh\n(.*?)^```", (ROOT / "docs" / name).read_text(), flags=re.DOTALL | re.MULTILINE)
    lines = [shlex.split(line, comments=True) for block in blocks for line in block.splitlines()]
    if not shutil.which("chromium"):
        lines = [line[: line.index("--pdf")] if "--pdf" in line else line for line in lines]
    return [line for line in lines if line and line[0] != "./bootstrap"]


def takes_long(command):
    """Four of them take as long as all others."""
    words = " ".join(command)
    return any(word in words for word in ("refine=auto", "study", "calibrate", 'kind="friction"', "reduce cases/fig2b-model"))


class Readme(ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ("cases", "meshes", "postprocess"):
            shutil.copytree(ROOT / name, self.folder / name)
        (self.folder / "build").mkdir()
        (self.folder / "build/upbead").symlink_to(PROGRAM)

    def test_every_quick_command_works(self):
        quick = [command for command in commands() if not takes_long(command)]
        self.assertGreater(len(quick), 10)
        self.run_all(quick)

    def test_every_command_works_at_length(self):
        self.run_all(commands())

    def test_every_command_of_the_tutorials_works_at_length(self):
        for name in ("tutorial-fig2b.md", "tutorial-own-breakwater.md"):
            self.assertGreater(len(tutorial(name)), 5)
            self.run_all(tutorial(name))

    def run_all(self, lines):
        for command in lines:
            with self.subTest(" ".join(command)):
                done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=600)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    main()
