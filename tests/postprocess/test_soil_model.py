"""SoilModel: answers are those of the program, gradients are those of the equations, refusals are exceptions that leave
the model usable, and copies in other processes have children of their own.

usage: test_soil_model.py FOLDER_OF_THE_SCRIPTS PROGRAM PROGRAM_THAT_WRITES_A_MODEL
"""

import json
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

SCRIPTS, PROGRAM, WRITER = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(SCRIPTS))
import upbead  # noqa: E402
from upbead.soil_gradient import gradient  # noqa: E402

G, K = "regions.sand.shear_modulus", "regions.sand.hydraulic_conductivity"
SOIL = {G: 5e7, K: 0.3}
TIME = np.linspace(0.0, 1.0, 201)
WAVE = (TIME, {"impact": 1.6e6 * np.interp(TIME, [0, 0.075, 0.15], [0, 1, 0])})


def shear_in_time(soil, time):
    """F_T under WAVE at equal steps by the exact exponential of the equations' first-order form."""
    from scipy.linalg import expm

    mass, damping = np.diag([6e5, 1e5, -1e-9]), np.array([[2e6, -1e6, 0], [-1e6, 3e6, 1.0], [0, 1.0, -0.5 * soil[K] / 1e4]])
    stiffness = soil[G] * np.array([[5.0, -5.0, 0], [-5.0, 8.0, 0], [0, 0, 0]])
    inverse = np.linalg.inv(mass)
    A = np.block([[np.zeros((3, 3)), np.eye(3)], [-inverse @ stiffness, -inverse @ damping]])
    b = np.concatenate([np.zeros(3), inverse @ [1.0, 0.0, 0.0]])
    h = time[1] - time[0]
    force = np.interp(time, WAVE[0], WAVE[1]["impact"])
    full = np.zeros((8, 8))  # z' = A z + b f, f' = slope
    full[:6, :6], full[:6, 6], full[6, 7] = A, b, 1.0
    step = expm(full * h)
    z, shear = np.zeros(6), []
    for n, f in enumerate(force):
        shear.append(f - 6e5 * (A @ z + b * f)[3])
        if n + 1 < len(force):
            z = (step @ np.concatenate([z, [f, (force[n + 1] - f) / h]]))[:6]
    return np.array(shear)


def of_peak(model, soil):
    return model.respond(WAVE, soil).peak_shear


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.path = self.folder / "soils.h5"
        subprocess.run([WRITER, self.path], check=True)
        (self.folder / "roof.csv").write_text("time,impact\n0,0\n0.05,1.6e6\n0.1,4e5\n1.5,0\n")

    def void_wave(self):
        path = self.folder / "nothing.csv"
        path.write_text("time,impact\n0,0\n1,0\n")
        return path

    def model(self, **options):
        model = upbead.SoilModel(self.path, program=PROGRAM, **options)
        self.addCleanup(model.close)
        return model


class Answers(Case):
    def test_a_void_answer_says_so(self):
        model = self.model()
        self.assertEqual((model.respond(self.void_wave(), {}).why_void, model.respond(WAVE, {}).why_void), ("load_zero", None))

    def test_tells_its_box_and_readings(self):
        model = self.model()
        self.assertEqual(model.box, {G: (1e7, 1e8, True), K: (1e-2, 1.0, True)})
        self.assertEqual((model.loads, model.readings), (["impact", "slow"], ["shear_force", "probes/A/pressure", "force"]))

    def test_is_what_the_program_says(self):
        model, wave = self.model(histories=["shear_force"], friction=0.6, buoyant_weight=1e6), self.folder / "roof.csv"
        answer = model.respond(wave, {G: 5e7})
        done = subprocess.run([PROGRAM, "respond", self.path, wave, "--soil", f"{G}=5e7", "--friction", "0.6", "--buoyant-weight", "1e6",
                               "--json", "--out", self.folder / "out"], capture_output=True, text=True, check=True)
        [told] = json.loads(done.stdout)["waves"]
        self.assertEqual((answer.soil, answer.name), ({G: 5e7, K: 0.2}, "roof"))
        self.assertEqual(answer.waves[0].numbers, {key: value for key, value in told.items() if key != "name"})
        self.assertGreater(answer.sliding, 0)
        self.assertEqual(answer.histories["shear_force"].shape, answer.time.shape)

    def test_a_wave_may_be_a_table(self):
        answer = self.model(histories=["shear_force", "force"]).respond(WAVE, SOIL)
        exact = shear_in_time(SOIL, answer.time)
        self.assertLess(np.abs(answer.histories["shear_force"] - exact).max(), 1e-6 * exact.max())
        np.testing.assert_allclose(answer.histories["force"], np.interp(answer.time, *WAVE[:1], WAVE[1]["impact"]), atol=1e-6)
        self.assertAlmostEqual(answer.ratio, answer.peak_shear / 1.6e6, 12)

    def test_a_table_may_hold_several_waves(self):
        answer = self.model().respond((TIME, {"impact": np.outer([1.0, 2.0], WAVE[1]["impact"])}), SOIL)
        self.assertAlmostEqual(answer.waves[1].peak_shear / answer.waves[0].peak_shear, 2.0, 9)
        with self.assertRaisesRegex(AttributeError, "there are 2: take that of waves"):
            print(answer.ratio)

    def test_answers_many_at_once_and_keeps_what_is_refused(self):
        soils = [{G: value} for value in (2e7, 3e7, 2e9, 4e7, 5e7)]
        found = self.model(jobs=2).respond_all(WAVE, soils)
        self.assertEqual([type(one).__name__ for one in found], ["SoilAnswer", "SoilAnswer", "SoilError", "SoilAnswer", "SoilAnswer"])
        self.assertEqual([one.soil[G] for one in found], [soil[G] for soil in soils])


class Gradients(Case):
    def test_are_those_of_the_equations(self):
        model, h = self.model(histories=["shear_force"]), 1e-4
        for soil in (SOIL, {G: 1e7, K: 1.0}):  # inside, and in a corner of the box
            found = model.gradient(WAVE, soil, lambda answer: answer.histories["shear_force"])
            time = model.respond(WAVE, soil).time
            for key in SOIL:
                exact = (shear_in_time({**soil, key: soil[key] * np.exp(h)}, time)
                         - shear_in_time({**soil, key: soil[key] * np.exp(-h)}, time)) / (2 * h)
                self.assertLess(np.abs(found.value[key] - exact).max(), found.of_steps[key] + 1e-6 * np.abs(exact).max(), key)
            largest = np.abs(found.value[G]).max()
            self.assertLess(found.of_steps[G], 0.01 * largest)
            self.assertTrue(all(found.logarithmic.values()) and all(0 < step <= 0.1 for step in found.step.values()))

    def test_err_by_what_the_model_errs_by(self):
        box = {"a": (1.0, 100.0, True), "b": (0.0, 4.0, False)}
        found = gradient(box, {"a": 10.0, "b": 2.0}, lambda soil: 3.0 * np.log(soil["a"]) + soil["b"], known_to=5.0)
        for key, slope, error in (("a", 3.0, 5.0), ("b", 1.0, 5.0 / 4.0)):
            self.assertAlmostEqual(found.value[key], slope, 9)
            self.assertAlmostEqual(found.error[key] - found.of_steps[key], error, 12)

    def test_of_a_number_by_its_name(self):
        found = self.model().gradient(WAVE, SOIL, "peak_shear")
        self.assertIsInstance(found.value[G], float)
        self.assertNotEqual(found.value[G], 0.0)
        with self.assertRaisesRegex(upbead.UserError, "'sliding' is no number"):
            self.model().gradient(WAVE, SOIL, "sliding")


class Refusals(Case):
    def test_of_soils_leave_the_model_usable(self):
        model = self.model()
        for soil, text in (({G: 1e9}, "outside the box"), ({"regions.sand.porosity": 0.3}, "no key that the model varies"),
                           ({G: float("nan")}, "is no finite number")):
            with self.assertRaisesRegex(upbead.SoilError, text) as caught:
                model.respond(WAVE, soil)
            self.assertEqual(list(caught.exception.soil), list(soil))
        self.assertGreater(of_peak(model, SOIL), 0)
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((str(again), list(again.soil)), (str(caught.exception), [G]))

    def test_of_files_and_options(self):
        with self.assertRaisesRegex(upbead.CaseError, "cannot read 'none.csv'|none.csv"):
            self.model().respond("none.csv", SOIL)
        with self.assertRaisesRegex(upbead.CaseError, "give --buoyant-weight too"):
            self.model(friction=0.6).respond(WAVE, SOIL)
        with self.assertRaisesRegex(upbead.UserError, "no reading 'shear'; it has shear_force"):
            self.model(histories=["shear"])
        with self.assertRaises(upbead.ModelError):
            upbead.SoilModel(self.folder / "roof.csv")
        with self.assertRaisesRegex(upbead.CaseError, "load"):
            self.model().respond((TIME, {"swell": TIME}), SOIL)


class Processes(Case):
    def test_copies_have_children_of_their_own(self):
        model = self.model()
        expected = of_peak(model, SOIL)
        self.assertEqual(of_peak(pickle.loads(pickle.dumps(model)), SOIL), expected)
        with multiprocessing.get_context("fork").Pool(2) as pool:
            self.assertEqual(pool.starmap(of_peak, 4 * [(model, SOIL)]), 4 * [expected])
        read, write = os.pipe()
        child = os.fork()
        if child == 0:  # the model itself, as memory is copied
            os.write(write, repr(of_peak(model, SOIL)).encode())
            os._exit(0)
        os.waitpid(child, 0)
        self.assertEqual(float(os.read(read, 100)), expected)
        self.assertEqual(of_peak(model, {G: 4e7}), of_peak(self.model(), {G: 4e7}), "the parent's is not disturbed")

    def test_a_disturbed_child_is_replaced(self):
        model = self.model()
        expected = of_peak(model, SOIL)
        [server] = next(iter(model.servers.values())).idle
        os.kill(server.process.pid, signal.SIGKILL)
        server.process.wait()
        with self.assertRaisesRegex(upbead.UpbeadError, "exit code -9"):
            of_peak(model, SOIL)
        self.assertEqual(of_peak(model, SOIL), expected)

    def test_an_interrupt_does_not_mix_up_answers(self):
        model = self.model()
        of_peak(model, SOIL)
        servers = next(iter(model.servers.values()))
        [server] = servers.idle
        server.process.stdout = Interrupting(server.process.stdout)
        with self.assertRaises(KeyboardInterrupt):
            of_peak(model, {G: 2e7})
        self.assertEqual(model.respond(WAVE, SOIL).soil, SOIL)

    def test_close_ends_the_children_and_no_folder_stays(self):
        before = set(Path(tempfile.gettempdir()).glob("upbead-wave-*"))
        with self.model() as model:
            of_peak(model, SOIL)
            [server] = next(iter(model.servers.values())).idle
            self.assertIsNone(server.process.poll())
        self.assertIsNotNone(server.process.poll())
        self.assertEqual(set(Path(tempfile.gettempdir()).glob("upbead-wave-*")), before)


class Interrupting:
    """A stream that is interrupted before a line is read."""

    def __init__(self, stream):
        self.stream = stream

    def readline(self):
        raise KeyboardInterrupt

    def close(self):
        self.stream.close()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
