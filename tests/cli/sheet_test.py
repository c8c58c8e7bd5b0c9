#!/usr/bin/python3
"""Claims: one file serves run, waves, expected and sheet; a sheet has every check of each of them once, its verdict is that of all of
them, the worst of each way to fail governs it, and measures that disagree both stand; mistakes of all tables are told at once, and
nothing is written.

usage: sheet_test.py PROGRAM CASES_FOLDER
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import time

from program import CASES, PROGRAM, ProgramTest, main, upbead

BONDED = ["--set", 'regions.caisson.interface.kind="bonded"']


def children_named(name):
    """Processes whose name, of which the system keeps 15 letters, is that."""
    for path in pathlib.Path("/proc").glob("[0-9]*/comm"):
        try:
            if path.read_text().strip() == name:
                yield int(path.parent.name)
        except OSError:  # it has ended
            continue


def parent_of(pid):
    try:
        return int(pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[1])
    except OSError:
        return None


class Sheet(ProgramTest):
    def summary(self, command, *options):
        done = upbead(command, CASES / "designer/section.toml", *options, "--out", command, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / command / "summary.json").read_text()), done

    def test_the_sheet_is_what_its_three_commands_say(self):
        sheet, done = self.summary("sheet", *BONDED)
        texts = sorted(row["text"] for row in sheet["checks"])
        model = f'dynamics.model="{self.folder}/sheet/reduced.h5"'  # that of the sheet, as its life takes it
        parts = {"run": self.summary("run", *BONDED)[0], "waves": self.summary("waves")[0],
                 "expected": self.summary("expected", "--set", model)[0]}
        def from_another_part(name, check):  # a limit that waves and expected leave to others
            return name != "run" and check["measure"].startswith("limits.")

        told = [check["text"] for name, part in parts.items() for check in part["checks"] if not from_another_part(name, check)]
        self.assertEqual(texts, sorted(told))
        self.assertEqual(sheet["verdict"]["failing"], sum(part["verdict"]["failing"] for part in parts.values()))
        self.assertEqual(sheet["verdict"]["checked"], sum(part["verdict"]["checked"] for part in parts.values()))
        limits = json.loads(upbead("explain", "--schema").stdout)["properties"]["limits"]["properties"]
        for row in sheet["checks"]:  # no check stands apart as a way to fail of its own
            self.assertNotIn(row["mode"], texts)
            self.assertIn(row["limit"], [None, *limits], row["name"])
        for command, part in parts.items():
            self.assertEqual(sheet[command]["checks"], part["checks"], command)
        self.check_governing(sheet["checks"])
        self.check_disagreements(sheet)
        self.check_screen(sheet, done.stdout)
        self.check_markdown(sheet, (self.folder / "sheet/sheet.md").read_text())
        self.assertTrue((self.folder / "sheet/results.h5").exists())
        self.check_document(sheet)

    def check_document(self, sheet):
        script = CASES.parent / "postprocess/report.py"
        done = subprocess.run(["/usr/bin/python3", "-B", script, self.folder / "sheet"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.folder / "sheet/report.html").read_text()
        for row in sheet["checks"]:
            if row["holds"] is False:
                self.assertIn(row["text"].split(":")[1].strip().split(" against")[0], page)
        for missing in sheet["not_covered"]:
            self.assertIn(missing.split(",")[0].replace("'", "&#x27;"), page)

    def check_governing(self, rows):
        for mode in {row["mode"] for row in rows}:
            judged = [row for row in rows if row["mode"] == mode and row["holds"] is not None]
            governing = [row for row in judged if row["governs"]]
            self.assertEqual(len(governing), 1 if judged else 0, mode)
            if judged and all(row["margin"] is not None for row in judged):
                self.assertEqual(governing[0]["margin"], min(row["margin"] for row in judged), mode)

    def check_disagreements(self, sheet):
        modes = {row["mode"] for row in sheet["checks"] if row["holds"] is True}
        both = {row["mode"] for row in sheet["checks"] if row["holds"] is False} & modes
        self.assertEqual({one["mode"] for one in sheet["disagreements"]}, both)
        self.assertTrue(both, "this section has measures that disagree")

    def check_markdown(self, sheet, text):
        head, _, *rows = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("|")]
        self.assertEqual(len(rows), len(sheet["checks"]))
        self.assertEqual({len(row) for row in rows}, {len(head)}, "a column for each cell, also where it is empty")
        factor, required = ([cell.strip() for cell in head].index(name) for name in ("factor", "required"))
        for row, check in zip(rows, sheet["checks"]):
            if check.get("at_least") and check["unit"] == "" and check["demand"] is not None and check["capacity"] is not None:
                self.assertAlmostEqual(float(row[factor]) / check["demand"], 1, 2)
                self.assertAlmostEqual(float(row[required]) / check["capacity"], 1, 2)

    def check_screen(self, sheet, text):
        self.assertIn("verdict     " + sheet["verdict"]["text"], text)
        self.assertIn("not covered by this program", text)
        table = text.split("not covered by")[0].split("measures that disagree")[0].splitlines()
        self.assertLessEqual(max(len(line) for line in table if "not checked" not in line), 100)
        for row in sheet["checks"]:
            self.assertTrue(any(row["name"] in line for line in table), row["name"])

    def test_older_files_are_understood(self):
        done = upbead("sheet", CASES / "designer/design.toml", "--out", "old", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        sheet = json.loads((self.folder / "old/summary.json").read_text())
        self.assertIsNone(sheet["run"])
        self.assertEqual({row["part"] for row in sheet["checks"]}, {"waves", "expected"})
        self.assertIn("run: no [loads.NAME]", done.stdout)
        self.assertFalse((self.folder / "old/results.h5").exists())

    def test_the_sheet_of_its_own_case_is_the_same(self):
        first, _ = self.summary("sheet", *BONDED)
        again = upbead("sheet", "sheet/case.toml", "--out", "again", cwd=self.folder)
        self.assertEqual(again.returncode, 0, again.stderr)
        second = json.loads((self.folder / "again/summary.json").read_text())
        self.assertEqual(first["checks"], second["checks"])

    def test_one_file_gives_the_numbers_of_two(self):
        one = self.summary("waves")[0]["waves"]["design"]
        done = upbead("waves", CASES / "designer/design.toml", "--out", "two", cwd=self.folder)
        self.assertEqual(done.returncode, 0)
        two = json.loads((self.folder / "two/summary.json").read_text())["waves"]["design"]
        self.assertEqual({key: one[key] for key in two if key != "warnings"},
                         {key: two[key] for key in two if key != "warnings"})

    def test_a_case_passes_over_every_table_of_a_design(self):
        shutil.copytree(CASES / "designer", self.folder / "own")
        case = self.folder / "own/section.toml"
        given = case.read_text()
        for command in ("waves", "reliability"):
            keys = json.loads(upbead(command, "--schema").stdout)["properties"]
            own = [name for name, key in keys.items() if key.get("type") == "object" and f"[{name}" not in given]
            self.assertIn("scatter", own)
            case.write_text(given + "".join(f"\n[{name}]\n" for name in own))
            done = upbead("explain", case, *BONDED, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_where_the_scene_cannot_be_reduced_the_life_is_by_formulas(self):
        march = ["--set", 'time.scheme="generalised_alpha"', "--set", "time.step=0.05", "--set", "accuracy.tolerance=1e-12"]
        sheet, done = self.summary("sheet", *BONDED, *march)
        warning = next(one for one in sheet["warnings"] if one["name"] == "no_own_dynamics")
        self.assertIn("has not converged", warning["text"])
        self.assertIsNone(sheet["expected"]["expected"].get("dynamic"))
        self.assertIsNotNone(sheet["run"]["response"]["peak_shear"])
        self.assertEqual({row["part"] for row in sheet["checks"]}, {"waves", "run", "expected"})
        self.assertFalse((self.folder / "sheet/reduced.h5").exists())
        self.assertNotIn("reduced.h5", done.stdout)

    def composite(self, *more):
        """A case of one wave by formulas on a small mesh, which is a design, too."""
        text = (CASES / "design-wave/composite.toml").read_text()
        text = text.replace("seabed_front = 400", "seabed_front = 100").replace("seabed_back = 400", "seabed_back = 100")
        case = self.folder / "one.toml"
        case.write_text(text + "\n[waves.storm]\nheight = 11.0\nperiod = 12.0\n" + "\n".join(more) + "\n")
        return case

    def test_limits_that_no_check_judges_stand_on_the_sheet(self):
        limits = {"circles": 1.1, "settlement": 0.1, "tilt": 0.01, "safety": 1.2, "lives_beyond": 0.1, "dynamic_base_pressure": 5e5}
        asked = [word for key, value in limits.items() for word in ("--set", f"limits.{key}={value}")]
        done = upbead("sheet", CASES / "designer/design.toml", *asked, "--out", "design", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check_unjudged(limits, "design", done.stdout)
        case = self.composite()
        done = upbead("sheet", case, "--set", "limits.settlement=0.1", "--set", "limits.tilt=0.01", "--out", "case", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check_unjudged(("settlement", "tilt"), "case", done.stdout)

    def check_unjudged(self, limits, folder, screen):
        sheet = json.loads((self.folder / folder / "summary.json").read_text())
        rows = {row["measure"]: row for row in sheet["checks"]}
        for key in limits:
            row = rows[f"limits.{key}"]
            self.assertEqual(row["limit"], key)
            self.assertIsNone(row["holds"])
            self.assertTrue(row["why_not"], key)
            self.assertIn(row["name"] + ": not checked", screen)
        self.assertEqual(sheet["verdict"]["unjudged"], len(limits))
        self.assertIn("limits that were not checked", sheet["verdict"]["text"])

    CHANCES = ["--set", "reliability.samples=2000", "--set", 'reliability.methods=["form", "importance"]', "--set", "life.simulated_lives=100"]

    def chances(self, command, *options, case=CASES / "designer/reliability.toml"):
        done = upbead(command, case, *self.CHANCES, *options, "--out", command, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / command / "summary.json").read_text()), done

    def test_probabilities_are_those_of_reliability(self):
        given = ["--set", "reliability.targets.eurocode_life=3.8", "--set", "reliability.targets.pianc_life=0.05"]
        sheet, done = self.chances("sheet", *given)
        alone, _ = self.chances("reliability", *given)
        rows = [row for row in sheet["checks"] if row["part"] == "reliability"]
        by_name = lambda row: row["name"]
        own = {"part", "governs"}
        self.assertEqual(sorted(({k: v for k, v in row.items() if k not in own} for row in rows), key=by_name),
                         sorted(alone["checks"], key=by_name))
        self.assertEqual({row["mode"] for row in rows}, {"failure over the life"})
        for name, mode in alone["modes"].items():  # each way to fail and each gate has its row
            row = next(row for row in rows if row["measure"] == f"modes.{name}.life.index")
            self.assertEqual((row["demand"], row.get("probability")), (mode["life"]["index"], mode["life"]["probability"]))
            self.assertEqual(row["by"], mode["governing"] or "formulas")
            self.assertEqual(row["why_not"] is None, mode["life"]["index"] is not None)
            self.assertIn("distributions assumed by the file: friction lognormal, goda normal, height gumbel", row["assumption"])
        self.assertEqual(sum(row["capacity"] is not None for row in rows), 3, "the target and both demands that the file gives")
        self.assertEqual(sheet["reliability"]["modes"], alone["modes"])
        self.assertEqual(sheet["parts"][3], {"name": "reliability", "why_not": None})
        self.assertEqual({warning["text"] for warning in alone["warnings"]} - {warning["text"] for warning in sheet["warnings"]}, set())
        self.assertEqual(json.loads((self.folder / "sheet/reliability/summary.json").read_text())["modes"], alone["modes"])
        system = next(row for row in rows if row["name"] == "reliability index of the life")
        self.assertRegex(done.stdout, rf"reliability index of the life, wave yearly\s+P {system['probability']:.3g} .*2.38 +holds +reliability, ")
        self.check_markdown(sheet, (self.folder / "sheet/sheet.md").read_text())
        self.check_document(sheet)

    def test_a_target_that_is_missed_fails_the_sheet(self):
        sheets = [self.chances("sheet", "--set", f"reliability.target={target}")[0] for target in (2.38, 9.0)]
        held, missed = (sheet["verdict"] for sheet in sheets)
        self.assertEqual(missed["failing"], held["failing"] + 1)
        self.assertIs(missed["holds"], False)
        row = next(row for row in sheets[1]["checks"] if row["name"] == "reliability index of the life")
        self.assertEqual((row["holds"], row["capacity"], row["at_least"]), (False, 9.0, True))

    def test_a_probability_that_is_not_found_stands_with_its_reason(self):
        case = self.composite()  # a wave and no probability: as it was
        done = upbead("sheet", case, "--out", "none", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        sheet = json.loads((self.folder / "none/summary.json").read_text())
        self.assertEqual([part["name"] for part in sheet["parts"]], ["waves", "run", "expected"])
        self.assertNotIn("reliability", sheet)
        self.assertFalse((self.folder / "none/reliability").exists())
        design = (CASES / "designer/reliability.toml").read_text()
        shutil.copy(CASES / "designer/storms.csv", self.folder)
        without = self.folder / "without.toml"
        without.write_text(design[: design.index("[waves.yearly]")] + design[design.index("[limits]") :])
        done = upbead("sheet", without, "--out", "without", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        sheet = json.loads((self.folder / "without/summary.json").read_text())
        row = next(row for row in sheet["checks"] if row["part"] == "reliability")
        self.assertIn("no [waves.NAME]", row["why_not"])
        self.assertEqual((row["capacity"], row["holds"], sheet["verdict"]["unjudged"]), (2.38, None, 1))
        wild = ["--set", "reliability.variables.weight.cov=0.5"]  # samples without weight, where formulas do not hold
        sheet, _ = self.chances("sheet", *wild)
        alone = upbead("reliability", CASES / "designer/reliability.toml", *self.CHANCES, *wild, "--out", "wild", cwd=self.folder)
        rows = [row for row in sheet["checks"] if row["part"] == "reliability"]
        if alone.returncode == 0:
            self.assertEqual(len(rows), len(json.loads((self.folder / "wild/summary.json").read_text())["checks"]))
        else:
            self.assertIn(alone.stderr.strip().splitlines()[0], rows[0]["why_not"])
            self.assertEqual(sheet["verdict"]["unjudged"], 1)

    def test_mistakes_of_reliability_are_told_before_anything_is_done(self):
        done = upbead("sheet", CASES / "designer/reliability.toml", "--set", 'reliability.methods=["forn"]', "--set", "section.width=-1",
                      "--out", "bad", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        for word in ("there is no method 'forn'", "width = -1"):
            self.assertIn(word, done.stderr)
        self.assertFalse((self.folder / "bad").exists())

    def test_an_interrupted_sheet_ends_its_child(self):
        before = set(children_named("upbead-reliabil"))
        plain = ["--set", 'reliability.methods=["plain"]', "--set", "reliability.plain_samples=100000000"]
        sheet = subprocess.Popen([PROGRAM, "sheet", CASES / "designer/reliability.toml", *plain, "--out", "stopped"], cwd=self.folder,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        own = []
        for _ in range(1200):
            own = [pid for pid in set(children_named("upbead-reliabil")) - before if parent_of(pid) == sheet.pid]
            if own or sheet.poll() is not None:
                break
            time.sleep(0.1)
        self.assertTrue(own, "the sheet has a child that samples")
        sheet.send_signal(signal.SIGTERM)
        self.assertEqual(sheet.wait(60), 143)
        sheet.stderr.close()
        self.assertFalse(os.path.exists(f"/proc/{own[0]}"))
        self.assertEqual(self.left_behind(), [])

    def test_run_and_waves_have_one_sliding_distance_by_formulas(self):
        case = self.composite("[duration]", "b = 1.0", "[combined]", "added_mass_factor = 0.5")
        for more in ([], ["--set", "loads.storm.wave.course='triangle'"]):
            done = upbead("sheet", case, "--set", "section.friction=0.45", *more, "--out", "out", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = json.loads((self.folder / "out/summary.json").read_text())["checks"]
            found = {row["part"]: row["demand"] for row in rows if row["name"] == "sliding distance by formulas"}
            self.assertEqual(set(found), {"run", "waves"})
            self.assertGreater(found["run"], 0.01)
            self.assertAlmostEqual(found["run"] / found["waves"], 1, 12)

    def test_a_model_of_other_ground_is_told(self):
        life = ["[sea]", f'states = "{CASES}/designer/storms.csv"', "years = 50"]
        case = self.composite(*life)
        self.assertEqual(upbead("reduce", case, "--out", "own", cwd=self.folder).returncode, 0)
        for options, told in (([], False), (["--set", "regions.seabed.shear_modulus=3e6"], True)):
            done = upbead("sheet", case, *options, "--set", f"dynamics.model='{self.folder}/own/reduced.h5'", "--out", "out",
                          cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            sheet = json.loads((self.folder / "out/summary.json").read_text())
            found = [one for one in sheet["warnings"] if one["name"] == "model_of_other_scene"]
            self.assertEqual(len(found), told)
            if told:
                self.assertIn("regions.seabed", found[0]["text"])

    def test_a_model_of_other_ground_is_told_without_a_life(self):
        chances = ["[reliability]", 'wave = "storm"', "dynamics = true", 'methods = ["form"]', "[reliability.variables.friction]", 'acts_on = "section.friction"',
                   'distribution = "lognormal"', "mean = 0.6", "cov = 0.15"]  # fmt: skip
        case = self.composite(*chances)
        self.assertEqual(upbead("reduce", case, "--out", "own", cwd=self.folder).returncode, 0)
        for options, told in (([], False), (["--set", "regions.seabed.shear_modulus=3e6"], True)):
            sheet = self.json_of("sheet", case, *options[1:], f"dynamics.model='{self.folder}/own/reduced.h5'")
            self.assertIsNone(sheet["expected"])
            found = [one for one in sheet["warnings"] if one["name"] == "model_of_other_scene"]
            self.assertEqual(len(found), told)
            if told:
                self.assertIn("the chances have the dynamics of", found[0]["text"])

    def test_run_and_waves_of_one_file_keep_their_results(self):
        case = self.composite()
        for command in ("run", "waves"):
            self.assertEqual(upbead(command, case, cwd=self.folder).returncode, 0)
        run = json.loads((self.folder / "results/one/summary.json").read_text())
        waves = json.loads((self.folder / "results/one-waves/summary.json").read_text())
        self.assertIn("response", run)
        self.assertIn("storm", waves["waves"])

    def test_scaling_tells_what_it_leaves_out(self):
        done = upbead("scale", self.composite(), "--factor", "0.05", "--out", "scaled", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("lacks [waves]", done.stderr)

    def test_mistakes_of_all_tables_are_told_at_once(self):
        shutil.copytree(CASES / "designer", self.folder / "own")
        case = self.folder / "own/section.toml"
        case.write_text(case.read_text().replace("period = 14.0", "period = -14.0").replace("degree = 2", "degrees = 2")
                        .replace("overturning = 1.2", "overturning = -1.2") + "\n[regoins]\n")
        done = upbead("sheet", case, "--out", "out", cwd=self.folder)
        self.assertEqual(done.returncode, 1)
        for word in ("period = -14", "degrees", "overturning = -1.2", "regoins"):
            self.assertIn(word, done.stderr)
        self.assertEqual(done.stderr.count("overturning = -1.2"), 1)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
