#!/usr/bin/python3
"""docs/reference/hand-calculations.md: each calculation gives its stated value, and so does the program, to the digits of the
value."""

import json
import math
import re
import unittest

from program import CASES, ProgramTest, upbead

PAGE = (CASES.parent / "docs/reference/hand-calculations.md").read_text()
ROW = re.compile(r"^\| (.+?) \| `(.+?)` \| (.+?) \| (.*?) \| (?:`(.+?)`)? *\|$", re.MULTILINE)
SCALE = {"kPa": 1e3, "kN/m": 1e3, "kN m/m": 1e3}
NAMES = {name: getattr(math, name) for name in ("pi", "sinh", "cosh", "tanh", "cos", "sqrt", "radians")}


def agree(number, text):
    """Whether the number agrees with the text to one unit of its last digit: half a unit for the rounding of the
    value, half for that of the data."""
    digits = text.lower().partition("e")
    last = 10.0 ** ((int(digits[2]) if digits[2] else 0) - len(digits[0].partition(".")[2]))
    return abs(number - float(text)) <= 0.5001 * last


class HandCalculations(ProgramTest):
    def sections(self):
        return [(part.partition("\n")[0], re.search(r"```toml\n(.*?)```", part, re.DOTALL)[1], ROW.findall(part))
                for part in PAGE.split("\n## ")[1:]]

    def test_every_working_gives_its_value(self):
        self.assertEqual(len(self.sections()), 3)
        for title, _, rows in self.sections():
            self.assertGreater(len(rows), 30)
            for symbol, working, value, _, _ in rows:
                with self.subTest(section=title, symbol=symbol):
                    number = eval(working, {"__builtins__": {}, "min": min, "max": max}, NAMES)
                    self.assertTrue(agree(number, value), f"{number} is not {value}")

    def test_the_program_has_the_same(self):
        for title, design, rows in self.sections():
            (self.folder / "design.toml").write_text(design)
            done = upbead("waves", "design.toml", "--json", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            wave = json.loads(done.stdout)["waves"]["design"]
            for symbol, _, value, unit, key in rows:
                if key:
                    with self.subTest(section=title, symbol=symbol):
                        self.assertTrue(agree(wave[key] / SCALE.get(unit, 1.0), value), f"{wave[key]} is not {value}")

    def test_expected_has_the_heel_pressure_of_waves(self):
        """For a record whose highest wave is that of the section: exp(2 (H/H_1/3)^2) waves, one of which is as high
        as H."""
        for title, design, _ in self.sections():
            with self.subTest(section=title):
                (self.folder / "design.toml").write_text(
                    design + '[sea]\nstates = "states.csv"\nyears = 50\nhighest = "none"\n'
                    '[life]\nsimulated_lives = 2\n')
                done = upbead("waves", "design.toml", "--json", cwd=self.folder)
                wave = json.loads(done.stdout)["waves"]["design"]
                number = math.exp(2 * (wave["height"] / wave["significant_height"]) ** 2)
                (self.folder / "states.csv").write_text(
                    "significant_height,period,waves,angle\n"
                    f"{wave['significant_height']!r},{wave['period']!r},{number!r},{wave['angle']!r}\n")
                done = upbead("expected", "design.toml", "--json", cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                found = json.loads(done.stdout)["expected"]["base"]
                self.assertAlmostEqual(found["height"] / wave["height"], 1, delta=1e-13)
                self.assertAlmostEqual(found["goda"]["peak_heel_pressure"] / wave["heel_pressure"], 1, delta=1e-9)
                self.assertAlmostEqual(found["goda"]["least_overturning_margin"] / wave["safety_overturning"], 1,
                                       delta=1e-9)


if __name__ == "__main__":
    unittest.main(argv=["hand_calculation_test.py"])
