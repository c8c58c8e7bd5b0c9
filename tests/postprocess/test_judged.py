"""Nothing that speaks against a section is left out: every check that fails and every warning of a summary stands in the
terminal, in the report in both languages, and in the page.

usage: test_judged.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES [at_length]
"""

import html
import json
import random
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path
from unittest import mock

from judged_designs import design

SCRIPTS, PROGRAM, CASES = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(SCRIPTS))

from report import inputs, judged, kinds, reference, sheet, source_case, verdict  # noqa: E402
from report.language import speaking  # noqa: E402
from upbead import live, told, typeset  # noqa: E402
from upbead.errors import UserError  # noqa: E402
from upbead.live.document import among  # noqa: E402
from upbead.opening import open_result  # noqa: E402
from upbead.results import read_case  # noqa: E402

QUICK, MANY = 10, 100  # random designs
MADE = {  # a summary has these in places that no program of today writes
    "verdict": {"holds": None, "why_void": "the ground <fails> & nothing holds", "failing": 2, "checked": 3},
    "checks": [
        {"name": "sliding by formulas", "by": "formulas", "wave": "a_wave", "level": "low", "unit": "", "demand": 0.9, "capacity": 1.0, "margin": 0.9,
         "holds": False, "measure": "x", "assumption": None, "why_not": None, "text": "sliding: 0.9 against 1 <b>: F_T tau_0 m^2 DOES NOT HOLD"},
        {"name": "a check that nobody knows", "unit": "Pa", "demand": None, "capacity": 1e5, "margin": None, "holds": False, "measure": "y", "assumption": "z"},
        {"name": "seaward", "unit": "", "demand": None, "capacity": 1.0, "margin": None, "holds": None, "why_not": "no trough acts", "measure": "w", "assumption": None},
    ],
    "warnings": [{"name": "routes_contradict", "cure": "look at <P>", "text": "F_T <above> alpha_1 & 'P'; look at <P>"}, {"name": "routes_contradict", "text": "another one"}],
    "deep": [{"inner": {"checks": [{"name": "hidden", "holds": False, "text": "hidden: DOES NOT HOLD"}], "warnings": [{"name": "inside", "text": "a list"}]}}],
}  # fmt: skip


def said(found):
    """Texts of a summary that must stand: the test's own walk through it."""
    if isinstance(found, dict):
        if found.get("holds") is False and "name" in found:
            yield found.get("text") or found["name"]
        if found.get("why_void"):
            yield found["why_void"]
        for warning in found["warnings"] if isinstance(found.get("warnings"), list) else ():
            cure = warning.get("cure") or ""
            yield from (warning["name"], cure, warning["text"].removesuffix(f"; {cure}"))
        for key, value in found.items():
            yield from said(value)
    elif isinstance(found, list):
        for value in found:
            yield from said(value)


def on_terminal(summary):
    """A warning of one wave at one level may stand for others of its name; of the whole summary none does."""
    above = {key: value for key, value in summary.items() if key != "waves"}
    below = summary.get("waves") if isinstance(summary.get("waves"), dict) else {}
    yield from said(above)
    names = {warning["name"] for path, one in told.objects(below) for warning in one.get("warnings") or ()}
    yield from names


def plain(text):
    return " ".join(text.split())


def visible(page):
    page = re.sub(r"<(script|style)\b.*?</\1>", " ", page, flags=re.DOTALL)
    return plain(html.unescape(re.sub(r"<[^>]*>", "", page)))


def as_set(text):
    """Words of the program as a report sets them: alpha_1 as α with a subscript."""
    return visible(typeset.words(html.escape(text)))


class Judged(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def solve(self, command, file, *settings):
        """(folder of the results, what stood on the terminal)."""
        out = self.folder / f"{command}-{file.parent.name}-{file.stem}"
        words = [word for setting in settings for word in ("--set", setting)]
        done = subprocess.run([PROGRAM, command, file, "--out", out, *words], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, f"{file}: {done.stderr}")
        return out, plain(done.stdout + done.stderr)

    def stand(self, wanted, text, where):
        missing = [one for one in wanted if plain(one) not in text]
        self.assertEqual(missing, [], where)

    def documents(self, folder, page=True, notebook=True):
        """Report in both languages, page and notebook hold all; returns how much there was."""
        wanted = list(said(json.loads((folder / "summary.json").read_text())))
        for language in ("en", "ja"):
            text = visible(kinds.build(folder, None, language))
            self.stand(map(as_set, wanted), text, (folder.name, language))
            verdict = text.partition("Question" if language == "en" else "検討課題")[2][:3000]
            self.assertFalse(wanted and ("limit all hold" in verdict or "すべて満足する" in verdict), folder.name)
        if notebook:
            self.stand(wanted, visible(open_result(folder)._repr_html_()), (folder.name, "notebook"))
        if page:
            self.stand(map(as_set, wanted), visible(live.page(folder, folder / "page.html", program=PROGRAM).read_text(encoding="utf-8")), (folder.name, "page"))
        return len(wanted)

    def designs(self, seeds):
        found = 0
        for seed in seeds:
            file = self.folder / f"random-{seed}.toml"
            file.write_text(design(seed), encoding="utf-8")
            commands = ["waves", "expected"] if "[storms]" in file.read_text() else ["waves"]
            for command in commands:
                folder, terminal = self.solve(command, file)
                self.stand(on_terminal(json.loads((folder / "summary.json").read_text())), terminal, (command, seed))
                found += self.documents(folder, command == "waves" or seed % 5 == 0, seed % 10 == 0)
        return found

    def test_random_designs(self):
        self.assertGreater(self.designs(range(QUICK)), QUICK)

    def test_random_designs_at_length(self):
        self.designs(range(QUICK, MANY))

    def shipped(self, files):
        for file in files:
            keys = tomllib.loads(file.read_text(encoding="utf-8"))
            commands = ["run"] if "mesh" in keys else ["waves"] * ("waves" in keys) + ["expected"] * ("sea" in keys or "storms" in keys) * ("dynamics" not in keys)
            for command in commands:
                folder, terminal = self.solve(command, file)
                self.stand(on_terminal(json.loads((folder / "summary.json").read_text())), terminal, file)
                self.documents(folder, command != "run")
                self.assertEqual(self.changed(folder, file, command), [], file)

    def changed(self, folder, file, command):
        """Inputs that a report says to be set for the run, though nothing was."""
        known = reference.read(SCRIPTS.parent / "docs/reference" / ("case.md" if command == "run" else "design.md"))
        rows = inputs.rows(read_case(folder), source_case.read(file), source_case.units(folder / "case.toml"), known)
        return [(row.path, row.value) for row in rows if row.mark == "changed"]

    def test_some_shipped_cases(self):
        self.shipped([CASES / name for name in ("designer/design.toml", "fig7-9/impulsive.toml", "section4/hd10.toml", "fig2b-model.toml")])

    def test_all_shipped_cases_at_length(self):
        self.shipped(sorted(file for file in CASES.rglob("*.toml") if "study" not in file.parts and "calibration" not in file.parts))

    def test_wherever_they_stand_in_a_summary(self):
        """Checks and warnings that no program writes yet, in a summary of each kind."""
        file = CASES / "designer/design.toml"
        for command in ("run", "waves", "expected"):
            folder, _ = self.solve(command, CASES / "fig2b-model.toml" if command == "run" else file, *["mesh.parameters.cells=0.8"] * (command == "run"))
            summary = json.loads((folder / "summary.json").read_text())
            (folder / "summary.json").write_text(json.dumps(summary | MADE))
            if command == "run":  # the page of a model tells of the run in its folder
                subprocess.run([PROGRAM, "reduce", CASES / "fig2b-model.toml", "--set", "mesh.parameters.cells=0.8", "--out", folder], capture_output=True, check=True)
            self.assertGreater(self.documents(folder, command != "expected"), 8)
        copy = shutil.copytree(folder, self.folder / "failing")
        calm = {key: value for key, value in summary.items() if key not in ("checks", "warnings", "verdict")}
        holds = {**MADE["checks"][0], "holds": True, "text": "holds"}
        (copy / "summary.json").write_text(json.dumps(calm | {"checks": [holds], "warnings": []}))
        self.assertIn("Of 1 checks with a limit all hold", visible(kinds.build(copy)))

    def test_a_title_stays_as_written(self):
        """In the page and the report; the program's own words in them are set."""
        name, file = "Delta Flume, berth A_12", self.folder / "named.toml"
        text = (CASES / "designer/design.toml").read_text(encoding="utf-8")
        file.write_text(re.sub(r"(?m)^title = .*$", f'title = "{name}"', text), encoding="utf-8")
        page = live.page(file, self.folder / "page.html", program=PROGRAM).read_text(encoding="utf-8")
        for made in (page, kinds.build(self.solve("waves", file)[0])):
            self.assertRegex(made, f"<h1[^>]*>{name}</h1>")
            self.assertIn("<sub>", made)

    def test_models_beside_each_other_have_names_of_their_own(self):
        """Of one title in two folders, in one folder, in folders of one name, and one file twice."""
        for titles, files, wanted in (
            ("AB", ("x/reduced.h5", "y/reduced.h5"), ["A", "B"]),
            ("AA", ("x/reduced.h5", "y/reduced.h5"), ["x", "y"]),
            ("AAB", ("x/soft.h5", "x/stiff.h5", "x/other.h5"), ["x/soft", "x/stiff", "B"]),
            ("AAA", ("x/soft.h5", "x/stiff.h5", "y/soft.h5"), ["x/soft", "x/stiff", "y"]),
            ("AA", ("1/x/reduced.h5", "2/x/reduced.h5"), ["A (1)", "A (2)"]),
            ("AA", ("x/soft.h5", "x/soft.h5"), ["A (1)", "A (2)"]),
        ):
            told = iter(titles)
            with mock.patch("upbead.live.document.model_data", lambda _: {"title": next(told), "loads": []}):
                found = among(Path(files[0]), [Path(file) for file in files[1:]])
            self.assertEqual([one["soil"] for one in (found, *found["others"])], wanted)

    def test_ground_without_a_rest_leaves_no_word_on_sliding(self):
        folder, _ = self.solve("run", CASES / "fig2b-model.toml", "mesh.parameters.cells=0.8")
        summary = json.loads((folder / "summary.json").read_text())
        self.assertIn("does not slide", visible(kinds.build(folder)))
        (folder / "summary.json").write_text(json.dumps(summary | {"void": "the ground does not stand under its own weight"}))
        text = visible(kinds.build(folder))
        self.assertNotIn("does not slide", text)
        self.assertIn("Whether the caisson slides is not known", text)

    def test_a_void_run_makes_no_statement_and_marks_its_numbers(self):
        folder, _ = self.solve("run", CASES / "fig2b-model.toml", "mesh.parameters.cells=0.8", "time.end=0.015")
        for language, words, mark in (("en", "No number that follows may be relied on.", '"VOID"'), ("ja", "以下の数値は信頼できない。", "--void: ")):
            page = kinds.build(folder, language=language)
            self.assertIn(words, visible(page))
            self.assertIn('<body class="void">', page)
            self.assertIn(mark, page)
        self.assertNotIn("does not slide", visible(kinds.build(folder)))
        self.assertNotIn('class="void"', kinds.build(self.solve("run", CASES / "fig2b-model.toml", "mesh.parameters.cells=0.8")[0]))

    def test_a_limit_that_was_not_judged_is_told(self):
        held = {"name": "force against friction", "holds": True, "demand": 1.0, "capacity": 2.0, "limit": None}
        open_one = {"name": "sliding distance", "limit": "sliding", "holds": None, "capacity": 0.3, "why_not": "it still slides", "text": "sliding distance: not checked"}
        no_limit = {**open_one, "name": "force against friction, seaward", "limit": None}
        for language, words in (("en", "Limits that were given and not judged: sliding distance."), ("ja", "照査できなかったもの：滑動量。")):
            with speaking(language):
                text = visible(str(judged.verdict({"checks": [held, open_one, no_limit]})))
            self.assertIn(words, text)
        text = visible(str(judged.verdict({"checks": [held, open_one]})))
        self.assertNotIn("all hold", text)
        self.assertNotIn("No check has a limit", visible(str(judged.verdict({"checks": [open_one]}))))
        self.assertIn("sliding distance: not checked", told.listed({"checks": [held, open_one]}))
        self.assertNotIn("seaward", told.listed({"checks": [held, no_limit]}))

    def test_a_study_tells_of_its_void_runs_once(self):
        summary = {"runs": 4, "void": [{"runs": [1], "why": "load_cut"}], "checks": []}
        self.assertNotIn("No verdict may be drawn", visible(str(judged.verdict(summary))))
        self.assertIn("No verdict may be drawn: run 1", visible(str(judged.verdict({**summary, "runs": 1}))))

    def test_the_worst_check_comes_first(self):
        made = [{"name": str(i), "holds": random.Random(i).choice([True, False, None]), "margin": random.Random(i + 50).random()} for i in range(30)]
        order = told.checks({"checks": made})
        self.assertEqual(len(order), 30)
        ranks = [{False: 0, True: 1, None: 2}[check["holds"]] for check in order]
        self.assertEqual(ranks, sorted(ranks))
        failing = [check["margin"] for check in order if check["holds"] is False]
        self.assertEqual(failing, sorted(failing))

    def test_a_study_tells_in_how_many_runs_a_check_fails(self):
        check = {"name": "sliding distance", "failing": 4, "judged": 6, "first_run": 1, "worst_run": 3, "text": "sliding distance: 0.2 m against 0.1 m: DOES NOT HOLD"}
        for language, words in (("en", "in some of 6 runs: sliding distance in 4."), ("ja", "6ケースの一部で満足しない照査：滑動量（4ケース）")):
            with speaking(language):
                self.assertIn(words, visible(str(judged.verdict({"runs": 6, "checks": [check]}))))

    def test_a_check_that_no_run_judged_does_not_hold(self):
        check = {"name": "sliding distance", "failing": 0, "judged": 0, "holds": None, "why_not": "it still slides", "capacity": 0.3}
        self.assertNotIn("all hold", visible(str(judged.verdict({"runs": 3, "checks": [check]}))))

    def test_what_fails_by_little_does_not_look_like_its_limit(self):
        check = {"name": "sliding distance", "unit": "m", "demand": 0.0277384, "capacity": 0.0277383, "margin": 0.99999968, "holds": False}
        with speaking("ja"):
            row, sentence = (visible(str(text)) for text in (sheet.verdicts([check]), judged.in_words(check)))
        for text in (row, sentence):
            self.assertIn("27.7384", text)
            self.assertIn("27.7383", text)
        self.assertIn("0.9999997", row)

    def test_ground_that_carries_the_caisson_is_told_first(self):
        summary = {"nonlinear": {"start": "k0"}, "residual": {"displacement_x": -0.348, "displacement_y": -0.218, "rotation": 0.0087}}
        for language, words in (("en", "carries it 348 mm seaward; it settles by 218 mm"), ("ja", "港外側へ348 mm運び、沈下量は218 mm")):
            with speaking(language):
                self.assertIn(words, visible(str(verdict.carried(summary))).replace("\u00a0", " "))
        self.assertEqual(verdict.carried({"nonlinear": None, "residual": None}), "")

    def test_a_caisson_that_slides_on_is_said_to(self):
        folder, _ = self.solve("run", CASES / "fig2b-model.toml", "mesh.parameters.cells=0.8", "loads.impulse.factor=5")
        summary = json.loads((folder / "summary.json").read_text())
        self.assertIn("By this run the caisson slides about", visible(kinds.build(folder)))
        summary["sliding"]["design"]["why_not_all"] = "it still slides at the end"
        (folder / "summary.json").write_text(json.dumps(summary))
        text = visible(kinds.build(folder)).replace("\u00a0", " ")
        self.assertRegex(text, "the caisson slides at least [0-9.]+ mm landward, and more is not known: it still slides at the end")
        self.assertRegex(text, "sliding distance Sat least [0-9.]+ mmit still slides at the end")
        self.assertRegex(open_result(folder)._repr_html_(), "<td>at least [0-9.]+ mm")
        summary["sliding"]["design"]["rests"] = False
        (folder / "summary.json").write_text(json.dumps(summary))
        text = visible(kinds.build(folder))
        self.assertIn("does not come to rest", text)
        self.assertIn("it slides on, without bound", text)
        self.assertNotIn("By this run the caisson slides about", text)

    def test_a_folder_without_document_says_whose_it_is(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "summary.json").write_text(json.dumps({"modes": [], "codes": []}))
            with self.assertRaisesRegex(UserError, "results of 'upbead reliability'"):
                kinds.build(Path(folder))


if __name__ == "__main__":
    asked = [name for name in unittest.TestLoader().getTestCaseNames(Judged) if name.endswith("at_length") == (sys.argv[4:] == ["at_length"])]
    unittest.main(argv=[sys.argv[0], *(f"Judged.{name}" for name in asked)])
