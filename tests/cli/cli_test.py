#!/usr/bin/python3
"""The program as a person meets it: exit codes, messages, files that appear whole or not at all.

usage: cli_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import pty
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from hand_made_model import write_oscillator  # noqa: E402

PROGRAM, CASES = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
QUICK = ["--set", "mesh.parameters.cells=0.5", "--set", "time.end=0.05"]


def upbead(*arguments, cwd=None, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, **options)


class Cli(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_model(self, *arguments, **options):
        return upbead("run", CASES / "fig2b-model.toml", *QUICK, *arguments, cwd=self.folder, **options)

    def left_behind(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))

    def test_help_teaches_by_example(self):
        for arguments, example in ((["--help"], "upbead run cases/"), (["run", "--help"], "upbead run cases/"),
                                   (["explain", "--help"], "upbead explain cases/"),
                                   (["respond", "--help"], "upbead respond results/")):
            done = upbead(*arguments)
            self.assertEqual(done.returncode, 0)
            self.assertIn(example, done.stdout)

    def test_no_command_is_an_error_of_the_user(self):
        self.assertEqual(upbead().returncode, 1)
        self.assertEqual(upbead("runn").returncode, 1)
        self.assertEqual(upbead("run").returncode, 1)

    def test_unknown_command_is_named_with_the_nearest(self):
        done = upbead("rum", "case.toml")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr, "there is no command 'rum'; did you mean 'run'?\n")

    def test_memory_that_does_not_suffice(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (800 * 2**20,) * 2)
        done = self.run_model("--set", "time.step=6e-8", preexec_fn=limit)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("does not fit in memory; use a coarser mesh, larger steps or fewer fields", done.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_interrupted_run_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen([PROGRAM, "run", CASES / "fig2b-model.toml", *QUICK, "--set", "time.step=1e-6"],
                                       cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            process.stdout.readline()  # the folder is made, the march about to begin
            process.send_signal(number)
            errors = process.communicate()[1]
            self.assertEqual(process.returncode, 128 + number, errors)
            self.assertIn(b"interrupted", errors)
            self.assertEqual(self.left_behind(), [])

    def test_gmsh_is_kept_from_impossible_meshes(self):
        for setting in ("cells=1e4", "grading=1e4"):
            done = upbead("explain", CASES / "fig2b-model.toml", "--set", f"mesh.parameters.{setting}")
            self.assertEqual(done.returncode, 1)
            self.assertIn("must be at most", done.stderr)

    def test_run_writes_three_files_that_other_programs_read(self):
        done = self.run_model()
        self.assertEqual((done.returncode, done.stderr), (0, ""), "no progress where nobody watches")
        result = self.folder / "results/fig2b-model"
        self.assertEqual(sorted(os.listdir(result)), ["case.toml", "results.h5", "summary.json"])
        summary = json.loads((result / "summary.json").read_text())
        with h5py.File(result / "results.h5") as file:
            history = file["history"]
            n = len(history["time"])
            self.assertEqual(n, summary["discretisation"]["steps"] + 1)
            for name in ("force", "shear_force", "inertia_force", "caisson/displacement_x", "caisson/displacement_y",
                         "caisson/rotation", "caisson/velocity_x", "caisson/acceleration_x",
                         "probes/in_sand/displacement_x", "probes/in_sand/pressure",
                         "probes/in_sand/effective_stress_yy", "probes/in_sand/strain_xy"):
                self.assertEqual(len(history[name]), n, name)
                self.assertTrue(history[name].attrs["unit"] and history[name].attrs["description"], name)
            self.assertLessEqual(max(history["shear_force"]), summary["response"]["peak_shear"] * (1 + 1e-12))

    def test_effective_case_runs_again_with_the_same_answer(self):
        self.run_model("--out", "first")
        again = upbead("run", self.folder / "first/case.toml", "--json", "--out", "second", cwd=self.folder)
        self.assertEqual(again.returncode, 0, again.stderr)
        first = json.loads((self.folder / "first/summary.json").read_text())
        self.assertEqual(json.loads(again.stdout)["response"], first["response"])

    def test_json_is_all_that_is_printed(self):
        done = self.run_model("--json")
        self.assertEqual(done.stdout, (self.folder / "results/fig2b-model/summary.json").read_text())

    def test_explain_writes_nothing(self):
        done = upbead("explain", CASES / "fig2b-model.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("seabed", "darcy", "mound", "inertial", "arm 0.4 m", "skipped"):
            self.assertIn(word, done.stdout)
        self.assertEqual(self.left_behind(), [])

    def test_fields_open_in_paraview(self):
        done = self.run_model("--set", "output.fields.every=0.025")
        self.assertEqual(done.returncode, 0, done.stderr)
        result = self.folder / "results/fig2b-model"
        record = (result / "fields.pvd").read_text()
        files = sorted(os.listdir(result / "fields"))
        self.assertEqual(len(files), 3)
        for name in files:
            self.assertIn("fields/" + name, record)
        head = (result / "fields" / files[-1]).read_text(errors="replace")
        for name in ("displacement_(m)", "pore_pressure_(Pa)", "effective_stress_yy_(Pa)"):
            self.assertIn(name, head)
        self.assertIn("case.toml, fields.pvd}", done.stdout)
        (result / "fields/mine.vtu").write_text("mine")
        self.run_model()
        self.assertEqual(sorted(os.listdir(result)), ["case.toml", "fields", "results.h5", "summary.json"])
        self.assertEqual(os.listdir(result / "fields"), ["mine.vtu"], "no older fields beside newer results")

    def test_shipped_cases_hold_their_identities_and_ratios(self):
        """Both routes to F_T and the energy to 1e-8 with both schemes; 0.75 is calibrated, the prototype within its band."""
        for case, low, high in (("fig2b-model", 0.745, 0.755), ("fig2b-prototype", 0.38, 0.48)):
            for scheme in ("sdirk4", "generalised_alpha"):
                done = upbead("run", CASES / f"{case}.toml", "--json", "--set", f"time.scheme={scheme}", cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                response = json.loads(done.stdout)["response"]
                self.assertLessEqual(response["reaction_mismatch"], 1e-8)
                self.assertLessEqual(response["energy_mismatch"], 1e-8)
                self.assertTrue(low < response["shear_to_force_ratio"] < high, response["shear_to_force_ratio"])

    def test_reference_of_keys_is_current(self):
        text = (CASES.parent / "docs/case.md").read_text()
        self.assertTrue(text.endswith(upbead("explain", "--keys").stdout), "run upbead explain --keys into docs/case.md")

    def test_wrong_input_leaves_an_old_result_as_it_was(self):
        self.run_model()
        before = {path: path.stat().st_mtime_ns for path in self.folder.rglob("*")}
        done = self.run_model("--set", "regions.mound.porosity=2")
        self.assertEqual(done.returncode, 1)
        self.assertIn("porosity", done.stderr)
        self.assertEqual(before, {path: path.stat().st_mtime_ns for path in self.folder.rglob("*")})

    def test_mesh_that_does_not_fit_the_case(self):
        case = (CASES / "fig2b-model.toml").read_text().replace('[regions.seabed]', '[regions.sand]')
        case = case.replace('top = {', 'lid = {')
        (self.folder / "case.toml").write_text(case)
        for name in ("impulse", "slow"):
            shutil.copy(CASES / f"fig2b-model-{name}.csv", self.folder)
        done = upbead("run", "case.toml", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        for part in ("case.toml:", "surface 'seabed'", "add a table [regions.seabed]", "no surface 'sand'",
                     "outer curve 'top'", "no outer curve 'lid'"):
            self.assertIn(part, done.stderr)
        self.assertFalse((self.folder / "results").exists())

    def test_full_disk(self):
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        done = self.run_model(preexec_fn=limit)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("--out DIR", done.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_no_right_to_write(self):
        done = self.run_model("--out", "/proc/upbead")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/proc/upbead", done.stderr)
        self.assertIn("--out DIR", done.stderr)

    def test_file_in_the_folders_place(self):
        (self.folder / "taken").write_text("mine")
        done = self.run_model("--out", "taken")
        self.assertEqual(done.returncode, 1)
        self.assertIn("taken", done.stderr)
        self.assertEqual((self.folder / "taken").read_text(), "mine")

    def respond(self, *arguments):
        return upbead("respond", *arguments, cwd=self.folder)

    def make_model_and_waves(self, **changes):
        write_oscillator(self.folder / "model.h5", **changes)
        (self.folder / "roof.csv").write_text("time,P\n0,0\n0.05,1.6e6\n0.1,4e5\n1.5,0\n")
        time = np.arange(401) * 1e-3
        with h5py.File(self.folder / "storm.h5", "w") as file:
            file["time"] = time
            file["impact"] = np.outer(np.linspace(1e5, 2e6, 30), np.interp(time, [0, 0.075, 0.15], [0, 1, 0]))

    def test_respond_answers_one_wave_and_many(self):
        self.make_model_and_waves()
        friction = ["--friction", 0.6, "--buoyant-weight", 1e6]
        done = self.respond("model.h5", "roof.csv", "storm.h5", *friction)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for part in ("oscillator, reduced to 2 modes", "waves       31", "peak F_T", "largest in storm[29]",
                     "of them slide the caisson", "written     results/model-respond/{responses.h5, summary.json}"):
            self.assertIn(part, done.stdout)
        result = self.folder / "results/model-respond"
        self.assertEqual(sorted(os.listdir(result)), ["responses.h5", "summary.json"])
        summary = json.loads((result / "summary.json").read_text())
        self.assertEqual([w["name"] for w in summary["waves"][:3]], ["roof", "storm[0]", "storm[1]"])
        with h5py.File(result / "responses.h5") as file:
            self.assertEqual(file["storm/shear_force"].shape, (30, len(file["storm/time"])))
            for name in ("time", "force", "shear_force", "peak_force", "peak_shear", "peak_shear_seaward",
                         "peak_shear_time", "ratio", "beyond_band", "sliding"):
                self.assertTrue(file["storm"][name].attrs["unit"] and file["storm"][name].attrs["description"], name)
            self.assertEqual([w["sliding"] for w in summary["waves"]], [*file["roof/sliding"], *file["storm/sliding"]])
            np.testing.assert_allclose(file["storm/ratio"], file["storm/ratio"][0], rtol=1e-12)
            self.assertAlmostEqual(file["storm/time"][-1], 4.0)
        again = self.respond("model.h5", "roof.csv", "storm.h5", *friction, "--out", "again")
        self.assertEqual(again.returncode, 0)
        self.assertEqual((result / "responses.h5").read_bytes(), (self.folder / "again/responses.h5").read_bytes())

    def test_respond_prints_a_table_or_json(self):
        self.make_model_and_waves()
        done = self.respond("model.h5", "roof.csv", "roof.csv", "--end", 1)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"wave +peak P +peak F_T +F_T / P\nroof +1.6 MN/m .*\nroof-2 +1.6 MN/m ")
        done = self.respond("model.h5", "roof.csv", "--json")
        summary = json.loads(done.stdout)
        self.assertEqual(summary["model"], {"title": "oscillator", "file": "model.h5", "error": 0.004,
                                            "tolerance": 0.01, "highest_frequency": 50.0})
        self.assertIsNone(summary["waves"][0]["sliding"])
        self.assertEqual(list(summary["timing"]), ["read", "respond", "write", "total"])
        self.assertGreater(summary["histories_per_second"], 0)

    def test_respond_warns_of_waves_that_the_model_does_not_cover(self):
        self.make_model_and_waves(highest=3.0)
        done = self.respond("model.h5", "roof.csv")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^warning: 1 of 1 waves reach beyond .* 3 Hz: worst roof, where .* % of F_T .*"
                                      r"\(tolerance 1 %\); reduce again .* or march it with 'upbead run'\n$")

    def test_respond_refuses_wrong_input_and_writes_nothing(self):
        self.make_model_and_waves(loads=("impact", "slow"))
        before = self.left_behind()
        for arguments, message in (
                (["model.h5", "roof.csv"], "column 'P' is no load of the model; the model's loads are: impact, slow"),
                (["roof.csv", "roof.csv"], "roof.csv: no HDF5 file; give a model made by 'upbead reduce'"),
                (["storm.h5", "roof.csv"], "storm.h5: an HDF5 file, but no reduced model"),
                (["model.h5", "none.csv"], "cannot read 'none.csv'"),
                (["model.h5", "storm.h5", "--friction", 0.6], "give --buoyant-weight too (N/m)"),
                (["model.h5", "storm.h5", "--buoyant-weight", 1e6], "give --friction too"),
                (["model.h5", "storm.h5", "--end", 0], "--end 0 is not above 0"),
                (["model.h5", "storm.h5", "--end", 1e9], "lower --end")):
            done = self.respond(*arguments)
            self.assertEqual((done.returncode, done.stdout), (1, ""), arguments)
            self.assertIn(message, done.stderr)
            self.assertEqual(self.left_behind(), before)
        write_oscillator(self.folder / "model.h5", mass=0.0)
        done = self.respond("model.h5", "storm.h5", "--friction", 0.6, "--buoyant-weight", 1e6)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nothing can slide", done.stderr)

    def test_progress_is_one_line_on_a_terminal(self):
        leader, follower = pty.openpty()
        process = subprocess.Popen(
            [PROGRAM, "run", CASES / "fig2b-model.toml", "--set", "time.step=1e-4", "--set", "mesh.parameters.cells=0.5"],
            cwd=self.folder, stdout=subprocess.DEVNULL, stderr=follower)
        os.close(follower)
        text = b""
        try:
            while chunk := os.read(leader, 4096):
                text += chunk
        except OSError:  # the terminal closes when the program ends
            pass
        self.assertEqual(process.wait(), 0)
        self.assertIn(b"marching", text)
        self.assertIn(b"%", text)
        self.assertNotIn(b"\n", text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
