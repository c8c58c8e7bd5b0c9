#!/usr/bin/python3
"""The JSON Schemas of case, design and study files, which editors use to complete and check keys: every shipped file
is valid, every key of the program is in its schema, and mistakes that can be seen without a mesh are found.

usage: schema_test.py PROGRAM CASES_FOLDER
"""

import json
import re
import tomllib
import unittest

from jsonschema import Draft4Validator

from program import CASES, ProgramTest, upbead

COMMANDS = {"case": "explain", "design": "waves", "study": "study"}
SOUND = """
[mesh]
geometry = "composite"
[regions.sand]
kind = "porous"
shear_modulus = 30e6
poissons_ratio = 0.3
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = 1e-4
[regions.caisson]
kind = "rigid"
density = 2100.0
[loads.impulse]
boundary = "front"
kind = "force"
pulse = { shape = "triangle", peak = 1e6, duration = 0.15 }
"""
# mistakes of a user, each with its place
MISTAKES = [
    ("porosity = 0.4", "porosity = 40", "regions.sand.porosity"),
    ("porosity = 0.4", 'porosity = "0.4"', "regions.sand.porosity"),
    ("porosity = 0.4", "porosty = 0.4", "regions.sand"),
    ('kind = "rigid"', 'kind = "ridgid"', "regions.caisson.kind"),
    ('kind = "rigid"\n', "", "regions.caisson"),
    ("density = 2100.0", "density = 2100.0\nporosity = 0.4", "regions.caisson.kind"),
    ('shape = "triangle"', 'shape = "half_sine", rise = 0.1', "loads.impulse.pulse.shape"),
    ("peak = 1e6", "peak = [1e6]", "loads.impulse.pulse.peak"),
    ("[mesh]", "[msh]\n[mesh]", ""),
    ("[mesh]", "[time]\nend = -1.0\n[mesh]", "time.end"),
    ("[mesh]", "[probes]\na.at = [1.0]\n[mesh]", "probes.a.at"),
]


def kind_of(table):
    if "case" in table or "vary" in table:
        return "study"
    return "case" if "mesh" in table else "design"


def paths_of(schema, path=""):
    """Every key, written as in the reference."""
    for part in [schema, *schema.get("anyOf", [])]:
        for name, inner in part.get("properties", {}).items():
            at = f"{path}.{name}".strip(".")
            if not inner["description"].startswith("older name of"):
                yield at
                yield from paths_of(inner, at)
        if isinstance(part.get("additionalProperties"), dict):
            yield from paths_of(part["additionalProperties"], f"{path}.NAME")


class New(ProgramTest):
    """`upbead new`: writes a valid case that runs without changes, and its schema beside it."""

    def test_is_sound_by_program_and_schema(self):
        for words in ([], ["--width", 20, "--height", 17, "--depth", 12, "--mound", 5, "--wave-height", 8], ["--mound", 1, "--depth", 25, "--height", 28]):
            path = self.folder / f"case{len(words)}.toml"
            done = upbead("new", path, *words)
            self.assertEqual(done.returncode, 0, done.stderr)
            schema = json.loads((self.folder / "upbead-case.schema.json").read_text())
            self.assertTrue(path.read_text().startswith("#:schema upbead-case.schema.json\n"))
            self.assertEqual(list(Draft4Validator(schema).iter_errors(tomllib.loads(path.read_text()))), [])
            told = upbead("explain", path)
            self.assertEqual(told.returncode, 0, told.stderr)
            for name in ("walls_too_near", "effective_force", "mesh_too_coarse", "implausible", "submerged_weight"):
                self.assertNotIn(name, told.stderr)

    def test_runs_with_its_checks(self):
        upbead("new", self.folder / "mine.toml")
        done = upbead("run", self.folder / "mine.toml", "--json", "--out", self.folder / "out", "--set", "mesh.parameters.cells=0.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        checks = {check["name"]: check for check in json.loads(done.stdout)["checks"]}
        self.assertIsNotNone(checks["sliding distance"]["holds"])
        self.assertIsNotNone(checks["heel pressure p_e"]["margin"])

    def test_force_and_checks_are_not_milder_than_those_by_formulas(self):
        """`new` wrote P_1 (1 + 0.5 alpha*), below Goda's P for every alpha* > 0: "does not slide" where `waves` said that it
        does."""
        for words in ((), ("--width", 14, "--height", 13, "--depth", 9, "--mound", 4, "--wave-height", 7, "--period", 11)):
            path = self.folder / f"case{len(words)}.toml"
            self.assertEqual(upbead("new", path, *words).returncode, 0)
            case = tomllib.loads(path.read_text())
            section = "".join(f"{key} = {value}\n" for key, value in case["section"].items())
            wave = case["loads"]["wave"]["wave"]
            (self.folder / "design.toml").write_text(
                f"[section]\n{section}[waves.wave]\nheight = {wave['height']}\nperiod = {wave['period']}\n[limits]\n"
                + "".join(f"{key} = {value}\n" for key, value in case["limits"].items()))
            waves = json.loads(upbead("waves", self.folder / "design.toml", "--json", "--out", self.folder / "w").stdout)
            done = upbead("explain", path, "--json", "--set", "mesh.parameters.cells=1")
            told = json.loads(done.stdout)["wave_loads"]["wave"]
            self.assertGreaterEqual(told["peak"], waves["waves"]["wave"]["force"] * (1 - 1e-9))
            for key in ("safety_sliding", "safety_overturning", "heel_pressure", "sliding_exact"):
                self.assertAlmostEqual(told[key], waves["waves"]["wave"][key], delta=1e-9 * waves["waves"]["wave"][key])

    def test_replaces_nothing_and_refuses_what_does_not_stand(self):
        mine = self.folder / "mine.toml"
        mine.write_text("mine")
        self.assertEqual(upbead("new", mine).returncode, 1)
        self.assertEqual(mine.read_text(), "mine")
        done = upbead("new", self.folder / "deep.toml", "--depth", 30, "--height", 10, "--mound", 32)
        self.assertEqual(done.returncode, 1)
        self.assertIn("--mound", done.stderr)
        self.assertEqual(upbead("new", self.folder / "deep.toml", "--width", -1).returncode, 1)
        self.assertEqual(self.left_behind(), ["mine.toml"])


class Schema(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.schemas = {kind: json.loads(upbead(command, "--schema").stdout) for kind, command in COMMANDS.items()}

    def test_each_is_a_schema(self):
        for schema in self.schemas.values():
            Draft4Validator.check_schema(schema)

    def test_shipped_files_are_valid(self):
        kinds = []
        for path in sorted(CASES.rglob("*.toml")):
            table = tomllib.loads(path.read_text())
            kinds.append(kind_of(table))
            wrong = [f"{'.'.join(map(str, e.path))}: {e.message}" for e in Draft4Validator(self.schemas[kinds[-1]]).iter_errors(table)]
            self.assertEqual(wrong, [], path)
        self.assertEqual(set(kinds), set(COMMANDS))

    def test_every_key_is_there(self):
        for kind, command in COMMANDS.items():
            table, keys = "", set()
            for line in upbead(command, "--keys").stdout.splitlines():
                if line.startswith("## "):
                    table = (re.findall(r"`\[(.*)\]`", line) or [""])[0]
                elif found := re.match(r"\| `(\w+)` \|", line):
                    keys.add(f"{table}.{found[1]}".strip("."))
            self.assertGreater(len(keys), 15)
            self.assertEqual(keys - set(paths_of(self.schemas[kind])), set(), kind)

    def test_editors_complete_every_key(self):
        """The common language server of TOML ignores the keys of a table that also has `allOf`, `anyOf` or
        `oneOf`."""
        def tables(schema):
            if isinstance(schema, dict):
                if "properties" in schema and schema.get("additionalProperties") is False:
                    yield schema
                schema = list(schema.values())
            if isinstance(schema, list):
                for inner in schema:
                    yield from tables(inner)

        for schema in self.schemas.values():
            found = list(tables(schema))
            self.assertGreater(len(found), 2)
            for table in found:
                self.assertFalse({"allOf", "anyOf", "oneOf"} & set(table), list(table["properties"]))

    def test_mistakes_are_found_at_their_place(self):
        validator = Draft4Validator(self.schemas["case"])
        self.assertEqual(list(validator.iter_errors(tomllib.loads(SOUND))), [])
        for right, wrong, place in MISTAKES:
            self.assertIn(right, SOUND)
            errors = list(validator.iter_errors(tomllib.loads(SOUND.replace(right, wrong, 1))))
            self.assertEqual({".".join(map(str, e.path)) for e in errors}, {place}, wrong)
            (self.folder / "case.toml").write_text(SOUND.replace(right, wrong, 1))
            told = upbead("explain", self.folder / "case.toml")
            self.assertEqual(told.returncode, 1, "the program refuses it, too: " + wrong)

    def test_units_and_meanings_are_told(self):
        sand = self.schemas["case"]["properties"]["regions"]["additionalProperties"]["properties"]
        self.assertIn("(m/s)", sand["hydraulic_conductivity"]["description"])
        self.assertEqual(sand["porosity"]["minimum"], 0)
        self.assertTrue(sand["porosity"]["exclusiveMinimum"])
        self.assertEqual(sand["flow"]["default"], "auto")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
