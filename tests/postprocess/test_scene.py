"""Cases made in Python: mappings, scenes, functions of time and place; names that are wrong; tables of pandas and xarray.

usage: test_scene.py FOLDER_OF_THE_SCRIPTS PROGRAM CASES_FOLDER
"""

import doctest
import importlib
import importlib.util
import os
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import h5py
import numpy as np

SCRIPTS, PROGRAM, CASES = (Path(argument).resolve() for argument in sys.argv[1:4])
os.environ["UPBEAD"] = str(PROGRAM)
sys.path.insert(0, str(SCRIPTS))

import upbead  # noqa: E402
from upbead.near import nearest  # noqa: E402
from upbead.sampled import sampled_field, sampled_function  # noqa: E402
from upbead.toml import toml_text  # noqa: E402
from upbead.written_case import as_file  # noqa: E402

MODEL = CASES / "fig2b-model.toml"
COARSE = {"mesh.parameters.cells": 0.4}
HAS = {name: importlib.util.find_spec(name) is not None for name in ("pandas", "xarray")}


def column():
    """A column of soil under a pressure, by the geometry of that name."""
    scene = upbead.Scene("A column", geometry="column", parameters={"height": 10.0, "width": 0.5, "cells": 8})
    scene.region("soil", "porous", shear_modulus=2e7, poissons_ratio=0.3, porosity=0.4, grain_density=2650.0, hydraulic_conductivity=1e-4)
    scene.boundary("base", displacement="fixed", pressure="sealed")
    scene.boundary("left", displacement="roller", pressure="sealed").boundary("right", displacement="roller", pressure="sealed")
    scene.boundary("top", displacement="free", pressure="open")
    return scene.put(fluid={"density": 1000.0, "bulk_modulus": 2.2e9}, time={"end": 0.05}).probe("middle", at=(0.25, 5.0))


class Solved(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        cls.result = upbead.run(MODEL, set=COARSE, out=cls.folder / "file")

    def same(self, other):
        np.testing.assert_allclose(other["shear_force"], self.result["shear_force"], rtol=0, atol=1e-9 * self.result["shear_force"].max())

    def test_a_mapping_is_the_case_that_it_was_read_from(self):
        case = dict(upbead.Scene.read(MODEL))
        case["mesh"]["parameters"]["cells"] = np.float64(0.4)
        found = upbead.run(case, out=self.folder / "mapping")
        self.same(found)
        self.assertEqual(found.title, self.result.title)
        self.assertTrue((self.folder / "mapping/given.toml").is_file())

    def test_a_saved_scene_is_a_case_file(self):
        self.same(upbead.run(upbead.Scene.read(MODEL).save(self.folder / "saved/mine.toml"), set=COARSE, out=self.folder / "saved/out"))

    def test_a_history_as_numbers_or_as_a_function(self):
        time, force = np.loadtxt(CASES / "fig2b-model-impulse.csv", delimiter=",", skiprows=1, unpack=True)
        scene = upbead.Scene.read(MODEL)
        scene["loads"]["impulse"]["history"] = (time, force)
        self.same(scene.run(COARSE, self.folder / "numbers"))
        scene["loads"]["impulse"]["history"] = lambda t: float(np.interp(t, time, force, right=0.0))
        found = scene.run(COARSE, self.folder / "function")
        self.assertAlmostEqual(found["shear_force"].max() / self.result["shear_force"].max(), 1.0, delta=1e-3)

    def test_a_function_that_jumps(self):
        scene = upbead.Scene.read(MODEL)
        scene["loads"]["impulse"]["history"] = ([0, 0.02, 0.02, 0.05, 0.05], [0, 0, 4e3, 4e3, 0])
        given = scene.run(COARSE, self.folder / "jumps")
        scene["loads"]["impulse"]["history"] = lambda t: 4e3 if 0.02 < t < 0.05 else 0.0
        found = scene.run(COARSE, self.folder / "jumping")
        self.assertAlmostEqual(found["shear_force"].max() / given["shear_force"].max(), 1.0, delta=1e-6)
        self.assertEqual(found.time.size, given.time.size)

    def test_a_longer_run_has_the_whole_function(self):
        scene = column().load("ramp", boundary="top", kind="pressure", history=lambda t: 1e5 * t)
        found = scene.run({"time.end": 0.1}, out=self.folder / "longer")
        self.assertAlmostEqual(found["probes/middle/pressure"][-1] / found["probes/middle/pressure"].max(), 1.0, delta=0.05)
        self.assertAlmostEqual(np.loadtxt(self.folder / "longer/given-1-ramp.csv", delimiter=",", skiprows=2)[-1, 1], 1e4, delta=1e-6)

    def test_a_pressure_of_place_and_time(self):
        """p(s, t) = f(t)/h on the front is the force f(t), uniform over it."""
        peak, height = 4e3, 0.8
        scene = upbead.Scene.read(MODEL)
        front = float(scene["mesh"]["parameters"].get("caisson_height", height))
        base = float(scene["mesh"]["parameters"]["mound_height"])
        pulse = lambda t: peak * max(0.0, 1.0 - abs(t - 0.015) / 0.015)  # noqa: E731
        load = {"boundary": "front", "measured_on_wall": scene["loads"]["impulse"].get("measured_on_wall", False)}
        scene["loads"] = {"impulse": {**load, "kind": "force", "direction": [1.0, 0.0], "history": pulse}}
        force = scene.run(COARSE, self.folder / "force")
        scene["loads"] = {"impulse": {**load, "gauges": lambda s, t: pulse(t) / front, "heights": np.linspace(base, base + front, 5)}}
        pressure = scene.run(COARSE, self.folder / "pressure")
        self.assertAlmostEqual(pressure["shear_force"].max() / force["shear_force"].max(), 1.0, delta=2e-3)
        self.assertAlmostEqual(pressure["force"].max() / peak, 1.0, delta=2e-3)

    def test_curves_of_soil_as_functions(self):
        """The hyperbola of Hardin and Drnevich, which the program has, too, by its own formula."""
        case = upbead.Scene.read(MODEL)
        case["mesh"]["parameters"]["cells"] = 0.4
        case["regions"]["seabed"]["strain"] = {"reference_strain": 5e-4, "smallest_damping": 0.02, "largest_damping": 0.2}
        own = case.run(out=self.folder / "formula")
        ratio = lambda strain: 1 / (1 + strain / 5e-4)  # noqa: E731
        case["regions"]["seabed"]["strain"] = {"modulus": ratio, "damping": lambda strain: 0.02 + 0.18 * (1 - ratio(strain))}
        given = case.run(out=self.folder / "functions")
        peaks = [found.summary["response"]["peak_shear"] for found in (self.result, own, given)]
        self.assertAlmostEqual(peaks[2] / peaks[1], 1.0, delta=2e-3)
        self.assertGreater(abs(peaks[0] / peaks[1] - 1.0), 0.01)  # so that the curve matters
        case["regions"]["seabed"]["strain"]["modulus"] = lambda strain: float("nan")
        with self.assertRaisesRegex(upbead.UserError, "regions.seabed.strain.modulus: the function"):
            case.run(out=self.folder / "none")

    def test_a_study_of_a_mapping(self):
        table = upbead.study({"title": "Few", "case": upbead.Scene.read(MODEL), "read": ["response.peak_shear"], "set": COARSE,
                              "vary": {"regions.seabed.shear_modulus": {"values": [6.57e6, 9e6]}}}, out=self.folder / "study")
        self.assertEqual(len(table), 2)
        if HAS["pandas"]:
            frame = table.to_pandas()
            self.assertEqual((len(frame), frame.attrs["units"]["response.peak_shear"], frame.attrs["units"]["regions.seabed.shear_modulus"]), (2, "N/m", "Pa"))
        with self.assertRaisesRegex(upbead.UnknownName, "did you mean response.peak_shear"):
            table["peak_shear"]
        self.assertAlmostEqual(table["response.peak_shear"][0] / self.result.summary["response"]["peak_shear"], 1.0, delta=1e-9)
        self.assertIn("regions.seabed.shear_modulus", list(table))

    def test_a_scene_in_code(self):
        scene = column().load("step", boundary="top", kind="pressure", history=lambda t: 1e3 * min(1.0, t / 1e-3))
        found = scene.run(out=self.folder / "column")
        self.assertIn("probes/middle/pressure", found)
        self.assertEqual(repr(scene), "<Scene 'A column': 1 regions, 4 boundaries, 1 loads, 1 probes>")
        with self.assertRaisesRegex(upbead.CaseError, r"given\.toml:\d+"):
            column().region("soil", "porus").run(out=self.folder / "wrong")

    def test_a_wrong_name_says_what_is_near(self):
        for name, near in (("F_T", "shear_force"), ("/history/F_T", "shear_force"), ("shear_forc", "shear_force"), ("displacement_x", "caisson/displacement_x")):
            with self.assertRaisesRegex(upbead.UnknownName, f"did you mean .*{near}", msg=name):
                self.result[name]
        self.assertIsNone(self.result.get("F_T"))
        with self.assertRaisesRegex(KeyError, "did you mean response"):
            self.result.summary["respons"]
        with self.assertRaisesRegex(upbead.UserError, "did you mean peak_shear"):
            self.result.summary["response"]["peak_sheer"]

    @unittest.skipUnless(HAS["pandas"], "no pandas")
    def test_pandas(self):
        frame = self.result.to_pandas()
        self.assertEqual((frame.index.name, frame.attrs["units"]["shear_force"], frame.attrs["units"]["time"]), ("time", "N/m", "s"))
        np.testing.assert_array_equal(frame["shear_force"], self.result["shear_force"])
        self.assertEqual(frame.shape, (self.result.time.size, len(self.result) - 1))
        waves = upbead.waves(CASES / "designer/design.toml", out=self.folder / "waves")
        frame = waves.to_pandas()
        self.assertEqual((list(frame.index), frame.attrs["units"]["height"]), (list(waves["waves"]), "m"))

    @unittest.skipUnless(HAS["xarray"] and HAS["pandas"], "no xarray")
    def test_xarray(self):
        found = self.result.to_xarray()
        self.assertEqual((found["shear_force"].attrs["units"], found["time"].attrs["units"], found["shear_force"].dims), ("N/m", "s", ("time",)))
        np.testing.assert_array_equal(found["shear_force"].values, self.result["shear_force"])
        slides = upbead.run(MODEL, set=COARSE | {"loads.impulse.factor": 3.0, "regions.caisson.interface.kind": "friction"}, out=self.folder / "slides")
        bottom = slides.to_xarray("interface")
        self.assertEqual((bottom["slip"].dims, bottom["slip"].attrs["units"]), (("time", "position"), "m"))
        np.testing.assert_array_equal(bottom["slip"].sel(position=slides.position[3]).values, slides.slip[:, 3])
        rows = slides.to_pandas("interface")
        self.assertEqual(len(rows), slides.slip.size)
        np.testing.assert_array_equal(rows["slip"], slides.slip.ravel())
        np.testing.assert_array_equal(rows["position"][: slides.position.size], slides.position)


class Written(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.addCleanup(os.chdir, os.getcwd())

    def test_texts_are_read_as_they_were(self):
        values = {"title": 'A "b" \\', "n": 3, "flag": True, "mesh": {"a.b": {"c": [1, 2.5, "x"]}, "d": float("inf")}, "e": {}}
        self.assertEqual(tomllib.loads(toml_text(values)), values)
        self.assertEqual(tomllib.loads(toml_text({"a": None, "b": {"c": None, "d": 1}})), {"b": {"d": 1}})
        with self.assertRaisesRegex(upbead.UserError, "^mesh.cells: .*has no form in TOML"):
            toml_text({"mesh": {"cells": object()}})

    def test_paths_are_those_of_the_working_folder(self):
        (self.folder / "wave.csv").write_text("time (s), P (N/m)\n0, 0\n1, 1\n")
        os.chdir(self.folder)
        for given in ("wave.csv", Path("wave.csv")):
            read = tomllib.loads(as_file({"loads": {"a": {"history": given}}, "title": "wave.csv"}, Path("out")).read_text())
            self.assertEqual((read["loads"]["a"]["history"], read["title"]), (str(self.folder / "wave.csv"), "wave.csv"))
        self.assertEqual(as_file("a/b.toml", Path("out")), Path("a/b.toml"))

    def test_a_path_in_the_folder_of_results_is_none_of_the_working_folder(self):
        (self.folder / "out").mkdir()
        (self.folder / "out/wave.csv").write_text("another")
        os.chdir(self.folder)
        for there in (False, True):
            if there:
                (self.folder / "wave.csv").write_text("time (s), P (N/m)\n0, 0\n1, 1\n")
            read = tomllib.loads(as_file({"loads": {"a": {"history": "wave.csv", "kind": "force"}}}, Path("out")).read_text())
            self.assertEqual(read["loads"]["a"], {"history": str(self.folder / "wave.csv"), "kind": "force"})

    def test_every_load_has_a_file_of_its_own(self):
        names = ("波", "風", "a b", "a_b")
        loads = {name: {"history": ([0, 1], [0, n])} for n, name in enumerate(names)}
        read = tomllib.loads(as_file({"loads": loads}, self.folder).read_text(encoding="utf-8"))["loads"]
        values = [np.loadtxt(self.folder / read[name]["history"], delimiter=",", skiprows=2)[1, 1] for name in names]
        self.assertEqual(values, [0, 1, 2, 3])
        self.assertTrue(all(path.name.isascii() for path in self.folder.iterdir()))

    def test_a_function_is_sampled_until_the_end_that_holds(self):
        scene = {"loads": {"a": {"history": lambda t: t}}, "time": {"end": 0.25}}
        vary = lambda **keys: {"case": scene, "vary": {"time.end": keys}}  # noqa: E731
        for case, values, end in ((scene, None, 0.25), (scene, {"time.end": 0.5}, 0.5), (scene, {"mesh.degree": 2, "time": {"end": 3}}, 3),
                                  ({"case": scene, "set": {"mesh.degree": 2}}, None, 0.25), ({"case": scene, "set": {"time.end": 2}}, None, 2),
                                  (vary(values=[0.5, 2, 1]), None, 2), (vary(**{"from": 0.1, "to": 1.5}), None, 1.5), (vary(to=1.5), {'vary."time.end".to': 4}, 4),
                                  ({"cases": [scene, scene]}, {'set."time.end"': 0.5}, 0.5)):
            folder = self.folder / str(len(list(self.folder.iterdir())))
            as_file(case, folder, values)
            ends = [np.loadtxt(path, delimiter=",", skiprows=2)[-1, 0] for path in folder.glob("*.csv")]
            self.assertEqual(set(ends), {end})
        with self.assertRaisesRegex(upbead.UserError, "loads.a is a function of time.*largest time.end: vary that by values"):
            as_file(vary(distribution="normal", mean=1, deviation=0.1), self.folder / "none")
        as_file(vary(distribution="normal") | {"case": "a.toml"}, self.folder / "file")  # has nothing to be sampled

    def test_files_of_others_are_kept(self):
        case = {"loads": {"a": {"history": ([0, 1], [0, 1])}}}
        for name in ("given.toml", "given-1-a.csv"):
            as_file(case, self.folder)
            as_file(case, self.folder)  # its own are written over
            (self.folder / name).write_text("mine\n")
            with self.assertRaisesRegex(upbead.UserError, f"{name}' would be written over"):
                as_file(case, self.folder)
            self.assertEqual((self.folder / name).read_text(), "mine\n")
            (self.folder / name).unlink()

    def test_a_jump_is_two_samples_at_one_time(self):
        for function, jumps in ((lambda t: 4e3 if 0.02 < t < 0.05 else 0.0, [0.02, 0.05]), (lambda t: np.where(t >= 0.1, 1.0, t), [0.1]),
                                (lambda t: 1.0 if 0 < t < 0.02345 else 0.0, [0, 0.02345]), (lambda t: np.arctan(1e4 * (t - 0.07)), [])):
            time, value = sampled_function(function, 0.2).T
            at = np.flatnonzero(np.diff(time) == 0)
            np.testing.assert_allclose(time[at], jumps, rtol=0, atol=1e-12)
            self.assertGreater(np.diff(time)[np.diff(time) > 0].min(), 0.2 / 2000 / (10 if jumps else 2**12))
            middle = 0.5 * (time[1:] + time[:-1])
            self.assertLess(max(abs(float(function(t)) - np.interp(t, time, value)) for t in np.delete(middle, at)), 1e-3 * np.abs(value).max())
        front = sampled_field(lambda s, t: 1.0 if t > s / 100 else 0.0, [1.0, 2.0, 3.0], 0.1)
        np.testing.assert_allclose(front[:-1][np.diff(front[:, 0]) == 0, 0], [0.01, 0.02, 0.03], rtol=0, atol=1e-12)

    def test_what_cannot_be_sampled(self):
        load = {"boundary": "front", "history": lambda t: t}
        for case, words in (({"loads": {"a": load}}, "loads.a is a function of time.*time.end"),
                            ({"loads": {"a": {"history": ([0, 1], [0])}}}, "loads.a.history: give .times, values."),
                            ({"loads": {"a": {"gauges": lambda s, t: s}}, "time": {"end": 1}}, "loads.a.heights: give the places"),
                            ({"loads": {"a": {"history": lambda t: np.nan}}, "time": {"end": 1}}, "no finite numbers")):
            with self.assertRaisesRegex(upbead.UserError, words):
                as_file(case, self.folder)

    def test_tables_follow_the_function(self):
        for function, end in ((lambda t: 4e3 if 0.0101 < t < 0.0102 else 0.0, 0.2), (np.sin, 30.0), (lambda t: np.exp(-((t - 0.3) / 1e-3) ** 2), 1.0)):
            time, value = sampled_function(function, end).T
            self.assertTrue((np.diff(time) >= 0).all() and time[0] == 0 and time[-1] == end)
            middle = 0.5 * (time[1:] + time[:-1])
            error = [abs(function(t) - np.interp(t, time, value)) for t in middle]
            self.assertLess(np.sum(error * np.diff(time)), 1e-4 * np.abs(value).max() * end)
        table = sampled_field(lambda s, t: s * np.exp(-t), [1.0, 2.0], 1.0)
        np.testing.assert_allclose(table[:, 1:], np.exp(-table[:, :1]) * [1.0, 2.0])

    def test_a_package_that_is_missing_is_named(self):
        code = (f"import sys; sys.path.insert(0, {str(SCRIPTS)!r}); import upbead.tables as t, upbead\n"
                "assert not {'pandas', 'xarray'} & set(sys.modules)\nsys.modules['pandas'] = sys.modules['xarray'] = None\n"
                "for call in (lambda: t.data_frame({}), lambda: t.data_set({}, {}, {})):\n"
                "    try:\n        call()\n    except upbead.MissingPackage as error:\n        print(error)")
        done = subprocess.run(["/usr/bin/python3", "-B", "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual([line.split(":")[1] for line in done.stdout.splitlines()], [" pip install pandas (Debian", " pip install xarray (Debian"])

    @unittest.skipUnless(HAS["xarray"] and HAS["pandas"], "no xarray or pandas")
    def test_expected_sliding_and_a_calibration_are_mappings_and_tables(self):
        folders = {name: self.folder / name for name in ("expected", "calibration")}
        for folder in folders.values():
            folder.mkdir()
        (folders["expected"] / "summary.json").write_text('{"title": "E", "expected": {}}')
        (folders["calibration"] / "summary.json").write_text('{"title": "K", "given": {"a": 0.3, "b": 2}, "models": {"m": {}}}')
        with h5py.File(folders["expected"] / "results.h5", "w") as file:
            for name in ("height", "waves", "distance/paper", "contribution/paper"):
                file[f"heights/{name}"] = np.linspace(0.0, 5.0, 11)
                file[f"heights/{name}"].attrs["unit"] = "m"
        with h5py.File(folders["calibration"] / "results.h5", "w") as file:
            file["model"], file["alpha_star"] = [b"m"] * 3, [0.5, 0.6, 0.7]
            file["alpha_star"].attrs["unit"] = "1"
        expected, calibration = (upbead.open(folder) for folder in folders.values())
        self.assertEqual((set(expected), expected["distance/paper"].unit), ({"height", "waves", "distance/paper", "contribution/paper"}, "m"))
        self.assertEqual((expected.to_pandas().index.name, expected.to_xarray()["waves"].units), ("height", "m"))
        self.assertEqual((set(calibration), list(calibration["model"]), calibration["alpha_star"].unit), ({"model", "alpha_star"}, ["m"] * 3, "1"))
        self.assertEqual((list(calibration.to_pandas()["model"]), calibration.to_xarray()["alpha_star"].units), (["m"] * 3, "1"))
        for found, name in ((expected, "distance/papre"), (calibration, "alpha")):
            with self.assertRaisesRegex(upbead.UnknownName, "did you mean"):
                found[name]

    def test_nearest_names(self):
        self.assertEqual(nearest("P", {"force": "P, wave force", "peak": "Peak"}), ["force"])

    def test_examples_of_the_docstrings(self):
        for name in ("near", "named", "toml", "sampled", "sampled_until", "written_case", "scene", "history", "outputs"):
            found = doctest.testmod(importlib.import_module(f"upbead.{name}"))
            self.assertEqual(found.failed, 0, name)
            self.assertGreater(found.attempted, 0, name)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
