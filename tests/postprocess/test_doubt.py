"""Void runs and numbers in doubt reach who looks at a figure, a table or a notebook.

usage: test_doubt.py FOLDER_OF_THE_SCRIPTS
"""

import json
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import h5py
import numpy as np
from scripts import call

SCRIPTS = Path(sys.argv[1])
sys.path.insert(0, str(SCRIPTS))
import upbead  # noqa: E402
from upbead import commands, figures, told  # noqa: E402

CUT = [{"name": "load_cut", "text": "the run ends before its load", "cure": "let it end later"}]
VOID = {"verdict": {"why_void": "load_cut", "text": "VOID"}, "warnings": CUT}
DOUBTED = {"verdict": {"why_void": None, "text": "holds"}, "warnings": CUT}
WORDS = "VOID, as the warnings say: load_cut"


def words(figure):
    return [text.get_text().replace("\n", " ") for text in figure.texts]


class Doubts(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def run_with(self, summary):
        time = np.linspace(0.0, 1.0, 11)
        self.folder = self.folder / "another"  # what is open is not written again
        self.folder.mkdir()
        with h5py.File(self.folder / "results.h5", "w") as file:
            for name in ("time", "force", "inertia_force", "shear_force", "caisson/displacement_x"):
                file[f"history/{name}"] = time
        (self.folder / "summary.json").write_text(json.dumps({"title": "A run", **summary}))
        return upbead.open(self.folder)

    def study_with(self, *void):
        """A study of which each run is void for that reason, if any."""
        rows = [f"{i},{i + 1.0},{i + 0.5},done,,,{why},{why}" for i, why in enumerate(void)]
        (self.folder / "study.csv").write_text("\n".join(["run,a.b,c.d,status,message,checks_failing,warnings,void", *rows]) + "\n")
        with h5py.File(self.folder / "study.h5", "w") as file:
            file["varied/a.b"], file["read/c.d"] = np.arange(1.0, 1.0 + len(void)), np.arange(len(void))
        runs = [i for i, why in enumerate(void) if why]
        summary = {"title": "A study", "runs": len(void), "void": [{"runs": runs, "why": "load_cut"}] * bool(runs), "checks": [], "warnings": []}
        (self.folder / "summary.json").write_text(json.dumps(summary))
        return upbead.open(self.folder)

    def test_a_void_run_is_marked_with_its_reason(self):
        found = words(figures.response(self.run_with(VOID)))
        self.assertEqual(found, [WORDS, "VOID"])
        done = call(SCRIPTS / "response.py", self.folder, "-o", self.folder / "a.svg")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"<!-- {WORDS} -->", (self.folder / "a.svg").read_text())

    def test_numbers_in_doubt_name_the_warnings_and_sound_ones_have_no_mark(self):
        self.assertEqual(words(figures.response(self.run_with(DOUBTED))), ["In doubt, as the warnings say: load_cut"])
        self.assertEqual(words(figures.response(self.run_with({"warnings": []}))), [])

    def test_of_several_results_the_void_one_is_named(self):
        waves = {"w": {"safety_sliding": 0.9, "sliding_paper": 0.1}}
        summaries = [{"title": title, "section": {"friction": 0.6}, "waves": waves, **rest} for title, rest in (("A", VOID), ("B", {"verdict": {}}))]
        self.assertEqual(words(figures.sliding_safety(summaries)), ["VOID in part, as the warnings say: A: load_cut"])

    def test_void_runs_of_a_study_are_crosses_that_no_number_counts(self):
        table = self.study_with("", "load_cut", "")
        figure = figures.study(table)
        self.assertIn("VOID in part, as the warnings say: run 1: load_cut", words(figure))
        self.assertIn("3 runs, 1 void (crosses)", figure._suptitle.get_text())
        line, crosses = figure.axes[0].lines
        self.assertEqual((line.get_xdata().tolist(), crosses.get_xdata().tolist()), ([1.0, 3.0], [2.0]))
        self.assertIn("VOID", words(figures.study(self.study_with("load_cut", "load_cut"))))

    def test_numbers_of_draws_are_without_void_runs(self):
        table = self.study_with(*(("load_cut" if i > 20 else "") for i in range(40)))
        figure = figures.study(table)
        self.assertIn("median 10.5", figure.axes[-1].get_title())

    def test_a_table_of_a_study_tells_each_void_run(self):
        frame = self.study_with("", "load_cut").to_pandas()
        self.assertEqual(frame["void"].tolist(), ["", "load_cut"])
        self.assertEqual(self.study_with("", "").to_pandas()["void"].tolist(), ["", ""])  # words, as in the other

    def test_tables_of_a_void_run_say_so(self):
        result = self.run_with(VOID)
        self.assertEqual(result.to_pandas().attrs["void"], "load_cut")
        self.assertIn("VOID: load_cut", repr(result))
        sound = self.run_with(DOUBTED)
        self.assertEqual(("void" in sound.to_pandas().attrs, "VOID" in repr(sound)), (False, False))

    def test_a_command_warns_of_void_results(self):
        result = self.run_with(VOID)
        with self.assertWarnsRegex(UserWarning, "no verdict may be drawn of 'A run': load_cut"):
            self.assertIs(commands.warned(result), result)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            commands.warned(self.run_with(DOUBTED))

    def test_numbers_of_sound_runs_alone_are_drawn(self):
        table = self.study_with("", "load_cut")
        np.testing.assert_array_equal(table.sound("c.d"), [0.5, np.nan])
        self.assertIn("1 of them void", repr(table))

    def test_a_notebook_tells_void_runs_of_a_study(self):
        self.assertIn("No verdict may be drawn: run 1: load_cut", self.study_with("", "load_cut")._repr_html_())

    def test_many_void_runs_are_counted(self):
        summary = {"runs": 9, "void": [{"runs": list(range(8)), "why": "no_rest"}]}
        self.assertEqual(told.void(summary), "runs 0, 1, 2, 3, 4 and 3 more: no_rest")
        self.assertFalse(told.is_all_void(summary))

    def test_a_model_of_a_void_scene_marks_its_figures(self):
        model = type("Model", (), {"title": "m", "warnings": [{"name": "no_rest", "text": "t", "voids": True}]})()
        self.assertEqual(told.void(told.summaries([model])[0]), "no_rest")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
