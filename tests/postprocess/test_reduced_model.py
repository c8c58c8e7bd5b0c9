"""The script that reads reduced models computes the program's numbers.

usage: test_reduced_model.py FOLDER_OF_THE_SCRIPTS PROGRAM
"""

import gzip
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from scripts import call

SCRIPTS, PROGRAM = Path(sys.argv[1]), Path(sys.argv[2])
sys.path[:0] = [str(SCRIPTS), str(Path(__file__).parents[1] / "support")]
from hand_made_model import write_oscillator  # noqa: E402
from reduced_model import ModelError, ReducedModel, phi_functions, read_wave  # noqa: E402


class ReducedModels(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.path = self.folder / "model.h5"
        write_oscillator(self.path, ("impact", "slow"))

    def program_answers(self, wave):
        done = subprocess.run([PROGRAM, "respond", self.path, wave, "--out", self.folder / "out"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        with h5py.File(self.folder / "out/responses.h5") as file:
            return {name: data[()] for name, data in file[wave.stem].items()}

    def script(self, *arguments):
        return call(SCRIPTS / "reduced_model.py", *arguments)

    def write_wave(self, time):
        wave = self.folder / "wave.csv"
        impact, slow = 1.6e6 * np.interp(time, [0, 0.075, 0.15], [0, 1, 0]), 3e5 * np.sin(20 * time) ** 2
        slow[-1] = 0.0
        np.savetxt(wave, np.c_[time, impact, slow], "%.17g", ",", header="time,impact,slow", comments="")
        return wave, {"impact": impact, "slow": slow}

    def assert_same(self, wave, time, loads):
        known = self.program_answers(wave)
        loads = {name: np.interp(known["time"], time, values, right=0.0) for name, values in loads.items()}
        answer = ReducedModel(self.path).respond(known["time"], loads)
        for name in ("force", "shear_force"):
            error = np.abs(answer[name] - known[name][0]).max()
            self.assertLess(error, 1e-10 * np.abs(known[name]).max(), name)

    def test_same_numbers_on_equal_steps(self):
        time = np.arange(1001) * 5e-4
        wave, loads = self.write_wave(time)
        self.assert_same(wave, time, loads)

    def test_same_numbers_on_any_steps(self):
        time = np.r_[0.0, np.sort(np.random.default_rng(1).uniform(0, 0.5, 60)), 0.5]
        wave, loads = self.write_wave(time)
        self.assert_same(wave, time, loads)

    def test_same_error_estimate(self):
        for nested, expected in (((1.02, 1.03), 1.2 * 0.03 + 1.5 * 0.01), ((1.0, 1.0), 0.0), (None, None)):
            self.path.unlink()
            write_oscillator(self.path, ("impact", "slow"), nested=nested)
            time = np.arange(1001) * 5e-4
            wave, loads = self.write_wave(time)
            known, model = self.program_answers(wave), ReducedModel(self.path)
            loads = {name: np.interp(known["time"], time, values, right=0.0) for name, values in loads.items()}
            found = model.error_estimate(known["time"], loads)
            if nested is None:
                self.assertIsNone(found)
                self.assertNotIn("error_estimate", known)
            else:
                self.assertAlmostEqual(found, expected, delta=1e-9)
                self.assertAlmostEqual(known["error_estimate"][0], expected, delta=1e-4)

    def test_transfer_function_is_that_of_the_oscillator(self):
        s = 2j * np.pi * np.array([0.1, 2.0, 30.0])
        spring = (4 * np.pi) ** 2 + 2 * 0.15 * 4 * np.pi * s
        model = ReducedModel(self.path)
        model.reading[1, 1] = 0.0  # the mode without physical meaning
        np.testing.assert_allclose(model.transfer("shear_force", "slow", [0.1, 2.0, 30.0]), spring / (s**2 + spring))

    def test_the_time_is_the_column_that_says_so(self):
        model = ReducedModel(self.path)
        wave = self.folder / "counted.csv"
        wave.write_text("Part,Time [ms],slow [kN/m],impact / MN/m\n0,0,0,0\n1,75,2,1.6\n2,150,0,0\n")
        time, loads = read_wave(wave, model)
        np.testing.assert_allclose(time, [0, 0.075, 0.15])
        np.testing.assert_allclose(loads["slow"], [0, 2e3, 0])
        np.testing.assert_allclose(loads["impact"], [0, 1.6e6, 0])
        self.assert_same(wave, time, loads)
        for text, words in (("Part,slow\n0,0\n1,1\n", "is a counter"), ("Time,Time,slow\n0,0,0\n1,2,1\n", "differ"),
                            ("t,slow (mm)\n0,0\n1,1\n", "the unit 'mm'"), ("t,slow (kPa)\n0,0\n1,1\n", "the unit 'kPa'"),
                            ("t,slow (ms)\n0,0\n1,1\n", "the unit 'ms'"), ("t,slow_kN\n0,0\n1,1\n", "the unit 'kN' in the name"),
                            ("t (kN/m),slow\n0,0\n1,1\n", "the unit 'kN/m'"), ("t,slow,slow\n0,0,1\n1,1,0\n", "two columns")):
            wave.write_text(text)
            with self.assertRaisesRegex(ModelError, words):
                read_wave(wave, model)

    def test_a_table_is_read_as_the_program_reads_it(self):
        self.path.unlink()
        write_oscillator(self.path, ("impact",))
        head, rows = "time,impact", ("0,0", "0.075,1600", "0.15,0.5", "0.5,0")
        tables = {"names": ("time (s),force_N_per_m", rows), "ends": ("time_s,impact_kN_per_m", rows), "capitals": ("t,F_KN_M", rows), "old": ("t,impact_tf_m", rows),
                  "comment": ("# a laboratory\n# time,impact (kgf/cm)", rows), "below": (f"{head}\ns,kN/m", rows), "none": (None, rows),
                  "semicolons": ("Zeit / s;impact [kN/m]", [row.replace(",", ";").replace(".", ",") for row in rows]),
                  "named": ("sep=;\ntime;impact", [row.replace(",", ";") for row in rows]), "tabs": ("time\timpact", [row.replace(",", "\t") for row in rows]),
                  "blanks": ("time impact", [row.replace(",", "  ") for row in rows]), "fortran": (head, ("0,0", "7.5D-2,1.6D3", "0.15,5D-1", "0.5,0"))}
        for name, (above, below) in tables.items():
            wave = self.folder / f"{name}.csv"
            wave.write_text("\n".join([*([above] if above else []), *below]) + "\n")
            with self.subTest(name):
                self.assert_same(wave, *read_wave(wave, ReducedModel(self.path)))
        packed = self.folder / "packed.csv.gz"
        packed.write_bytes(gzip.compress("\n".join(("time,impact", *rows)).encode()))
        np.testing.assert_array_equal(read_wave(packed, ReducedModel(self.path))[1]["impact"], [0, 1600, 0.5, 0])

    def test_a_table_that_is_not_read_says_where_and_what_to_do(self):
        wave = self.folder / "wave.csv"
        for text, words in (("t;impact\n0;1.250\n1;2.500\n", ":2: in '1.250' point and comma .*; write decimal points"),
                            ("t;impact\n0;0,5\n1;0.5\n", "point and comma"), ("t,impact\n0,0\n1,1,2\n", ":3: 3 cells where other rows have 2; give"),
                            ("t,impact\n0,0\n1,\n", ":3: a cell of 1,  is no finite number; give"), ("t,impact\n1,0\n0,1\n", ":3: t = 0 s follows no earlier time; give"),
                            ("t,impact\n-1,0\n0,1\n", ":2: the wave starts at t = -1 s, before the response; let it"), ("hello\n", "no row holds two numbers; give")):
            wave.write_text(text)
            with self.assertRaisesRegex(ModelError, words):
                read_wave(wave, ReducedModel(self.path))

    def test_peaks_between_the_times_are_those_of_the_program(self):
        """At the corners of a load alone, which are far from its peaks."""
        time, impact = np.array([0.0, 0.075, 0.15, 0.5]), np.array([0.0, 1.6e6, 0.0, 0.0])
        model, wave = ReducedModel(self.path), self.folder / "wave.csv"
        np.savetxt(wave, np.c_[time, impact], "%.17g", ",", header="time,impact", comments="")
        self.program_answers(wave)
        known = json.loads((self.folder / "out/summary.json").read_text())["waves"][0]
        found = model.peaks(time, {"impact": impact})
        self.assertLess(max(model.respond(time, {"impact": impact})["shear_force"]), 0.98 * known["peak_shear"])
        self.assertAlmostEqual(found.largest / known["peak_shear"], 1.0, delta=1e-4)
        self.assertAlmostEqual(found.least / known["peak_shear_seaward"], 1.0, delta=1e-4)
        self.assertAlmostEqual(found.largest_time, known["peak_shear_time"], delta=1e-3)
        fine = np.union1d(np.linspace(0.0, 0.5, 20001), time)
        for reading, values in model.respond(fine, {"impact": np.interp(fine, time, impact)}).items():
            found = model.peaks(time, {"impact": impact}, reading)
            np.testing.assert_allclose([found.largest, found.least], [values.max(), values.min()], rtol=1e-6, atol=1e-9 * np.abs(values).max(), err_msg=reading)
        with self.assertRaisesRegex(ModelError, "no reading 'x'"):
            model.peaks(time, {"impact": impact}, "x")

    def test_a_jump_at_the_begin_counts_in_the_peak(self):
        found = ReducedModel(self.path).peaks([0.0, 1.0], {"impact": [3e5, 0.0]}, "force")
        self.assertEqual((found.largest, found.largest_time), (3e5, 0.0))

    def test_phi_functions_agree_where_series_and_formula_meet(self):
        below, above = phi_functions(np.array([0.5 - 1e-9 + 0j])), phi_functions(np.array([0.5 + 1e-9 + 0j]))
        np.testing.assert_allclose(below, above, rtol=1e-8)
        np.testing.assert_allclose(phi_functions(np.zeros(1, dtype=complex)), [[1.0], [1.0], [0.5]])

    def test_questions_that_do_not_fit(self):
        model = ReducedModel(self.path)
        with self.assertRaisesRegex(ModelError, "'p' is no load of the model; its loads are: impact, slow"):
            model.respond([0.0, 1.0], {"p": [0.0, 1.0]})
        with self.assertRaisesRegex(ModelError, "begin with 0"):
            model.respond([0.1, 1.0], {"impact": [0.0, 1.0]})
        with self.assertRaisesRegex(ModelError, "not as many values"):
            model.respond([0.0, 1.0], {"impact": [0.0]})

    def test_figure(self):
        wave = self.write_wave(np.arange(301) * 1e-3)[0]
        done = self.script(self.path, wave)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "wave.png").read_bytes().startswith(b"\x89PNG"))
        done = self.script(self.path, wave, "--reading", "caisson/displacement_x", "--out", self.folder / "x.svg")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_script_tells_what_is_wrong(self):
        wave = self.write_wave(np.arange(301) * 1e-3)[0]
        for arguments, message in (([wave, wave], "cannot be read as a reduced model"),
                                   ([self.path, self.path], "cannot be read as a table"),
                                   ([self.path, wave, "--reading", "x"], "the model has no reading 'x', but: force")):
            done = self.script(*arguments)
            self.assertEqual(done.returncode, 1)
            self.assertIn(message, done.stderr)
            self.assertNotIn("Traceback", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
