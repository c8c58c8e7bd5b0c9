#!/usr/bin/python3
"""One wave has one P and one U, in `waves`, `run`, `reduce` with `respond`, and `expected`; cases/design-wave is as shipped.

usage: wave_loads_test.py PROGRAM CASES_FOLDER
"""

import json
import re
import tomllib

import h5py
import numpy

from program import CASES, ProgramTest, main, upbead

CASE, DESIGN = CASES / "design-wave/composite.toml", CASES / "design-wave/section.toml"
# coarse, as P and U do not depend on cells
COARSE = ["--set", "mesh.parameters.cells=0.5", "--set", "mesh.parameters.sea_cells=4"]
COURSES = ["church_roof", "triangle", "sine", "combined"]


class WaveLoads(ProgramTest):
    def ask(self, *arguments):
        done = upbead(*arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def by_formulas(self, *settings):
        return json.loads(self.ask("waves", DESIGN, "--json", "--out", "formulas", *settings).stdout)["waves"]["storm"]

    def assert_same(self, a, b, relative=1e-12):
        self.assertLessEqual(abs(a - b), relative * abs(b), f"{a} is not {b}")

    def test_the_case_and_the_design_have_one_section_and_wave(self):
        case, design = (tomllib.loads(path.read_text()) for path in (CASE, DESIGN))
        self.assertEqual(case["section"], design["section"])
        wave = dict(case["loads"]["storm"]["wave"])
        del wave["course"]
        self.assertEqual(wave, design["waves"]["storm"])

    def test_a_berm_that_is_not_the_meshed_one_is_told(self):
        for case in (CASE, CASE.with_name("standing.toml"), CASES / "designer/section.toml"):
            warnings = json.loads(self.ask("explain", case, "--json").stdout)["warnings"]
            self.assertNotIn("berm_differs", {warning["name"] for warning in warnings}, case)
        for change, meshed in (("section.berm_width=12", 7), ("section.berm_depth=12", 9)):
            warnings = json.loads(self.ask("explain", CASE, "--json", *COARSE, "--set", change).stdout)["warnings"]
            (told,) = (warning for warning in warnings if warning["name"] == "berm_differs")
            self.assertAlmostEqual(told["limit"], meshed, 9)

    def test_a_wave_or_a_berm_that_cannot_be_voids_run_and_waves_alike(self):
        for section, wave in ({}, {"height": 11, "period": 3}), ({"berm_depth": 40}, {}):
            def keys(way):
                given = {**{f"section.{k}": v for k, v in section.items()}, **{f"{way}.{k}": v for k, v in wave.items()}}
                return [word for key, value in given.items() for word in ("--set", f"{key}={value}")]
            run = json.loads(self.ask("run", CASE, "--json", *COARSE, *keys("loads.storm.wave")).stdout)
            waves = json.loads(self.ask("waves", DESIGN, "--json", *keys("waves.storm")).stdout)
            self.assertIn("wave_outside_formulas", run["verdict"]["why_void"])
            self.assertIn("breaking_limit" if wave else "berm_below_bed", waves["verdict"]["why_void"])

    def test_a_weight_in_water_without_sliding_is_that_of_the_scene(self):
        (self.folder / "bare.toml").write_text(re.sub(r"\[sliding\].*?(?=\[regions)", "", CASE.read_text(), flags=re.S))
        told = self.ask("explain", "bare.toml", *COARSE, "--set", "section.submerged_weight=3.5e6").stderr
        self.assertIn("section.submerged_weight = 3.5e+06 N/m, but the caisson less the water", told)
        self.assertNotIn("section.submerged_weight", self.ask("explain", "bare.toml", *COARSE).stderr)

    def test_run_and_waves_have_one_P_and_U(self):
        formulas = self.by_formulas()
        for course in COURSES:
            setting = f"loads.storm.wave.course={course}"
            summary = json.loads(self.ask("run", CASE, "--json", "--out", course, "--set", setting, *COARSE).stdout)
            told = summary["wave_loads"]["storm"]
            for key in ("height", "significant_height", "period", "angle", "wavelength", "alpha_1", "alpha_2", "alpha_I",
                        "alpha_star", "eta_star", "p1", "p3", "p4", "pu", "force", "force_moment", "uplift"):
                self.assertEqual(told[key], formulas[key], key)
            self.assertEqual(told["course"], course)
            self.assert_same(told["peak"], formulas["force"])
            with h5py.File(self.folder / course / "results.h5") as file:
                P = file["history/force"][:]
            self.assert_same(P.max(), formulas["force"])
            self.assert_same(summary["response"]["arm"], formulas["force_moment"] / formulas["force"], 1e-9)
            self.assert_same(summary["sliding"]["tau_0"], formulas["tau_0"])
            self.assertTrue(any("course: " in words for words in told["assumptions"]))
            if course in ("triangle", "combined"):
                self.assert_same(told["duration"], formulas["tau_0"])
            # held: U stays at its largest value, so that F_S includes the whole U at the peak of F_T
            self.assert_same(summary["sliding"]["uplift_at_peak"], formulas["uplift"])

    def test_run_and_waves_have_one_standing_wave(self):
        case = CASES / "design-wave/standing.toml"
        section, wave = (tomllib.loads(case.read_text())[key] for key in ("section", "loads"))
        wave = wave["storm"]["wave"]
        (self.folder / "deep.toml").write_text("\n".join(
            ["[section]", *(f"{key} = {value}" for key, value in section.items()),
             "[waves.storm]", f"height = {wave['height']}", f"period = {wave['period']}"]))
        formulas = json.loads(self.ask("waves", "deep.toml", "--json").stdout)["waves"]["storm"]["standing"]
        run = json.loads(self.ask("run", case, "--json", "--out", "standing", *COARSE).stdout)
        told, response, base = run["wave_loads"]["storm"], run["response"], run["base"]
        self.assert_same(told["peak"], formulas["force"], 1e-9)
        self.assert_same(told["trough_force"], formulas["trough_force"], 1e-9)
        self.assert_same(response["peak_force"], formulas["force"], 1e-8)
        self.assert_same(response["peak_force_seaward"], formulas["trough_force"], 1e-8)
        self.assert_same(response["arm"], formulas["force_moment"] / formulas["force"], 1e-6)
        # the wave is so slow that the response is nearly static
        self.assert_same(response["peak_shear"], formulas["force"], 0.02)
        self.assert_same(response["peak_shear_seaward"], formulas["trough_force"], 0.02)
        self.assert_same(base["peak_heel_pressure"], formulas["heel_pressure"], 0.02)
        # the run has no suction under the base, which presses the toe by its pressure at the edge in a trapezoid
        W, B = section["submerged_weight"], section["width"]
        self.assert_same(base["peak_toe_pressure"], W / B - 6 * formulas["trough_moment"] / B**2, 0.02)
        self.assertGreater(formulas["toe_pressure"], 1.05 * base["peak_toe_pressure"])
        self.assert_same(run["sliding"]["peak_sliding_force_seaward"], -response["peak_shear_seaward"], 1e-5)
        seaward = next(check for check in run["checks"] if check["name"] == "force against friction, seaward")
        self.assert_same(seaward["margin"], formulas["trough_safety_sliding"], 0.02)

    def test_respond_has_them_too(self):
        formulas = self.by_formulas()
        self.ask("reduce", CASE, "--out", "reduced", *COARSE)
        self.ask("run", CASE, "--out", "run", *COARSE)
        with h5py.File(self.folder / "run/results.h5") as file:
            t, P = file["history/time"][:], file["history/force"][:]
        numpy.savetxt(self.folder / "wave.csv", numpy.column_stack([t, P]), delimiter=",", comments="",
                      header="time (s),force (N/m)", fmt="%.17g")
        summary = json.loads((self.folder / "run/summary.json").read_text())
        wave = json.loads(self.ask("respond", "reduced/reduced.h5", "wave.csv", "--json", "--out", "answers").stdout)["waves"][0]
        self.assert_same(wave["peak_force"], formulas["force"])
        self.assertGreater(wave["sliding"], 0.01)
        # with U of the wave by the model's law; the two reduced models agree in F_T to their accuracy
        self.assert_same(wave["sliding"], summary["sliding"]["sliding_history"], 0.01)

    def test_expected_has_them_too(self):
        """The wave that just slides the caisson by eq. (7) in `expected` has P + mu U = mu W' in `waves` and as a
        load."""
        (self.folder / "states.csv").write_text("significant_height (m),period (s),waves\n6.0,12.0,1000\n")
        design = DESIGN.read_text() + '[sea]\nstates = "states.csv"\nyears = 1\nhighest = "none"\n'
        (self.folder / "expected.toml").write_text(design)
        told = json.loads(self.ask("expected", "expected.toml", "--json", "--out", "expected").stdout)
        threshold = told["expected"]["threshold_height"]["paper"]
        height = [f"--set=waves.storm.height={threshold!r}", "--set=waves.storm.significant_height=6.0"]
        formulas = self.by_formulas(*height)
        explained = json.loads(self.ask("explain", CASE, "--json", *COARSE, "--set", f"loads.storm.wave.height={threshold!r}",
                                        "--set", "loads.storm.wave.significant_height=6.0").stdout)["wave_loads"]["storm"]
        self.assertEqual((explained["force"], explained["uplift"]), (formulas["force"], formulas["uplift"]))
        self.assert_same(explained["force"] + 0.6 * explained["uplift"], 0.6 * 4.296e6, 1e-9)

    def test_a_study_that_keeps_the_solution_keeps_the_profile_at_length(self):
        settings = ["accuracy.estimate=true", "mesh.parameters.cells=0.35"]
        (self.folder / "study.toml").write_text(f"""case = "{CASE}"
read = ["sliding.sliding_history", "sliding.error_estimate"]
[set]
"accuracy.estimate" = true
"mesh.parameters.cells" = 0.35
[vary."sliding.drag"]
values = [0.0, 1e5]
""")
        self.assertIn("differed in [sliding] alone", self.ask("study", "study.toml", "--out", "study").stdout)
        row = (self.folder / "study/study.csv").read_text().splitlines()[2].split(",")
        alone = json.loads(self.ask("run", CASE, "--json", "--out", "alone", "--set", "sliding.drag=1e5",
                                    *(f"--set={setting}" for setting in settings)).stdout)["sliding"]
        self.assert_same(float(row[2]), alone["sliding_history"], 1e-9)
        self.assert_same(float(row[3]), alone["error_estimate"], 1e-6)

    def test_explain_tells_the_wave(self):
        done = self.ask("explain", CASE)
        told = re.sub(" +", " ", done.stdout)
        for part in ("wave_loads\n storm\n course church_roof\n height 11 m H\n", "\n peak 1.931 MN/m largest P", "\n uplift 766.",
                     "\n alpha_star 0.37", "assumptions of ours"):
            self.assertIn(part, told)
        self.assertRegex(done.stderr, r"warning: effective_force: give the peak of an impact .*\n +loads.storm: ")
        self.assertNotIn("walls_too_near", done.stderr)
        self.assertNotIn("wave_cut", done.stderr)

    def test_a_section_of_another_caisson_is_refused(self):
        done = upbead("explain", CASE, "--set", "section.foundation_depth=8", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("foundation_depth + crest = 15 m, but the wall 'front' is 16 m high", done.stderr)
        self.assertIn("still water stands at y = 14 m", done.stderr)


if __name__ == "__main__":
    main()
