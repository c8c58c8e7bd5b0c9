#!/usr/bin/python3
"""The program as a user runs it: exit codes, messages, files that appear complete or not at all.

usage: cli_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import unittest

import h5py
import numpy

from program import CASES, PROGRAM, ProgramTest, main, on_a_terminal, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "postprocess"))
import output_tables  # noqa: E402
from pages import reference  # noqa: E402
from report import vtu  # noqa: E402

QUICK = ["--set", "mesh.parameters.cells=0.5", "--set", "time.end=0.05"]


def undescribed(value, path, rows):
    """Paths that are written but not described; those of lists are "slips[]", those by name "loads.NAME"."""
    free = next((row for row in rows if re.fullmatch(re.escape(path) + r"\.[A-Z]+", row)), None)
    if isinstance(value, list) and path + "[]" in rows:
        for item in value:
            yield from undescribed(item, path + "[]", rows)
    elif isinstance(value, dict) and (free or not path or any(row.startswith(path + ".") for row in rows)):
        for key, below in value.items():
            yield from undescribed(below, free or f"{path}.{key}".lstrip("."), rows)
    elif path not in rows and path + "[]" not in rows:
        yield path


class Cli(ProgramTest):
    def run_model(self, *arguments, **options):
        return upbead("run", CASES / "fig2b-model.toml", *QUICK, *arguments, cwd=self.folder, **options)

    def test_help_teaches_by_example(self):
        for arguments, example in ((["--help"], "upbead run cases/"), (["run", "--help"], "upbead run cases/"),
                                   (["explain", "--help"], "upbead explain cases/"),
                                   (["reduce", "--help"], "upbead reduce cases/"),
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

    def test_a_length_that_is_no_positive_number_is_told_in_a_line(self):
        for width in ("nan", "-2", "inf", "2m", "1e999"):
            done = upbead("new", "mine.toml", "--width", width, "--height", "17", cwd=self.folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"--width: {width} is no positive number; give one such as 20\n", done.stderr)
            self.assertEqual(self.left_behind(), [])

    def test_a_case_of_a_wide_shoulder_has_sea_beyond_its_toe(self):
        done = upbead("new", "mine.toml", "--width", "20", "--height", "17", "--shoulder", "100", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(upbead("explain", "mine.toml", cwd=self.folder).returncode, 0)

    def test_mistakes_of_a_case_are_told_without_the_solver(self):
        alone = self.folder / "upbead"
        shutil.copy(PROGRAM, alone)
        for command in ("run", "explain", "reduce"):
            done = subprocess.run([alone, command, CASES / "fig2b-model.toml", "--set", "gravty=1"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 1)
            self.assertIn("did you mean 'gravity'?", done.stderr)
            done = subprocess.run([alone, command, CASES / "fig2b-model.toml"], capture_output=True, text=True)
            self.assertIn("upbead-solver', which meshes and solves", done.stderr)

    @unittest.skipIf(os.environ.get("UPBEAD_SANITIZE") == "ON", "sanitizers map terabytes of addresses")
    def test_memory_that_does_not_suffice(self):
        for megabytes in (600, 1200):  # too little for the start, and exceeded during the run
            limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes * 2**20,) * 2)
            done = self.run_model("--set", "time.step=6e-8", preexec_fn=limit)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("does not fit in memory; use a coarser mesh, larger steps or fewer fields", done.stderr)
            self.assertEqual(self.left_behind(), [])

    def test_interrupted_run_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen([PROGRAM, "run", CASES / "fig2b-model.toml", *QUICK, "--set", "time.step=1e-6"],
                                       cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            process.stdout.readline()  # the folder has been made, the march is about to start
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
        done = self.run_model("--set", "time.end=0.11")
        self.assertEqual((done.returncode, done.stderr), (0, ""), "no progress where nobody watches")
        result = self.folder / "results/fig2b-model"
        self.assertEqual(sorted(os.listdir(result)), ["case.toml", "results.h5", "summary.json"])
        summary = json.loads((result / "summary.json").read_text())
        with h5py.File(result / "results.h5") as file:
            history = file["history"]
            n = len(history["time"])
            self.assertGreaterEqual(n, summary["discretisation"]["steps"] + 1)
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

    def test_older_name_of_a_key_is_understood_with_a_note(self):
        done = upbead("explain", CASES / "fig2b-model.toml", "--set", "mesh.keep_unreached=true", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, "note: .*'keep_unreached' is called 'full_domain' now\n")

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

    def test_fields_of_soil_that_follows_its_strain(self):
        done = self.run_model("--set", "output.fields.every=0.025", "--set", "regions.seabed.strain.reference_strain=1e-4")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(os.listdir(self.folder / "results/fig2b-model/fields")), 3)

    def test_fields_hold_what_a_probe_reads(self):
        self.fields_hold_what_a_probe_reads()

    def test_fields_of_soil_that_yields_hold_what_a_probe_reads(self):
        """The middle of a cell is a quadrature point, whose stress is that of the law; also the energy lost in each
        cell."""
        self.fields_hold_what_a_probe_reads(
            "--set", 'regions.mound.law="hysteretic"', "--set", "regions.mound.strain.reference_strain=1e-5",
            "--set", "initial.bounds=false")
        result = self.folder / "results/fig2b-model"
        names = {"mobilised_strength_(1)", "dissipated_energy_(J_m3)", "points", "types"}
        found = vtu.arrays(vtu.times(result / "fields.pvd")[-1][1], names)
        mobilised, lost = found["mobilised_strength_(1)"], found["dissipated_energy_(J_m3)"]
        self.assertTrue(numpy.isnan(mobilised).any() and (lost >= 0).all())
        self.assertTrue(((mobilised > 0) & (mobilised <= 1))[lost > 0].all())
        corners = found["points"][vtu.corners(len(found["points"]), len(found["types"]))][..., :2].astype(float)
        x, y = corners[..., 0], corners[..., 1]
        area = 0.5 * abs(numpy.sum(x * numpy.roll(y, -1, 1) - y * numpy.roll(x, -1, 1), axis=1))
        energy = json.loads((result / "summary.json").read_text())["energy"]
        cells = lost[vtu.corners(len(lost), len(found["types"]))[:, 0]]
        self.assertLess(abs(cells @ area / energy["plastic"] - 1), 1e-3, "at the last written time, which is the end")

    def fields_hold_what_a_probe_reads(self, *settings):
        """Fields equal the readings of a probe in the middle of a cell of the mound, at every written time, to the
        single precision of the files."""
        result, fields = self.folder / "results/fig2b-model", ["--set", "output.fields.every=0.025", *settings]
        self.run_model(*fields)
        points = vtu.arrays(result / "fields/fields_0000.vtu", {"points"})["points"][:, :2].astype(float)
        middles = points.reshape(-1, 9, 2)[:, 4]  # of patches of 3 by 3 points
        at = middles[numpy.hypot(*(middles - [0.35, 0.2]).T).argmin()].tolist()
        done = self.run_model(*fields, "--set", f"probes.A.at={at}")
        self.assertEqual(done.returncode, 0, done.stderr)
        unit = {"displacement": "m", "velocity": "m_s", "acceleration": "m_s2", "pore_pressure": "Pa", "strain_xx": "1",
                "strain_xy": "1", "effective_stress_yy": "Pa", "effective_stress_zz": "Pa"}
        names = {f"{name}_({unit})": name for name, unit in unit.items()}
        with h5py.File(result / "results.h5") as file:
            time, probe = file["history/time"][:], {name: values[:] for name, values in file["history/probes/A"].items()}
        probe["pore_pressure"] = probe["pressure"]
        scale = {}
        for instant, path in vtu.times(result / "fields.pvd"):
            found = vtu.arrays(path, {"points", *names})
            step = abs(time - instant).argmin()
            self.assertLess(abs(time[step] - instant), 1e-9)
            place = numpy.hypot(*(found["points"][:, :2] - at).T).argmin()
            for full, name in names.items():
                value = found[full][place]
                expected = probe[f"{name}_x"][step] if value.ndim else probe[name][step]
                history = probe.get(f"{name}_x", probe.get(name))
                self.assertLess(abs(numpy.ravel(value)[0] - expected), 1e-5 * abs(history).max(), (full, instant))
                scale[full] = max(scale.get(full, 0), abs(expected))
        self.assertTrue(all(scale.values()), scale)

    def test_shipped_cases_hold_their_identities_and_ratios_at_length(self):
        """Both routes to F_T and the balance of energy agree to 1e-8 with both schemes; 0.75 is calibrated, the
        prototype is within its range."""
        for case, low, high in (("fig2b-model", 0.745, 0.755), ("fig2b-prototype", 0.38, 0.48)):
            for scheme in ("sdirk4", "generalised_alpha"):
                done = upbead("run", CASES / f"{case}.toml", "--json", "--set", f"time.scheme={scheme}", cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                response = json.loads(done.stdout)["response"]
                self.assertLessEqual(response["reaction_mismatch"], 1e-8)
                self.assertLessEqual(response["energy_mismatch"], 1e-8)
                self.assertTrue(low < response["shear_to_force_ratio"] < high, response["shear_to_force_ratio"])

    def test_reference_of_keys_is_current(self):
        for page, option in (("case", "--keys"), ("warnings", "--warnings")):
            text = (CASES.parent / f"docs/reference/{page}.md").read_text()
            printed = reference.from_reference(upbead("explain", option).stdout)
            self.assertTrue(text.endswith(printed), "run postprocess/reference.py build/upbead docs")

    def test_tables_of_outputs_are_current(self):
        for path, text in output_tables.files(PROGRAM).items():
            self.assertEqual(path.read_text(), text, "run postprocess/output_tables.py build/upbead")

    def test_summaries_hold_only_what_is_described(self):
        known = json.loads(upbead("explain", "--outputs-json").stdout)
        done = {"run": self.run_model("--json"), "explain": upbead("explain", CASES / "fig2b-model.toml", "--json")}
        for command, case in (("waves", "fig7-9/impulsive"), ("expected", "section4/hd10")):
            done[command] = upbead(command, CASES / f"{case}.toml", "--json", cwd=self.folder)
        for command, end in done.items():
            self.assertEqual(end.returncode, 0, end.stderr)
            self.assertEqual(list(undescribed(json.loads(end.stdout), "", known[command])), [], command)

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

    def test_progress_is_one_line_on_a_terminal(self):
        code, text = on_a_terminal("run", CASES / "fig2b-model.toml", "--set", "time.step=1e-4", "--set", "mesh.parameters.cells=0.5",
                                   cwd=self.folder)
        self.assertEqual(code, 0)
        self.assertIn(b"solving", text)
        self.assertIn(b"%", text)
        self.assertNotIn(b"\n", text)


if __name__ == "__main__":
    main()
