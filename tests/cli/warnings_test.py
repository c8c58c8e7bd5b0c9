#!/usr/bin/python3
"""Warnings about numbers that look right and are not: each appears on a scene built for it, with the number for which
the scene was built; the shipped cases have no warning.

usage: warnings_test.py PROGRAM CASES_FOLDER [--facts FILE]   FILE: facts for docs/reference/reliability.md
"""

import json
import math
import pathlib
import re
import sys
import unittest

import h5py
import numpy

from program import CASES, ProgramTest, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import SCENE, WIDTH  # noqa: E402

MOUND_DENSITY = 0.6 * 2650 + 0.4 * 1030
SHEAR_SPEED = math.sqrt(30e6 / MOUND_DENSITY)
PASSING = 0.15 + WIDTH / SHEAR_SPEED
LEVEL = ["--set", "initial.water_level=15.0"]
WEIGHT = ["--set", "sliding={ friction = 0.6, submerged_weight = 4.3e6 }"]
COLUMN = """
[mesh]
geometry = "column"
parameters = { height = 10, cells = 20 }
[regions.soil]
%s
[boundaries]
base = { displacement = "fixed"%s }
left = { displacement = "roller"%s }
right = { displacement = "roller"%s }
top = { %s }
[loads.top]
boundary = "top"
kind = "traction"
direction = [0, -1]
pulse = %s
[time]
end = %g
[probes]
a.at = [0.5, 2.13]
b.at = [0.5, 5.07]
c.at = [0.5, 8.02]
"""
DRY = 'kind = "solid"\nshear_modulus = 20e6\npoissons_ratio = 0.25\ndensity = 2000.0'
WET = ('kind = "porous"\nshear_modulus = 50e6\npoissons_ratio = 0.3\nporosity = 0.4\ngrain_density = 2650.0\n'
       'hydraulic_conductivity = 10.0\nflow = "inertial"')
HEIGHT, DRY_SPEED, SLOW_SPEED = 10.0, math.sqrt(60e6 / 2000), 262.0  # m, m/s
facts = {}


def settings(**values):
    return [text for key, value in values.items() for text in ("--set", f"{key.replace('__', '.')}={value}")]


class Warnings(ProgramTest):
    def ask(self, command, *arguments, scene=SCENE):
        """Warnings of a scene by name, the summary and stderr."""
        (self.folder / "scene.toml").write_text(scene)
        out = ["--out", self.folder / "out"] if command == "run" else []
        done = upbead(command, self.folder / "scene.toml", "--json", *arguments, *out)
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads(done.stdout)
        for warning in summary["warnings"]:
            what, cure = warning["text"].removesuffix(f"; {warning['cure']}"), warning["cure"]
            self.assertIn(f"warning: {warning['name']}: {cure}\n         {what}\n", done.stderr)
        return {warning["name"]: warning for warning in summary["warnings"]}, summary

    def expect(self, found, name, value=None, limit=None, places=6):
        self.assertEqual(list(found), [name])
        if value is not None:
            self.assertAlmostEqual(found[name]["value"] / value, 1, places)
        if limit is not None:
            self.assertAlmostEqual(found[name]["limit"] / limit, 1, places)
        facts[name] = found[name]["text"]
        return found[name]

    def test_a_sound_scene_has_none(self):
        for command in ("explain", "run"):
            self.assertEqual(self.ask(command)[0], {})
        self.assertEqual(self.ask("run", *LEVEL, *WEIGHT)[0], {})

    def test_step_too_coarse(self):
        found, _ = self.ask("explain", *settings(time__step=0.05, time__scheme="sdirk4"))
        self.expect(found, "step_too_coarse", 0.05, PASSING / 8)
        found, _ = self.ask("explain", *settings(time__step=0.012, time__scheme="generalised_alpha"))
        self.expect(found, "step_too_coarse", 0.012, PASSING / 32)
        self.assertEqual(self.ask("explain", *settings(time__step=0.035, time__scheme="sdirk4"))[0], {})
        self.assertEqual(self.ask("explain", *settings(time__step=0.05, time__scheme="reduced"))[0], {})

    def test_a_step_that_is_told_to_be_too_coarse_is(self):
        def history(*arguments):
            self.ask("run", *arguments)
            with h5py.File(self.folder / "out/results.h5") as file:
                return file["history/time"][:], file["history/shear_force"][:]

        fine = history(*settings(time__step=0.002, time__scheme="sdirk4"))
        for step, scheme, order in ((0.075, "sdirk4", 2.5), (0.02, "generalised_alpha", 2)):
            time, force = history(*settings(time__step=step, time__scheme=scheme))
            error = abs(force - numpy.interp(time, *fine)).max() / abs(fine[1]).max()
            told = 0.015 * (8 * step / PASSING) ** order if order == 2.5 else 0.02 * (32 * step / PASSING) ** order
            self.assertGreater(error, 0.25 * told)
            self.assertLess(error, 4 * told)

    def test_jump_with_alpha(self):
        jump = ["--set", 'loads.impulse.pulse={ shape = "step", peak = 1e6 }', *settings(
            time__inertia="false", time__scheme='"generalised_alpha"', time__step=0.005, probes__A__at="[3.0, -8.0]")]
        found, _ = self.ask("run", *jump)
        self.expect(found, "jump_with_alpha", 0.005)

        def last(*arguments):
            self.ask("run", *jump, *arguments)
            with h5py.File(self.folder / "out/results.h5") as file:
                return file["history/probes/A/pressure"][-1]

        self.assertEqual(self.ask("run", *jump, "--set", "time.scheme=sdirk4")[0], {})
        error = abs(last() / last("--set", "time.scheme=sdirk4") - 1)
        self.assertLess(error, 0.01, "what is told is so")
        self.assertGreater(error, 0.0005, "else it need not be told")
        self.assertEqual(self.ask("explain", *jump, "--set", "loads.impulse.pulse.rise=0.05")[0], {})

    def test_mesh_too_coarse(self):
        found, _ = self.ask("explain", *settings(mesh__parameters__cells=0.2))
        warning = self.expect(found, "mesh_too_coarse", limit=4)
        self.assertLess(warning["value"], 4)
        self.assertIn("region 'seabed'", warning["text"])
        self.assertEqual(self.ask("explain", *settings(mesh__parameters__cells=0.35))[0], {})

    def test_mesh_too_coarse_without_damping(self):
        bare = SCENE.replace("damping = { ratio = 0.05, frequencies = [1, 10] }\n", "")
        short = settings(loads__impulse__pulse__duration=0.05)

        def history(*arguments):
            found, _ = self.ask("run", *short, *arguments, scene=bare)
            with h5py.File(self.folder / "out/results.h5") as file:
                return found, file["history/time"][:], file["history/shear_force"][:]

        found, time, force = history(*settings(mesh__parameters__cells=0.35))
        self.assertIn("mesh_too_coarse", found)
        facts["mesh_too_coarse, undamped"] = found["mesh_too_coarse"]["text"]
        self.assertEqual(found["mesh_too_coarse"]["limit"], 2.3)
        _, fine_time, fine = history(*settings(mesh__parameters__cells=0.7, mesh__degree=3))
        error = abs(force - numpy.interp(time, fine_time, fine)).max() / abs(fine).max()
        told = 0.05 * (2.3 / found["mesh_too_coarse"]["value"]) ** 2
        self.assertGreater(error, 0.1)
        self.assertGreater(told, 0.8 * error)
        self.assertLess(told, 3 * error)
        self.assertEqual(self.ask("explain", *short, *settings(mesh__parameters__cells=0.5))[0], {}, "with damping")
        slow = settings(loads__impulse__pulse__duration=0.2)
        self.assertEqual(self.ask("explain", *slow, scene=bare)[0], {})

    def test_walls_too_near(self):
        echo = 2 * 60 / SHEAR_SPEED
        found, _ = self.ask("run", *settings(time__end=1.2))
        self.assertNotIn("peak", self.expect(found, "walls_too_near", echo, 1.2)["text"])
        slow = settings(time__end=5, loads__impulse__pulse__duration=3)
        self.assertEqual(self.ask("explain", *slow)[0], {})
        near = settings(mesh__parameters__seabed_front=6)
        found, _ = self.ask("run", *slow, *near)
        self.assertIn("its peak at", self.expect(found, "walls_too_near", 2 * 6 / SHEAR_SPEED, 5)["text"])

    def test_fast_load(self):
        speed = math.sqrt(30e9 * 0.8 / (1.2 * 0.6) / 2100)
        fast = settings(loads__impulse__pulse__duration=0.01)
        found, _ = self.ask("explain", *fast)
        self.expect(found, "fast_load", 0.01, 4 * WIDTH / speed)
        elastic = SCENE.replace('kind = "rigid"', 'kind = "solid"\nyoungs_modulus = 30e9\npoissons_ratio = 0.2')
        self.assertEqual(self.ask("explain", *fast, scene=elastic)[0], {})
        jump = settings(loads__impulse__pulse__rise=0)
        self.assertEqual(self.ask("explain", *jump)[0], {})

    def test_smallest_step(self):
        found, _ = self.ask("explain", *settings(probes__A__at="[0.0, -0.2]"))
        warning = self.expect(found, "smallest_step", 0.15 / 6)
        self.assertGreater(warning["limit"], warning["value"])
        self.assertIn("probe 'A': where 'seabed' drains into 'mound'", warning["text"])
        self.assertEqual(self.ask("explain", *settings(probes__A__at="[0.0, -12.0]"))[0], {})

    def column(self, soil, pulse, end):
        sealed, top = (', pressure = "sealed"', 'pressure = "open"') if "porous" in soil else ("", "")
        return COLUMN % (soil, sealed, sealed, sealed, top, pulse, end)

    def probed(self, scene, reading, *arguments):
        """Warnings, times and histories of the three probes (per 1 Pa of load)."""
        found, _ = self.ask("run", *arguments, scene=scene)
        with h5py.File(self.folder / "out/results.h5") as file:
            return found, file["history/time"][:], [file[f"history/probes/{name}/{reading}"][:] for name in "abc"]

    def told_cure(self, text):
        """Size of cells (m), rise (s) and step (s) that a warning asks for; None for those that it does not name."""
        def number(pattern):
            match = re.search(pattern + r" ([0-9.e+-]+) (?:m|s)\b", text)
            return match and float(match.group(1))
        return number("cells of at most"), number("a rise of the load of at least"), number("time.step of at most")

    def dry_error(self, rise, *arguments):
        """Error of the stress of the dry column under a load that rises within `rise`, against d'Alembert's
        solution."""
        pulse = f'{{ shape = "step", peak = 1.0, rise = {rise} }}'
        end = 8 * HEIGHT / DRY_SPEED
        found, time, stress = self.probed(self.column(DRY, pulse, end), "stress_yy", *arguments)
        error = 0.0
        for y, history in zip((2.13, 5.07, 8.02), stress):
            exact = sum((-1) ** i * numpy.clip((time - (2 * i * HEIGHT + HEIGHT + side * y) / DRY_SPEED) / rise, 0, 1)
                        for i in range(5) for side in (-1, 1))
            error = max(error, abs(history + exact).max())
        return found, error

    def test_stress_rings(self):
        crossing = 0.5 / DRY_SPEED
        for rise, arguments in ((crossing, ()), (4 * crossing, ()), (8 * crossing, settings(mesh__degree=3))):
            found, error = self.dry_error(rise, *arguments)
            warning = self.expect(found, "stress_rings", limit=0.05)
            self.assertGreater(warning["value"], 0.8 * error)
            self.assertLess(warning["value"], 3 * error)
        found, error = self.dry_error(4 * crossing)
        cells, rise, step = self.told_cure(found["stress_rings"]["text"])
        finer = settings(mesh__parameters__cells=math.ceil(HEIGHT / cells), time__step=step)
        found, error = self.dry_error(4 * crossing, *finer)
        self.assertEqual(found, {})
        self.assertLess(error, 0.05)
        found, error = self.dry_error(rise, *settings(time__step=step))
        self.assertEqual(found, {})
        self.assertLess(error, 0.05)

    def test_stress_rings_after_a_jump(self):
        jump = '{ shape = "step", peak = 1.0 }'
        found, time, stress = self.probed(self.column(DRY, jump, 0.4), "stress_yy", *settings(time__step=3e-4))
        self.assertIn("jumps on the ground", self.expect(found, "stress_rings", limit=0.05)["text"])
        self.assertGreater(max(abs(history).max() for history in stress), 2.2, "it rings by a tenth or more")
        damped = DRY + "\ndamping = { ratio = 0.2, frequencies = [1, 10] }"
        found, _, _ = self.probed(self.column(damped, '{ shape = "step", peak = 1.0, rise = 0.05 }', 0.4), "stress_yy")
        self.assertEqual(found, {})
        for changes in (settings(loads__top__factor=0), settings(time__inertia="false")):
            self.assertEqual(self.ask("explain", *changes, scene=self.column(DRY, jump, 0.4))[0], {})

    def test_slow_wave_unresolved(self):
        duration = 8 * 0.5 / SLOW_SPEED
        scene = self.column(WET, f'{{ shape = "triangle", peak = 1.0, duration = {duration} }}', 0.3)

        def pressures(step, *arguments):
            found, time, pressure = self.probed(scene, "pressure", *settings(time__step=step), *arguments)
            return found, [numpy.interp(numpy.linspace(0, 0.3, 2001), time, history) for history in pressure]

        _, exact = pressures(duration / 256, *settings(mesh__parameters__cells=320, mesh__degree=3))

        def error(found):
            return max(abs(a - b).max() for a, b in zip(found, exact))

        told, coarse = pressures(duration / 64)
        warning = told["slow_wave_unresolved"]
        facts["slow_wave_unresolved"] = warning["text"]
        self.assertGreater(error(coarse), 0.15)
        self.assertGreater(warning["value"], 0.8 * error(coarse))
        self.assertLess(warning["value"], 3 * error(coarse))
        cells, _, step = self.told_cure(warning["text"])
        finer = settings(mesh__parameters__cells=math.ceil(HEIGHT / cells))
        told, fine = pressures(min(step or 1.0, duration / 64), *finer)
        self.assertNotIn("slow_wave_unresolved", told)
        self.assertLess(error(fine), 0.05)
        drag = WET.replace("= 10.0", "= 1e-4")
        self.assertEqual(self.ask("explain", scene=self.column(
            drag, '{ shape = "triangle", peak = 1.0, duration = 0.5 }', 1.0))[0].get("slow_wave_unresolved"), None)

    def test_drained_layer(self):
        mud = settings(mesh__parameters__seabed_depth=0.2, regions__seabed__shear_modulus=1e5,
                       regions__mound__shear_modulus=5e8, regions__seabed__hydraulic_conductivity=1e-8)
        found, summary = self.ask("run", *mud)
        self.assertEqual(list(found), ["drained_layer", "mesh_too_coarse"], "the ends of a thin layer are coarse, too")
        warning = self.expect({"drained_layer": found["drained_layer"]}, "drained_layer", limit=0.05)
        ratio = summary["response"]["shear_to_force_ratio"]
        stays = SCENE.replace('bed = { pressure = "open" }', "bed = {}")
        for side in ("base", "left", "right"):
            stays = re.sub(rf'({side} = {{ displacement = "\w+"), pressure = "sealed"', r"\1", stays)
        soil = SCENE[SCENE.index("[regions.seabed]"):SCENE.index("[regions.mound]")]
        stays = stays.replace(soil, '[regions.seabed]\nkind = "solid"\nshear_modulus = 30e6\npoissons_ratio = 0.499\n'
                                    'density = 2002.0\ndeformation = "elastic"\n'
                                    'damping = { ratio = 0.05, frequencies = [1, 10] }\n')
        self.assertIn('kind = "solid"', warning["text"])
        mud = [text for text in mud if "conductivity" not in text][:-1]
        found, summary = self.ask("run", *mud, scene=stays)
        self.assertEqual(list(found), ["mesh_too_coarse"])
        cured = summary["response"]["shear_to_force_ratio"]
        _, summary = self.ask("run", *mud, *settings(mesh__degree=3, mesh__refine=1), scene=stays)
        exact = summary["response"]["shear_to_force_ratio"]
        self.assertLess(abs(cured / exact - 1), 0.05)
        self.assertGreater(abs(ratio / exact - 1), 0.1)
        self.assertGreater(warning["value"], abs(ratio / exact - 1))
        sand = settings(mesh__parameters__seabed_depth=0.2, regions__seabed__shear_modulus=1e5)
        found, _ = self.ask("explain", *sand)
        self.assertNotIn('kind = "solid"', found["drained_layer"]["text"], "its skin yields by itself")

    def record(self, **changes):
        """A smooth pulse of 0.15 s, sampled every ms; `changes`: other values by time."""
        rows = []
        for i in range(600):
            t = i * changes.get("every", 1e-3)
            value = 5e5 * (1 - math.cos(2 * math.pi * (t - 0.1) / 0.15)) if 0.1 < t < 0.25 else 0.0
            rows.append(f"{t},{changes.get('change', lambda t, v: v)(t, value)}")
        (self.folder / "record.csv").write_text("time_s,force\n" + "\n".join(rows) + "\n")
        return SCENE.replace('pulse = { shape = "triangle", peak = 1e6, duration = 0.15 }', 'history = "record.csv"')

    def test_records(self):
        self.assertEqual(self.ask("explain", scene=self.record())[0], {})
        for name, value, change in (
            ("record_dead", None, lambda t, v: 1e6),
            ("record_saturated", None, lambda t, v: min(v, 8e5)),
            ("record_drifting", 0.1, lambda t, v: v + 1e5 * (t > 0.2)),
            ("record_spikes", 2, lambda t, v: 6e5 if round(t, 6) in (0.4, 0.5) else v),
        ):
            found, _ = self.ask("explain", scene=self.record(change=change))
            self.assertIn("loads.impulse", self.expect(found, name, value, places=1)["text"])
        whole = self.record()
        rows = (self.folder / "record.csv").read_text().splitlines()
        for name, value, left in (
            ("record_gap", 0.051, rows[:150] + rows[200:]),
            ("record_begun", 0.5, rows[:1] + rows[139:]),
            ("record_dropout", 30, rows[:160] + [row.split(",")[0] + ",0" for row in rows[160:190]] + rows[190:]),
        ):
            (self.folder / "record.csv").write_text("\n".join(left))
            found, _ = self.ask("explain", scene=whole)
            self.expect({name: found[name]}, name, value, places=1)
            facts[name] = found[name]["text"]
            _, summary = self.ask("run", "--set", "limits.overturning=1", "--set", "initial.water_level=15", scene=whole)
            self.assertIn(name, summary["verdict"]["why_void"])
        found, _ = self.ask("explain", scene=self.record(every=0.01), *settings(time__end=6))
        found.pop("walls_too_near")
        self.expect(found, "record_too_coarse", 6)

    def test_motion_stays(self):
        base = SCENE.split("[loads.impulse]")[0].replace('"roller"', '"level"')
        tail = SCENE[SCENE.index("[time]"):]
        for rows, left in (([(0, 0), (0.1, 2), (0.2, 0), (0.3, -1), (0.4, 0)], 0.1), ([(0, 0), (0.1, 2), (0.3, -2), (0.4, 0)], 0)):
            (self.folder / "base.csv").write_text("t (s),a (m/s2)\n" + "".join(f"{t},{a}\n" for t, a in rows))
            quake = '[loads.quake]\nboundary = "base"\nkind = "acceleration"\nhistory = "base.csv"\n'
            found, _ = self.ask("explain", scene=base + quake + tail)
            if left:
                self.expect(found, "motion_stays", left)
            else:
                self.assertNotIn("motion_stays", found)

    def test_nothing_holds(self):
        """A column on a dashpot c under the impulse J of its top: J/c (1 - exp(-c t/m)), per metre of width."""
        c, peak, duration, end, mass = 4e4, 1e3, 0.2, 3.0, 2000 * HEIGHT
        scene = COLUMN % (DRY, "", "", "", "", '{ shape = "triangle", peak = %g, duration = %g }' % (peak, duration), end)
        held = '"fixed"'
        self.assertNotIn("nothing_holds", self.ask("explain", scene=scene)[0])
        self.assertIn(held, scene)
        drift = peak * duration / 2 / c * (1 - math.exp(-c * end / mass))
        found, summary = self.ask("run", scene=scene.replace(held, f'"free", dashpot = [{c}, {c}]'))
        self.expect({"nothing_holds": found["nothing_holds"]}, "nothing_holds", drift)
        with h5py.File(self.folder / "out/results.h5") as file:
            moved = file["history/probes/a/displacement_y"][-1]
        self.assertAlmostEqual(-moved / drift, 1, 1, "what is told is so: the impulse acts a little later than at t = 0")
        sprung = scene.replace(held, f'"free", dashpot = [{c}, {c}], spring = [1e6, 1e6]')
        self.assertNotIn("nothing_holds", self.ask("explain", scene=sprung)[0])

    def test_sides_unlike_ground(self):
        base = SCENE.split("[loads.impulse]")[0]
        quake = '[loads.quake]\nboundary = "base"\nkind = "velocity"\npulse = { shape = "half_sine", peak = 0.1, duration = 0.3 }\n'
        tail = SCENE[SCENE.index("[time]"):]
        for sides, number in (("level", 0), ("absorbing", 2), ("free", 2)):
            found, _ = self.ask("explain", scene=base.replace('"roller"', f'"{sides}"') + quake + tail)
            if number:
                self.assertEqual(found["sides_unlike_ground"]["value"], number)
                facts["sides_unlike_ground"] = found["sides_unlike_ground"]["text"]
            else:
                self.assertNotIn("sides_unlike_ground", found)

    def test_impact_unresolved(self):
        strong = [*LEVEL, *settings(loads__impulse__factor=6, regions__caisson__interface="{ kind = \"friction\" }", time__end=0.4)]
        self.assertNotIn("impact_unresolved", self.ask("run", *strong, "--set", "time.step=0.005")[0])
        stiff = settings(regions__seabed__shear_modulus=3e10, regions__mound__shear_modulus=5e10)
        found, summary = self.ask("run", *strong, *stiff, "--set", "time.step=0.005")
        self.assertGreater(summary["contact"]["solved"]["impacts"], 0)
        self.assertEqual(found["impact_unresolved"]["value"], summary["discretisation"]["time_step"])
        facts["impact_unresolved"] = found["impact_unresolved"]["text"]

    def test_cavitation(self):
        strong = settings(loads__impulse__factor=20)
        for scheme in ("reduced", "sdirk4"):
            found, _ = self.ask("run", *LEVEL, *strong, "--set", f"time.scheme={scheme}")
            warning = found["cavitation"]
            self.assertEqual(warning["limit"], 2339)
            region, x, y, kpa, time = re.search(
                r"'(\w+)' at \((\S+), (\S+)\) m would come to (\S+) kPa absolute at (\S+) s", warning["text"]).groups()
            facts[f"cavitation, {scheme}"] = warning["text"]
            _, _ = self.ask("run", *LEVEL, *strong, "--set", f"probes.A.at=[{x}, {float(y) - 0.01}]",
                            "--set", "time.scheme=sdirk4", "--set", "time.step=0.005")
            with h5py.File(self.folder / "out/results.h5") as file:
                excess = file["history/probes/A/pressure"][:].min()
            still = 101325 + 1030 * 9.81 * (15 - float(y))
            self.assertAlmostEqual((warning["value"] - still) / excess, 1, delta=0.1)
            self.assertAlmostEqual(warning["value"] / 1e3, float(kpa), delta=0.01 * abs(float(kpa)))
        found, summary = self.ask("run", *strong)
        self.assertNotIn("cavitation", found)
        self.assertIn("cavitation of the water", [item["what"] for item in summary["skipped"]])

    def test_strength(self):
        soil = settings(regions__mound__strength__friction_angle=40, regions__seabed__strength__friction_angle=35)
        found, summary = self.ask("run", *LEVEL, *soil, *settings(loads__impulse__factor=4))
        self.assertEqual(summary["discretisation"]["scheme"], "reduced")
        self.assertEqual([part["region"] for part in summary["strength"]], ["seabed", "mound"])
        for part in summary["strength"]:
            self.assertLess(part["initial"], part["largest"])
            self.assertLessEqual(part["initial_share"], part["share"])
            self.assertLess(part["left_out"], 0.25)
        largest = max(part["largest"] for part in summary["strength"])
        self.assertGreater(largest, 1)
        self.assertEqual(found["strength"]["limit"], 1)
        facts["strength"] = found["strength"]["text"]
        found, summary = self.ask("run", *LEVEL, *soil, *settings(loads__impulse__factor=1e-3))
        self.assertEqual(found, {})
        for part in summary["strength"]:
            self.assertAlmostEqual(part["largest"], part["initial"], delta=0.02 * part["initial"])
        found, summary = self.ask("run")
        self.assertIn("strength of the soil", [item["what"] for item in summary["skipped"]])

    def test_units_that_were_mistaken(self):
        for key, value, meant in (("regions.mound.shear_modulus", 48.97, "in MPa, write 4.897e+07"),
                                  ("fluid.density", 1.03, "in t/m3, write 1030"),
                                  ("regions.caisson.density", 2.1, "in t/m3, write 2100"),
                                  ("regions.seabed.hydraulic_conductivity", 100.0, "in m/day, write 0.001157")):
            with self.subTest(key=key):
                found, _ = self.ask("explain", *LEVEL, "--set", f"{key}={value}")
                self.assertIn(meant, found["implausible"]["text"])
                self.assertTrue(found["implausible"]["text"].startswith(key + " = "))
                self.assertEqual(found["implausible"]["value"], value)
        found, _ = self.ask("explain", *LEVEL, "--set", "regions.mound.biot=0.3")
        facts["biot_below_porosity"] = self.expect(found, "biot_below_porosity", 0.3, 0.4)["text"]
        wrong = ["--set", "sliding={ friction = 60, submerged_weight = 4296 }"]
        found, _ = self.ask("explain", *LEVEL, *wrong)
        self.assertIn("in percent, write 0.6", found["implausible"]["text"])
        self.assertIn("in kN/m, write 4.296e+06", found["submerged_weight"]["text"])
        facts["implausible"], facts["submerged_weight"] = found["implausible"]["text"], found["submerged_weight"]["text"]
        found, _ = self.ask("explain", *WEIGHT)
        self.expect(found, "no_water", 4.3e6)

    def test_base_pressure(self):
        found, summary = self.ask("run", *LEVEL, *WEIGHT, "--set", "limits.dynamic_base_pressure=2.4e5")
        peak = max(summary["base"]["peak_heel_pressure"], summary["base"]["peak_toe_pressure"])
        self.expect(found, "base_pressure", peak, 2.4e5)
        held = {check["name"]: check["holds"] for check in summary["checks"]}
        self.assertEqual((held["heel pressure in motion"], held["sliding distance"], held["force against friction"]),
                         (False, None, True))
        with h5py.File(self.folder / "out/results.h5") as file:
            self.assertAlmostEqual(file["history/heel_pressure"][:].max(), summary["base"]["peak_heel_pressure"])

    def test_would_lift(self):
        found, _ = self.ask("run", *LEVEL, *WEIGHT, *settings(loads__impulse__factor=8))
        with h5py.File(self.folder / "out/results.h5") as file:
            at = {name: file[f"history/{name}"][:]
                  for name in ("normal_force", "uplift", "base_moment", "uplift_moment")}
        N, M = 4.3e6 + at["normal_force"] - at["uplift"], at["base_moment"] + at["uplift_moment"]
        edge = N / WIDTH - 6 * abs(M) / (1.26 * WIDTH**2)
        self.expect(found, "would_lift", edge.min())
        self.assertLess(edge.min(), 0)
        tied = settings(regions__caisson__interface__kind='"friction"')
        found, _ = self.ask("run", *LEVEL, *WEIGHT, *settings(loads__impulse__factor=8), *tied)
        self.assertNotIn("would_lift", found)
        with h5py.File(self.folder / "out/results.h5") as file:
            opening, length = file["interface/opening"][:], file["interface/length"][:]
        self.expect(found, "no_settlement", opening[:, [0, -1]].max())
        solved = json.loads((self.folder / "out/summary.json").read_text())["contact"]["solved"]
        in_end = length[opening[-1] > 0].sum() / length.sum()
        self.assertAlmostEqual(solved["open_in_end"], in_end)
        self.assertEqual(solved["last_closing"] is None, in_end > 0)
        self.assertGreater(solved["lift_energy"], 0)
        self.assertGreater(solved["closing_speed"], 0)

    def test_still_slides(self):
        """A run that ends while the caisson slides, though its load has fallen below the friction."""
        pushed = [*LEVEL, *WEIGHT, *settings(loads__impulse__factor=8)]
        for tied in ([], settings(regions__caisson__interface__kind='"friction"')):
            for end, limit, held in ((0.145, 5.0, None), (0.145, 0.001, False), (0.6, 5.0, True)):
                found, summary = self.ask("run", *pushed, *tied, *settings(time__end=end, limits__sliding=limit, time__scheme='"sdirk4"'))
                design = summary["sliding"]["design"]
                check = next(check for check in summary["checks"] if check["name"] == "sliding distance")
                if design["measure"] == "sliding.sliding_coupled":  # followed until the caisson rests
                    self.assertNotIn("still_slides", found)
                    self.assertEqual(check["holds"], design["value"] <= limit)
                    continue
                self.assertEqual(check["holds"], held)
                self.assertEqual("still_slides" in found, end < 0.5)
                if end < 0.5:
                    self.assertEqual(found["still_slides"]["value"], abs(design["end_velocity"]))
                    facts["still_slides"] = found["still_slides"]["text"]
        self.assertIn("still_slides", facts)

    def test_shipped_cases_have_none(self):
        for case in ("fig2b-model", "fig2b-prototype", "one-soil/model", "one-soil/prototype"):
            done = upbead("run", CASES / f"{case}.toml", "--out", self.folder / "out")
            self.assertEqual(done.returncode, 0, done.stderr)
            names = [w["name"] for w in json.loads((self.folder / "out/summary.json").read_text())["warnings"]]
            facts[f"shipped: {case}"] = ", ".join(names) or "none"
            self.assertEqual(names, [], done.stderr)


def write_facts(path):
    rows = [{"what": name, "tried": "a shipped case" if name.startswith("shipped") else "a scene built for it",
             "came_out": text} for name, text in sorted(facts.items())]
    pathlib.Path(path).write_text(json.dumps({
        "title": "Numbers that look right and are not",
        "text": "A scene was built for each warning; its number was compared with the one that the scene was built "
                "with, or with the histories of the run. The shipped cases bring none.",
        "command": "/usr/bin/python3 tests/cli/warnings_test.py build/upbead cases --facts docs/reliability/warnings.json",
        "figure": None, "rows": rows}, indent=2) + "\n")


if __name__ == "__main__":
    result = unittest.main(argv=["warnings_test.py"], exit=False).result
    if "--facts" in sys.argv and result.wasSuccessful():
        write_facts(sys.argv[sys.argv.index("--facts") + 1])
    sys.exit(not result.wasSuccessful())
