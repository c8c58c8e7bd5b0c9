#!/usr/bin/python3
"""Records of a laboratory: pressures by transducers along the wall and under the bottom, in every format.

usage: gauges_test.py PROGRAM CASES_FOLDER
"""

import gzip
import json
import math
import re
import time

import h5py
import numpy

from program import ProgramTest, main, upbead
from warnings_test import SCENE, WEIGHT, settings

BASE, CREST = 6.0, 22.0  # heights of the wall's bottom and top in SCENE (m)
SPACING = 2.25
HEIGHTS = {f"p{i + 1}": 7.0 + SPACING * i for i in range(7)}
LOWEST, HIGHEST = 7.0, 20.5
TIME = numpy.arange(0, 601) / 1000.0
COURSE = numpy.interp(TIME, [0.05, 0.1, 0.2], [0, 1, 0])


def scene(**keys):
    """SCENE with the load on the wall measured by transducers."""
    keys = {"boundary": '"front"', "kind": '"pressures"', "gauges": '"wall.csv"', "to_base": '"constant"',
            "to_crest": '"none"', "heights": "{ " + ", ".join(f"{n} = {y}" for n, y in HEIGHTS.items()) + " }", **keys}
    head, tail = SCENE.split("[loads.impulse]")
    lines = "\n".join(f"{key} = {value}" for key, value in keys.items() if value)
    return head + "[loads.wall]\n" + lines + "\n[time]" + tail.split("[time]")[1]


def linear(y):
    return 2e5 - 4e3 * (y - BASE)


def narrow(y):
    return 4e5 * numpy.exp(-0.5 * ((y - 15.2) / 0.7) ** 2)


class Gauges(ProgramTest):
    def write_csv(self, pressure, *, name="wall.csv", unit="Pa", factor=1.0, time_unit="s", per_second=1.0, separator=",",
                  comma=False, offset=0.0, start=0.0, more=None):
        columns = [(TIME + start) * per_second] + [(pressure(y) * COURSE + offset) / factor for y in HEIGHTS.values()]
        names = [f"time ({time_unit})"] + [f"{gauge} ({unit})" for gauge in HEIGHTS]
        for heading, values in (more or {}).items():
            names.append(heading)
            columns.append(values)
        rows = [separator.join(names)] + [separator.join(repr(float(v)) for v in row) for row in zip(*columns)]
        text = "\n".join(rows) + "\n"
        if comma:
            text = text.replace(".", ",")
        path = self.folder / name
        path.write_bytes(gzip.compress(text.encode()) if name.endswith(".gz") else text.encode())

    def ask(self, command, text, *arguments, code=0):
        (self.folder / "scene.toml").write_text(text)
        out = ["--out", self.folder / "out"] if command == "run" else []
        done = upbead(command, self.folder / "scene.toml", "--json", *arguments, *out)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout) if code == 0 else done.stderr

    def shear(self, text, *arguments):
        self.ask("run", text, *arguments)
        with h5py.File(self.folder / "out/results.h5") as file:
            return file["history/shear_force"][:]

    def test_is_the_pressure_that_it_samples(self):
        self.write_csv(linear)
        (self.folder / "course.csv").write_text("time,p\n" + "".join(f"{t!r},{c!r}\n" for t, c in zip(TIME, COURSE)))
        load = ('boundary = "front"\nkind = "pressure"\nhistory = "course.csv"\n'
                f"shape = [[-100.0, {linear(LOWEST)}], [7.0, {linear(LOWEST)}], [20.5, {linear(HIGHEST)}], [100.0, {linear(HIGHEST)}]]\n")
        head, tail = SCENE.split("[loads.impulse]")
        march = settings(time__scheme="sdirk4", time__step=0.005)
        drawn = self.shear(head + "[loads.wall]\n" + load + "[time]" + tail.split("[time]")[1], *march)
        measured = self.shear(scene(to_crest='"constant"', heights="{ p1 = 7.0, p7 = 20.5 }"), *march)
        self.assertLess(abs(measured - drawn).max(), 1e-11 * abs(drawn).max())

    def test_force_arm_and_pressure_are_told(self):
        self.write_csv(linear)
        for command in ("explain", "run"):
            found = self.ask(command, scene(ends=f"[{BASE}, {CREST}]", to_crest='"to_zero"'))["gauges"]["wall"]
            self.assertEqual((found["gauges"], found["samples"], found["peak_gauge"]), (7, 601, "p1"))
            self.assertAlmostEqual(found["peak_pressure"], linear(7.0))
            self.assertAlmostEqual(found["peak_pressure_time"], 0.1)
            a, b, length = linear(LOWEST), linear(HIGHEST), HIGHEST - LOWEST
            row, down, up = length * (a + b) / 2, a * (LOWEST - BASE), b * (CREST - HIGHEST) / 2
            moment = length**2 * (a + 2 * b) / 6 + row * (LOWEST - BASE) + down * (LOWEST - BASE) / 2 + up * (
                HIGHEST - BASE + (CREST - HIGHEST) / 3)
            self.assertAlmostEqual(found["peak_force"] / (row + down + up), 1, 9)
            self.assertAlmostEqual(found["arm"] / (moment / (row + down + up)), 1, 9)

    def test_it_is_told_how_each_column_was_read(self):
        self.write_csv(linear, unit="kPa", factor=1e3, time_unit="ms", per_second=1e3, separator=";", comma=True)
        records = self.ask("explain", scene())["records"]
        self.assertEqual([record["column"] for record in records], list(HEIGHTS))
        first = records[0]
        self.assertEqual((first["of"], first["file"], first["unit"], first["samples"]), ("loads.wall", "wall.csv", "kPa", 601))
        self.assertEqual(first["layout"], "columns separated by semicolons, decimal commas, names in line 1")
        self.assertAlmostEqual(first["extreme"], linear(7.0))
        self.assertAlmostEqual(first["extreme_time"], 0.1)
        self.assertAlmostEqual(first["interval"], 0.001)
        done = upbead("explain", self.folder / "scene.toml")
        told = re.sub(r",\n +", ", ", done.stdout)
        self.assertIn("\nrecords\n  of loads.wall, file wall.csv, column p1, unit kPa, layout columns separated by semicolons", told)
        self.assertIn("samples 601, begin 0 s, interval 0.001 s, extreme 1.96e+05, extreme_time 0.1 s, extreme_unit Pa\n", told)

    def test_however_it_is_written(self):
        march = settings(time__scheme="sdirk4", time__step=0.005, time__end=0.4)
        self.write_csv(linear)
        plain = self.shear(scene(), *march)

        def same(text, places=1e-11):
            self.assertLess(abs(self.shear(text, *march) - plain).max(), places * abs(plain).max())

        self.write_csv(linear, unit="kPa", factor=1e3, time_unit="ms", per_second=1e3, separator=";", comma=True)
        same(scene())
        self.write_csv(linear, name="wall.csv.gz", unit="kgf/cm2", factor=98066.5, separator="\t")
        same(scene(gauges='"wall.csv.gz"'))
        self.write_csv(linear, unit="volt", factor=1e3)
        same(scene(gauge_unit='"kPa"'))
        self.write_csv(linear, offset=3e4, start=12.0)  # the first 0.05 s are at rest
        same(scene(zero="0.049", record_start="12.0"), 1e-9)
        with h5py.File(self.folder / "wall.h5", "w") as file:
            file["time"] = TIME
            for name, y in HEIGHTS.items():
                file[name] = linear(y) * COURSE / 1e3
                file[name].attrs["unit"] = "kPa"
        same(scene(gauges='"wall.h5"'))
        rows = [",".join(HEIGHTS)] + [",".join(repr(float(linear(y) * c)) for y in HEIGHTS.values()) for c in COURSE]
        (self.folder / "wall.csv").write_text("\n".join(rows) + "\n")
        same(scene(sampling_rate="1000.0"))

    def test_effective_case_gives_the_same(self):
        self.write_csv(linear)
        first = self.shear(scene())
        again = upbead("run", self.folder / "out/case.toml", "--out", self.folder / "again")
        self.assertEqual(again.returncode, 0, again.stderr)
        with h5py.File(self.folder / "again/results.h5") as file:
            self.assertTrue((file["history/shear_force"][:] == first).all())

    def test_seven_transducers_and_a_narrow_peak(self):
        """Assumed positions: 7 at equal distances of h = 2.25 m. The standard deviation of the peak is s = 0.7 m: by
        Poisson's summation formula trapezoids err by 2 exp(-2 pi^2 s^2/h^2) cos(2 pi (y0 - y1)/h) of the force at
        most."""
        self.write_csv(narrow)
        report = self.ask("explain", scene(to_base='"none"'))
        found = report["gauges"]["wall"]
        exact = 4e5 * 0.7 * math.sqrt(2 * math.pi)
        bound = 2 * math.exp(-2 * math.pi**2 * 0.7**2 / SPACING**2)
        self.assertLess(abs(found["peak_force"] / exact - 1), 1.05 * bound)
        self.assertLess(abs(found["arm"] - (15.2 - BASE)), bound * SPACING)
        warning = {w["name"]: w for w in report["warnings"]}["gauges_too_sparse"]
        self.assertGreater(warning["value"], abs(found["peak_force"] / exact - 1) / 4)
        self.write_csv(linear)
        self.assertNotIn("gauges_too_sparse", [w["name"] for w in self.ask("explain", scene())["warnings"]])

    def test_faults_are_named(self):
        cell = sum(SPACING * linear(y) * COURSE for y in HEIGHTS.values())
        self.write_csv(linear, more={"F (kN/m)": 0.7 * cell / 1e3})
        report = self.ask("explain", scene(load_cell='"F"'))
        names = [w["name"] for w in report["warnings"]]
        self.assertIn("load_cell_differs", names)
        self.assertAlmostEqual(report["gauges"]["wall"]["load_cell"] / (0.7 * cell.max()), 1, 9)
        self.write_csv(lambda y: 0.0 if y == 11.5 else linear(y))
        found = {w["name"]: w["text"] for w in self.ask("explain", scene())["warnings"]}
        self.assertIn("'loads.wall.p3'", found["record_dead"])
        self.write_csv(linear)
        rows = (self.folder / "wall.csv").read_text().splitlines()
        lost = [",".join(["0.0" if i in (2, 3) else v for i, v in enumerate(row.split(","))]) for row in rows[90:140]]
        for name, left, more in (("record_gap", rows[:90] + rows[140:], "6 more of its row have it, too"),
                                 ("record_dropout", rows[:90] + lost + rows[140:], "1 more of its row lost it, too"),
                                 ("record_begun", rows[:1] + rows[80:], "6 more of its row begin so, too")):
            (self.folder / "wall.csv").write_text("\n".join(left) + "\n")
            found = [w for w in self.ask("explain", scene())["warnings"] if w["name"] == name]
            self.assertEqual(len(found), 1, name)
            self.assertIn(more, found[0]["text"])
        self.write_csv(linear, offset=3e4)  # from 0.05 to 0.2 s it is no rest
        for zero, told in (("0.045", 0), ("0.09", 1), ("0.2", 1), ("0.235", 1)):
            found = [w for w in self.ask("explain", scene(zero=zero))["warnings"] if w["name"] == "record_zero"]
            self.assertEqual(len(found), told, zero)
        at_rest = self.ask("explain", scene(zero="0.045"))["warnings"]
        self.assertNotIn("record_offset", [w["name"] for w in at_rest])
        (offset,) = [w for w in self.ask("explain", scene())["warnings"] if w["name"] == "record_offset"]
        self.assertIn("6 more of its row are so, too", offset["text"])
        bent = {**HEIGHTS, "p2": HEIGHTS["p5"], "p5": HEIGHTS["p2"]}
        self.write_csv(lambda y: linear(y) + 3e4 * math.sin(0.25 * y))
        swapped = "{ " + ", ".join(f"{n} = {y}" for n, y in bent.items()) + " }"
        found = {w["name"]: w["text"] for w in self.ask("explain", scene(heights=swapped))["warnings"]}
        self.assertIn("loads.wall.p2' and 'loads.wall.p5'" if "loads.wall.p2' and" in found["records_swapped"]
                      else "loads.wall.p5' and 'loads.wall.p2'", found["records_swapped"])

    def test_pressures_that_no_water_has_void_the_verdict(self):
        """Still water at a wall can lose rho g d, and nothing above its level: a reversed sign is told."""
        limits = ("--set", "sliding.friction=0.6", "--set", "limits.sliding=1", *WEIGHT)
        self.write_csv(linear)
        self.assertNotIn("suction", self.ask("run", scene(), *limits)["verdict"]["why_void"] or "")
        self.write_csv(linear, factor=-1.0)
        summary = self.ask("run", scene(), *limits)
        self.assertIn("suction", summary["verdict"]["why_void"])
        self.assertIsNone(summary["verdict"]["holds"])
        told = {w["name"]: w for w in summary["warnings"]}["suction"]
        self.assertLess(told["value"], told["limit"])

    def test_uplift_by_transducers_under_the_bottom(self):
        self.write_csv(linear)
        rows = ["time,u1 (kPa),u2 (kPa)"] + [f"{t!r},{60 * c!r},{20 * c!r}" for t, c in zip(TIME, COURSE)]
        (self.folder / "bottom.csv").write_text("\n".join(rows) + "\n")
        uplift = ('sliding.uplift={ kind = "prescribed", gauges = "bottom.csv", positions = { u1 = -6.0, u2 = 6.0 }, '
                  'ends = [-9.0, 9.0], to_seaward = "constant", to_landward = "to_zero" }')
        summary = self.ask("run", scene(), *WEIGHT, "--set", uplift)
        found = summary["gauges"]["sliding.uplift"]
        self.assertAlmostEqual(found["peak_force"] / (60e3 * 3 + 40e3 * 12 + 10e3 * 3), 1, 9)
        moment = 60e3 * 3 * -7.5 + (12 * 12 * -40e3 / 12) + 10e3 * 3 * 7
        self.assertAlmostEqual(found["arm"] * found["peak_force"] / moment, 1, 9)
        self.assertEqual(summary["sliding"]["uplift"], "prescribed")
        self.assertLess(summary["sliding"]["least_normal_force"], 4.3e6 - 0.9 * found["peak_force"])
        self.assertNotIn("uplift_ends", [w["name"] for w in summary["warnings"]])
        for ends in ("[-8.0, 9.0]", "[-9.0, 12.0]"):
            other = self.ask("explain", scene(), *WEIGHT, "--set", uplift.replace("[-9.0, 9.0]", ends))
            self.assertIn("uplift_ends", [w["name"] for w in other["warnings"]], ends)

    def test_the_similar_prototype_has_similar_records(self):
        """Scaled by 2 with Froude's law, forces are four times as large; so the record of the response and the run
        agree again."""
        self.write_csv(linear, unit="kPa", factor=1e3)
        march = settings(time__scheme="sdirk4", time__step=0.005, mesh__degree=2)
        self.ask("run", scene(), *march)
        with h5py.File(self.folder / "out/results.h5") as file:
            t, F_T = file["history/time"][:], file["history/shear_force"][:]
        (self.folder / "lab.csv").write_text("t (s),x,F (kN/m)\n" + "".join(f"{a!r},0,{1e-3 * b!r}\n" for a, b in zip(t, F_T)))
        text = scene() + '[measured.lab]\nfile = "lab.csv"\ncolumn = "F"\nreading = "shear_force"\n'
        small = self.ask("run", text, *march)
        done = upbead("scale", self.folder / "scene.toml", "--factor", "2", *march, "--out", self.folder / "twice")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = upbead("run", self.folder / "twice/case.toml", "--json", "--out", self.folder / "large")
        self.assertEqual(done.returncode, 0, done.stderr)
        large = json.loads(done.stdout)
        for key, factor in (("peak_pressure", 2), ("peak_force", 4), ("arm", 2), ("peak_pressure_time", 2**0.5)):
            self.assertAlmostEqual(large["gauges"]["wall"][key] / small["gauges"]["wall"][key], factor, 6)
        self.assertAlmostEqual(large["response"]["peak_shear"] / small["response"]["peak_shear"], 4, 6)
        for found in (small, large):
            self.assertAlmostEqual(found["measured"]["lab"]["peak_ratio"], 1, 6)
            self.assertLess(found["measured"]["lab"]["rms_relative"], 1e-6)
        (self.folder / "lab.csv").write_text("t,F\n0,0\n1,1\n")
        (self.folder / "scene.toml").write_text(text)
        done = upbead("scale", self.folder / "scene.toml", "--factor", "2", "--out", self.folder / "no")
        self.assertEqual(done.returncode, 1)
        self.assertIn("it is not said what unit column 'F' has", done.stderr)

    def test_mistakes_stand_where_they_were_made(self):
        self.write_csv(linear)

        def refusal(**keys):
            return self.ask("explain", scene(**keys), code=1)

        self.assertIn("no 'to_base'", refusal(to_base=""))
        self.assertIn("'to_zero' needs the places", refusal(to_crest='"to_zero"'))
        self.assertIn("did you mean 'p2'?", refusal(heights="{ p1 = 7.0, pp2 = 8.0 }"))
        self.assertIn("two transducers are at 7 m", refusal(heights="{ p1 = 7.0, p2 = 7.0 }"))
        self.assertIn("the unit 'kN/m' of column 'p1'", refusal(gauge_unit='"kN/m"'))
        self.assertIn("'pulse' does not belong", refusal(pulse='{ shape = "step", peak = 1.0 }'))
        self.assertIn("the record is over before", refusal(record_start="100.0"))
        told = refusal(heights="{ " + ", ".join(f"{n} = {y + 20}" for n, y in HEIGHTS.items()) + " }")
        self.assertIn("transducer 'p2' presses on no height of 'front', which reaches from y = 6 to 22", told)
        self.assertNotIn("'p1' presses", told)  # not reported, as the pressure is constant down to the base
        self.assertEqual(refusal(boundary='"bed"').count("'bed' lies at y = 0; name the curve of the wall"), 1)  # not 7
        self.assertIn("'heights' does not belong in [loads.wall]", refusal(kind='"pressure"'))
        self.write_csv(linear, unit="V")
        self.assertIn("the unit 'V' of column 'p1' is none of what it should hold, Pa; write one of Pa, hPa, kPa", refusal())

    def test_a_million_samples_of_twenty_channels_at_length(self):
        n = 10**6
        t = numpy.arange(n) / 1e4
        course = numpy.exp(-((t - 50.0) / 0.05) ** 2)
        with open(self.folder / "long.csv", "w") as file:
            file.write("time (s)," + ",".join(f"c{i} (kPa)" for i in range(20)) + "\n")
            for begin in range(0, n, 50000):
                part = slice(begin, begin + 50000)
                block = numpy.column_stack([t[part]] + [course[part] * (200 - 5 * i) for i in range(20)])
                numpy.savetxt(file, block, delimiter=",", fmt=["%.4f"] + ["%.5g"] * 20)
        heights = "{ " + ", ".join(f"c{i} = {6.5 + 0.75 * i}" for i in range(20)) + " }"
        begin = time.monotonic()
        found = self.ask("explain", scene(gauges='"long.csv"', heights=heights, record_start="49.9"))["gauges"]["wall"]
        print(f"explain with {(self.folder / 'long.csv').stat().st_size / 1e6:.0f} MB: {time.monotonic() - begin:.1f} s")
        self.assertEqual(found["gauges"], 20)
        self.assertAlmostEqual(found["peak_pressure_time"], 0.1, 3)


if __name__ == "__main__":
    main()
