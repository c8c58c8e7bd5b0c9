"""An installation works by itself: the program, its geometries, its scripts, and a user's program that is linked with
it.

usage: install_test.py CMAKE COMPILER FOLDER_OF_THE_BUILD FOLDER_OF_THE_PROJECT [with_program_of_others]
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py

CMAKE, COMPILER = sys.argv[1:3]
BUILD, PROJECT = (Path(argument).resolve() for argument in sys.argv[3:5])
CONSUMER = Path(__file__).resolve().parent / "consumer"
PEAK, DURATION = 4e3, 0.03354101966  # of cases/fig2b-model-impulse.csv
COARSE = ["--set", "mesh.parameters.cells=0.4"]
LEFT = ("UPBEAD", "UPBEAD_MESHES", "PYTHONPATH")  # left out of the environment, as they may point to another upbead


def call(*command, **options):
    environment = {key: value for key, value in os.environ.items() if key not in LEFT}
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, env=environment, timeout=300,
                          check=False, **options)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}\n{done.stderr}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        call(CMAKE, "--install", BUILD, "--prefix", cls.folder / "made")
        cls.prefix = (cls.folder / "made").rename(cls.folder / "moved")
        cls.program, cls.share = cls.prefix / "bin/upbead", cls.prefix / "share/upbead"
        cls.case, cls.result = cls.share / "cases/fig2b-model.toml", cls.folder / "result"
        cls.summary = json.loads(call(cls.program, "run", cls.case, "--json", "--out", cls.result, *COARSE))
        cls.ratio = cls.summary["response"]["shear_to_force_ratio"]

    def reduced(self):
        file = self.result / "reduced.h5"
        if not file.is_file():
            call(self.program, "reduce", self.case, "--out", self.result, *COARSE)
        return file

    def test_case_of_the_installation(self):
        self.assertAlmostEqual(self.ratio, 0.75, delta=0.01)
        self.assertTrue((self.prefix / "share/doc/upbead/LICENSE").is_file())

    def test_geometries_of_the_installation(self):
        meshes = self.share / "meshes"
        own = meshes / "of_this_place.geo"
        self.addCleanup(own.unlink)
        shutil.copy(meshes / "composite.geo", own)
        call(self.program, "explain", self.case, *COARSE, "--set", 'mesh.geometry="of_this_place"')

    def test_package_calls_the_installed_program(self):
        code = "import upbead.program; print(upbead.program.find())"
        found = call("/usr/bin/python3", "-B", "-c", code, cwd=self.share / "postprocess")
        self.assertEqual(Path(found.strip()), self.program)

    def test_scripts(self):
        scripts = self.share / "postprocess"
        call("/usr/bin/python3", "-B", scripts / "response.py", self.result)
        self.assertGreater((self.result / "figure.png").stat().st_size, 10_000)
        call("/usr/bin/python3", "-B", scripts / "report.py", self.result, cwd=self.folder)
        page = (self.result / "report.html").read_text()
        self.assertIn('id="run"', page)
        self.assertIn("share of the pores in the volume", page)  # the meaning of a key, from the installed docs/reference/case.md

    def test_manual_pages_and_completion(self):
        page = (self.prefix / "share/man/man1/upbead-run.1").read_text()
        self.assertIn("\\-\\-checkpoint SECONDS", page)
        self.assertNotIn(str(self.folder), page)
        completion = self.prefix / "share/bash-completion/completions/upbead"
        for words, completed in (("re", "reduce reliability respond read"), ("run --ch", "--checkpoint"), ("run fi", "")):
            typed = ["upbead", *words.split()]
            script = (f"source {completion}; COMP_WORDS=({' '.join(typed)}); COMP_CWORD={len(typed) - 1}; _upbead; "
                      "echo ${COMPREPLY[@]}")
            self.assertEqual(call("bash", "-c", script).strip(), completed)

    def test_versions(self):
        told = dict(line.split(maxsplit=1) for line in call(self.program, "--version").splitlines())
        self.assertEqual(self.summary["versions"], told)
        for name in ("deal.II", "PETSc", "HDF5", "Eigen", "CHOLMOD", "FFTW"):
            self.assertRegex(told[name], r"^\d+\.\d+", name)
        for file in (self.result / "results.h5", self.reduced()):
            with h5py.File(file) as opened:
                self.assertEqual(opened.attrs["versions"].decode(), "; ".join(" ".join(pair) for pair in told.items()))
        for file in ("share/doc/upbead/CITATION.cff", "share/upbead/postprocess/pyproject.toml"):
            self.assertRegex((self.prefix / file).read_text(), f'version(: | = "){told["upbead"]}\\b', file)

    @unittest.skipUnless(sys.argv[5:] == ["with_program_of_others"], "compiling it takes a minute: only with ctest -C long")
    def test_program_of_others(self):
        build = self.folder / "consumer"
        call(CMAKE, "-S", CONSUMER, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release",
             f"-DCMAKE_CXX_COMPILER={COMPILER}")
        call(CMAKE, "--build", build)
        share, geometries = call(build / "consumer", self.reduced(), PEAK, DURATION).split()
        self.assertAlmostEqual(float(share), self.ratio, delta=0.005)
        self.assertEqual(int(geometries), len(list((PROJECT / "meshes").glob("*.geo"))))
        self.solves_a_section(build / "section")

    def solves_a_section(self, program):
        """The C++ program, which builds its section without a case, has the peak F_T of the case."""
        no_sea = ["--set", "mesh.parameters.sea_front=0", "--set", "mesh.parameters.sea_back=0"]
        run = json.loads(call(self.program, "run", self.share / "cases/fig2b-prototype.toml", "--json", "--out",
                              self.folder / "prototype", *COARSE, *no_sea))
        shear = float(call(program, self.share / "meshes/composite.geo", 1.6e6, 0.15, 1))
        self.assertAlmostEqual(shear / run["response"]["peak_shear"], 1, delta=1e-5)  # digits printed

    def test_headers_are_whole(self):
        include = self.prefix / "include"
        for header in include.rglob("*.h"):
            for name in re.findall(r'#include "(.*)"', header.read_text()):
                self.assertTrue((include / name).is_file(), f"{header} includes {name}")

    def test_package_names_no_folder_of_the_build(self):
        for file in (self.prefix / "lib/cmake/upbead").iterdir():
            for folder in (BUILD, PROJECT, self.folder):
                self.assertNotIn(str(folder), file.read_text(), file)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
