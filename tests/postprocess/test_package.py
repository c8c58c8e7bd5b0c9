"""The package upbead: arrays with units, results, errors of the program.

usage: test_package.py FOLDER_OF_THE_SCRIPTS
"""

import json
import os
import re
import sys
import tempfile
import types
import unittest
import warnings
from pathlib import Path
from unittest import mock

import h5py
import numpy as np

SCRIPTS = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess").resolve()
sys.path.insert(0, str(SCRIPTS))
import upbead  # noqa: E402
from upbead.program import find, toml_value  # noqa: E402
from upbead.results import command_of  # noqa: E402
from upbead.reporting import response as reported  # noqa: E402

TIME = np.linspace(0.0, 1.0, 11)


def write_result(folder, **tables):
    """Writes a run with P, F_T, and the given {path: values}, with two underscores for a slash."""
    folder.mkdir(exist_ok=True)
    values = {"history/time": (TIME, "s"), "history/force": (2e6 * TIME, "N/m")}
    values["history/shear_force"] = 1e6 * TIME, "N/m"
    values |= {path.replace("__", "/"): (numbers, "Pa") for path, numbers in tables.items()}
    with h5py.File(folder / "results.h5", "w") as file:
        for path, (numbers, unit) in values.items():
            file[path] = numbers
            file[path].attrs["unit"], file[path].attrs["description"] = unit, f"made-up {path}"
        if "measured" in file:
            file["measured/gauge"].attrs["reading"] = "shear_force"
            file["measured/gauge/value"].attrs["unit"] = "N/m"
    (folder / "summary.json").write_text(json.dumps({"title": "Made-up"}), encoding="utf-8")
    (folder / "case.toml").write_text("[time]\nend = 1.0\n", encoding="utf-8")
    return folder


class InFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)


class Histories(unittest.TestCase):
    def setUp(self):
        self.force = upbead.History([0.0, 2.0, -4.0], "N/m", "wave force")

    def test_unit_stays_with_the_same_numbers_only(self):
        for same in (self.force[1:], self.force.copy(), self.force[self.force > 0], self.force.reshape(3, 1)):
            self.assertEqual((same.unit, same.description), ("N/m", "wave force"))
        for other in (self.force * 2, self.force**2, 1 / (self.force + 1), np.abs(self.force), self.force - self.force,
                      np.cumsum(self.force), np.concatenate([self.force, self.force]), np.gradient(self.force)):
            self.assertIs(type(other), np.ndarray)

    def test_numbers_are_those_of_numpy(self):
        plain = self.force.values
        self.assertIs(type(plain), np.ndarray)
        self.assertEqual((self.force.max(), self.force.mean(), np.ptp(self.force)), (2.0, plain.mean(), 6.0))
        self.assertIsInstance(self.force.max(), float)
        self.assertEqual(np.interp(0.5, [0, 1, 2], self.force), 1.0)
        self.force += 1.0
        np.testing.assert_array_equal(self.force, [1.0, 3.0, -3.0])
        self.assertEqual(self.force.unit, "N/m")

    def test_scale_keeps_the_largest_at_one_or_more(self):
        self.assertEqual(self.force.scale(), (1.0, "N/m"))
        self.assertEqual(self.force.scale([upbead.History([5e6], "N/m")]), (1e-6, "MN/m"))
        self.assertEqual(upbead.History([3.0], "1").scale(), (1.0, "1"))


class Results(InFolder):
    def test_mapping_of_histories(self):
        result = upbead.open(write_result(self.folder / "a", history__probes__A__pressure=TIME))
        self.assertEqual(set(result), {"time", "force", "shear_force", "probes/A/pressure"})
        self.assertEqual(len(result), 4)
        self.assertEqual((result["shear_force"].unit, result["probes/A/pressure"].unit), ("N/m", "Pa"))
        np.testing.assert_array_equal(dict(result)["force"], 2e6 * TIME)
        self.assertNotIn("inertia_force", result)
        self.assertNotIn("probes/A", result)
        with self.assertRaisesRegex(upbead.UserError, "has no dataset /history/inertia_force"):
            result["inertia_force"]
        self.assertEqual((result.case["time"]["end"], result.summary["title"], result.tables), (1.0, "Made-up", []))

    def test_tables_beside_the_histories(self):
        pressure = np.outer(TIME, [1.0, 2.0])
        result = upbead.open(write_result(self.folder / "a", base__position=[0.0, 1.0], base__pore_pressure=pressure,
                                          measured__gauge__time=TIME[:4], measured__gauge__value=TIME[:4]))
        self.assertEqual(result.tables, ["base", "measured/gauge"])
        self.assertEqual(set(result.table("base")), {"position", "pore_pressure"})
        np.testing.assert_array_equal(result["/base/pore_pressure"], pressure)
        measured = result.measured()["gauge"]
        self.assertEqual((measured["reading"], measured["value"].size), ("shear_force", 4))
        self.assertEqual((measured["time"].unit, measured["value"].unit), ("Pa", "N/m"))
        with self.assertRaisesRegex(upbead.UserError, "no table 'coupled'; its tables are: base, measured/gauge"):
            result.table("coupled")

    def test_what_is_no_result(self):
        for name, message in (("none", "there is no folder"), (".", "has no results.h5")):
            with self.assertRaisesRegex(upbead.UserError, message):
                upbead.open(self.folder / name)
        with self.assertRaisesRegex(upbead.ModelError, "is no reduced model"):
            upbead.open_model(write_result(self.folder / "a") / "results.h5")


class Program(InFolder):
    def fake(self, body):
        """A shell script instead of the program; its arguments are in $*, the folder of --out in $4."""
        path = self.folder / "fake"
        path.write_text(f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)
        return path

    def test_values_as_toml(self):
        for value, text in ((np.float64(0.5), "0.5"), (np.array([1, 2]), "[1, 2]"), (float("inf"), "inf"),
                            (False, "false"), ('a "b" \\', '"a \\"b\\" \\\\"'), (np.bool_(True), "true"), (10**30, "1e+30"), (-(2**63), "-9.223372036854776e+18"),
                            ("a\nb\x01", '"a\\nb\\u0001"')):
            self.assertEqual(toml_value(value), text)
        with self.assertRaisesRegex(upbead.UserError, "has no form in TOML"):
            toml_value(None)

    def test_the_newer_summary_tells_whose_a_folder_is(self):
        (self.folder / "study.csv").write_text("run,x,status,message\n0,1,done,\n")
        (self.folder / "results.h5").touch()
        for summary, command in ((None, "study"), ({"runs": 1}, "study"), ({"response": {}}, "run"), ({"expected": {}}, "expected")):
            if summary:
                (self.folder / "summary.json").write_text(json.dumps(summary))
            self.assertEqual(command_of(self.folder), command)

    def test_arguments_of_the_program(self):
        source = write_result(self.folder / "source")
        program = self.fake(f'echo "$*" > {self.folder}/arguments; cp -r {source} "$4"')
        values = {"time.scheme": "sdirk4", "time.end": 2}
        result = upbead.run("a.toml", set=values, out=self.folder / "out", program=program)
        self.assertEqual(result.title, "Made-up")
        self.assertEqual((self.folder / "arguments").read_text().strip(),
                         f'run a.toml --out {self.folder}/out --set time.scheme="sdirk4" --set time.end=2')

    def test_exit_codes(self):
        for code, kind in ((1, upbead.CaseError), (2, upbead.NumericsError), (3, upbead.UpbeadError)):
            program = self.fake(f"echo a.toml:3:4: what and cure >&2; exit {code}")
            with self.assertRaisesRegex(kind, "a.toml:3:4: what and cure") as found:
                upbead.run("a.toml", out=self.folder / "out", program=program)
            self.assertIs(type(found.exception), kind)

    def test_study_with_failed_runs_is_a_table_and_a_warning(self):
        (self.folder / "study.csv").write_text("run,x,y,status,message\n0,1,3,done,\n1,2,,failed,why\n")
        program = self.fake("echo 1 of 2 runs failed >&2; exit 2")
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            table = upbead.study("a.toml", out=self.folder, program=program)
        self.assertIn("1 runs failed", str(caught[0].message))
        self.assertEqual((len(table), list(table["y"]), table.failed[0]["message"]), (1, [3.0], "why"))

    def test_where_the_program_is_looked_for(self):
        program = self.fake("")
        with mock.patch.dict(os.environ, {"UPBEAD": str(program), "PATH": ""}):
            self.assertEqual(find(), str(program.resolve()))
        nowhere = self.folder / "no/upbead"
        beside = mock.patch.multiple("upbead.program", BESIDE=nowhere, INSTALLED=nowhere)
        with beside, mock.patch.dict(os.environ, {"UPBEAD": "/no/where", "PATH": str(self.folder)}):
            with self.assertRaises(upbead.UserError) as found:
                find()
            for place in ("UPBEAD: /no/where", f"beside the package: {self.folder}/no/upbead", "PATH: upbead"):
                self.assertIn(place, str(found.exception))
            program.rename(self.folder / "upbead")
            self.assertEqual(find(), str((self.folder / "upbead").resolve()))
        with self.assertRaisesRegex(upbead.UserError, "argument 'program': /no/where"):
            find("/no/where")


class Figures(InFolder):
    def test_notebook_shows_a_figure_and_pyplot_keeps_none(self):
        names = ("inertia_force", "caisson__displacement_x")
        result = upbead.open(write_result(self.folder / "a", **{f"history__{name}": TIME for name in names}))
        figure = upbead.figures.response(result)
        self.assertEqual(len(figure.axes), 4)
        self.assertTrue(figure._repr_png_().startswith(b"\x89PNG"))
        self.assertNotIn("matplotlib.pyplot", sys.modules)


    def test_measured_records_are_drawn_over_what_they_are_compared_with(self):
        tables = {f"history__{name}": TIME for name in ("inertia_force", "caisson__displacement_x")}
        tables |= {"measured__gauge__time": TIME[:4], "measured__gauge__value": 5e5 * TIME[:4]}
        figure = upbead.figures.response(upbead.open(write_result(self.folder / "a", **tables)))
        drawn = [[line for line in axes.lines if line.get_label() == "measured: gauge"] for axes in figure.axes]
        self.assertEqual([len(lines) for lines in drawn], [0, 0, 1, 0])
        self.assertIn("(kN/m)", figure.axes[2].get_ylabel())
        np.testing.assert_allclose(drawn[2][0].get_ydata(), 500 * TIME[:4])

    def test_peaks_are_marked_on_the_side_of_the_larger_force(self):
        """The ratio that is told is of that side."""
        time, swing = [0.0, 1.0, 2.0], np.array([0.0, -3.0, 2.0])
        for force, wanted in ((-5.0, (1.5, -3.1)), (1.0, (2.5, 2.2))):
            response = {"peak_force": 2.0, "peak_force_seaward": force, "peak_shear": 2.2, "peak_shear_time": 2.5,
                        "peak_shear_seaward": -3.1, "peak_shear_seaward_time": 1.5}  # fmt: skip
            result = types.SimpleNamespace(summary={"response": response}, time=time)
            self.assertEqual(reported.peak_of(result, "shear_force", swing), wanted)
            self.assertEqual(reported.peak_of(result, "inertia_force", swing)[1], -3.0 if force < 0 else 2.0)
            self.assertEqual(reported.peak_of(result, "inertia_force", abs(swing))[1], 3.0)

    def test_figure_and_report_draw_the_same_panels(self):
        tables = {f"history__{name}": 3e3 * TIME for name in ("inertia_force", "caisson__displacement_x", "probes__a_b__pressure", "probes__c__pressure")}
        result = upbead.open(write_result(self.folder / "a", **tables))
        told, figure = reported.plot(result, {}).data(), upbead.figures.response(result)
        self.assertEqual(len(figure.axes), len(told["panels"]))
        for axes, panel in zip(figure.axes, told["panels"]):
            self.assertTrue(axes.get_ylabel().endswith(f"({panel['unit']})"), axes.get_ylabel())
            np.testing.assert_allclose(axes.lines[0].get_ydata(), panel["lines"][0]["y"], rtol=1e-4)
            self.assertEqual([text.get_text().strip() for text in axes.texts], [mark["text"].strip() for mark in panel["marks"]])
        self.assertEqual(figure.axes[0].get_xlim(), tuple(told["window"]))
        (axes,) = upbead.figures.probes(result).axes
        self.assertEqual([line.get_label() for line in axes.lines[:2]], ["a b", "c"])

    def test_pressures_under_the_caisson_at_telling_times(self):
        pressure = np.outer(np.sin(3 * TIME), [3.0, 2.0, 1.0])
        result = upbead.open(write_result(self.folder / "a", base__position=[-1.0, 0.0, 1.0], base__length=TIME[:3],
                                          base__pore_pressure=pressure, base__shear_stress=-pressure))
        figure = upbead.figures.base_pressures(result)
        self.assertEqual([axes.get_ylabel() for axes in figure.axes], ["pore pressure (Pa)", "shear stress (Pa)"])
        np.testing.assert_array_equal(figure.axes[0].lines[0].get_ydata(), pressure[-1])  # where F_T is largest
        np.testing.assert_array_equal(figure.axes[1].lines[0].get_xdata(), [0.0])  # stresses are singular under the edges
        with self.assertRaisesRegex(upbead.UserError, "no table 'base'"):
            upbead.figures.base_pressures(upbead.open(write_result(self.folder / "b")))


class ParaView(InFolder):
    def state(self, fields, *words):
        """With stubs for ParaView, which is not installed; the names of fields are compared with those of the
        writer."""
        (self.folder / "fields.pvd").write_text("")
        simple = mock.MagicMock()
        reader = simple.PVDReader.return_value
        reader.TimestepValues, reader.GetDataInformation().GetBounds.return_value = [0.0, 1.0], (-9, 9, 0, 10, 0, 0)
        reader.PointData.__getitem__.return_value.GetRange.return_value = (-2.0, 0.1)
        reader.PointData.keys.return_value = fields
        reader.PointData.__getitem__.return_value.GetNumberOfComponents.return_value = 1
        modules = {"paraview": types.SimpleNamespace(simple=simple), "paraview.simple": simple}
        code = (SCRIPTS / "paraview_state.py").read_text(encoding="utf-8")
        with mock.patch.dict(sys.modules, modules), mock.patch.object(sys, "argv", ["state", str(self.folder), *words]):
            exec(compile(code, "paraview_state.py", "exec"), {"__name__": "__main__"})
        warped = simple.WarpByVector.return_value
        self.assertAlmostEqual(warped.ScaleFactor * 0.1, 0.03 * 10)
        asked = {warped.Vectors[1], simple.ColorBy.call_args[0][1][1]}
        writer = (SCRIPTS.parent / "src/output/fields.cc").read_text(encoding="utf-8")
        self.assertLessEqual(asked, set(re.findall(r'"([^"\n]+)"', writer)))
        return simple

    def test_every_field_that_is_written_can_colour(self):
        writer = (SCRIPTS.parent / "src/output/fields.cc").read_text(encoding="utf-8")
        written = sorted(set(re.findall(r'"(\w+_\((?:1|m|m_s|m_s2|Pa|Pa_s|J_m3)\))"', writer)))
        self.assertEqual(len(written), 16)
        state = (SCRIPTS / "paraview_state.py").read_text(encoding="utf-8")
        names = re.search(r"^DISPLACEMENT.*?^}\n", state, re.MULTILINE | re.DOTALL)[0]
        known = {}
        exec(compile(names, "paraview_state.py", "exec"), known)
        self.assertEqual(sorted(field for field, _, _ in known["COLOURED"].values()), written)
        for name, (field, _, colours) in known["COLOURED"].items():
            simple = self.state(written, "a.png", name)
            self.assertEqual(simple.ColorBy.call_args[0][1][1], field)
            low = -2.0 if colours == known["SIGNED"] else 0.0
            simple.GetColorTransferFunction.return_value.RescaleTransferFunction.assert_called_once_with(low, 2.0)

    def test_fields_of_a_void_run_say_so(self):
        (self.folder / "summary.json").write_text(json.dumps({"verdict": {"why_void": "load_cut"}}))
        self.assertIn("VOID, as the warnings say: load_cut", self.state(["pore_pressure_(Pa)"]).Text.call_args[1]["Text"])
        (self.folder / "summary.json").write_text(json.dumps({"verdict": {"why_void": None}}))
        self.assertNotIn("VOID", self.state(["pore_pressure_(Pa)"]).Text.call_args[1]["Text"])

    def test_state_asks_for_the_fields_that_are_written(self):
        scale = self.state(["pore_pressure_(Pa)"]).GetColorTransferFunction
        scale.assert_called_once_with("pore_pressure_(Pa)")
        scale.return_value.RescaleTransferFunction.assert_called_once_with(-2.0, 2.0)

    def test_where_soil_yields_its_strength_colours(self):
        fields = ["pore_pressure_(Pa)", "mobilised_strength_(1)", "dissipated_energy_(J_m3)"]
        scale = self.state(fields).GetColorTransferFunction
        scale.assert_called_once_with("mobilised_strength_(1)")
        scale.return_value.RescaleTransferFunction.assert_called_once_with(0.0, 2.0)
        self.state(fields, "a.png", "dissipated").GetColorTransferFunction.assert_called_once_with(fields[2])
        with self.assertRaisesRegex(SystemExit, "no soil yields"):
            self.state(fields[:1], "a.png", "dissipated")


class Versions(unittest.TestCase):
    def test_package_has_the_version_of_the_program(self):
        cmake = (SCRIPTS.parent / "CMakeLists.txt").read_text(encoding="utf-8")
        program = re.search(r"project\(upbead VERSION ([\d.]+)", cmake).group(1)
        self.assertIn(f'version = "{program}"', (SCRIPTS / "pyproject.toml").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
