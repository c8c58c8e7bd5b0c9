#!/usr/bin/python3
"""The commands of the README, in their order, as someone in a fresh clone runs them.

usage: readme_test.py PROGRAM CASES_FOLDER
"""

import shlex
import shutil
import subprocess
import unittest

from program import CASES, PROGRAM, ProgramTest

ROOT = CASES.parent


def commands():
    """Of the block under "## Use"."""
    block = (ROOT / "README.md").read_text().split("## Use", 1)[1].split("```sh\n", 1)[1].split("```", 1)[0]
    return [shlex.split(line, comments=True) for line in block.splitlines() if line.strip()]


class Readme(ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ("cases", "meshes", "postprocess"):
            shutil.copytree(ROOT / name, self.folder / name)
        (self.folder / "build").mkdir()
        (self.folder / "build/upbead").symlink_to(PROGRAM)

    def test_every_command_works(self):
        self.assertGreater(len(commands()), 10)
        for command in commands():
            with self.subTest(" ".join(command)):
                done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=600)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=["readme_test.py"])
