#!/usr/bin/python3
"""Claims: reliability prints and writes each way to fail, the fault tree, and the demands of codes; the same file has the same numbers
again; one file may be a case and a design; mistakes of its tables are told at once, with place and cure, and nothing is written.

usage: reliability_test.py PROGRAM CASES_FOLDER
"""

import json
import subprocess

from program import CASES, PROGRAM, ProgramTest, main, upbead

DESIGN = CASES / "designer/reliability.toml"
QUICK = ["--set", "reliability.samples=2000"]


class Reliability(ProgramTest):
    def summary(self, *options, design=DESIGN, out="out"):
        done = upbead("reliability", design, *options, "--out", out, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / out / "summary.json").read_text()), done

    def test_each_way_to_fail_and_the_tree_have_a_row(self):
        found, done = self.summary(*QUICK)
        modes = found["modes"]
        for name, mode in modes.items():
            self.assertIn(name, done.stdout)
            indices = [method["index"] for method in mode["methods"].values() if method["index"] is not None]
            if indices:  # the worse governs
                self.assertEqual(mode["occasion"]["index"], min(indices))
                self.assertEqual(mode["methods"][mode["governing"]]["index"], min(indices))
            else:
                self.assertTrue(mode["why_not"])
            if mode["life"]["probability"] is not None:
                p = mode["occasion"]["probability"]
                self.assertAlmostEqual(mode["life"]["probability"], 1 - (1 - p) ** 50, delta=1e-9)
            if mode["design_point"]:
                self.assertAlmostEqual(sum(v["importance"] for v in mode["design_point"].values()), 1, delta=1e-6)
        self.assertEqual(found["system"], "unusable")
        self.assertEqual({row["code"] for row in found["codes"]}, {"Japan", "PIANC WG 28", "Eurocode"})
        self.assertIn("assumed", done.stdout)

    def test_the_same_file_gives_the_same_numbers(self):
        again = [self.summary(*QUICK)[0]["modes"] for _ in range(2)]
        self.assertEqual(*again)

    def test_a_wider_caisson_fails_less(self):
        narrow, wide = (self.summary(*QUICK, "--set", f"section.submerged_weight={W}")[0]["modes"]["sliding"]["life"]["index"]
                        for W in (5.2e6, 5.9e6))
        self.assertGreater(wide, narrow)

    def test_what_it_writes_runs_again(self):
        first = self.summary(*QUICK)[0]["modes"]
        self.assertEqual(first, self.summary(design=self.folder / "out/case.toml", out="again")[0]["modes"])

    def test_one_file_may_be_case_and_design(self):
        case = self.folder / "both.toml"
        case.write_text((CASES / "designer/section.toml").read_text() + """
[reliability]
wave = "design"
[reliability.variables.friction]
acts_on = "section.friction"
cov = 0.16
[reliability.variables.goda]
acts_on = "force"
cov = 0.17
""")
        (self.folder / "storms.csv").write_text((CASES / "designer/storms.csv").read_text())
        found = self.summary(*QUICK, design=case)[0]
        self.assertEqual(found["system"], "system")
        self.assertEqual(upbead("waves", case, "--out", "waves", cwd=self.folder).returncode, 0)

    def test_mistakes_are_told_at_once_and_nothing_is_written(self):
        bad = self.folder / "bad.toml"
        bad.write_text(DESIGN.read_text().replace('acts_on = "section.friction"', 'acts_on = "section.frction"')
                       .replace('second = "uplift"', 'second = "uplfit"').replace('"overturning", ', '"overturnign", ')
                       .replace("mean = 6.5\ncov = 0.12", "mean = 6.5"))
        done = upbead("reliability", bad, "--set", 'reliability.methods=["forn"]', "--out", "bad", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        for line in ("section.frction", "did you mean 'uplift'?", "did you mean 'overturning'?", "neither 'cov' nor 'deviation'",
                     "there is no method 'forn'"):
            self.assertIn(line, done.stderr)
        self.assertFalse((self.folder / "bad").exists())

    def test_two_trees_beside_each_other_are_refused(self):
        text = DESIGN.read_text()
        two = self.folder / "two.toml"
        two.write_text(text + '[reliability.system.another]\nany = ["sliding"]\n')
        done = upbead("reliability", two, *QUICK, "--out", "two", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("[reliability.system.unusable]: gates another, unusable are each part of no other", done.stderr)
        self.assertFalse((self.folder / "two").exists())

    def test_a_system_names_what_it_leaves_out(self):
        text = DESIGN.read_text()
        bare = self.folder / "bare.toml"
        (self.folder / "storms.csv").write_text((DESIGN.parent / "storms.csv").read_text())
        bare.write_text(text[: text.index("[reliability.system.unusable]")].replace("base_pressure = 600e3\n", "") + "[levels]\nhigh = 1.0\n")
        found, done = self.summary(*QUICK, "--set", 'reliability.methods=["form"]', design=bare)
        self.assertIsNone(found["modes"]["heel_pressure"]["occasion"]["probability"])
        out = "without heel_pressure, sliding_seaward"
        for told in (found["modes"]["system"]["meaning"], found["checks"][0]["assumption"],
                     *(row["what"] for row in found["codes"] if row["code"] in ("PIANC WG 28", "Eurocode"))):
            self.assertIn(out, told)
        names = [warning["name"] for warning in found["warnings"]]
        self.assertIn("system_incomplete", names)
        self.assertIn("levels_not_used", names)

    def test_a_life_that_fails_for_certain_misses_its_target(self):
        found, done = self.summary(*QUICK, "--set", "reliability.variables.goda.mean=6", "--set", 'reliability.methods=["form"]')
        self.assertEqual(found["modes"]["unusable"]["life"], {"probability": 1, "index": None})
        check = found["checks"][0]
        self.assertEqual((check["holds"], check["demand"], check["probability"]), (False, None, 1))
        self.assertIs(found["verdict"]["holds"], False)
        self.assertIn("not found (probability 1) against at least 2.38: DOES NOT HOLD", done.stdout)

    def test_only_targets_of_the_file_are_judged(self):
        assumed = self.summary(*QUICK)[0]
        self.assertEqual(sum(row["holds"] is not None for row in assumed["checks"]), 1, "the target alone")
        given = self.summary(*QUICK, "--set", "reliability.targets.eurocode_year=6", "--set", "reliability.targets.exceed_0_1=0.3")[0]
        rows = {row["name"]: row["holds"] for row in given["checks"] if row["name"].startswith("reliability, ")}
        self.assertEqual(rows, {"reliability, Eurocode: beta of the system unusable in a year": False,
                                "reliability, Japan: S of all waves of a life above 0.1 m": True})
        self.assertEqual({row["source"] for row in given["codes"] if row["target"] in (6, 0.3) and row["source"].startswith("given")},
                         {"given by the file"})
        self.assertEqual(given["verdict"]["failing"], 1)

    def test_a_system_fails_as_often_as_each_of_its_parts(self):
        text = DESIGN.read_text()
        bare = self.folder / "bare.toml"
        (self.folder / "storms.csv").write_text((DESIGN.parent / "storms.csv").read_text())
        bare.write_text(text[: text.index("[reliability.system.unusable]")])
        modes = self.summary("--set", 'reliability.methods=["form"]', design=bare)[0]["modes"]
        parts = [mode["occasion"]["probability"] for name, mode in modes.items() if name in ("sliding", "overturning", "sliding_distance", "heel_pressure")]
        self.assertGreaterEqual(modes["system"]["occasion"]["probability"], max(parts))
        self.assertLessEqual(modes["system"]["occasion"]["probability"], sum(parts))

    def test_only_its_program_loads_the_library(self):
        for name, loads in (("upbead", False), ("upbead-solver", False), ("upbead-reliability", True)):
            libraries = subprocess.run(["ldd", PROGRAM.with_name(name)], capture_output=True, text=True, check=True).stdout
            self.assertEqual("libOT" in libraries, loads, name)


if __name__ == "__main__":
    main()
