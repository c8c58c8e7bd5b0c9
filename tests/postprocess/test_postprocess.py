"""Draws the figures from artificial results. Usage: test_postprocess.py FOLDER_OF_THE_SCRIPTS"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
from scripts import call

SCRIPTS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess"
sys.path.insert(0, str(SCRIPTS))
from upbead import msh  # noqa: E402

TWO_CELLS_22 = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "base"
2 1 "soil"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
2
1 1 2 1 1 1 2
2 3 2 1 1 1 2 3 4
$EndElements
"""

TWO_CELLS_41 = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "base"
2 1 "soil"
$EndPhysicalNames
$Entities
1 1 1 0
1 0 0 0 0
1 0 0 0 1 0 0 1 1 2 1 -1
1 0 0 0 1 1 0 1 1 1 1
$EndEntities
$Nodes
1 4 1 4
2 1 0 4
1
2
3
4
0 0 0
1 0 0
1 1 0
0 1 0
$EndNodes
$Elements
2 2 1 2
1 1 1 1
1 1 2
2 1 3 1
2 1 2 3 4
$EndElements
"""


def write(file, name, values, unit):
    file[f"history/{name}"] = values
    file[f"history/{name}"].attrs["unit"] = unit
    file[f"history/{name}"].attrs["description"] = f"made-up {name}"


def add_caisson(file, time):
    """An oscillator of 604.8 t/m and 2 Hz under a triangle of 1.6 MN/m and 0.15 s."""
    mass, rate, ratio = 604.8e3, 2 * np.pi * 2.0, 0.15
    force = 1.6e6 * np.interp(time, [0, 0.075, 0.15], [0, 1, 0])
    x, v = np.zeros_like(time), np.zeros_like(time)
    a = np.zeros_like(time)
    step = time[1] - time[0]
    for i in range(1, time.size):
        v[i] = v[i - 1] + step * a[i - 1]
        x[i] = x[i - 1] + step * v[i]
        a[i] = force[i] / mass - 2 * ratio * rate * v[i] - rate**2 * x[i]
    write(file, "force", force, "N/m")
    write(file, "inertia_force", mass * a, "N/m")
    write(file, "shear_force", force - mass * a, "N/m")
    write(file, "caisson/displacement_x", x, "m")


def add_probes(file, time):
    for name, delay in (("A", 0.0), ("B", 0.3)):
        wave = np.exp(-3 * time) * np.sin(10 * np.clip(time - delay, 0, None))
        write(file, f"probes/{name}/pressure", 2e4 * wave, "Pa")
        write(file, f"probes/{name}/displacement_y", 1e-4 * wave, "m")


class Figures(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def script(self, name, *arguments):
        return call(SCRIPTS / name, *arguments)

    def make_result(self, *adders, title="Made-up caisson"):
        time = np.linspace(0.0, 4.0, 4001)
        with h5py.File(self.folder / "results.h5", "w") as file:
            write(file, "time", time, "s")
            for add in adders:
                add(file, time)
        summary = {"title": title, "response": {"shear_to_force_ratio": 0.4321}}
        (self.folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")

    def expect_figure(self, done, path, beginning):
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(path.read_bytes().startswith(beginning), path)

    def expect_error(self, done, message):
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(message, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def make_records(self, error=1e-4):
        curve = {"panel": "p", "x": "time (s)", "y": "p (Pa)", "label": "", "abscissa": [0, 1], "exact": [0, 1]}
        curve["computed"] = [0, 1.01]
        checks = [{"what": "p over q", "value": error, "limit": 1e-3, "kind": "at_most"}]
        checks += [{"what": "order of u", "value": 1.98, "limit": 1.9, "kind": "at_least"}]
        checks += [{"what": "order of p", "value": 1.5, "limit": None, "kind": "measured"}]
        record = {"problem": "terzaghi", "test": "a.b", "checks": checks, "curves": [curve]}
        (self.folder / "a.b.json").write_text(json.dumps(record), encoding="utf-8")

    def test_verification(self):
        self.make_records()
        docs = self.folder / "docs"
        figure = docs / "figures/verification/terzaghi.png"
        self.expect_figure(self.script("verification.py", self.folder, docs), figure, b"\x89PNG")
        text = (docs / "reference/verification.md").read_text(encoding="utf-8")
        self.assertIn("| p over q | 1.0e-04 | 0.001 |", text)
        self.assertIn("| order of u | 1.98 | at least 1.9 |", text)
        self.assertIn("| [Terzaghi's consolidation](#terzaghis-consolidation) | 2 | none | 10 % |", text)
        self.assertEqual(self.script("verification.py", self.folder, docs, "--check").returncode, 0)
        self.make_records(error=2e-3)
        self.expect_error(self.script("verification.py", self.folder, docs, "--check"), "not met: p over q")
        self.make_records(error=None)  # a number that is not finite
        self.script("verification.py", self.folder, docs)
        self.assertIn("| not finite | 0.001 **not met** |", (docs / "reference/verification.md").read_text(encoding="utf-8"))

    def test_verification_without_results(self):
        self.expect_error(self.script("verification.py", self.folder, self.folder), "holds no results")

    def test_response_of_caisson(self):
        self.make_result(add_caisson, add_probes)
        self.expect_figure(self.script("response.py", self.folder), self.folder / "figure.png", b"\x89PNG")
        vector = self.folder / "a.svg"
        self.expect_figure(self.script("response.py", self.folder, "-o", vector), vector, b"<?xml")
        text = vector.read_text(encoding="utf-8")
        self.assertIn("Made-up caisson", text)
        document = self.folder / "a.pdf"
        self.expect_figure(self.script("response.py", self.folder, "-o", document, "--until", 1), document, b"%PDF")

    def test_words_are_no_mathematics(self):
        title = r"costs 5 $ or $\frac{x$, \$ and _"
        names = ("$\\frac{A$", "_B")

        def add(file, time):
            for name in names:
                write(file, f"probes/{name}/$p_{{$", np.sin(time), "Pa")

        self.make_result(add, title=title)
        vector = self.folder / "a.svg"
        self.expect_figure(self.script("response.py", self.folder, "-o", vector), vector, b"<?xml")
        text = vector.read_text(encoding="utf-8")
        for words in (title, *(name.replace("_", " ") for name in names), "$p {$"):  # names as the report has them
            self.assertIn(f"<!-- {words} -->", text)

    def test_nothing_is_written_over_what_is_read(self):
        self.make_result(add_caisson)
        before = (self.folder / "results.h5").read_bytes()
        (self.folder / "link.png").symlink_to("results.h5")
        for path in ("link.png", "results.h5"):
            done = self.script("response.py", self.folder, "-o", self.folder / path)
            self.expect_error(done, "which is read; choose another file")
        done = self.script("report.py", self.folder, "-o", self.folder / "summary.json")
        self.expect_error(done, "which is read; choose another file")
        self.expect_error(self.script("lumped_model.py", self.folder / "results.h5", "-o", self.folder / "link.png"), "which is read")
        self.assertEqual((self.folder / "results.h5").read_bytes(), before)

    def test_response_without_caisson_shows_probes(self):
        self.make_result(add_probes)
        self.expect_figure(self.script("response.py", self.folder), self.folder / "figure.png", b"\x89PNG")

    def test_response_without_summary(self):
        self.make_result(add_caisson)
        (self.folder / "summary.json").unlink()
        self.expect_figure(self.script("response.py", self.folder), self.folder / "figure.png", b"\x89PNG")

    def test_response_of_nothing(self):
        self.expect_error(self.script("response.py", self.folder / "none"), "there is no folder")
        self.expect_error(self.script("response.py", self.folder), "has no results.h5")
        (self.folder / "results.h5").write_text("hello", encoding="utf-8")
        self.expect_error(self.script("response.py", self.folder), "is no HDF5 file")
        self.make_result()
        self.expect_error(self.script("response.py", self.folder), "no caisson and no probes")
        self.make_result(lambda file, time: write(file, "shear_force", time, "N/m"))
        self.expect_error(self.script("response.py", self.folder), "has no dataset /history/force")
        self.make_result(lambda file, time: write(file, "shear_force", time[1:], "N/m"),
                         lambda file, time: write(file, "force", time[1:], "N/m"))
        self.expect_error(self.script("response.py", self.folder), "not that of /history/time")
        self.make_result(add_caisson)
        self.expect_error(self.script("response.py", self.folder, "-o", "a.xyz"), "unknown format '.xyz'")
        self.expect_error(self.script("response.py", self.folder, "-o", "/no/where.png"), "cannot write")
        (self.folder / "summary.json").write_text("hello", encoding="utf-8")
        self.expect_error(self.script("response.py", self.folder), "is no JSON")

    def test_mesh(self):
        for text in (TWO_CELLS_22, TWO_CELLS_41):
            (self.folder / "a.msh").write_text(text, encoding="utf-8")
            figure = self.folder / "a.svg"
            self.expect_figure(self.script("mesh.py", self.folder / "a.msh", "-o", figure), figure, b"<?xml")
            self.assertIn("soil: 1 cells", figure.read_text(encoding="utf-8"))
            figure.unlink()

    def test_mesh_of_nothing(self):
        path = self.folder / "a.msh"
        self.expect_error(self.script("mesh.py", path), "there is no file")
        path.write_text("hello", encoding="utf-8")
        self.expect_error(self.script("mesh.py", path), "is no gmsh mesh of version 2.2 or 4.1 in text")
        for text in (TWO_CELLS_22, TWO_CELLS_41):
            path.write_text(text[: text.index("$EndNodes") - 8], encoding="utf-8")
            self.expect_error(self.script("mesh.py", path), "is cut short or broken")
        path.write_text(TWO_CELLS_22.replace("2 3 2 1 1 1 2 3 4", "2 15 2 1 1 1"), encoding="utf-8")
        self.expect_error(self.script("mesh.py", path), "has no cells")

    def test_mesh_of_other_cells(self):
        """Triangles and cells of second order are read by their corners."""
        path = self.folder / "a.msh"
        for cell, corners in (("2 2 2 1 1 1 2 3", [1, 2, 3]), ("2 9 2 1 1 1 2 3 4 4 4", [1, 2, 3]),
                              ("2 16 2 1 1 1 2 3 4 1 1 1 1", [1, 2, 3, 4]), ("2 10 2 1 1 1 2 3 4 1 1 1 1 1", [1, 2, 3, 4])):
            text = TWO_CELLS_22.replace("2 3 2 1 1 1 2 3 4", cell).replace("1 1 2 1 1 1 2", "1 8 2 1 1 1 2 3")
            path.write_text(text, encoding="utf-8")
            mesh = msh.read(path)
            self.assertEqual(mesh.surfaces["soil"], [corners])
            self.assertEqual(mesh.curves["base"], [[1, 2]])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
