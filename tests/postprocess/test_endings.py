"""How scripts end: beside another Python, on a full disk, before a reader that went away.

usage: test_endings.py FOLDER_OF_THE_SCRIPTS
"""

import os
import signal
import subprocess
import sys
import unittest
from pathlib import Path

SCRIPTS = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess").resolve()
PYTHON = "/usr/bin/python3"
FEW = ("page.py", "report.py", "wave_pressure.py")


def end(*command, **options):
    done = subprocess.run(list(map(str, command)), stderr=subprocess.PIPE, text=True, check=False, **options)
    return done.returncode, done.stderr


class Endings(unittest.TestCase):
    def test_scripts_that_can_be_called_name_their_python(self):
        """`env python3` is the first on the PATH, which may have none of the modules."""
        called = [path for path in SCRIPTS.rglob("*.py") if os.access(path, os.X_OK)]
        self.assertGreater(len(called), 15)
        for path in called:
            self.assertEqual(path.read_text().splitlines()[0], "#!" + PYTHON, path.name)

    def test_every_script_hears_of_its_end(self):
        for path in SCRIPTS.glob("*.py"):
            if os.access(path, os.X_OK) and "argparse" in path.read_text():
                self.assertRegex(path.read_text(), r"(?m)^(import common|from common import)", path.name)

    def test_module_that_a_python_lacks_is_told(self):
        for name in FEW:
            code, said = end(PYTHON, "-S", SCRIPTS / name, "--help", stdout=subprocess.DEVNULL)  # -S: without Debian's modules
            self.assertEqual(code, 1)
            self.assertRegex(said, rf"^{name}: \S+ has no module '\w+'; call the script with another Python .*-m pip install \w+\n$")

    def test_full_disk_behind_stdout(self):
        for name in FEW:
            with open("/dev/full", "w") as full:
                code, said = end(PYTHON, SCRIPTS / name, "--help", stdout=full)
            self.assertEqual(code, 1, said)
            self.assertEqual(said, f"{name}: not all could be written: No space left on device; make room there, or send it "
                             "elsewhere\n")

    def test_reader_that_went_away(self):
        for name in FEW:
            reading, writing = os.pipe()
            os.close(reading)
            code, said = end(PYTHON, SCRIPTS / name, "--help", stdout=writing)
            os.close(writing)
            self.assertIn(code, (-signal.SIGPIPE, 128 + signal.SIGPIPE))
            self.assertEqual(said, "")

    def test_closed_stdout(self):
        code, said = end("sh", "-c", f"{PYTHON} {SCRIPTS}/page.py --help >&-")
        self.assertEqual(code, 0)
        self.assertNotIn("Error", said)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
