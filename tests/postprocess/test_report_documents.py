"""Documents for a client: languages, the author's words, and documents of other commands than `run`.

Usage: test_report_documents.py FOLDER_OF_THE_SCRIPTS UPBEAD FOLDER_OF_THE_CASES
"""

import csv
import html
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from report_results import CASES, PROGRAM, SCRIPTS, page, run

MOST = 1.5e6  # bytes
LATIN = re.compile(r"[A-Za-z]{2,}( [a-z]{2,}){2,}")
JAPANESE = re.compile("[ぁ-んァ-ヶ一-龠]")
# Elements with fixed words; texts of the author and quotations of the program are in other elements
PLACES = re.compile(r"<(h2|h3|th|figcaption|summary|p)\b([^>]*)>(.*?)</\1>|<div class=\"(?:name|below)\">(.*?)</div>", re.DOTALL)
REPORT = '\n[report]\nproject = "Breakwater <A>"\nclient = "Port & Co."\nquestion = "Does it hold?"\ntext = "Some **words**."\nlogo = "logo.svg"\n'
LOGO = '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><circle r="4"/></svg>'
STUDY = """title = "Two soils"
case = "{case}"
read = ["response.shear_to_force_ratio", "response.peak_shear"]
[set]
"mesh.parameters.cells" = 0.8
[vary."regions.seabed.shear_modulus"]
values = [5e6, 20e6]
"""


def command(name, case, folder, *settings, jobs=None):
    words = [word for setting in settings for word in ("--set", setting)]
    processes = ["--jobs", str(jobs)] if jobs else []
    done = subprocess.run([PROGRAM, name, case, "--out", folder, *words, *processes], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return folder


def english_left(text, names):
    """Fixed words of a Japanese page that are still English, apart from names of the case."""
    found = []
    # these sections are texts of the program, and say so
    text = re.sub(r'<section id="(skipped|what-if)".*?</section>', "", text, flags=re.DOTALL)
    for match in PLACES.finditer(text.partition("<main>")[2]):
        inside = match[3] if match[3] is not None else match[4]
        inside = re.sub(r"<(code|data|script|svg)\b.*?</\1>", "", inside, flags=re.DOTALL)
        inside = html.unescape(re.sub(r"<[^>]*>", "", inside))
        if LATIN.search(inside) and not JAPANESE.search(inside) and inside.strip() not in names:
            found.append(inside)
    return found


class Documents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        folder = Path(cls.temporary.name)
        cls.mine = folder / "cases" / "mine.toml"
        cls.mine.parent.mkdir()
        cls.mine.write_text((CASES / "fig2b-prototype.toml").read_text(encoding="utf-8") + REPORT, encoding="utf-8")
        (cls.mine.parent / "logo.svg").write_text(LOGO)
        (folder / "two.toml").write_text(STUDY.format(case=CASES.resolve() / "fig2b-model.toml"))
        cls.folders = {
            "run": run(CASES / "fig2b-prototype.toml", folder / "run", "loads.impulse.factor=5"),
            "study": command("study", folder / "two.toml", folder / "study", jobs=1),
            "expected": command("expected", CASES / "section4/hd10.toml", folder / "expected", "life.years=50", "life.simulated_lives=50"),
            "waves": command("waves", CASES / "fig7-9/impulsive.toml", folder / "waves"),
        }
        cls.english = {name: page(place)[0] for name, place in cls.folders.items()}
        cls.japanese = {name: page(place, "--language", "ja")[0] for name, place in cls.folders.items()}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def summary(self, name):
        return json.loads((self.folders[name] / "summary.json").read_text())

    def exact(self, name):
        return {float(value) for value in re.findall(r'<data value="([-+.\deinf]+)"', self.english[name])}

    def test_every_document_asks_answers_and_says_what_it_stands_on(self):
        for name, text in self.english.items():
            places = [text.find(f'<section id="{part}"') for part in ("question", "verdict", "quality", "assumptions", "run")]
            self.assertEqual(places, sorted(places), name)
            self.assertNotIn(-1, places, name)
            self.assertIn("<svg", text, name)
            self.assertLess(len(text.encode()), MOST, name)
            self.assertNotIn("http", text, name)

    def test_japanese_pages_are_japanese(self):
        for name, text in self.japanese.items():
            self.assertIn('<html lang="ja">', text)
            self.assertEqual(english_left(text, {"under front edge"}), [], name)
            self.assertIn('<html lang="en">', self.english[name])
            numbers = [re.findall(r'<data value="([^"]*)"', page) for page in (text, self.english[name])]
            self.assertEqual(sorted(numbers[0]), sorted(numbers[1]), name)

    def test_needs_neither_matplotlib_nor_scipy(self):
        with tempfile.TemporaryDirectory() as missing:
            for name in ("matplotlib", "scipy"):
                (Path(missing) / f"{name}.py").write_text(f'raise ModuleNotFoundError("no {name}", name="{name}")\n')
            environment = {**os.environ, "PYTHONPATH": missing}
            for name, place in self.folders.items():
                text, done = page(place, environment=environment)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(text, self.english[name])
            done = subprocess.run(["/usr/bin/python3", "-B", SCRIPTS / "response.py", self.folders["run"]], env=environment,
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stderr, "response.py: figures are drawn by matplotlib, which is not installed; "
                             "apt install python3-matplotlib\n")

    def test_the_words_of_the_author(self):
        text, done = page(self.folders["run"], "--case", self.mine)
        self.assertEqual(done.returncode, 0, done.stderr)
        head = text.partition("</header>")[0]
        for told in ("Breakwater &lt;A&gt;", "Port &amp; Co.", "Does it hold?", "<strong>words</strong>", 'src="data:image/svg+xml;base64,'):
            self.assertIn(told, head)
        self.assertEqual(len(re.findall(r"\bsrc=", text)), 1)

    def test_a_refused_logo_leaves_the_page_as_it_was(self):
        wrong = self.mine.with_name("wrong.toml")
        wrong.write_text(self.mine.read_text(encoding="utf-8").replace("logo.svg", "mine.toml") + 'language = "de"\n', encoding="utf-8")
        target = self.folders["run"] / "page.html"
        before = target.read_text(encoding="utf-8")
        _, done = page(self.folders["run"], "--case", wrong)
        self.assertEqual(done.returncode, 1)
        for told in ("wrong.toml': report.logo: ", "neither PNG nor JPEG nor SVG", "report.language is 'de'"):
            self.assertIn(told, done.stderr)
        self.assertEqual(target.read_text(encoding="utf-8"), before)

    def test_the_language_of_the_case(self):
        japanese = self.mine.with_name("japanese.toml")
        japanese.write_text(self.mine.read_text(encoding="utf-8") + 'language = "ja"\n', encoding="utf-8")
        text, _ = page(self.folders["run"], "--case", japanese)
        self.assertIn('<html lang="ja">', text)
        self.assertIn("<h2>照査</h2>", text)
        self.assertIn("Does it hold?", text)

    def test_sensitivity_begins_with_the_number_of_the_run(self):
        sensitivity = self.english["run"].partition('<section id="sensitivity"')[2].partition("</section>")[0]
        less, given, more = (float(value) for value in re.findall(r'<data value="([^"]*)"', sensitivity)[:3])
        self.assertEqual(given, self.summary("run")["sliding"]["sliding_history"])
        self.assertTrue(less > given > more > 0, (less, given, more))

    def test_a_study_has_all_its_numbers(self):
        with open(self.folders["study"] / "study.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        wanted = {float(row[key]) for row in rows for key in ("regions.seabed.shear_modulus", "response.peak_shear", "response.shear_to_force_ratio")}
        self.assertLessEqual(wanted, self.exact("study"))
        checks = [check for check in self.summary("study")["checks"] if check["demand"] is not None]
        self.assertTrue(checks)
        self.assertLessEqual({float(check[key]) for check in checks for key in ("demand", "capacity")}, self.exact("study"))
        self.assertIn('<section id="quality"', self.english["study"])

    def test_a_life_has_its_distances_and_what_makes_them_unsure(self):
        expected, lives = self.summary("expected")["expected"], self.summary("expected")["monte_carlo"]
        wanted = {expected["distance_exact"], expected["distance_paper"], lives["mean"], lives["quantiles"]["0.95"]}
        self.assertLessEqual(wanted, self.exact("expected"))
        verdict = self.english["expected"].partition('<section id="verdict"')[2].partition("</section>")[0]
        for told in ("about", "Other laws say", "overturns the caisson", "have no limit here"):
            self.assertIn(told, verdict)

    def test_waves_have_pressures_forces_and_their_warnings(self):
        (wave,) = self.summary("waves")["waves"].values()
        self.assertLessEqual({wave[key] for key in ("p1", "p3", "p4", "pu", "force", "uplift", "sliding_exact")}, self.exact("waves"))
        for told in ("does not hold against sliding", "2 warnings", "the resultant leaves the base", 'id="pressures-impulsive"'):
            self.assertIn(told, self.english["waves"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
