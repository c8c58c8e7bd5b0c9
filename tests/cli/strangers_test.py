#!/usr/bin/python3
"""Files from unknown sources: meshes that would run commands, and models that were changed, end with a message and
exit code 1."""

import ctypes
import json
import os
import unittest

import h5py

from program import CASES, ProgramTest, upbead

SCRIPT = """
Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {2, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Transfinite Curve{1:4} = 3;
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Transfinite Surface{1}; Recombine Surface{1};
Physical Surface("soil") = {1}; Physical Curve("side") = {1, 2, 3}; Physical Curve("top") = {4};
"""

CASE = """
title = "somebody's"
[mesh]
file = "section.geo"
[regions.soil]
kind = "solid"
shear_modulus = 1e8
poissons_ratio = 0.3
density = 2000.0
[boundaries.side]
displacement = "fixed"
[boundaries.top]
displacement = "free"
[loads.push]
boundary = "top"
kind = "traction"
direction = [1.0, 0.0]
pulse = { shape = "triangle", peak = 1e3, rise = 0.01, duration = 0.02 }
[time]
end = 0.05
"""


def without_confinement():
    """Runs in the child process before it becomes the program: makes it find neither seccomp nor Landlock, as on an
    old kernel."""
    library = ctypes.CDLL("libseccomp.so.2")
    library.seccomp_init.restype = ctypes.c_void_p
    allow, fails_as_missing = 0x7FFF0000, 0x00050000 | 38
    calls = ctypes.c_void_p(library.seccomp_init(allow))
    for name in (b"seccomp", b"landlock_create_ruleset"):
        library.seccomp_rule_add_array(calls, fails_as_missing, library.seccomp_syscall_resolve_name(name), 0, None)

    class Argument(ctypes.Structure):
        _fields_ = [("number", ctypes.c_uint), ("compare", ctypes.c_int), ("a", ctypes.c_uint64), ("b", ctypes.c_uint64)]
    set_seccomp, equal = 22, 4
    first = Argument(0, equal, set_seccomp, 0)
    library.seccomp_rule_add_array(calls, fails_as_missing, library.seccomp_syscall_resolve_name(b"prctl"), 1,
                                   ctypes.byref(first))
    if library.seccomp_load(calls) != 0:
        os._exit(99)


class Strangers(ProgramTest):
    def setUp(self):
        super().setUp()
        self.made = self.folder / "made"
        self.write("case.toml", CASE)

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def mesh(self, more, command="explain", *arguments, **options):
        self.write("section.geo", SCRIPT + more + "\n")
        done = upbead(command, "case.toml", *arguments, cwd=self.folder, **options)
        self.assertFalse(self.made.exists(), more)
        return done

    def test_commands_are_told_by_name_and_line(self):
        for command in ("explain", "run", "reduce"):
            done = self.mesh(f'SystemCall "touch {self.made}";\n\nCreateDir "made"; Exit;', command)
            self.assertEqual(done.returncode, 1, command)
            for told in ("section.geo:7:1: 'SystemCall' would start a program",
                         "section.geo:9:1: 'CreateDir' would make a folder", "section.geo:9:19: 'Exit' would end"):
                self.assertIn(told, done.stderr)
            self.assertFalse((self.folder / "results").exists())

    def test_what_escapes_the_reading_is_refused(self):
        for word, told in ("SystemCall", "it tries to start a program"), ("CreateDir", "it tries to make the folder"):
            text = "touch made" if word == "SystemCall" else "made"
            done = self.mesh(f'StringToName[StrCat("{word[:3]}", "{word[3:]}")] "{text}";')
            self.assertEqual(done.returncode, 1)
            self.assertIn(told, done.stderr)

    def test_the_end_of_gmsh_is_no_success(self):
        self.write("end.txt", "Exit;\n")
        for command in ("explain", "run"):
            done = self.mesh('Merge StrCat("end", ".txt");', command)
            self.assertEqual(done.returncode, 1)
            self.assertIn("gmsh ends the program on it", done.stderr)

    def test_nothing_is_printed_twice_and_nothing_is_left(self):
        done = self.mesh('Printf("hello");', "run")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count("written"), 1)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["case.toml", "results", "section.geo"])

    def test_options_beside_it_are_ignored(self):
        self.write("section.geo.opt", f'SystemCall "touch {self.made}"; Exit;\n')
        self.assertEqual(self.mesh("").returncode, 0)

    @unittest.skipIf(os.environ.get("UPBEAD_SANITIZE") == "ON", "the sanitizers' run-time is confined as well")
    def test_cells_of_second_order_are_read_by_their_corners(self):
        """A top along an arc of 53.13 degrees in two parts: each rises by tan(53.13/8)/2 = 0.0582 of its chord."""
        arc = SCRIPT.replace("Line(3) = {3, 4};", "Point(5) = {1, -1, 0}; Circle(3) = {3, 5, 4};")
        for script, bent in ((SCRIPT, None), (arc, 0.0582)):
            for order in (1, 2):
                (self.folder / "section.geo").write_text(f"Mesh.ElementOrder = {order};\n{script}")
                (self.folder / "case.toml").write_text(CASE)
                done = upbead("explain", "case.toml", "--json", cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                found = {w["name"]: w["value"] for w in json.loads(done.stdout)["warnings"]}
                told = "4 cells of second or higher order, read by their corners"
                self.assertEqual(told in upbead("explain", "case.toml", cwd=self.folder).stdout, order == 2)
                if bent and order == 2:
                    self.assertAlmostEqual(found["sides_straightened"], bent, 4)
                else:
                    self.assertNotIn("sides_straightened", found)

    def test_where_nothing_can_confine_it_a_person_must_vouch(self):
        done = self.mesh("", preexec_fn=without_confinement)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nothing on this machine (seccomp, Landlock) can keep 'section.geo' from", done.stderr)
        self.assertIn("--trust", done.stderr)
        done = self.mesh("", "explain", "--trust", preexec_fn=without_confinement)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.mesh("", "explain", "--trust").returncode, 0)
        # with confinement --trust changes nothing
        done = self.mesh(f'StringToName["SystemCall"] "touch {self.made}";', "explain", "--trust")
        self.assertEqual(done.returncode, 1)
        # the shipped geometries need no --trust
        done = upbead("explain", CASES / "fig2b-model.toml", preexec_fn=without_confinement)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_models_that_were_changed(self):
        quick = ["--set", "mesh.parameters.cells=0.35", "--set", "time.end=0.3"]
        done = upbead("reduce", CASES / "fig2b-model.toml", *quick, "--out", "model", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        model, wave = self.folder / "model" / "reduced.h5", CASES / "fig2b-model-impulse.csv"
        whole = model.read_bytes()

        def respond():
            return upbead("respond", model, wave, "--out", "answer", cwd=self.folder)
        self.assertEqual(respond().returncode, 0)
        with h5py.File(model) as file:
            parts = []
            file.visititems(lambda name, part: parts.append(name) if getattr(part, "size", 0) else None)
            parts = [name for name in parts if file[name].dtype.kind == "f" and file[name][...].any()]
        self.assertGreater(len(parts), 8)
        for name in parts:
            for factor in -1., 2.:
                model.write_bytes(whole)
                with h5py.File(model, "r+") as file:
                    file[name][...] = file[name][...] * factor
                done = respond()
                self.assertEqual(done.returncode, 1, f"{name} times {factor}: {done.stderr}")
                self.assertIn(str(model), done.stderr)


if __name__ == "__main__":
    unittest.main(argv=["strangers_test.py"], verbosity=2)
