#!/usr/bin/python3
"""Claims: `upbead run` prints one screen of at most 30 lines, with verdict, failing checks, F_T/P and S; --details prints every
number of the summary, a line each; of warnings of one kind the terminal has the worst six and counts the others.

usage: one_screen_test.py PROGRAM CASES_FOLDER
"""

import json
import re
from collections import Counter

from program import CASES, ProgramTest, main, upbead

MOST_LINES = 30
SHIPPED = sorted(path for path in CASES.rglob("*.toml") if re.search(r"^\[mesh\]", path.read_text(), re.M))
QUICK = [CASES / "fig2b-model.toml", CASES / "designer/church-roof.toml", CASES / "earthquake/caisson.toml"]


def keys_of(value):
    """All keys of a summary that hold something."""
    if isinstance(value, dict):
        for key, item in value.items():
            if item not in (None, "", [], {}):
                yield key
                yield from keys_of(item)


class OneScreen(ProgramTest):
    def check_screen(self, case):
        done = upbead("run", case, "--out", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = (done.stderr + done.stdout).splitlines()
        self.assertLessEqual(len(lines), MOST_LINES, f"{case}:\n" + "\n".join(lines))
        found = json.loads((self.folder / "out/summary.json").read_text())
        for check in found["checks"]:
            if check["holds"] is False:
                self.assertIn(check["text"], done.stdout)
        for warning in found["warnings"]:
            self.assertIn(f"warning: {warning['name']}: ", done.stderr)
        if found["verdict"]:
            self.assertIn("verdict     " + found["verdict"]["text"], done.stdout)
        if found["response"] and found["response"]["shear_to_force_ratio"]:
            self.assertIn("F_T / P     %.4g" % found["response"]["shear_to_force_ratio"], done.stdout)
        return found

    def test_a_run_fits_one_screen(self):
        for case in QUICK:
            self.check_screen(case)

    def test_every_shipped_case_fits_one_screen_at_length(self):
        for case in SHIPPED:
            self.check_screen(case)

    def test_warnings_of_many_waves_are_counted(self):
        done = upbead("waves", CASES / "fig10/impulsive.toml", "--json", "--out", "out", cwd=self.folder)
        counted = Counter(warning["name"] for warning in json.loads(done.stdout)["warnings"])
        self.assertGreater(max(counted.values()), 20)
        for name, count in counted.items():
            heads = re.findall(f"^warning: {name}: (.*)$", done.stderr, re.M)
            self.assertEqual(len(heads), min(count, 7))
            if count > 6:
                self.assertEqual(heads[-1], f"{count - 6} more of this kind, all in --json")

    def test_details_have_every_key(self):
        case = CASES / "fig2b-model.toml"
        done = upbead("run", case, "--details", "--out", "out", cwd=self.folder)
        found = json.loads((self.folder / "out/summary.json").read_text())
        printed = {line.split()[0] for line in done.stdout.splitlines() if line.strip()}
        self.assertEqual(sorted(set(keys_of(found)) - printed), [])


if __name__ == "__main__":
    main()
