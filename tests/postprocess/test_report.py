"""The content of the report of a run. Usage: test_report.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES"""

import json
import re
import sys
import tempfile
import time
import unittest
from pathlib import Path

import report_results as made
from report_results import CASES, page, run

SECTIONS = [
    "question",
    "verdict",
    "section",
    "loads",
    "response-section",
    "base-section",
    "sliding",
    "fields-section",
    "measured-section",
    "sheet",
    "quality",
    "sensitivity",
    "assumptions",
    "run",
    "formulas",
    "skipped",
    "inputs",
    "case",
]  # in the order of the page
COARSE = "mesh.parameters.cells=0.5"


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        folder = Path(cls.temporary.name)
        case = CASES / "fig2b-prototype.toml"
        cls.plain = run(case, folder / "plain", COARSE)
        limits = ("limits={ sliding=0.3, base_pressure=4e5 }", 'report={ project="A <b> mole", revision="C" }')
        friction = 'regions.caisson.interface.kind="friction"'
        cls.slid = run(case, folder / "slid", COARSE, "loads.impulse.factor=5", friction, *limits)
        fields = run(case, folder / "fields", COARSE, "output.fields={ every = 0.05 }")
        cls.full = made.with_records(fields, folder / "full")
        cls.column = made.column(folder)
        cls.pages = {name: page(getattr(cls, name))[0] for name in ("plain", "slid", "full", "column")}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def summary(self, name):
        return json.loads((getattr(self, name) / "summary.json").read_text())

    def section(self, name, section):
        return self.pages[name].partition(f'<section id="{section}"')[2].partition("</section>")[0]

    def exact(self, name):
        """The exact values behind the numbers of a page."""
        return {float(value) for value in re.findall(r'<data value="([-+.\deinf]+)"', self.pages[name])}

    def test_every_section_stands_in_the_order_of_a_client(self):
        places = [self.pages["full"].find(f'<section id="{name}"') for name in SECTIONS]
        self.assertEqual(places, sorted(places), dict(zip(SECTIONS, places)))
        self.assertNotIn(-1, places)

    def test_the_sheet_has_every_check_with_its_numbers(self):
        sheet = self.section("slid", "sheet")
        for told in ("does not hold", "holds", "no limit given"):
            self.assertIn(told, sheet)
        for told in ("A &lt;b&gt; mole", ">C<"):
            self.assertIn(told, self.pages["slid"].partition("</header>")[0])
        self.assertIn(">mound<", self.section("slid", "section"))
        for check in self.summary("slid")["checks"]:
            for value in (check["demand"], check["capacity"]):
                if value is not None:
                    self.assertIn(f'value="{value!r}"', sheet)
            self.assertIn(check["measure"], sheet)

    def test_nothing_is_drawn_that_was_not_asked_for(self):
        for absent in ("fields-section", "measured-section", "base-pressures"):
            self.assertIn(f'id="{absent}"', self.pages["full"])
        self.assertNotIn('id="fields-section"', self.pages["plain"])
        self.assertNotIn('id="measured-section"', self.pages["plain"])
        self.assertNotIn('id="sliding"', self.pages["column"])

    def test_numbers_are_those_of_the_summary(self):
        for name in ("plain", "slid", "full"):
            found, summary = self.exact(name), self.summary(name)
            response, sliding = summary["response"], summary["sliding"]
            wanted = [
                response[key]
                for key in (
                    "peak_force",
                    "peak_shear",
                    "peak_shear_time",
                    "shear_to_force_ratio",
                    "impulse",
                    "peak_displacement",
                    "peak_base_moment",
                    "reaction_mismatch",
                )
            ]
            wanted += [
                sliding[key] for key in ("sliding_history", "sliding_normal_force", "sliding_coupled", "resistance")
            ]
            wanted += [summary["discretisation"]["unknowns"], summary["timing"]["total"]]
            self.assertEqual([value for value in wanted if value not in found], [], name)
        self.assertIn(self.summary("slid")["contact"]["solved"]["slip"], self.exact("slid"))
        for value in self.summary("full")["measured"]["load_cell_3"].values():
            self.assertTrue(value == "shear_force" or value in self.exact("full"), value)

    def test_the_three_numbers_stand_at_the_head(self):
        summary = self.summary("slid")
        head = self.pages["slid"].partition("</header>")[0]
        for value in (
            summary["response"]["peak_shear"],
            summary["response"]["shear_to_force_ratio"],
            summary["contact"]["solved"]["slip"],
        ):
            self.assertIn(f'<data value="{value!r}">', head)

    def test_titles_and_remarks_are_text(self):
        text = self.pages["column"]
        self.assertNotIn("<b>&", text)
        self.assertNotIn("<script>alert", text)
        self.assertEqual(
            text.count("&lt;b&gt;&amp;&quot;&lt;/b&gt;&lt;script&gt;alert(1)&lt;/script&gt;"), 2
        )  # in the title and the head
        self.assertNotIn("<record>", self.pages["full"])

    def test_the_page_needs_nothing_else(self):
        for name, text in self.pages.items():
            self.assertNotIn("http", text, name)
            self.assertNotRegex(text, r"""\b(src|srcset|poster)=|@import|url\((?!#)""", name)  # hatches of the page itself have a name
            self.assertLessEqual(set(re.findall(r'href="([^"]*)"', text)), {"data:,", "#quality"}, name)

    def test_every_plot_has_a_still_picture_and_the_same_data(self):
        for name, text in self.pages.items():
            plots = re.findall(r'<figure id="([\w-]+)" class="plot">(.*?)</figure>', text, re.DOTALL)
            self.assertTrue(plots, name)
            for plot, inside in plots:
                told = json.loads(re.search(r'class="plot">(.*?)</script>', inside, re.DOTALL)[1])
                lines = [line for panel in told["panels"] for line in panel["lines"]]
                self.assertTrue(lines and all(len(line["x"]) == len(line["y"]) > 1 for line in lines), (name, plot))
                self.assertEqual(inside.count('class="line '), len(lines), (name, plot))

    def test_the_peak_is_marked_in_the_figure(self):
        told = json.loads(
            re.search(r'<figure id="response".*?json" class="plot">(.*?)</script>', self.pages["plain"], re.DOTALL)[1]
        )
        mark = told["panels"][2]["marks"][0]
        response = self.summary("plain")["response"]
        self.assertAlmostEqual(mark["x"], response["peak_shear_time"], places=9)
        self.assertAlmostEqual(1e3 * mark["y"], response["peak_shear"], places=3)

    def test_inputs_tell_where_they_come_from(self):
        text = self.pages["slid"]
        self.assertRegex(text, r'<code>factor</code>.*?<td class="number">5</td><td class="mark-changed">')
        self.assertRegex(text, r'<code>porosity</code>.*?<td class="number">0.4</td><td class="mark-assumed">')
        self.assertRegex(text, r'<code>tortuosity</code>.*?<td class="number">1</td><td class="mark-default">')
        self.assertRegex(text, r'<code>gravity</code>.*?<td class="mark-given">')
        self.assertIn("Nothing is calibrated here", text)

    def test_warnings_and_what_was_skipped_are_told(self):
        text = self.pages["full"]
        summary = self.summary("full")
        self.assertTrue(summary["warnings"])
        for warning in summary["warnings"]:
            self.assertIn(warning["name"].replace("_", " "), text)
        for entry in summary["skipped"]:
            self.assertIn(entry["what"].replace("_", " "), text)

    def test_the_page_is_small_and_quickly_made(self):
        start = time.perf_counter()
        text, _ = page(self.plain)
        print(
            f"\nreport of fig2b-prototype: {time.perf_counter() - start:.2f} s, {len(text.encode()) / 1e6:.2f} MB; "
            f"with fields {len(self.pages['full'].encode()) / 1e6:.2f} MB"
        )
        self.assertLess(len(self.pages["full"].encode()), 1.5e6)

    def test_mistakes_are_told(self):
        _, done = page(CASES)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no results.h5", done.stderr)
        _, done = page(self.plain, "-o", "/nowhere/page.html")
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write '/nowhere/page.html'", done.stderr)
        _, done = page(self.plain, "--pdf", "/tmp/never.pdf", environment={"PATH": "/nowhere"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("needs Chromium", done.stderr)
        _, done = page(self.plain, "--case", CASES / "fig2b-prototype-impulse.csv")
        self.assertEqual(done.returncode, 1)
        self.assertIn("is no case", done.stderr)

    def test_broken_fields_leave_the_rest(self):
        first = sorted((self.full / "fields").glob("*.vtu"))[0]
        whole = first.read_bytes()
        try:
            first.write_bytes(whole[: len(whole) // 2])
            text, done = page(self.full)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("Not shown: cannot read the fields", text)
        finally:
            first.write_bytes(whole)

    def test_the_outline_is_that_of_the_mesh(self):
        """Areas by kind from the parameters of composite.geo equal those of the cells in the fields."""
        two = run(CASES / "designer/section.toml", self.full.parent / "two", "output.fields={ every = 0.04 }", "time.end=0.04",
                  "mesh.full_domain=true", "mesh.parameters.cells=0.4", 'regions.caisson.interface.kind="bonded"')  # fmt: skip
        for folder in (self.full, two):
            self.compare_outlines(folder)

    def compare_outlines(self, folder):
        from report import frames, geometry
        from upbead.results import Result

        section = geometry.section(Result(folder).case, folder)
        cells = frames.read(folder / "fields.pvd", (-1e9, 1e9))
        corners = cells.points[cells.cells]
        area = {kind: sum(abs(polygon(loop)) for loop in corners[cells.kinds == kind]) for kind in (0, 1, 2)}
        drawn = {name: abs(polygon(loops[0])) for name, loops in section.regions.items()}
        water = sum(drawn.pop(name) for name in ("sea_front", "sea_back"))
        self.assertAlmostEqual(area[frames.RIGID], drawn["caisson"], delta=1e-4 * drawn.pop("caisson"))
        self.assertAlmostEqual(area[frames.GROUND], sum(drawn.values()), delta=1e-4 * area[frames.GROUND])
        self.assertAlmostEqual(area[frames.WATER], water, delta=1e-4 * area[frames.WATER])


def polygon(loop):
    """Signed area, by the shoelace formula."""
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(loop, [*loop[1:], loop[0]]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
