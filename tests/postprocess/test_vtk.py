"""The fields of a run as ParaView reads them: by VTK's own reader where python3-vtk9 is installed, else by their XML.

usage: test_vtk.py FOLDER_OF_THE_SCRIPTS PROGRAM CASES_FOLDER
"""

import importlib.util
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

SCRIPTS, PROGRAM, CASES = (Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(SCRIPTS))

from report import vtu  # noqa: E402

STATE = (SCRIPTS / "paraview_state.py").read_text(encoding="utf-8")
OF_YIELDING = {"mobilised_strength_(1)", "dissipated_energy_(J_m3)"}


def asked():
    """The fields that the state for ParaView may colour."""
    known = {}
    exec(compile(re.search(r"^DISPLACEMENT.*?^}\n", STATE, re.MULTILINE | re.DOTALL)[0], "paraview_state.py", "exec"), known)
    return {field for field, _, _ in known["COLOURED"].values()}


class Fields(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        settings = ("mesh.parameters.cells=0.3", "output.fields={ every = 0.025 }", 'regions.caisson.interface.kind="friction"', "loads.impulse.factor=4")
        words = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([PROGRAM, "run", CASES / "fig2b-model.toml", "--out", cls.folder / "run", *words], capture_output=True, check=True)
        cls.steps = vtu.times(cls.folder / "run/fields.pvd")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_the_collection_names_all_files_and_no_others(self):
        written = {path.resolve() for path in (self.folder / "run").rglob("*.vt*")}
        self.assertEqual({path.resolve() for _, path in self.steps}, written)
        times = [time for time, _ in self.steps]
        self.assertEqual(times, sorted(set(times)))
        self.assertEqual([path.name for path in (self.folder / "run").rglob("*.pv*")], ["fields.pvd"])

    def test_every_field_that_the_state_asks_for_is_in_every_file(self):
        for _, path in self.steps:
            head = ElementTree.fromstring(vtu.parts(path.read_bytes())[0])
            names = {item.get("Name") for item in head.iter("DataArray")}
            self.assertEqual(asked() - names, OF_YIELDING, path.name)  # no soil yields in this run

    def test_cells_know_their_region(self):
        """In every file, though no soil yields: a number of each small cell, and the names by these numbers."""
        for _, path in self.steps:
            names, numbers = vtu.regions(path)
            self.assertEqual(sorted(names), ["caisson", "mound", "sea_back", "sea_front", "seabed"], path.name)
            grid = vtu.arrays(path, ("points", "types"))
            self.assertEqual(numbers.shape, grid["types"].shape)
            corners = vtu.corners(len(grid["points"]), len(grid["types"]))
            middles = grid["points"][corners, :2].mean(axis=1)
            of_patches = numbers.reshape(len(corners), -1)
            self.assertTrue((of_patches == of_patches[:, :1]).all())
            seabed = of_patches[:, 0] == names.index("seabed")
            self.assertTrue(((middles[:, 1] < 0) == seabed).all())

    @unittest.skipUnless(importlib.util.find_spec("vtkmodules"), "no python3-vtk9")
    def test_vtk_reads_the_same_numbers(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

        for _, path in (self.steps[0], self.steps[-1]):
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(path))
            reader.Update()
            grid = reader.GetOutput()
            ours = vtu.arrays(path, asked() | {"points", "types"})
            self.assertEqual((grid.GetNumberOfCells(), grid.GetNumberOfPoints()), (len(ours["types"]), len(ours["points"])))
            for name in asked() - OF_YIELDING:
                read = vtk_to_numpy(grid.GetPointData().GetArray(name))
                np.testing.assert_array_equal(read, ours[name], name)
            names, numbers = vtu.regions(path)
            texts = grid.GetFieldData().GetAbstractArray("region_names")
            self.assertEqual([texts.GetValue(i) for i in range(texts.GetNumberOfValues())], names)
            np.testing.assert_array_equal(vtk_to_numpy(grid.GetCellData().GetArray("region")), numbers)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
