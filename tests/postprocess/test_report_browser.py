"""The report in Chromium without a window: display, pointing and printing.

Skipped (exit code 77) where there is no Chromium.

Usage: test_report_browser.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES
"""

import re
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import report_results as made
from chromium import Browser
from report_results import CASES, page, run

from report import pdf

A4_PRINTABLE = (680, 1001)  # px at 96 per inch: A4 less the margins of page.css
# Texts of visible drawings that extend beyond their figure or are too small to read.
BAD_TEXTS = """[...document.querySelectorAll('figure svg text')]
  .filter((text) => text.getClientRects().length && text.textContent)
  .filter((text) => {
    const box = text.getBoundingClientRect(), room = text.closest('figure').getBoundingClientRect();
    return box.left < room.left - 1 || box.right > room.right + 1 || box.height < 8;
  }).map((text) => text.closest('figure').id + ': ' + text.textContent)"""
# Figures in which nothing is drawn.
EMPTY = """[...document.querySelectorAll('figure')].filter((figure) => {
    const size = (item) => { const box = item.getBoundingClientRect(); return box.width > 50 && box.height > 50; };
    const svg = [...figure.querySelectorAll('svg')].find(size), canvas = figure.querySelector('canvas');
    if (canvas) {
      const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data, colours = new Set();
      let painted = 0;
      for (let i = 0; i < data.length; i += 4) {
        painted += data[i + 3] > 0;
        colours.add((data[i] << 16) + (data[i + 1] << 8) + data[i + 2]);
      }
      return !size(canvas) || colours.size < 50 || painted < 0.4 * canvas.width * canvas.height;
    }
    return !svg || svg.querySelectorAll('path, polygon').length === 0;
  }).map((figure) => figure.id)"""


class Reading(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        folder = Path(cls.temporary.name)
        case = CASES / "fig2b-prototype.toml"
        friction = 'regions.caisson.interface.kind="friction"'
        drawn = ["output.fields={ every = 0.05 }", "mesh.parameters.cells=0.5"]
        slid = run(case, folder / "slid", "loads.impulse.factor=5", friction, *drawn)
        fields = run(case, folder / "fields", *drawn)
        results = {"slid": slid, "full": made.with_records(fields, folder / "full"), "column": made.column(folder)}
        cls.pages = {name: path / "page.html" for name, path in results.items()}
        for path in results.values():
            page(path)
        cls.pages["japanese"] = slid / "japanese.html"
        page(slid, "--language", "ja", "-o", cls.pages["japanese"])
        cls.browser = Browser(pdf.browser(), pdf.options)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def show(self, name, width, **options):
        self.browser.problems.clear()
        self.browser.open(self.pages[name], width, **options)
        return self.browser.value

    def test_narrow_and_wide_dark_and_light(self):
        for name in self.pages:
            for width, dark in ((360, name == "slid"), (1600, name != "slid")):
                value = self.show(name, width, dark=dark)
                where = f"{name} at {width} px, dark: {dark}"
                self.assertEqual(self.browser.problems, [], where)
                self.assertLessEqual(value("document.documentElement.scrollWidth"), width, where)
                self.assertGreater(value("document.querySelectorAll('figure').length"), 1, where)
                self.assertEqual(value(EMPTY), [], where)
                self.assertEqual(value(BAD_TEXTS), [], where)

    def test_a_plot_is_read_off_at_the_cursor(self):
        value = self.show("slid", 1600)
        x, y, width = self.place(value, "#response .live")
        at = round(x + 0.16 * width)  # where all lines are steep
        self.browser.mouse("mouseMoved", at, y + 60)
        told = value("[...document.querySelectorAll('#response .reading')].map((item) => item.textContent)")
        data = value("JSON.parse(document.querySelector('#response script').textContent)")
        low, high = data["window"]
        time = low + (at - x - 62) / (width - 62 - 12) * (high - low)
        for text, panel in zip(told, data["panels"], strict=True):
            line = panel["lines"][0]
            wanted = np.interp(time, line["x"], line["y"])
            self.assertAlmostEqual(float(text.strip().replace("−", "-")), wanted, delta=1e-3 * abs(wanted))

    def test_a_plot_is_zoomed_and_reset(self):
        value = self.show("slid", 1600)
        ticks = """[...document.querySelectorAll('#response .live .tick')].map((text) => text.textContent)
          .filter((text) => !text.startsWith('time'))"""  # not the marked time, which clicks move
        before = value(ticks)
        x, y, width = self.place(value, "#response .live")
        for kind, share in (("mousePressed", 0.3), ("mouseMoved", 0.5), ("mouseReleased", 0.5)):
            self.browser.mouse(
                kind, x + share * width, y + 60, clickCount=1, buttons=0 if kind == "mouseReleased" else 1
            )
        zoomed = value(ticks)
        self.assertNotEqual(zoomed, before)
        self.browser.mouse("mouseWheel", x + 0.4 * width, y + 60, deltaX=0, deltaY=-100)
        self.browser.value("new Promise((done) => setTimeout(done, 200))")
        self.assertNotEqual(value(ticks), zoomed)
        for count in (1, 2):
            for kind in ("mousePressed", "mouseReleased"):
                self.browser.mouse(kind, x + 0.4 * width, y + 60, clickCount=count)
        self.browser.mouse("mouseMoved", x, y - 30)
        value("document.activeElement.blur()")
        self.assertEqual(value(ticks), before)
        self.assertEqual(self.browser.problems, [])

    def test_the_animation_plays_and_stops(self):
        value = self.show("full", 1600)
        frame = "+document.querySelector('#fields input').value"
        picture = "document.querySelector('#fields canvas').toDataURL()"
        first, shown = value(frame), value(picture)
        value("document.querySelector('#fields button').click()")
        value("new Promise((done) => setTimeout(done, 1500))")
        value("document.querySelector('#fields button').click()")
        stopped = value(frame)
        self.assertNotEqual(stopped, first)
        self.assertNotEqual(value(picture), shown)
        value("new Promise((done) => setTimeout(done, 900))")
        self.assertEqual(value(frame), stopped)

    def test_section_and_histories_share_one_time(self):
        value = self.show("slid", 1600)
        frame, picture = "+document.querySelector('#fields input').value", "document.querySelector('#fields canvas').toDataURL()"
        times = value("JSON.parse(document.querySelector('#fields script').textContent).times")
        before, told = value(picture), "document.querySelector('#fields .told').textContent"
        x, y, width = self.place(value, "#fields-histories .live")
        for kind, share in (("mousePressed", 0.2), ("mouseMoved", 0.5), ("mouseMoved", 0.7), ("mouseReleased", 0.7)):
            self.browser.mouse(kind, x + share * width, y + 60, clickCount=1, buttons=0 if kind == "mouseReleased" else 1)
        wanted = (0.7 * width - 62) / (width - 62 - 12) * times[-1]
        self.assertEqual(value(frame), int(np.argmin(np.abs(np.array(times) - wanted))))
        self.assertNotEqual(value(picture), before)
        self.assertRegex(value(told), r"^bottom: .*; mean slip [\d.]+ mm$")
        value("document.querySelector('#fields-histories .live').focus()")
        self.key("ArrowLeft")
        index = value(frame)
        self.assertEqual(index, int(np.argmin(np.abs(np.array(times) - wanted))) - 1)
        self.assertIn(value(told), value("document.querySelector('#fields input').getAttribute('aria-valuetext')"))
        self.assert_read_off(value, "#response", times[index])
        x, y, width = self.place(value, "#response .live")
        for kind in ("mousePressed", "mouseReleased"):
            self.browser.mouse(kind, x + 62 + 0.01 * width, y + 60, clickCount=1)
        self.assertLessEqual(value(frame), 1)
        self.assertEqual(self.browser.problems, [])

    def assert_read_off(self, value, plot, time):
        """Without a pointer, the values that a plot shows beside its lines are those at the time of the section."""
        self.place(value, plot)
        value("new Promise((done) => setTimeout(done, 300))")  # until the page has noticed that the plot is visible
        told = value(f"[...document.querySelectorAll('{plot} .reading')].map((item) => item.textContent)")
        panels = value(f"JSON.parse(document.querySelector('{plot} script').textContent).panels")
        for text, line in zip(told, [line for panel in panels for line in panel["lines"]], strict=True):
            wanted, reach = np.interp(time, line["x"], line["y"]), 1e-3 * max(map(abs, line["y"]))
            self.assertAlmostEqual(float(text.strip().replace("−", "-")), wanted, delta=reach)

    def key(self, name):
        for kind in ("keyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key=name, code=name)

    def test_still_pictures_stand_without_scripts(self):
        value = self.show("full", 1600, scripts=False)
        stills = value(
            """[...document.querySelectorAll('figure svg.still')]
                 .filter((svg) => svg.getBoundingClientRect().height > 50)
                          .map((svg) => svg.querySelectorAll('path, polygon').length)"""
        )
        self.assertGreaterEqual(len(stills), 6)
        self.assertGreater(min(stills), 0)

    def test_no_figure_is_cut_on_paper(self):
        value = self.show("full", A4_PRINTABLE[0])
        self.browser.call("Emulation.setEmulatedMedia", media="print")
        sizes = value(
            """[...document.querySelectorAll('figure')].map((figure) => {
            const box = figure.getBoundingClientRect();
            return [figure.id, box.width, box.height, getComputedStyle(figure).breakInside];
          })"""
        )
        self.browser.call("Emulation.setEmulatedMedia", media="")
        self.assertGreater(len(sizes), 5)
        for name, width, height, together in sizes:
            self.assertEqual(together, "avoid", name)
            self.assertTrue(50 < height <= A4_PRINTABLE[1] and 50 < width <= A4_PRINTABLE[0], (name, width, height))

    def test_the_pdf_has_pages_of_a4(self):
        target = self.pages["slid"].parent / "page.pdf"
        _, done = page(self.pages["slid"].parent, "--pdf", target)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = target.read_bytes()
        self.assertTrue(text.startswith(b"%PDF"))
        self.assertGreater(len(re.findall(rb"/Type\s*/Page\b", text)), 3)
        box = [float(edge) for edge in re.search(rb"/MediaBox\s*\[([^\]]*)\]", text)[1].split()]
        self.assertAlmostEqual(box[2], 595.3, delta=1.0)
        self.assertAlmostEqual(box[3], 841.9, delta=1.0)

    def place(self, value, selector):
        value(f"document.querySelector('{selector}').scrollIntoView()")
        return value(
            f"(() => {{ const box = document.querySelector('{selector}').getBoundingClientRect();"
            " return [box.left, box.top, box.width]; })()"
        )


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
