#!/usr/bin/python3
"""Comparison of programs at equal error: rows in, seconds and ratios out."""

import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import compare  # noqa: E402

FLOORS = {"upbead": 0.3, "FEniCSx": 1.0, "FreeFEM": 0.1}


def row(series, wall, error, unknowns):
    return {"series": series, "family": series, "label": "", "unknowns": unknowns, "solves": 1, "steps": 0,
            "wall": wall, "peak_error": error, "history_error": error, "parts": {}}


class Comparison(unittest.TestCase):
    ROWS = [row("FEniCSx", 3.0, 0.02, 100), row("FEniCSx", 5.0, 0.0005, 1000)]

    def times(self, *ours, kind="beyond its own start"):
        return compare.comparison([*self.ROWS, *ours], FLOORS)["peak_error"][kind]

    def test_a_run_faster_than_its_own_start(self):
        ours = row("upbead, reduced", 0.29, 0.02, 100), row("upbead, reduced", 0.8, 0.0005, 1000)
        self.assertEqual(self.times(*ours)["upbead"], [0.5, 0.5, 0.5])  # the time of the slower run, on the safe side
        peer = 2 * 2**(math.log(20) / math.log(40))  # log-log between 2 s at 0.02 and 4 s at 0.0005
        self.assertAlmostEqual(self.times(*ours)["ratio best peer / upbead"][2], peer / 0.5)
        self.assertTrue(all(0.29 < time < 0.8 for time in self.times(*ours, kind="whole process")["upbead"]))

    def test_only_runs_faster_than_their_own_start(self):
        found = self.times(row("upbead, reduced", 0.3, 0.0005, 1000))
        self.assertEqual(found["upbead"], [None, None, None])
        self.assertEqual(found["ratio best peer / upbead"], [None, None, None])


if __name__ == "__main__":
    unittest.main()
