#!/usr/bin/python3
"""One run on several processes.

usage: processes_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

import h5py
import numpy as np

from program import CASES, PROGRAM, ProgramTest, main, upbead, with_keys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "postprocess"))
from report import vtu  # noqa: E402

CASE = CASES / "fig2b-prototype.toml"
# without symmetry, which makes readings vanish; every kind of flow and side; an elastic caisson softer than concrete,
# as the round-off of accelerations grows with the stiffness
SCENE = ["mesh.parameters.cells=0.4", "mesh.parameters.mound_crest_front=11", "time.scheme=sdirk4", "time.end=0.5"]
SCENES = {
    "rigid": ["regions.mound.flow=inertial", "regions.seabed.flow=darcy"],
    "elastic": ["regions.caisson={kind='solid', youngs_modulus=1e9, poissons_ratio=0.2, density=2100, "
                "deformation='elastic'}",
                "boundaries.right={displacement='absorbing', pressure='sealed'}"],
    "prescribed": ["mesh.parameters.sea_front=0", "mesh.parameters.sea_back=0",
                   "loads.wave={boundary='bed', kind='pressure', pulse={shape='half_sine', peak=20e3, duration=0.3}}",
                   "time.scheme=generalised_alpha", "time.step=4e-3"],
    # water beside the walls as a mass, and air in the pores that each cell has by its depth
    "without seas": ["mesh.parameters.sea_front=0", "mesh.parameters.sea_back=0",
                     "regions.caisson.added_mass={seaward=9, landward=6}", "initial.water_level=6",
                     "regions.seabed.saturation=0.99", "regions.seabed.air_by_depth=true"],
}


STRAIN = [f"regions.{name}.strain={{reference_strain=1e-3, smallest_damping=0.05, largest_damping=0.2}}"
          for name in ("seabed", "mound")]

# soil of both laws, so soft that the mound fails at its edges and all of the seabed yields
YIELDING = [*SCENES["rigid"], "time.end=0.3", "loads.impulse.factor=2",
            "regions.mound.law=mohr_coulomb", "regions.mound.strength={friction_angle=42, cohesion=2e3}",
            "regions.seabed.law=hysteretic", "regions.seabed.strain={reference_strain=1e-3}"]
FRICTION = ["regions.caisson.interface.kind=friction", "loads.impulse.factor=5"]
# tolerable residual of a stage of such soil, over the largest force (src/run/solve.h), by the tolerance of F_T
RESIDUAL = 2e-4 * 5e-3

# As srun --mpi=pmix starts a program: with the variables of PMIx and Slurm, and without those of Open MPI.
AS_SRUN = '''for name in $(env | grep -oE "^(OMPI|ORTE)_[A-Za-z0-9_]*"); do unset $name; done
export SLURM_NODELIST=here SLURM_JOBID=1 SLURM_STEPID=0 SLURM_JOB_ID=1 SLURM_STEP_ID=0
export SLURM_PROCID=$PMIX_RANK SLURM_STEP_NUM_TASKS=2
exec "$@"
'''


def launched(n, *arguments, by=()):
    # a container may forbid binding to cores and copying between processes
    launch = ["mpirun", "--quiet", "-n", n, "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "--mca",
              "btl_vader_single_copy_mechanism", "none"]
    return [*map(str, launch), *map(str, by), PROGRAM, *map(str, arguments)]


def mpirun(n, *arguments, cwd, by=()):
    return subprocess.run(launched(n, *arguments, by=by), cwd=cwd, capture_output=True, text=True, timeout=300)


class Processes(ProgramTest):
    def run_on(self, n, *keys, by=(), petsc=()):
        done = mpirun(n, "run", CASE, *with_keys([*SCENE, *keys]), "--out", f"on{n}", "--json", *petsc, cwd=self.folder,
                      by=by)
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads(done.stdout)
        self.assertEqual(summary["discretisation"]["processes"], n)
        return summary

    def histories(self, n):
        with h5py.File(self.folder / f"on{n}" / "results.h5") as file:
            found = {}

            def keep(name, item):
                if isinstance(item, h5py.Dataset):
                    found[name] = item[()], (name.rpartition("/")[0], item.attrs["unit"])

            file["history"].visititems(keep)
            return found

    def expect_same_history(self, n):
        """Histories agree to 1e-9 of the largest history with the same unit and group, as round-off is relative to
        that."""
        alone = self.histories(1)
        for name, (values, kind) in self.histories(n).items():
            peak = max(np.abs(others).max() for others, other_kind in alone.values() if other_kind == kind)
            self.assertLessEqual(np.abs(values - alone[name][0]).max(), 1e-9 * peak, f"{name} on {n}")
        shear, peak = (np.abs(each).max() for each in (self.histories(n)["shear_force"][0] - alone["shear_force"][0],
                                                       alone["shear_force"][0]))
        self.assertLess(shear, 1e-10 * peak)

    def compare(self, keys, numbers, counted=("cells", "unknowns", "steps", "solves", "factorisations")):
        """The answer of one process is that of so many. Returns their summaries."""
        summaries = []
        alone = self.run_on(1, *keys)
        for n in numbers:
            summary = self.run_on(n, *keys)
            self.expect_same_history(n)
            summaries.append(summary)
            for key in counted:
                self.assertEqual(summary["discretisation"][key], alone["discretisation"][key])
            peaks = [each["response"]["peak_shear"] for each in (summary, alone)]
            self.assertAlmostEqual(peaks[0] / peaks[1], 1, delta=1e-10)
            self.assertLess(summary["response"]["reaction_mismatch"], 1e-9)
            if alone.get("energy") is None:  # of a reduced model
                continue
            self.assertAlmostEqual(summary["energy"]["friction"], alone["energy"]["friction"],
                                   delta=1e-9 * alone["energy"]["work"])
            self.assertLess(summary["response"]["energy_mismatch"], 1e-9)
            for part in ("work", "kinetic", "strain", "fluid", "drag", "damping", "radiated"):
                self.assertAlmostEqual(summary["energy"][part], alone["energy"][part], delta=1e-9 * alone["energy"]["work"])

        return alone, summaries

    def slide(self, numbers):
        """Several processes cannot halve their solves, so that they take more of them."""
        keys = [*SCENES["rigid"], "regions.caisson.interface.kind=friction", "loads.impulse.factor=5",
                "mesh.parameters.cells=0.25", "time.end=0.3", "mesh.full_domain=true"]
        alone, summaries = self.compare(keys, numbers, ("cells", "unknowns", "steps", "factorisations"))
        self.assertGreater(abs(alone["contact"]["solved"]["slip"]), 1e-3)
        self.assertGreater(alone["contact"]["solved"]["open_steps"], 0)
        for summary in summaries:
            for key, value in alone["contact"]["solved"].items():
                if value is None:
                    self.assertIsNone(summary["contact"]["solved"][key])
                else:
                    self.assertAlmostEqual(summary["contact"]["solved"][key], value, delta=1e-9 * abs(value), msg=key)

    def test_gives_the_same_friction_node_by_node(self):
        self.slide([2])

    def test_gives_the_same_friction_node_by_node_on_two_to_four_at_length(self):
        self.slide([2, 3, 4])

    def test_gives_the_same_answer(self):
        self.compare(SCENES["elastic"], [2, 3])

    def test_gives_the_same_answer_with_added_mass_and_air_by_depth(self):
        self.compare(SCENES["without seas"], [2, 3])

    def test_gives_the_same_answer_to_every_scene_on_two_to_four_at_length(self):
        for scene, keys in SCENES.items():
            with self.subTest(scene):
                self.compare(keys, [2, 3, 4])

    def test_gives_the_same_reduced_model(self):
        self.compare([*SCENES["elastic"], "time.scheme=reduced"], [2])

    def test_gives_the_same_reduced_model_on_two_to_four_at_length(self):
        for scene in ("rigid", "elastic"):
            with self.subTest(scene):
                self.compare([*SCENES[scene], "time.scheme=reduced"], [2, 3, 4])

    def test_gives_the_same_soil_by_strain(self):
        self.compare([*STRAIN, "time.scheme=auto"], [2])  # by reduced models

    def test_gives_the_same_soil_by_strain_marched_at_length(self):
        self.compare(STRAIN, [2, 3, 4])

    def compare_yielding(self, keys, numbers):
        """F_T, the work that the soil took, and what is said of the soil are those of one process."""
        alone = self.run_on(1, *keys)
        self.assertGreater(alone["energy"]["plastic"], 0.01 * alone["energy"]["work"])
        shear = self.histories(1)["shear_force"][0]
        for n in numbers:
            both = self.run_on(n, *keys)
            change = np.abs(self.histories(n)["shear_force"][0] - shear).max() / np.abs(shear).max()
            self.assertLess(change, RESIDUAL)
            for key in ("steps", "factorisations"):
                self.assertEqual(both["discretisation"][key], alone["discretisation"][key])
            self.assertLess(both["response"]["reaction_mismatch"], 1e-6)
            self.assertLess(both["response"]["energy_mismatch"], 1e-6)
            for part in ("work", "plastic", "kinetic", "strain", "damping"):
                self.assertAlmostEqual(both["energy"][part], alone["energy"][part], delta=1e-6 * alone["energy"]["work"])
            for key in ("share_yielded", "share_skipped", "stages", "cut_steps"):
                self.assertAlmostEqual(both["nonlinear"][key], alone["nonlinear"][key], delta=2e-3, msg=key)
            self.assertEqual([each["region"] for each in both["nonlinear"]["regions"]],
                             [each["region"] for each in alone["nonlinear"]["regions"]])
            for found, there in zip(both["nonlinear"]["regions"], alone["nonlinear"]["regions"]):
                self.assertAlmostEqual(found["largest"], there["largest"], delta=1e-5)
                self.assertAlmostEqual(found["share"], there["share"], delta=0.02)  # some cells are at their strength's edge

            self.expect_same_residual(both, alone)

    def expect_same_residual(self, both, alone):
        """What stays when all has come to rest, and what the contact has slipped and opened."""
        of = [{each["start"]: each["residual"] for each in summary["nonlinear"]["bounds"]} for summary in (both, alone)]
        self.assertEqual(of[0].keys(), of[1].keys())
        for start, there in of[1].items():
            for key in ("displacement_x", "displacement_y", "rotation", "pore_pressure"):
                self.assertAlmostEqual(of[0][start][key] / there[key], 1, delta=1e-6, msg=f"{start} {key}")
        self.assertEqual(both["contact"] is None, alone["contact"] is None)
        if alone["contact"] is None:
            return
        there = alone["contact"]["solved"]
        self.assertGreater(there["slip"], 1e-3)
        self.assertGreater(there["open_steps"], 0)
        for key in ("slip", "largest_slip", "least_contact", "least_normal_force", "dissipated"):
            self.assertAlmostEqual(both["contact"]["solved"][key] / there[key], 1, delta=1e-6, msg=key)
        for key in ("slip_steps", "open_steps"):
            self.assertEqual(both["contact"]["solved"][key], there[key], key)

    def test_gives_the_same_soil_that_yields(self):
        self.compare_yielding(YIELDING, [2, 3])

    def test_gives_the_same_soil_that_yields_with_friction_node_by_node(self):
        self.compare_yielding([*YIELDING, *FRICTION, "time.end=0.2"], [2])

    def test_gives_the_same_soil_that_yields_on_two_to_four_with_and_without_friction_at_length(self):
        self.compare_yielding(YIELDING, [2, 3, 4])
        self.compare_yielding([*YIELDING, *FRICTION], [2, 3, 4])

    def test_writes_the_stresses_of_soil_that_yields(self):
        # not the share of the strength: where Mohr-Coulomb soil has lost all stress, it is 1 or less by round-off
        names = {"dissipated_energy_(J_m3)", "effective_stress_xx_(Pa)", "effective_stress_yy_(Pa)", "effective_stress_xy_(Pa)"}
        fields = {}
        for n in (1, 2):
            self.run_on(n, *YIELDING, "output.fields.every=0.1")
            fields[n] = [vtu.arrays(path, names)
                         for _, path in vtu.times(self.folder / f"on{n}/fields.pvd")]
        for found, alone in zip(fields[2], fields[1]):
            self.assertEqual(sorted(found), sorted(alone))
            for name in alone:
                np.testing.assert_array_equal(np.isnan(found[name]), np.isnan(alone[name]))  # where nothing yields
                self.assertLess(np.nanmax(np.abs(found[name] - alone[name])), 1e-5 * max(1, np.nanmax(np.abs(alone[name]))))

    def test_keeps_no_checkpoint_of_soil_that_yields(self):
        done = mpirun(2, "run", CASE, *with_keys([*SCENE, *YIELDING]), "--out", "none", "--checkpoint", "1", cwd=self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stderr.count("keeps no checkpoints on several processes"), 1, done.stderr)

    def test_estimates_the_error_alike(self):
        keys = ["time.scheme=auto", "accuracy.estimate=true"]
        alone = self.run_on(1, *keys)
        for n in (2, 3):
            both = self.run_on(n, *keys)
            for key in ("error_sources", "history_error_sources"):
                self.assertEqual(both["response"][key].keys(), alone["response"][key].keys())
                for part, value in alone["response"][key].items():
                    self.assertAlmostEqual(both["response"][key][part], value, delta=1e-6)
            for key in ("error_estimate", "history_error_estimate"):
                self.assertAlmostEqual(both["response"][key] / alone["response"][key], 1, delta=1e-6)
            self.expect_same_history(n)

    def interrupted(self, n, *keys):
        """Ends the run once it has kept a checkpoint."""
        state = self.folder / "parts.checkpoint/state.h5"
        before = state.stat().st_mtime_ns if state.exists() else 0
        run = subprocess.Popen(launched(n, "run", CASE, *with_keys([*SCENE, *keys]), "--out", "parts", "--checkpoint",
                                        "0.05", "--resume"), cwd=self.folder, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
        while run.poll() is None and not (state.exists() and state.stat().st_mtime_ns > before):
            time.sleep(0.01)
        run.send_signal(signal.SIGTERM)
        run.communicate(timeout=60)
        self.assertNotEqual(run.returncode, 0)
        self.assertTrue(state.exists())

    def test_goes_on_from_a_checkpoint_on_any_number(self):
        keys = [*SCENES["rigid"], "time.step=5e-5", "output.fields.every=0.1"]  # so many steps that none ends by itself
        self.run_on(1, *keys)
        for n in (2, 3, 1):
            self.interrupted(n, *keys)
        done = mpirun(2, "run", CASE, *with_keys([*SCENE, *keys]), "--out", "parts", "--resume", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("resumed     at t =", done.stdout)
        self.assertFalse((self.folder / "parts.checkpoint").exists())
        (self.folder / "parts").rename(self.folder / "on2")
        self.expect_same_history(2)
        self.assertEqual(len(vtu.times(self.folder / "on2/fields.pvd")), 6)

    def test_stops_early_where_one_process_does(self):
        alone, both, three = (self.run_on(n, *SCENES["rigid"], "time.end=3", "time.stop_at_energy=0.5")
                              for n in (1, 2, 3))
        self.assertTrue(alone["discretisation"]["stopped_early"])
        self.assertEqual(both["discretisation"]["steps"], alone["discretisation"]["steps"])
        self.assertEqual(three["discretisation"]["steps"], alone["discretisation"]["steps"])
        self.expect_same_history(2)
        self.expect_same_history(3)

    def test_writes_the_fields_that_one_process_writes(self):
        names = {"points", "displacement_(m)", "velocity_(m_s)", "acceleration_(m_s2)", "pore_pressure_(Pa)",
                 "effective_stress_yy_(Pa)"}
        fields = {}
        for n in (1, 2, 3):
            self.run_on(n, *SCENES["rigid"], "output.fields.every=0.1")
            fields[n] = [(time, vtu.arrays(path, names)) for time, path in vtu.times(self.folder / f"on{n}/fields.pvd")]
        self.assertEqual(len(fields[1]), 6)
        for n in (2, 3):
            self.assertEqual([time for time, _ in fields[n]], [time for time, _ in fields[1]])
            for name in names:
                peak = max(np.abs(arrays[name]).max() for _, arrays in fields[1])
                self.assertGreater(peak, 0)
                for (_, found), (_, alone) in zip(fields[n], fields[1]):
                    # single precision: half a unit of the last place may be rounded either way
                    self.assertLess(np.abs(found[name] - alone[name]).max(), 2e-7 * peak, f"{name} on {n}")

    def test_is_started_by_srun_too(self):
        self.run_on(1)
        self.run_on(2, by=("bash", "-c", AS_SRUN, "srun"))
        self.expect_same_history(2)

    def test_says_where_mpi_connects_no_process_that_a_launcher_has_started(self):
        # as of srun --mpi=none; by the list of nodes alone, Open MPI would end the process
        environment = {**os.environ, "SLURM_NODELIST": "here", "SLURM_JOBID": "1", "SLURM_STEPID": "0",
                       "SLURM_STEP_ID": "0", "SLURM_PROCID": "0", "SLURM_STEP_NUM_TASKS": "2"}
        done = upbead("run", CASE, *with_keys(SCENE), "--out", "alone", cwd=self.folder, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("SLURM_PROCID tells that 2 processes were started, but MPI connects none", done.stderr)
        self.assertNotIn("divided among", done.stdout)

    def test_takes_options_of_petsc(self):
        self.run_on(1)
        self.run_on(2, petsc=("--petsc", "-mat_mumps_icntl_14 400 -mat_mumps_icntl_7 0"))
        self.expect_same_history(2)

    def test_obeys_options_of_petsc(self):
        # MUMPS fails in so little room, which is told, and no NaN is written
        done = mpirun(2, "run", CASE, *with_keys(SCENE), "--out", "none", "--petsc", "-mat_mumps_icntl_23 1",
                      cwd=self.folder)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count("upbead: "), 1, done.stderr)
        self.assertIn("MUMPS cannot factorise", done.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_tells_what_is_no_option_of_petsc(self):
        for n, options, what in ((2, "mat_mumps_icntl_14 400", "'mat_mumps_icntl_14' is no option of PETSc"),
                                 (2, "-mat_mumps_icntl_14 400 500", "'500' is no option of PETSc"),
                                 (2, "-mat_mumps_icntl_99 1", "nothing in PETSc asks for -mat_mumps_icntl_99"),
                                 (1, "-mat_mumps_icntl_14 400", "--petsc is for several processes")):
            done = mpirun(n, "run", CASE, *with_keys(SCENE), "--out", "none", "--petsc", options, cwd=self.folder)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertEqual(done.stderr.count(what), 1, done.stderr)
            self.assertEqual(self.left_behind(), [])

    def test_decides_and_finds_the_same_mesh_at_length(self):
        keys = ["time.scheme=auto", "mesh.refine='auto'", "mesh.parameters.cells=0.3", "accuracy.tolerance=0.02"]
        alone, both = (self.run_on(n, *keys) for n in (1, 2))
        self.assertEqual(both["discretisation"]["scheme"], "reduced")
        self.assertEqual(both["discretisation"]["unknowns"], alone["discretisation"]["unknowns"])
        self.expect_same_history(2)
        self.assertAlmostEqual(both["response"]["error_estimate"] / alone["response"]["error_estimate"], 1, delta=1e-6)

    @unittest.skipIf(os.environ.get("UPBEAD_SANITIZE") == "ON", "a sanitizer needs more addresses than that")
    def test_ends_on_all_where_one_has_no_memory(self):
        little = 'test "$OMPI_COMM_WORLD_RANK" = 1 && ulimit -v $0; exec "$@"'
        for limit in (700000, 950000):  # kB
            done = mpirun(2, "run", CASE, *with_keys(["mesh.parameters.cells=2.5", "time.scheme=sdirk4"]), "--out", "none",
                          by=("bash", "-c", little, limit), cwd=self.folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count("the case does not fit in memory"), 1, done.stderr)
            self.assertEqual(self.left_behind(), [])

    def test_says_once_what_is_not_done(self):
        for keys, what in (([*YIELDING, "regions.mound.densification={relative_density=0.5}"], "no soil packs denser"),
                          (["regions.mound.porosity=2"], "is outside (0, 1)")):
            done = mpirun(2, "run", CASE, *with_keys([*SCENE, *keys]), "--out", "none", cwd=self.folder)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertEqual(done.stderr.count(what), 1, done.stderr)
            self.assertEqual(self.left_behind(), [])


if __name__ == "__main__":
    main()
