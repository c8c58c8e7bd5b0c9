"""The author's words and logo in a report, and the verdict of a run. Usage: test_report_author.py
FOLDER_OF_THE_SCRIPTS"""

import base64
import html
import re
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np

SCRIPTS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess"
sys.path.insert(0, str(SCRIPTS))

from report import author, friction, judged, logo, verdict  # noqa: E402
from report.markup import join  # noqa: E402
from upbead.errors import UserError  # noqa: E402

PNG = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")
SVG = b'<?xml version="1.0"?><!-- drawn --><svg xmlns="http://www.w3.org/2000/svg"><script>alert(1)</script></svg>'
EVIL = """# Heading
**bold** and <b onclick="alert(1)">not bold</b>

<script>alert(1)</script>
<img src=x onerror=alert(1)> <iframe src="//a"></iframe>
![picture](http://example.org/a.png) ![ref][r]
[one](javascript:alert(1)) [two](JaVaScRiPt:alert(1)) [three](&#106;avascript:alert(1)) [four](java\tscript:alert(1))
[five](data:text/html,x) [six](vbscript:x) [seven](//example.org) <javascript:alert(1)> [eight]( javascript:alert(1)) [r2][r]

| a | b |
|---|---|
| 1 | [good](https://example.org/?a=1&b="2") |

[r]: javascript:alert(1) "t"
"""
OPENED = re.compile(r"<([a-z0-9]+)([^>]*)>")
HARMLESS = {"div", "h1", "p", "strong", "table", "thead", "tbody", "tr", "th", "td", "a"}


class Text(unittest.TestCase):
    def test_nothing_of_a_strangers_runs_or_is_fetched(self):
        made = author.html(EVIL)
        opened = OPENED.findall(made)
        self.assertLessEqual({name for name, _ in opened}, HARMLESS)
        for name, attributes in opened:
            keys = set(re.findall(r"([\w-]+)=", re.sub(r'"[^"]*"', '""', attributes)))
            self.assertLessEqual(keys, {"a": {"href"}, "div": {"class"}}.get(name, set()), (name, attributes))
        self.assertEqual(re.findall(r'href="([^"]*)"', made), ["http://example.org/a.png", "https://example.org/?a=1&amp;b=%222%22"])
        self.assertIn("&lt;script&gt;", made)
        self.assertIn("<strong>bold</strong>", made)

    def test_no_text_is_nothing(self):
        self.assertEqual(author.html(""), "")


class Logo(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def test_its_content_says_what_it_is(self):
        for content, kind in ((PNG, "image/png"), (b"\xff\xd8\xff\xe0", "image/jpeg"), (SVG, "image/svg+xml")):
            path = self.folder / "logo.txt"
            path.write_bytes(content)
            found = logo.address(path, "here")
            self.assertTrue(found.startswith(f"data:{kind};base64,"))
            self.assertEqual(base64.b64decode(found.partition(",")[2]), content)

    def test_what_is_refused_is_told_with_place_and_cure(self):
        path = self.folder / "logo.png"
        for content, told in (
            (b"<html><svg/></html>", "neither PNG nor JPEG nor SVG"),
            (b"<svg></svg>", "neither PNG"),
            (b"", "neither PNG"),
            (PNG + bytes(300_000), "more than 300; save it with fewer pixels"),
        ):
            path.write_bytes(content)
            with self.assertRaisesRegex(UserError, f"here: '.*logo.png'.*{told}"):
                logo.address(path, "here")
        with self.assertRaisesRegex(UserError, "here: cannot read '.*none.png': No such file .*relative to the case file"):
            logo.address(self.folder / "none.png", "here")
        with self.assertRaisesRegex(UserError, "is no file"):
            logo.address(self.folder, "here")

    def test_all_mistakes_of_the_table_are_told_at_once(self):
        source = SimpleNamespace(values={"report": {"logo": "none.png", "language": "fr", "client": 3}}, path=self.folder / "mine.toml")
        with self.assertRaises(UserError) as caught:
            author.read({}, source, self.folder / "case.toml")
        for told in ("report.language is 'fr'; it can be 'en' or 'ja'", "report.client is no string", "report.logo: cannot read"):
            self.assertIn(told, str(caught.exception))
        self.assertEqual(str(caught.exception).count("mine.toml'"), 3)

    def test_the_run_s_own_words_come_first_and_the_logo_stands_beside_the_author_s_file(self):
        (self.folder / "logo.png").write_bytes(PNG)
        source = SimpleNamespace(values={"report": {"logo": "logo.png", "client": "A", "project": "P"}}, path=self.folder / "mine.toml")
        found = author.read({"report": {"client": "B", "logo": "../elsewhere.png"}}, source, self.folder / "results" / "case.toml")
        self.assertEqual((found.get("client"), found.get("project"), found.language), ("B", "P", "en"))
        self.assertTrue(found.logo.startswith("data:image/png"))


class Answer(unittest.TestCase):
    """The verdict for artificial summaries."""

    def told(self, summary, has_caisson=True):
        result = SimpleNamespace(summary=summary, has_caisson=has_caisson)
        words = join([verdict.slides(result), " ", verdict.shear(result), " ", verdict.rests_on(summary), judged.verdict(summary)])
        return html.unescape(re.sub(r"<[^>]*>", "", words)).replace("\u00a0", " ")

    RESPONSE = {"peak_shear": 634570.1, "peak_force": 1.6e6, "shear_to_force_ratio": 0.39661, "error_estimate": None}

    def test_what_slides(self):
        sliding = {"sliding_coupled": 0.027926, "design": {"value": 0.027926, "measure": "sliding.sliding_coupled", "why": ""}, "ratio": 1.2}
        told = self.told({"response": self.RESPONSE, "sliding": sliding})
        for words in ("slides about 27.9 mm landward", "FT = 635 kN/m, 0.397 of", "P = 1,600 kN/m", "sliding as a rigid block on the moving ground", "not estimated"):
            self.assertIn(words, told)
        sliding["design"]["value"] = -0.5
        self.assertIn("slides about 500 mm seaward", self.told({"response": self.RESPONSE, "sliding": sliding}))

    def test_what_does_not_slide(self):
        sliding = {"sliding_history": 0.0, "ratio": 0.246}
        told = self.told({"response": {**self.RESPONSE, "error_estimate": 0.012}, "sliding": sliding})
        self.assertIn("does not slide: the largest sliding force is 24.6 %", told)
        self.assertIn("estimated at 1.2 % at most", told)

    def test_it_is_no_surer_than_the_run(self):
        self.assertIn("was not asked", self.told({"response": self.RESPONSE}))
        told = self.told({"response": {**self.RESPONSE, "shear_to_force_ratio": None}})
        self.assertIn("it has no ratio to the wave's force", told)
        self.assertIn("tells no shear force", self.told({"response": None}))
        self.assertIn("no caisson", self.told({"response": None}, has_caisson=False))
        sliding = {"sliding_history": 0.01, "why_not_coupled": "the bottom lifts", "ratio": 1.1}
        warnings = [{"name": "walls_too_near", "text": "x"}]
        checks = [{"name": "heel pressure", "holds": False}, {"name": "toe pressure", "holds": True}, {"name": "sliding distance", "holds": None}]
        told = self.told({"response": self.RESPONSE, "sliding": sliding, "warnings": warnings, "checks": checks})
        for words in ("could not be told: the bottom lifts", "warns of: walls too near", "Checks beyond their limit, 1 of 2: heel pressure"):
            self.assertIn(words, told)
        self.assertIn("in the end", self.told({"response": self.RESPONSE, "sliding": {"sliding_history": 0.0, "ratio": 1.1}}))


class Block(unittest.TestCase):
    """Eq. (4) by hand: a force that exceeds the resistance for a second, then no force."""

    def test_a_step_of_force(self):
        mass, force, resistance, edge = 2.0, 10.0, 4.0, 1e-7
        time = np.array([0.0, 1.0, 1.0 + edge, 2.0, 2.0 + edge, 9.0])
        course = np.array([0.0, 0.0, force, force, 0.0, 0.0])
        speed = (force - resistance) / mass
        wanted = speed / 2 + mass * speed**2 / (2 * resistance)
        for way in (1, -1):
            found = friction.slip(mass, time, way * course, np.full(6, resistance))
            self.assertAlmostEqual(found, way * wanted, places=6)
        self.assertEqual(friction.slip(mass, time, course, np.full(6, 10.5)), 0.0)

    def test_a_triangle_that_is_still_moving_at_the_end(self):
        """A force that rises linearly from R to R + m: v = t^2/2, x = t^3/6; then R stops the block."""
        found = friction.slip(1.0, np.array([0.0, 1.0]), np.array([3.0, 4.0]), np.array([3.0, 3.0]))
        self.assertAlmostEqual(found, 1 / 6 + 0.5**2 / 6, places=12)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
