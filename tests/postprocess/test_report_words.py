"""The fixed words of the documents in both languages. Usage: test_report_words.py FOLDER_OF_THE_SCRIPTS"""

import ast
import re
import sys
import tomllib
import unittest
from pathlib import Path

SCRIPTS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess"
sys.path.insert(0, str(SCRIPTS))

from report import base, document, gauges, head, input_tables, language, loads, measures, response, run, sheet, waves, yielding  # noqa: E402
from report.kinds import calibration, expected, one_sheet, study  # noqa: E402
from report.kinds import waves as wave_document  # noqa: E402
from report.language import listed, named, phrase, say, speaking  # noqa: E402
from upbead import outputs  # noqa: E402

PLACES = re.compile(r"\$[^$]+\$|`[^`]+`|\{\w+\}")


def literals(node):
    """All strings that an argument may evaluate to."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.IfExp):
        yield from literals(node.body)
        yield from literals(node.orelse)


def spoken_words():
    """{words: file} of every literal that the code passes to the functions of report.language."""
    found = {}
    for file in sorted((SCRIPTS / "upbead/reporting").rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("say", "phrase", "heads"):
                found |= {word: file.name for argument in node.args for word in literals(argument)}
    return found


def listed_words():
    """Words that the code keeps in lists."""
    for _, short, what in measures.KNOWN:
        yield from (short, what)
    yield from (row[1] for table in (yielding.MOVED, yielding.ENERGY, base.PROFILES) for row in table)
    yield from (word for pair in sheet.FORMULAS for word in pair)
    yield from (*gauges.HEAD, *waves.HEAD, *document.OF_SCRIPTS, *input_tables.TITLES.values(), *head.NAMES.values())
    yield from (*expected.LAWS, *expected.LAWS.values(), *calibration.MEASURES.values())
    yield from (word for kind in (study, expected, calibration, one_sheet, wave_document) for word in (kind.KIND, kind.QUESTION))
    yield from (key.replace("_", " ") for key, _ in loads.PULSE)
    yield from (outputs.label(f"response.{key}") for key, _, _ in response.ROWS)
    yield from (outputs.label(f"discretisation.{key}") for key in run.SIZES)
    yield from (outputs.label(f"response.error_sources.{key}") for key in ("mesh", "time", "reduced_model", "far_boundary"))


class Words(unittest.TestCase):
    def test_every_english_word_has_a_japanese_one(self):
        table = language.table()
        said = spoken_words()
        self.assertGreater(len(said), 300)
        missing = {word: file for word, file in said.items() if word and re.search("[A-Za-z]{2}", word) and word not in table}
        self.assertEqual(missing, {})
        self.assertEqual([word for word in listed_words() if re.search("[A-Za-z]{2}", word) and word not in table], [])

    def test_both_languages_have_the_same_values_symbols_and_code(self):
        for english, japanese in language.table().items():
            self.assertTrue(japanese.strip(), english)
            self.assertEqual(sorted(PLACES.findall(english)), sorted(PLACES.findall(japanese)), english)

    def test_sentences_are_japanese(self):
        """Every translation of a text with a full stop or four words has kana or kanji."""
        for english, japanese in language.table().items():
            plain = PLACES.sub("", english)
            if re.search("[a-z]{2}.*\\.$", plain) or len(re.findall(r"[A-Za-z]{2,}", plain)) >= 4:
                self.assertRegex(japanese, "[ぁ-んァ-ヶ一-龠]", english)

    def test_no_word_stands_twice_in_the_table(self):
        files = sorted((SCRIPTS / "upbead/reporting" / "words").glob("*.toml"))
        keys = [key for file in files for key in tomllib.loads(file.read_text(encoding="utf-8"))]
        self.assertEqual(len(keys), len(set(keys)))

    def test_terms_of_port_engineering(self):
        table = language.table()
        for english, term in (
            ("caisson", "ケーソン"),
            ("mound", "捨石マウンド"),
            ("sliding distance", "滑動量"),
            ("expected sliding $E(S)$", "期待滑動量"),
            ("peak $F_T$", "せん断力"),
            ("friction coefficient mu of the bottom", "摩擦係数"),
            ("course of the uplift", "揚圧力"),
            ("excess pore pressure", "間隙水圧"),
            ("Checks", "照査"),
            ("heel pressure", "後趾"),
            ("weight W' of the caisson in still water", "有効重量"),
        ):
            self.assertIn(term, table[english])

    def test_every_way_to_fail_has_japanese_words(self):
        checks = (Path(__file__).parents[2] / "src/output/checks.cc").read_text(encoding="utf-8")
        modes = re.findall('"([a-z ]+)"', checks[checks.index("mode_words[]"):checks.index("static_assert")])
        self.assertGreater(len(modes), 10)
        self.assertEqual([mode for mode in modes if mode not in language.table()], [])

    def test_phrases(self):
        self.assertEqual(phrase("peak $F_T$"), "peak <i>F</i><sub>T</sub>")
        self.assertEqual(say("{low} to {high}", low=1, high=2), "1 to 2")
        self.assertEqual(phrase("{low} to {high}", low="<", high=2), "&lt; to 2")
        with speaking("ja"):
            self.assertEqual(named("sea_front"), "港外側の海")
            self.assertEqual(named("a_name_of_my_own"), "a name of my own")
            self.assertEqual(listed(["a", "b"]), "a、b")
        self.assertEqual(say("no warnings"), "no warnings")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
