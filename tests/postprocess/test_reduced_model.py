"""The script that reads reduced models computes the program's numbers.

usage: test_reduced_model.py FOLDER_OF_THE_SCRIPTS PROGRAM
"""

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
                            ("t,slow (ms)\n0,0\n1,1\n", "the unit 'ms'"), ("t,slow_kN_m\n0,0\n1,1\n", "the unit 'kN' in the name"),
                            ("t (kN/m),slow\n0,0\n1,1\n", "the unit 'kN/m'"), ("t,slow,slow\n0,0,1\n1,1,0\n", "two columns")):
            wave.write_text(text)
            with self.assertRaisesRegex(ModelError, words):
                read_wave(wave, model)

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
