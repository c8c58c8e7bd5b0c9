"""The interactive page in Chromium without a window: display, typing, dropped files, and accessibility.

Skipped (exit code 77) where there is no Chromium; the test with axe-core is skipped if npm cannot fetch it.

usage: test_page_browser.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES [TEST ...]
"""

import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import page_models as made
from chromium import Browser

import upbead
from report import page, pdf
from upbead.live import document, model_data
from upbead.results import Result

LARGEST_PAGE = 1.5e6
COARSE = "mesh.parameters.cells=0.5"
NUMBER = """(key) => { const item = document.querySelector(`.whatif data[data-key="${key}"]`); return item && Number(item.value); }"""
TYPE = """(key, text) => { const field = document.querySelector(`[data-key="${key}"]`); field.value = text;
  field.dispatchEvent(new Event("input")); return document.querySelector(".wrong").textContent; }"""
# Milliseconds of handling and laying out each of 40 moves of a slider.
DRAG = """async (key) => {
  const slider = document.querySelector(`[data-key="${key}"]`).parentNode.querySelector("input[type=range]"), took = [];
  for (let i = 0; i < 40; ++i) {
    slider.value = 300 + 6 * i;
    const start = performance.now();
    slider.dispatchEvent(new Event("input"));
    document.body.offsetHeight;
    took.push(performance.now() - start);
    await new Promise((done) => requestAnimationFrame(done));
  }
  return took;
}"""
SETTLED = """(async () => { while (!document.querySelector('data[data-key="error_estimate"]'))
  await new Promise((done) => setTimeout(done, 10)); })()"""


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        cls.model = made.reduced("fig2b-prototype.toml", cls.folder / "one", COARSE)
        cls.two = made.reduced("fig2b-prototype.toml", cls.folder / "two", COARSE, "loads.slow.factor=1")
        contact = made.reduced("fig2b-prototype.toml", cls.folder / "contact", COARSE, 'regions.caisson.interface.kind="friction"')
        cls.pages = {"one": upbead.page(cls.model), "two": upbead.page(cls.two), "contact": upbead.page(contact)}
        cls.browser = Browser(pdf.browser(), pdf.options)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.temporary.cleanup()

    def show(self, name="one", width=1280, **options):
        self.browser.problems.clear()
        self.browser.open(self.pages[name], width, **options)
        self.browser.value(SETTLED)
        return self.browser.value

    def call(self, function, *arguments):
        return self.browser.value(f"({function})({', '.join(map(repr, arguments))})")

    def drop(self, name, text):
        """Gives a record by the file field; returns the page's message about it."""
        path = self.folder / name
        path.write_text(text)
        said = "document.querySelector('.drop p').textContent"
        self.browser.value(f"{said} = ''; 0")
        root = self.browser.call("DOM.getDocument")["root"]["nodeId"]
        node = self.browser.call("DOM.querySelector", nodeId=root, selector="#whatif-record")["nodeId"]
        self.browser.call("DOM.setFileInputFiles", files=[str(path)], nodeId=node)
        self.browser.value(f"(async () => {{ while (!{said}) await new Promise((done) => setTimeout(done, 10)); }})()")
        return self.browser.value(said)

    def test_from_phones_to_wide_screens(self):
        for name in self.pages:
            for width, dark in ((360, False), (640, True), (861, False), (1280, True), (1600, False)):
                value = self.show(name, width, dark=dark)
                where = f"{name} at {width} px, dark: {dark}"
                self.assertEqual(self.browser.problems, [], where)
                self.assertLessEqual(value("document.documentElement.scrollWidth"), width, where)

    def test_asks_for_nothing(self):
        self.browser.call("Network.enable")
        self.browser.requests.clear()
        self.show()
        self.call(TYPE, "peak", "3000")
        self.browser.value(SETTLED)
        asked = [address for address in self.browser.requests if not address.startswith("data:")]
        self.browser.call("Network.disable")
        self.assertEqual(asked, [self.pages["one"].resolve().as_uri()])

    def test_sizes(self):
        data = model_data.model_data(self.model)
        parts = {"page": self.pages["one"].read_text(), "model": document.as_json(data), "scripts": document.script(data)}
        parts |= {name: document.read(name) for name in ("page.css", "whatif.css")}
        sizes = {name: len(text.encode()) for name, text in parts.items()}
        print("bytes: " + ", ".join(f"{name} {size}" for name, size in sizes.items()), file=sys.stderr)
        self.assertLess(sizes["page"], LARGEST_PAGE)

    def test_follows_a_slider(self):
        self.show()
        for key in ("peak", "duration", "friction"):
            took = sorted(self.call(DRAG, key))
            print(f"{key}: median {took[20]:.1f} ms, slowest {took[-1]:.1f} ms of {len(took)} moves", file=sys.stderr)
        self.assertEqual(self.browser.problems, [])

    def test_a_slider_by_keys(self):
        self.show()
        before = self.call(NUMBER, "peak_shear")
        self.browser.value("""document.querySelector('[data-key="peak"]').parentNode.querySelector("input[type=range]").focus()""")
        for kind in ("rawKeyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key="PageUp", code="PageUp", windowsVirtualKeyCode=33)
        self.assertGreater(self.call(NUMBER, "peak_shear"), 1.1 * before)

    def test_what_does_not_do_is_told_and_not_answered(self):
        value = self.show()
        for key, text in (("duration", "0"), ("peak", "0"), ("rise", "-1"), ("start", ""), ("friction", "0"), ("weight", "-5")):
            held = value(f"""document.querySelector('[data-key="{key}"]').value""")
            self.assertIn("No answer", self.call(TYPE, key, text), key)
            self.assertEqual(value(f"""document.querySelector('[data-key="{key}"]').getAttribute("aria-invalid")"""), "true")
            self.assertEqual(value("getComputedStyle(document.querySelector('.tables')).visibility"), "hidden")
            self.assertEqual(self.call(TYPE, key, held), "")
        self.assertIn("more than", self.call(TYPE, "start", "100000"))

    def test_says_where_the_model_no_longer_holds(self):
        self.show()
        self.call(TYPE, "duration", "0.005")
        self.browser.value(SETTLED)
        said = self.browser.value("document.querySelector('.trust').textContent")
        self.assertIn("more than the model's tolerance", said)
        self.assertGreater(self.call(NUMBER, "error_estimate"), 0.05)

    def test_it_says_when_the_base_lifts(self):
        notes = "document.querySelector('.notes').textContent"
        self.show()
        for peak, lifts in (("100", False), ("20000", True)):
            self.assertEqual(self.call(TYPE, "peak", peak), "")
            self.assertEqual("The base lifts (the seaward edge" in self.browser.value(notes), lifts, peak)
            self.assertEqual(self.call(NUMBER, "base_lifts") is not None, lifts)
            self.assertIn("made for pe by Goda", self.browser.value(notes))

    def test_it_names_who_slides_a_bottom_node_by_node(self):
        for name, knows in (("one", False), ("contact", True)):
            self.show(name)
            told = self.browser.value("document.querySelector('.notes').textContent")
            self.assertEqual("upbead respond answers slip and lift node by node" in told, knows, name)

    def test_a_record(self):
        text = "zeit (ms);F (kN/m)\n13,5;0\n80;2500,5\n95;1000\n300;0\n"
        self.show()
        said = self.drop("record.csv", text)
        self.assertIn("4 times up to 0.3 s", said)
        self.browser.value(SETTLED)
        self.same_as_respond(self.model, self.folder / "record.csv")

    def test_a_record_of_two_loads(self):
        text = "time,slow,impulse\n0,0,0\n0.1,1e5,2e6\n0.5,3e5,0\n0.9,1e5,0\n"
        self.show("two")
        self.drop("two.csv", text)
        self.browser.value(SETTLED)
        self.same_as_respond(self.two, self.folder / "two.csv")

    def test_a_pulse_of_the_second_load(self):
        self.show("two")
        told = made.ask(self.browser, {"load": "1", "peak": "900", "duration": "0.4", "rise": "0.1"})
        (self.folder / "second.csv").write_text(told["wave"])
        self.same_as_respond(self.two, self.folder / "second.csv")

    def same_as_respond(self, model, wave):
        exact, _ = made.respond(model, [wave], self.folder / "out")
        exact = exact[wave.stem]
        for key in ("peak_force", "peak_shear", "peak_shear_seaward", "error_estimate", "beyond_band", "peak_heel_pressure"):
            self.assertLess(abs(self.call(NUMBER, key) - exact[key]), 1e-10 * max(1.0, abs(exact[key])), key)

    def test_records_that_are_not_sure_are_refused(self):
        refused = {
            "1,2\n3,4\n": "not the names",
            "step,F\n1,2\n3,4\n": "not sure to be the time",
            "time,F\n1,2\n1,4\n": "does not follow",
            "time,F\n-1,2\n1,4\n": "starts at -1",
            "time,F\n1,2\n2,x\n": "line 3: 'x' is not a number",
            "time,F\n1,2\n2\n": "line 3: 1 cells",
            "time,F (m)\n1,2\n2,3\n": "unit 'm'",
            "time,F_kN_m\n1,2\n2,3\n": "holds 'kN', a unit that is not read there",
            "time,F / kN/m\n1,2\n2,3\n": "holds 'kN'",
            "time,F_kN\n1,2\n2,3\n": "holds 'kN'",
            "time;F (N/m)\n0,017;4.000\n0,02;0\n": "line 2: a point where other numbers have decimal commas",
            "time,F,G\n1,2,3\n2,3,4\n": "is no load of the model",
            "time,F\n1,0\n2,0\n": "zero throughout",
            "time\n1\n2\n": "without a load",
            "": "empty file",
        }
        self.show()
        for number, (text, words) in enumerate(refused.items()):
            said = self.drop(f"refused{number}.csv", text)
            self.assertIn(words, said)
            self.assertIn("was not read", said)

    def test_an_uplift_that_is_a_record_is_told_at_the_head(self):
        for uplift in ("in_phase", "history"):
            text = document.document(model_data.model_data(made.changed(self.model, self.folder / f"{uplift}.h5", uplift=uplift)))
            head = text[text.index("<body>") :]
            self.assertEqual("uplift_left_out" in head[: head.index("whatif")], uplift == "history")

    def test_a_void_scene_is_told_beside_every_number(self):
        void = made.voided(self.model, self.folder / "void.h5")
        self.pages["void"] = upbead.page(void, self.folder / "void.html")
        shown = self.show("void")
        self.assertIn("No verdict may be drawn: implausible", shown("document.querySelector('.judged').textContent"))
        self.assertIn("VOID: implausible", shown("document.querySelector('.headline').textContent"))
        self.assertIn("VOID: implausible", shown("document.querySelector('.whatif figure').textContent"))
        self.assertEqual(shown("document.querySelectorAll('.checks .holds').length"), 0)
        self.assertIn("VOID, as the warnings say: implausible", self.browser.value(f"({made.ASK})({{}})")["histories"].splitlines()[0])
        self.show()
        self.assertNotIn("VOID", shown("document.querySelector('.whatif').textContent"))

    def test_of_models_beside_each_other_the_void_one_is_named(self):
        (self.folder / "soft").mkdir()
        void = made.voided(self.model, self.folder / "soft/reduced.h5")
        text = upbead.page(self.model, self.folder / "beside.html", beside=[void]).read_text(encoding="utf-8")
        self.assertIn("No verdict may be drawn: soft: implausible", text)

    def test_begins_with_the_pulse_of_the_case(self):
        pulse = {"shape": "church_roof", "peak": 2e6, "rise": 0.02, "duration": 0.07, "plateau": 0.4, "plateau_duration": 0.9, "start": 0.01}
        case = "[loads.impulse.pulse]\n" + "\n".join(f"{key} = {value!r}" for key, value in pulse.items())
        self.assertEqual(model_data.pulse_of({"case": np.array([case.encode()])}, "impulse"), pulse)
        data = model_data.model_data(self.model)
        self.assertIsNone(data["loads"][0]["pulse"])
        data["loads"][0]["pulse"] = pulse
        self.pages["pulse"] = self.folder / "pulse.html"
        self.pages["pulse"].write_text(document.document(data))
        value = self.show("pulse")
        del self.pages["pulse"]
        self.assertEqual(self.browser.problems, [])
        for key, given in {**pulse, "peak": data["loads"][0]["peak"] / 1e3}.items():
            self.assertEqual(value(f"""document.querySelector('[data-key="{key}"]').value"""), str(given).removesuffix(".0"), key)

    def test_in_the_report_of_a_run(self):
        folder = self.folder / "one"
        made.call("run", made.CASES / "fig2b-prototype.toml", "--out", folder, "--set", COARSE)
        for width in (400, 1600):
            text = self.report(folder, width)
            self.assertEqual(self.browser.problems, [])
            self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
        self.assertLess(len(text.encode()), LARGEST_PAGE)
        self.browser.value(SETTLED)
        before = self.call(NUMBER, "peak_shear")
        self.call(TYPE, "peak", "3200")
        self.assertAlmostEqual(self.call(NUMBER, "peak_shear") / before, 2.0, places=9)

    def test_not_in_the_report_of_another_scene(self):
        folder = self.folder / "two"
        made.call("run", made.CASES / "fig2b-prototype.toml", "--out", folder, "--set", COARSE, "--set", "regions.mound.porosity=0.41")
        self.assertIn("of another scene", self.report(folder, 1280))

    def report(self, folder, width):
        target = folder / "report.html"
        target.write_text(page.build(Result(folder)))
        self.browser.problems.clear()
        self.browser.open(target, width)
        return target.read_text()

    def test_on_paper(self):
        self.show()
        target = self.folder / "page.pdf"
        pdf.write(self.pages["one"], target)
        self.assertTrue(target.read_bytes().startswith(b"%PDF"))

    def test_for_all_readers(self):
        source = made.axe(self.folder)
        if source is None:
            self.skipTest("npm does not bring axe-core")
        for name, width, dark in (("one", 360, False), ("one", 1280, True), ("two", 1280, False)):
            self.show(name, width, dark=dark)
            self.assertEqual(made.violations(self.browser, source), [], f"{name} at {width} px, dark: {dark}")


if __name__ == "__main__":
    if pdf.browser() is None:
        print("no Chromium: skipped")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
