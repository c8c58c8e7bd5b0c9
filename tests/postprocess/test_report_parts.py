"""Single parts of the report. Usage: test_report_parts.py FOLDER_OF_THE_SCRIPTS"""

import base64
import html
import json
import os
import re
import struct
import sys
import tempfile
import unittest
import zlib
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import h5py
import numpy as np

SCRIPTS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess"
sys.path[:0] = [str(SCRIPTS), str(Path(__file__).parents[1] / "support")]

from report import corners, document, drawing, geometry, input_tables, inputs, labels, markup, reference, series, source_case, ticks, units, vtu  # noqa: E402
from report import author, construction, head, loads, sensitivity, sheet, yielding, zones  # noqa: E402
from hand_made_model import write_oscillator  # noqa: E402
from upbead import typeset  # noqa: E402
from upbead.errors import UserError  # noqa: E402
from upbead.figures.expected import why_nothing_slides  # noqa: E402

ONE_CELL = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "sand"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 2 0 0
3 2 1 0
4 0 1 0
$EndNodes
$Elements
1
1 3 2 1 1 1 2 3 4
$EndElements
"""
SOURCE = """# A made-up case. # of it
# All other
# numbers are assumed, as told elsewhere.
title = "made-up # 1"
[regions.sand]  # measured: boreholes 1 to 3
kind = "porous"
shear_modulus = 30e6  # calibrated: peak F_T
porosity = 0.4
damping = { ratio = 0.05 }  # assumed
[regions.rubble]  # of the quarry
porosity = 0.45
[loads.wave]
direction = [1.0, 0.0]
history = "wave.csv"  # measured
factor = 2.0
"""


def blocks_of(values):
    """An array as VTK compresses it, in two blocks: head and body."""
    raw = values.tobytes()
    size = len(raw) // 2 + 1
    blocks = [zlib.compress(raw[:size]), zlib.compress(raw[size:])]
    return struct.pack("<5I", 2, size, len(raw) - size, *map(len, blocks)), b"".join(blocks)


class Fields(unittest.TestCase):
    """Files with arrays appended as they are, and with arrays in base64 within the XML."""

    def test_both_kinds_are_read(self):
        points, p = np.arange(12, dtype="<f4"), np.array([1, 2, 3, 4], dtype="<f4")
        heads, bodies = zip(*map(blocks_of, (points, p)))
        kinds = '<DataArray type="Float32" Name="{}" NumberOfComponents="{}" format="{}"'
        frame = '<VTKFile><Piece>{}</Piece>{}</VTKFile>'
        inline = "".join(kinds.format(name, n, "binary") + ">" + (base64.b64encode(head) + base64.b64encode(body)).decode()
                         + "</DataArray>" for name, n, head, body in zip(("points", "p"), (3, 1), heads, bodies))
        offset = len(heads[0]) + len(bodies[0])
        declared = "".join(kinds.format(name, n, "appended") + f' offset="{at}"/>'
                           for name, n, at in (("points", 3, 0), ("p", 1, offset)))
        appended = b'<AppendedData encoding="raw">_' + heads[0] + bodies[0] + heads[1] + bodies[1] + b"</AppendedData>"
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.vtu"
            for content in (frame.format(inline, "").encode(),
                            frame.format(declared, "@").encode().replace(b"@", appended)):
                path.write_bytes(content)
                found = vtu.arrays(path, {"points", "p"})
                np.testing.assert_array_equal(found["points"], points.reshape(4, 3))
                np.testing.assert_array_equal(found["p"], p)
                path.write_bytes(content[: len(content) * 2 // 3])
                with self.assertRaises(UserError):
                    vtu.arrays(path, {"points", "p"})


class Units(unittest.TestCase):
    def test_prefixes_suit_the_size(self):
        for value, unit, wanted in (
            (634570.1, "N/m", "634.6 kN/m"),
            (1.6e6, "N/m", "1,600 kN/m"),
            (30.56e6, "N m/m", "30.56 MN m/m"),
            (0.0151686, "m", "15.17 mm"),
            (2.5, "m", "2.5 m"),
            (0.0, "m", "0 m"),
            (8.9e-4, "rad", "0.89 mrad"),
            (-460133.2, "N/m", "−460.1 kN/m"),
            (1.73e-13, "", "1.73 × 10⁻¹³"),
            (9999.99, "", "10,000"),
            (22580, "", "22,580"),
            (9.81, "m/s2", "9.81 m/s²"),
            (0.99996, "", "1"),
            (float("inf"), "Pa", "infinite Pa"),
        ):
            self.assertIn(f">{wanted}<".replace(" ", "\u00a0"), units.quantity(value, unit).replace(" ", "\u00a0"))
        self.assertIn('value="634570.1"', units.quantity(634570.1, "N/m"))
        self.assertEqual(units.quantity(None), "none")

    def test_a_limit_that_is_just_exceeded_looks_so(self):
        check = {"name": "S", "unit": "m", "demand": 0.02774, "capacity": 0.027737, "margin": 0.99995, "holds": False}
        _, demand, capacity, margin, *_ = sheet.row(check)
        self.assertEqual([re.sub("<[^>]*>|\u00a0", "", text) for text in (demand, capacity, margin)], ["27.74mm", "27.737mm", "0.99995"])


class Markup(unittest.TestCase):
    def test_text_is_escaped_and_markup_is_not(self):
        made = markup.tag("p", "<&>", markup.tag("b", '"'), class_='a"b', hidden=None)
        self.assertEqual(made, '<p class="a&quot;b">&lt;&amp;&gt;<b>&quot;</b></p>')

    def test_data_cannot_end_its_element(self):
        made = markup.data({"a": "</script>x <!-- &"}, "plot")
        inside = made.removeprefix('<script type="application/json" class="plot">').removesuffix("</script>")
        self.assertFalse(set("<>&") & set(inside), made)
        self.assertEqual(json.loads(inside), {"a": "</script>x <!-- &"})

    def test_symbols(self):
        self.assertEqual(markup.symbol("F_T"), "<i>F</i><sub>T</sub>")
        self.assertEqual(markup.symbol("as a whole"), "as a whole")
        self.assertEqual(
            markup.prose("F_T < c_v of sea_front"), "<i>F</i><sub>T</sub> &lt; <i>c</i><sub>v</sub> of sea_front"
        )


class Lines(unittest.TestCase):
    def test_thinning_keeps_ends_and_peaks(self):
        x = np.linspace(0.0, 1.0, 100_000)
        y = np.sin(40 * x)
        y[777], y[55_555] = 9.0, -7.0
        few_x, few_y = series.thinned(x, y)
        self.assertLessEqual(few_x.size, 2 * series.SPANS + 2)
        self.assertTrue(np.all(np.diff(few_x) > 0))
        self.assertEqual((few_x[0], few_x[-1], few_y.max(), few_y.min()), (0.0, 1.0, 9.0, -7.0))

    def test_what_is_not_finite_is_left_out(self):
        few_x, few_y = series.thinned([0, 1, 2], [1.0, np.nan, 3.0])
        self.assertEqual((few_x.tolist(), few_y.tolist()), ([0.0, 2.0], [1.0, 3.0]))

    def test_ticks_are_round(self):
        self.assertEqual([text for _, text in ticks.ticks(-26.0, 40.0, 4)], ["−20", "0", "20", "40"])
        self.assertEqual([text for _, text in ticks.ticks(0.0, 1.0, 5)], ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"])
        self.assertEqual(ticks.ticks(1.0, 1.0, 5), [])


class Source(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name) / "case_of_mine.toml"
        self.path.write_text(SOURCE)
        self.source = source_case.read(self.path)

    def tearDown(self):
        self.folder.cleanup()

    def test_marks(self):
        for path, is_number, wanted in (
            (("regions", "sand", "shear_modulus"), True, ("calibrated", "peak F_T")),
            (("regions", "sand", "porosity"), True, ("measured", "")),
            (("regions", "sand", "damping", "ratio"), True, ("assumed", "")),
            (("regions", "rubble", "porosity"), True, ("assumed", "")),
            (("loads", "wave", "history"), False, ("measured", "")),
            (("loads", "wave", "direction"), False, ("", "")),
            (("regions", "sand", "kind"), False, ("", "")),
        ):
            self.assertEqual(self.source.mark(path, is_number, is_number), wanted, path)

    def test_the_file_is_found_by_its_title_and_values(self):
        run = {"title": "made-up # 1", "loads": {"wave": {"history": "../wave.csv", "factor": 2.0}}}
        results = Path(self.folder.name) / "results"
        results.mkdir()
        self.assertEqual(source_case.find(run, results).path.name, "case_of_mine.toml")
        (self.path.parent / "other.toml").write_text(SOURCE.replace("factor = 2.0", "factor = 3.0"))
        self.assertEqual(source_case.find(run, results).path.name, "case_of_mine.toml")
        run["loads"]["wave"]["factor"] = 4.0  # both fit equally well
        self.assertIsNone(source_case.find(run, results))
        self.assertIsNone(source_case.find({"title": "another"}, results))

    def test_a_case_called_case_is_found_and_those_of_runs_are_not(self):
        run = {"title": "made-up # 1", "loads": {"wave": {"history": "../wave.csv", "factor": 2.0}}}
        results = Path(self.folder.name) / "results"
        results.mkdir()
        (results / "case.toml").write_text(SOURCE)
        (results / "summary.json").write_text("{}")
        mine = self.path.rename(self.path.parent / "case.toml")
        self.assertEqual(source_case.find(run, results).path.resolve(), mine.resolve())

    def test_what_lies_near_does_no_harm(self):
        folder = self.path.parent / "results"
        folder.mkdir(exist_ok=True)
        os.mkfifo(self.path.parent / "pipe.toml")
        (self.path.parent / "nested.toml").write_text("a = " + "[" * 100_000, encoding="utf-8")
        (self.path.parent / "blank.toml").write_text("[" + " " * 20_000, encoding="utf-8")
        self.assertIsNone(source_case.find({"title": "another"}, folder))
        for name in ("pipe", "nested", "blank"):
            with self.assertRaises(ValueError):
                source_case.read(self.path.parent / f"{name}.toml")

    def test_rows(self):
        case = {
            "title": "made-up # 1",
            "gravity": 9.81,
            "regions": {"sand": {"shear_modulus": 30e6, "porosity": 0.41, "tortuosity": 1.0, "biot": 0.9}},
            "loads": {"wave": {"direction": [1.0, 0.0], "history": "../elsewhere/wave.csv", "factor": 2.0}},
        }
        found = {row.path[-1]: row for row in inputs.rows(case, self.source)}
        marks = {key: row.mark for key, row in found.items()}
        self.assertEqual(
            marks,
            {
                "gravity": "default",
                "shear_modulus": "calibrated",
                "porosity": "changed",
                "tortuosity": "default",
                "biot": "changed",
                "direction": "given",
                "history": "measured",
                "factor": "given",
            },
        )
        self.assertIn("the case file has 0.4", found["porosity"].remark)
        self.assertEqual(input_tables.show(found["shear_modulus"]), "30 MPa")
        self.assertEqual(input_tables.show(found["history"]), "wave.csv")
        unknown = {row.path[-1]: row.mark for row in inputs.rows(case, None)}
        self.assertEqual((unknown["tortuosity"], unknown["biot"], unknown["gravity"]), ("default", "given", "default"))


class Reference(unittest.TestCase):
    def test_units_and_meanings_are_those_of_the_printed_reference(self):
        known = reference.read()
        key = reference.find(known, ("regions", "seabed", "damping", "ratio"))
        self.assertEqual((key.unit, key.meaning), ("", "damping ratio at both frequencies"))
        key = reference.find(known, ("regions", "seabed", "hydraulic_conductivity"))
        self.assertEqual((key.unit, key.meaning), ("m/s", "hydraulic conductivity k"))
        self.assertTrue(reference.find(known, ("regions", "x", "flow")).is_default("auto"))
        self.assertFalse(reference.find(known, ("regions", "x", "flow")).is_default("darcy"))


def polygon(loop):
    """Signed area, by the shoelace formula."""
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(loop, [*loop[1:], loop[0]]))


class Typesetting(unittest.TestCase):
    def test_formulas_of_the_program(self):
        for written, wanted in (
            ("mu U against mu W'", "μ U against μ W′"),
            ("k(alpha*) tau_0F, alpha_I", "k(α*) <i>τ</i><sub>0F</sub>, <i>α</i><sub>I</sub>"),
            ("h^2/(6 c_v) = 8.51e+04 s &lt;= 1e-08", "h²/(6 <i>c</i><sub>v</sub>) = 8.51 × 10⁴ s ≤ 1 × 10⁻⁸"),
            ("m x_G'' by sqrt(2 pi)", "m <i>x\u0308</i><sub>G</sub> by √(2 π)"),
            ("H_1/3 is the paper's", "<i>H</i><sub>1/3</sub> is the paper's"),
            ("<code>alpha_I</code> sliding.peak_force, alpha_I_negative, 'left', pi.csv", "<code>alpha_I</code> sliding.peak_force, alpha_I_negative, 'left', pi.csv"),
        ):  # fmt: skip
            self.assertEqual(typeset.page(written), wanted)
        self.assertEqual(typeset.page("<svg><text>alpha_I</text></svg>"), "<svg><text>α_I</text></svg>")  # an SVG has no <sub>

    def test_what_the_author_wrote_stays_as_written(self):
        name = "Delta Flume & Sigma Ltd, berth A_12"
        case = {"loads": {"Delta_2": {"boundary": "top", "pulse": {"peak": 1e3}}}}
        who = author.Author({"client": name, "question": f"Does it hold? {name}", "text": f"- {name}\n\n| a |\n|---|\n| {name} |"}, "")
        parts = (head.title(who, "Report", name), head.question(who, "F_T?"),
                 loads.table_of([loads.row("Delta_2", case["loads"]["Delta_2"], SimpleNamespace(summary={}, case=case))]),
                 input_tables.group_table(("loads", "Delta_2"), []), sheet.name_of({"name": "sliding", "wave": "Sigma 2"}),
                 drawing.drawing(geometry.Section({"sand": [[(0, 0), (2, 0), (2, 1), (0, 1)]]}), case, {}, 860, "wide"))  # fmt: skip
        for part, there in zip(parts, (2, 3, 0, 0, 0, 0)):
            page = typeset.page(f"<main>{part}F_T</main>")
            self.assertEqual(page.count(html.escape(name)), there, page)
            self.assertEqual(re.findall("[ΔΣσδ]|A<", page), [], page)
            self.assertIn("<i>F</i><sub>T</sub></main>", page)  # and the program's own words after it are set
        for words in ("Delta 2", "Load Delta 2", "Sigma 2"):
            self.assertIn(words, "".join(map(typeset.page, parts[2:])))
        self.assertEqual(typeset.page('<p class="written">A_1<p>A_1</p></p><b class="unwritten">A_1</b>'),
                         '<p class="written">A_1<p>A_1</p></p><b class="unwritten"><i>A</i><sub>1</sub></b>')  # fmt: skip

    def test_quantities_of_one_table_have_one_prefix(self):
        shown = lambda *values: re.findall(r">([^<>]*)</data>", markup.table(None, [("a", units.quantity(v, u)) for v, u in values]))  # noqa: E731
        self.assertEqual(shown((6.98e6, "Pa"), (10.07e6, "Pa")), ["6,980\u00a0kPa", "10,070\u00a0kPa"])
        self.assertEqual(shown((80e6, "Pa"), (20e3, "Pa"), (3e3, "N/m")), ["80\u00a0MPa", "0.02\u00a0MPa", "3\u00a0kN/m"])
        self.assertEqual(shown((8.5, "m"), (0.055, "m")), ["8.5\u00a0m", "55\u00a0mm"])  # a height and a displacement
        self.assertEqual(shown((0.4382, "m"), (1.2, "m")), ["438.2\u00a0mm", "1,200\u00a0mm"])

    def test_a_title_at_the_foot_of_pages_ends_nothing(self):
        self.assertEqual(document.in_css('a"}</style>é'), '"a\\000022\\00007d\\00003c\\00002fstyle\\00003eé"')

    def test_an_axis_over_decades(self):
        self.assertEqual([text for _, text in ticks.decades(-2.0, -1.0, 8)], ["0.01", "0.02", "0.05", "0.1"])
        self.assertEqual([text for _, text in ticks.decades(0.0, 6.0, 8)], ["1", "10", "100", "1,000", "10,000", "100,000", "1,000,000"])
        self.assertEqual([text for _, text in ticks.decades(0.05, 0.2, 4)], ["1.2", "1.3", "1.4", "1.5"])


class Labels(unittest.TestCase):
    def test_they_cover_neither_each_other_nor_lines(self):
        """Two names at one place and a line across it: the second and third go where there is room."""
        places = [(50, 20, "middle"), (50, 40, "middle"), (50, 60, "middle")]
        three = [labels.Label(name, places) for name in ("one", "two", "three")]
        labels.place(three, [(0, 40, 100, 40)], [], (0, 0, 100, 100))
        self.assertEqual([one.at[1] for one in three[:2]], [20, 60])
        for a, b in zip(three[:1], three[1:2]):
            self.assertFalse(labels.overlap(a.box, b.box))
        self.assertTrue(labels.crosses(three[2].box, (0, 40, 100, 40)))  # the least of three evils

    def test_a_box_and_a_line(self):
        box = (0, 0, 10, 4)
        for line, wanted in (((-5, 2, 15, 2), True), ((-5, 9, 15, 9), False), ((11, -5, 11, 9), False), ((-2, -2, 2, 2), True), ((3, 1, 4, 2), True)):
            self.assertEqual(labels.crosses(box, line), wanted, line)

    def test_the_corners_slopes_and_layers_of_an_outline(self):
        mound = [(-8, 0), (-6, 1), (-4, 2), (0, 2), (3, 2), (6, 0), (0, 0)]
        self.assertEqual(corners.simple(mound), [(-8, 0), (-4, 2), (3, 2), (6, 0)])
        self.assertEqual([(slope, way) for _, slope, way in corners.slopes(corners.simple(mound))], [(2.0, -1), (1.5, 1)])
        section = geometry.Section({"mound": [mound], "sand": [[(-20, -5), (20, -5), (20, 0), (-20, 0)]]})
        self.assertEqual(corners.column_at(section, 0.5), [-5, 0, 2])


class Geometry(unittest.TestCase):
    def test_parameters_of_a_geometry_are_read_from_its_script(self):
        declared = geometry.declared("composite")
        self.assertEqual(declared["mound_height"], (6.0, "m", "height of the mound above the seabed"))
        self.assertEqual(geometry.declared("nothing"), {})

    def test_what_a_side_or_a_layer_has_of_its_own_is_drawn(self):
        """Areas with two layers, two slopes and two levels by hand; a parameter not given for a side is that of both
        sides."""
        own = {"seabed_depth": 8, "subsoil_depth": 12, "seabed_front": 72, "seabed_back": 70.5, "mound_height": 5,
               "mound_crest_front": 18, "mound_crest_back": 22, "mound_slope_front": 2, "mound_slope_back": 1.5,
               "caisson_width": 20, "caisson_height": 17, "water_depth": 12, "water_depth_back": 11.5,
               "sea_front": 6, "sea_back": 20 / 3}  # fmt: skip
        outline = geometry.section({"mesh": {"geometry": "composite", "parameters": own}}, ".")
        expected = {"seabed": 1600, "subsoil": 2400, "mound": 243.75, "caisson": 340,
                    "sea_front": 799, "sea_back": 11.5 * 11.5 * 20 / 3 - 5 * (12 + 7.5 / 2)}  # fmt: skip
        self.assertEqual(set(outline.regions), set(expected))
        for name, area in expected.items():
            self.assertAlmostEqual(abs(polygon(outline.regions[name][0])), area, places=9, msg=name)
        self.assertEqual(outline.box(), (-100, 100, -20, 22))
        self.assertEqual(outline.box("subsoil")[2:], (-20, -8))
        self.assertEqual(outline.box("sea_back")[3], 11.5)
        alike = geometry.section({"mesh": {"geometry": "composite", "parameters": {"sea_back": 3}}}, ".")
        self.assertEqual(set(alike.regions), {"seabed", "mound", "caisson", "sea_back"})
        self.assertEqual(alike.box("mound"), (-28, 28, 0, 6))

    def test_the_drawing_names_layers_levels_and_slopes(self):
        own = {"subsoil_depth": 13, "mound_slope_back": 1.5, "water_depth_back": 11.5, "sea_front": 6, "sea_back": 6}
        for given, both in ((own, True), ({"sea_front": 6, "sea_back": 6}, False)):
            outline = geometry.section({"mesh": {"geometry": "composite", "parameters": given}}, ".")
            case = {"regions": {"caisson": {"kind": "rigid"}, "sea_front": {"kind": "water"}, "sea_back": {"kind": "water"}}}
            page = str(drawing.drawing(outline, case, {}, 860, "wide"))
            self.assertIn("1 : 2", page)
            for words in ("11.5\u00a0m", "13\u00a0m", "1 : 1.5", "subsoil"):
                self.assertEqual(words in page, both, words)

    def test_the_outline_of_cells(self):
        points = {1: (0, 0), 2: (1, 0), 3: (2, 0), 4: (0, 1), 5: (1, 1), 6: (2, 1)}
        for second in ([2, 3, 6, 5], [5, 6, 3, 2]):  # surfaces of a mesh may be numbered one way or the other
            (loop,) = geometry.outline([[1, 2, 5, 4], second], points)
            self.assertEqual(sorted(loop), sorted(points.values()))
            self.assertEqual(abs(polygon(loop)), 2.0)

    def test_the_outlines_in_results_are_those_of_the_mesh(self):
        """Sides of cells in any order, of survey coordinates too, give each region's loop."""
        with tempfile.TemporaryDirectory() as folder, h5py.File(Path(folder) / "results.h5", "w") as file:
            x0 = 441871.65
            sides = [(0, 0, 1, 0), (2, 0, 1, 0), (2, 0, 2, 1), (2, 1, 1, 1), (0, 1, 1, 1), (0, 0, 0, 1)]
            file["section/sand/fill"] = np.array(sides, dtype=float) + [x0, 0, x0, 0]  # a name with a slash
            found = geometry.section({"mesh": {"file": "nowhere.geo"}}, folder, file)
            (loop,) = found.regions["sand/fill"]
            self.assertEqual(len(loop), 6)
            self.assertAlmostEqual(abs(polygon([(x - x0, y) for x, y in loop])), 2.0, places=6)
            self.assertEqual(len(corners.simple(loop)), 4)

    def test_sizes_of_results_in_survey_coordinates_are_drawn_to_the_centimetre(self):
        for x0, y0 in ((0.0, 0.0), (441871.65, 3.2), (4418716.5, 0.0), (3.2, 4418716.5)):
            with tempfile.TemporaryDirectory() as folder, h5py.File(Path(folder) / "results.h5", "w") as file:
                sides = np.array([(0, 0, 18.04, 0), (18.04, 0, 18.04, 12.37), (18.04, 12.37, 0, 12.37), (0, 12.37, 0, 0)])
                file["section/caisson"] = sides + [x0, y0, x0, y0]
                outline = geometry.section({"mesh": {"file": "nowhere.geo"}}, folder, file)
                page = str(drawing.drawing(outline, {"regions": {"caisson": {"kind": "rigid"}}}, {}, 860, "wide"))
                for words in ("18.04\u00a0m", "12.37\u00a0m"):
                    self.assertIn(words, page, (x0, y0))

    def test_a_script_of_ones_own_is_drawn_where_gmsh_is_installed(self):
        """With a script instead of gmsh that records its arguments and copies a mesh."""
        with tempfile.TemporaryDirectory() as folder, mock.patch.dict(os.environ, {"PATH": folder}):
            (Path(folder) / "own.geo").write_text("")
            case = {"mesh": {"file": "own.geo", "parameters": {"width": 2.5}}}
            with self.assertRaisesRegex(UserError, "needs the program gmsh"):
                geometry.section(case, folder)
            (Path(folder) / "cells.msh").write_text(ONE_CELL)
            program = Path(folder) / "gmsh"
            program.write_text(f'#!/bin/sh\necho "$@" > {folder}/called\n/bin/cp {folder}/cells.msh "$4"\n')
            program.chmod(0o755)
            section = geometry.section(case, folder)
            self.assertEqual(section.box("sand"), (0.0, 2.0, 0.0, 1.0))
            self.assertIn("-setnumber width 2.5", (Path(folder) / "called").read_text())


class Yielding(unittest.TestCase):
    RESIDUAL = {"displacement_x": 0.0123, "displacement_y": -0.004, "rotation": 2e-4, "pore_pressure": 1500.0}
    SUMMARY = {
        "response": {"shear_to_force_ratio": 0.32},
        "nonlinear": {
            "start": "k0",
            "bounds": [{"start": "virgin", "shear_to_force_ratio": 0.35, "residual": {**RESIDUAL, "displacement_x": 0.002}}],
            "regions": [
                {"region": "mound", "law": "hysteretic", "initial": 0.4, "largest": 0.97, "initial_share": 0.0, "share": 0.1}
            ],
        },
        "residual": RESIDUAL,
        "energy": {"work": 1000.0, "plastic": 400.0, "kinetic": 0.0, "mismatch": 1e-12},
        "sliding": {"design": {"value": 0.05, "measure": "sliding.sliding_history", "why": "because"}},
    }

    def page(self, summary):
        result = mock.Mock(summary=summary, folder=Path("/nowhere"))
        return yielding.section(result, (-1.0, 1.0)).replace("\u00a0", " ")

    def test_the_section_tells_rest_and_its_bounds_energy_and_strength(self):
        page = self.page(self.SUMMARY)
        for told in ("12.3 mm", "−4 mm", "start virgin", "2 mm", "1.5 kPa", "40 %", "400 J/m", "97 %", "50 mm"):
            self.assertIn(f">{told}", page)
        self.assertNotIn("still in motion", page)

    def test_linear_soil_has_no_such_section(self):
        self.assertEqual(self.page({"residual": None, "nonlinear": None}), "")

    def test_cells_are_drawn_by_class_and_elastic_ones_in_outline(self):
        limits = [0.25, 0.5]
        number = zones.classes(np.array([0.1, 0.25, 0.7, np.nan]), limits)
        self.assertEqual(number.tolist(), [0, 1, 2, -1])
        square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
        corners = np.stack([square + [i, 0.0] for i in range(4)])
        drawn = zones.drawing(corners, number, limits, str, "cells")
        self.assertEqual((drawn.count("<path"), drawn.count('class="elastic"')), (3, 1))
        number[2] = -1  # beside the other elastic one: both have one outline
        drawn = zones.drawing(corners, number, limits, str, "cells")
        self.assertEqual((drawn.count("<path"), drawn.count('class="elastic"')), (2, 1))

    def test_what_lost_nothing_is_not_drawn(self):
        still = zones.Zones(1.0, np.zeros((1, 4, 2)), np.array([0.2]), np.array([0.0]))
        self.assertEqual(zones.of_dissipated(still), "")


class Construction(unittest.TestCase):
    GROUND = {"name": "ground", "regions": "seabed, subsoil", "weight": 2e7, "settlement": None, "caisson": None,
              "heel_pressure": None, "toe_pressure": None, "mobilised": None, "mobilised_in": None}
    FILL = {"name": "fill", "regions": "", "weight": 3e7, "settlement": 0.0123,
            "caisson": {"settlement": 0.0119, "displacement_x": 0.001, "rotation": -2e-4}, "heel_pressure": 2.5e5,
            "toe_pressure": None, "mobilised": 0.75, "mobilised_in": "mound"}

    def test_a_section_that_is_not_built_in_stages_has_no_part(self):
        self.assertEqual(construction.section({"construction": None}), "")

    def test_every_stage_has_a_row(self):
        page = construction.section({"construction": {"stages": [self.GROUND, self.FILL], "falls_in": None,
                                                      "caisson": self.FILL["caisson"]}})
        self.assertEqual(page.count("<tr>"), 3)
        for value in ("0.0123", "0.0119", "-0.0002", "250000.0", "0.75"):
            self.assertIn(f'value="{value}"', page)
        self.assertIn("mound", page)
        self.assertIn("Since it was set down", page)
        self.assertNotIn("no state at rest", page)

    def test_a_stage_that_falls_is_told(self):
        page = construction.section({"construction": {"stages": [self.GROUND], "falls_in": "mound", "caisson": None}})
        self.assertIn("The stage mound has no state at rest.", page)
        self.assertNotIn("Since it was set down", page)


class NothingSlides(unittest.TestCase):
    def test_lives_that_slide_are_told_beside_waves_that_do_not(self):
        calm, moving = (SimpleNamespace(lives=np.array(lives)) for lives in ([0.0, 0.0], [0.0, 0.1, 0.2]))
        self.assertEqual(why_nothing_slides([calm]), "Nothing slides: no wave is high enough.")
        self.assertEqual(why_nothing_slides([calm, moving]), "Without scatter nothing slides; with it 2 of 5 lives do.")


class OtherWaves(unittest.TestCase):
    def test_they_are_promised_only_where_the_page_answers_them(self):
        with tempfile.TemporaryDirectory() as name:
            result = SimpleNamespace(folder=Path(name), case={})
            self.assertFalse(sensitivity.pointer(result))
            write_oscillator(Path(name) / "reduced.h5")
            self.assertIn("Other waves", str(sensitivity.pointer(result)))
            result.case = {"mesh": {"degree": 2}}
            self.assertFalse(sensitivity.pointer(result), "of another scene")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
