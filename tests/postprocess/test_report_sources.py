"""Where each input of a report comes from. Usage: test_report_sources.py FOLDER_OF_THE_SCRIPTS UPBEAD"""

import copy
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

SCRIPTS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess"
PROGRAM = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).parents[2] / "build" / "upbead"
sys.path.insert(0, str(SCRIPTS))

from report import assumptions, inputs, remarks, source_case  # noqa: E402

CASE = """#:schema upbead-case.schema.json
# Port B, quay 3.
# The soil is that of the borings; what is "assumed" says so.

title = "mine"
[section]  # dimensions in m
width = 14  # from drawing C-104
crest = 8
friction = 0.6  # of concrete on rubble, assumed
submerged_weight = 3042081
# guess
bed_slope = 0.01
berm_width = 7
[sliding]
drag = 0.0
[sliding.uplift]
kind = "none"  # the unsafe side, but assumed
# 砂（推定値）
[regions.seabed]
shear_modulus = 40e6  # at small strain (Pa)
porosity = 0.4  # measured, not assumed
damping = { ratio = 0.05, frequencies = [1,
  10] }
[regions.mound]  # rubble, assumed
shear_modulus = 80e6
poissons_ratio = 0.3  # 図面
[regions."a.b # c"]  # typical
shear_modulus = 1e6
[regions.caisson]
density = 2100
# These values are estimates:
centre_of_gravity = [0.0, 5.0]
moment_of_inertia = 1e6

width = 3.0
[limits]
sliding = 0.3  # m, 仮定
overturning = 1.2  # not assumed: the client's
[accuracy]
tolerance = 0.005  # of the estimated error
[report]
text = \"\"\"
[regions.mound]  # measured
shear_modulus = 3  # measured
\"\"\"
"""
WANTED = {
    "section.width": "given", "section.crest": "given", "section.friction": "assumed", "section.submerged_weight": "given",
    "section.bed_slope": "assumed", "section.berm_width": "given", "sliding.friction": "derived", "sliding.submerged_weight": "derived",
    "sliding.drag": "given", "sliding.uplift.kind": "assumed", "regions.seabed.shear_modulus": "assumed", "regions.seabed.porosity": "measured",
    "regions.seabed.damping.ratio": "assumed", "regions.seabed.damping.frequencies": "assumed", "regions.mound.shear_modulus": "assumed",
    "regions.mound.poissons_ratio": "given", "regions.a.b # c.shear_modulus": "assumed", "regions.caisson.density": "given",
    "regions.caisson.centre_of_gravity": "assumed", "regions.caisson.moment_of_inertia": "assumed", "regions.caisson.width": "given",
    "limits.sliding": "assumed", "limits.overturning": "given", "accuracy.tolerance": "given", "regions.seabed.tortuosity": "default",
    "time.end": "changed", "gravity": "default",
}  # fmt: skip
SAYS = (
    ("assumed", "assumed|sand; assumed|Assumption|an estimate|estimated from N|our own guess|typical of rubble|typ. value|tbd|to be confirmed|"
                "not yet measured|unknown|仮定|推定値|N値より推定|想定|仮の値|暫定|一般的な値|typically 0.4; measured elsewhere"),
    ("calibrated", "calibrated|fitted to the test|同定値|逆解析による"),
    ("measured", "measured: three cores|as measured|実測（仮定ではない）|現地計測"),
    ("derived", "derived|computed from W|算定値"),
    ("given", "given|from drawing 3|図面による"),
    ("", "highest wave (m)|the safe side|not assumed|no longer assumed|a shipped section; or file = \"assumed\"|仮想質量|N/m, of the caisson"),
)  # fmt: skip
HEADS = (
    ("assumed", "All other numbers are assumed, see README.md.|all dimensions and soils are our own.|The section is ours and its numbers are assumptions|"
                "その他の数値はすべて仮定である。"),
    ("measured", "All other values are measured"),
    ("", 'What is marked "assumed" is to be replaced.|Some numbers are assumed|'),
)  # fmt: skip


class Marks(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.path = Path(self.temporary.name) / "mine.toml"
        self.path.write_text(CASE, encoding="utf-8")
        self.source = source_case.read(self.path)

    def tearDown(self):
        self.temporary.cleanup()

    def rows(self, case):
        return {".".join(row.path): row for row in inputs.rows(case, self.source)}

    def effective(self):
        """What the program makes of the case: defaults, and what it takes from [section]."""
        case = copy.deepcopy(self.source.values)
        case["sliding"] |= {"friction": 0.6, "submerged_weight": 3042081}
        case["regions"]["seabed"]["tortuosity"] = 1.0
        return case | {"time": {"end": 3.0}, "gravity": 9.81}

    def test_every_value_tells_where_it_comes_from(self):
        rows = self.rows(self.effective())
        self.assertEqual({path: rows[path].mark for path in WANTED}, WANTED)
        self.assertIn("section.friction, there: assumed", rows["sliding.friction"].remark)
        self.assertIn("section.submerged_weight, there: given", rows["sliding.submerged_weight"].remark)

    def test_what_is_set_for_the_run_is_told_beside_what_the_case_has(self):
        case = self.effective()
        case["sliding"]["friction"] = case["section"]["friction"] = 0.5
        rows = self.rows(case)
        self.assertEqual((rows["section.friction"].mark, rows["sliding.friction"].mark), ("changed", "derived"))
        self.assertIn("the case file has 0.6", rows["section.friction"].remark)
        case["section"]["friction"] = 0.6
        self.assertEqual(self.rows(case)["sliding.friction"].mark, "changed")

    def test_without_the_author_s_file_what_is_taken_from_elsewhere_is_known(self):
        rows = {".".join(row.path): row.mark for row in inputs.rows(self.effective(), None)}
        self.assertEqual((rows["sliding.friction"], rows["section.crest"], rows["gravity"]), ("derived", "given", "default"))

    def test_an_older_name_is_that_of_the_case(self):
        self.path.write_text("[sliding]\nfriction = 0.5  # assumed\nbuoyant_weight = 2e6  # guess\n")
        self.source = source_case.read(self.path)
        rows = self.rows({"sliding": {"friction": 0.5, "submerged_weight": 2e6}})
        self.assertEqual({row.mark for row in rows.values()}, {"assumed"})

    def test_words_of_authors(self):
        for mark, comments in SAYS:
            for comment in comments.split("|"):
                self.assertEqual(remarks.marked(comment)[0], mark, comment)
        for mark, heads in HEADS:
            for head in heads.split("|"):
                self.assertEqual(remarks.of_the_rest(head), mark, head)

    def test_what_is_written_for_editors_is_not_for_clients(self):
        quoted = assumptions.head(self.source)
        self.assertIn("Port B, quay 3.", quoted)
        for text in (quoted, source_case.shown(self.path)):
            self.assertNotIn("schema", text)
        self.assertEqual(tomllib.loads(source_case.shown(self.path)), self.source.values)


class Template(unittest.TestCase):
    """The case of `upbead new`: nothing that is marked assumed is told as given, and nothing of it is quoted."""

    def test_its_marks_and_its_head(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "breakwater.toml"
            subprocess.run([PROGRAM, "new", path], check=True, capture_output=True)
            source = source_case.read(path)
            self.assertEqual(source.head, "")
            self.assertEqual(assumptions.head(source), "")
            rows = {".".join(row.path): row.mark for row in inputs.rows(source.values, source)}
            lines = path.read_text(encoding="utf-8").splitlines()
            table, marked = "", {}
            for line in lines:
                table = line.partition("]")[0][1:] if line.startswith("[") else table
                key = f"{table}.{line.partition(' =')[0]}"
                if " = " in line and "assumed" in line.partition("#")[2]:
                    marked[key] = rows[key]
            self.assertGreater(len(marked), 5)
            self.assertEqual(set(marked.values()), {"assumed"}, marked)
            soils = {mark for path, mark in rows.items() if path.startswith(("regions.seabed.", "regions.mound.")) and not path.endswith("kind")}
            self.assertEqual(soils, {"assumed"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
