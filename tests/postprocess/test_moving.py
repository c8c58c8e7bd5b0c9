"""Parts of the moving section, on artificial fields: contact at the bottom, mean slip, strength, the still picture.

usage: test_moving.py FOLDER_OF_THE_SCRIPTS
"""

import base64
import dataclasses
import re
import sys
import tempfile
import types
import unittest
from pathlib import Path

import h5py
import numpy as np

SCRIPTS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess"
sys.path.insert(0, str(SCRIPTS))

from report import animation, bottom, frames, moment, strength  # noqa: E402
from report.frames import GROUND, RIGID, Frames  # noqa: E402
from report.plot import Line, Panel, Plot  # noqa: E402
from upbead.results import Result  # noqa: E402

TIME = np.linspace(0.0, 1.0, 11)
X = np.linspace(-1.0, 1.0, 5)  # nodes of the bottom: ends and middles of two cells


def section(mobilised=None):
    """Two cells of a caisson on two cells of ground; in the second of two frames the caisson has opened at its
    seaward end."""
    row = [(x, y) for y in (0.0, -1.0) for x in (-1.0, 0.0, 1.0)]  # ground: its top first
    points = np.array(row + [(x, y) for y in (1.0, 0.0) for x in (-1.0, 0.0, 1.0)])
    cells = np.array([[0, 1, 4, 3], [1, 2, 5, 4], [6, 7, 10, 9], [7, 8, 11, 10]])
    moved = np.zeros((2, 12, 2))
    moved[1, 6:, 0], moved[1, [6, 9], 1] = 0.01, 0.02  # the caisson slips, its seaward end rises
    pressure = np.zeros((2, 12))
    pressure[1, :6] = np.linspace(-5e3, 1e4, 6)
    return Frames(np.array([0.0, 0.5]), points, cells, np.array([GROUND, GROUND, RIGID, RIGID]), moved, pressure, mobilised)


def write(folder, interface=True, coupled=False):
    with h5py.File(folder / "results.h5", "w") as file:
        for name in ("time", "force", "shear_force", "caisson/displacement_x"):
            file[f"history/{name}"] = TIME
            file[f"history/{name}"].attrs["unit"] = {"time": "s", "caisson/displacement_x": "m"}.get(name, "N/m")
        if interface:
            slip, opening = np.outer(TIME, np.full(5, 0.02)), np.zeros((11, 5))
            slip[5:, 4] = slip[4, 4]  # the landward node sticks from 0.4 s on
            opening[5:, 0] = 0.02
            for name, values in (("position", X), ("length", [0.25, 0.5, 0.5, 0.5, 0.25]), ("slip", slip), ("opening", opening)):
                file[f"interface/{name}"] = values
            file["interface/shear_force"] = file["interface/normal_force"] = np.ones((11, 5))
            file["history/interface/slip"] = slip.mean(axis=1)
            file["history/interface/slip"].attrs["unit"] = "m"
        if coupled:
            file["coupled/time"], file["coupled/slip"] = [0.0, 1.0], [0.0, 0.2]
    return Result(folder)


class Seams(unittest.TestCase):
    def test_the_line_between_two_soils(self):
        """Four cells of ground, the lower two of another region: the line is the two sides between them; without regions there
        is none."""
        row = [(x, y) for y in (0.0, -1.0, -2.0) for x in (-1.0, 0.0, 1.0)]
        places = np.array(row)
        corners = np.array([[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]])
        points, moved, pressed = places[corners].reshape(-1, 2), np.full((1, 16, 2), 0.1), np.ones((1, 16))
        made = frames.merged(np.array([0.0]), points, moved, pressed, None, np.array([5, 5, 2, 2]))
        found = {tuple(sorted(map(tuple, made.points[side].tolist()))) for side in made.seams}
        self.assertEqual(found, {((-1.0, -1.0), (0.0, -1.0)), ((0.0, -1.0), (1.0, -1.0))})
        self.assertEqual(len(frames.merged(np.array([0.0]), points, moved, pressed).seams), 0)


class Survey(unittest.TestCase):
    """Pictures of a section in survey coordinates are those of the same section about the origin."""

    PLACES = (np.array([441871.6, 6329700.7]), np.array([-3.2e6, 12.5]))

    def test_the_section_and_its_contact(self):
        with tempfile.TemporaryDirectory() as folder:
            result = write(Path(folder))
            here = section()
            wanted = animation.summary(here, result)
            drawn = moment.draw(here, wanted, 1)
            for place in self.PLACES:
                result.file.close()
                with h5py.File(Path(folder) / "results.h5", "a") as file:
                    file["interface/position"][:] = X + place[0]
                result = Result(Path(folder))
                there = dataclasses.replace(here, points=here.points + place)
                told = animation.summary(there, result)
                for name, values in wanted.items():
                    if name not in ("points", "origin", "magnify"):
                        self.assertEqual(told[name], values, name)
                self.assertAlmostEqual(told["points"]["step"] / wanted["points"]["step"], 1.0, places=6)
                self.assertEqual(re.sub("-0.0", "0.0", moment.draw(there, told, 1)), re.sub("-0.0", "0.0", drawn))

    def test_where_it_fails(self):
        summary = {"safety": {"lower": 0.8, "upper": 0.82, "fails_at": "region 'seabed' at (441871.1, 6329700.2) m"}}
        told = animation.failing(types.SimpleNamespace(summary=summary), self.PLACES[0])
        np.testing.assert_allclose(told["at"], [-0.5, -0.5], atol=1e-6)

    def test_plots_over_places(self):
        x = np.linspace(0.0, 0.2, 9)
        for shift in (0.0, 441871.6, -6.3e6):
            told = Plot("p", [Panel("Pa", [Line("a", x + shift, x)])], axis=("position", "m")).data()
            factor = 1000.0 if told["symbol"][1] == "mm" else 1.0
            np.testing.assert_allclose(np.diff(told["panels"][0]["lines"][0]["x"]) / factor, 0.025, rtol=1e-3)


class Moving(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def test_each_node_has_its_state_in_each_frame(self):
        told = bottom.contact(write(self.folder), section())
        self.assertEqual(told["states"], ["00000", "21110"])  # no node slips at the first time
        self.assertEqual(told["pairs"], [[9, 0], [10, 1], [11, 2]])
        self.assertEqual(told["place"], [0.0, 0.5, 1.0, 1.5, 2.0])
        self.assertEqual(told["told"][1], "bottom: 12 % sticks, 75 % slips, 12 % is open, gap up to 20 mm; mean slip 9.8 mm")

    def test_pieces_of_the_bottom_lie_on_both_bodies(self):
        frames_ = section()
        told, moved = bottom.contact(write(self.folder), frames_), frames_.points + frames_.displacement[1]
        upper, lower = (moment.along(told, moved, side) for side in (0, 1))
        np.testing.assert_allclose(upper[[0, 1, -1]], [[-0.99, 0.02], [-0.99, 0.02], [1.01, 0.0]], atol=1e-12)
        np.testing.assert_allclose(lower[:, 0], np.interp(np.arange(11), np.arange(1, 11, 2), X, left=-1, right=1), atol=1e-12)

    def test_slip_as_a_whole_is_told_where_fields_know_none(self):
        np.testing.assert_allclose(bottom.as_a_whole(write(self.folder, interface=False, coupled=True), section()), [0.0, 0.1])
        (self.folder / "both").mkdir()
        self.assertIsNone(bottom.as_a_whole(write(self.folder / "both", coupled=True), section()))
        (self.folder / "none").mkdir()
        result = write(self.folder / "none", interface=False)
        self.assertIsNone(bottom.as_a_whole(result, section()))
        self.assertIsNone(bottom.contact(result, section()))

    def test_slip_counts_in_the_factor_of_what_is_drawn(self):
        told = animation.summary(section(), write(self.folder, interface=False, coupled=True))
        alone = animation.summary(section(), types.SimpleNamespace(file={}, folder=self.folder, summary={}))
        self.assertGreaterEqual(alone["magnify"], 2 * told["magnify"])

    def test_strength_is_a_byte_for_each_cell(self):
        mobilised = np.array([[0.5, 0.96, np.nan, np.nan], [1.0, 0.2, np.nan, np.nan]])
        told = strength.summary(section(mobilised))
        self.assertEqual(list(base64.b64decode(told["data"])), [125, 240, 255, 255, 250, 50, 255, 255])
        self.assertTrue(told["told"][0].startswith("50.0 % of the soil"))
        self.assertIsNone(strength.summary(section()))

    def test_where_it_fails_at_rest(self):
        found = {"safety": {"lower": 1.5, "upper": 1.51, "fails_at": "region 'mound' at (-3.2, 1.5e-1) m"}}
        self.assertEqual(strength.failing(found), ((-3.2, 0.15), 1.5, 1.51))
        for nothing in ({}, {"safety": None}, {"safety": {"lower": 16.0, "upper": None, "fails_at": ""}}):
            self.assertIsNone(strength.failing(nothing))

    def test_the_still_picture_shows_states_zone_and_slip(self):
        mobilised = np.array([[0.5, 0.96, np.nan, np.nan]] * 2)
        frames_, result = section(mobilised), write(self.folder)
        told = animation.summary(frames_, result) | {"fails": {"at": (0.5, -0.5), "text": "x"}, "slip": [0.0, 0.1]}
        drawn = moment.draw(frames_, told, 1)
        for class_ in ("zone", "slipped", "fails"):
            self.assertEqual(drawn.count(f'class="{class_}"'), 1, class_)
        self.assertEqual(len(re.findall("<polyline", drawn)), 5)
        self.assertIn("bottom: 12 % sticks", re.search('aria-label="([^"]*)"', drawn)[1])
        self.assertEqual([drawn.count(colour) for _, colour in bottom.STATES], [1, 3, 2])  # gaps are filled, too

    def test_pressures_are_numbers_of_colours(self):
        self.assertEqual(list(base64.b64decode(animation.shades(np.array([-9.0, -1.0, 0.0, 1.0])))), [0, 0, 128, 255])

    def test_frames_are_left_out_so_that_a_page_stays_small(self):
        for yields in (False, True):
            kept = frames.thinned(500, 2000, yields)
            self.assertLess(len(kept) * 2000 * (5.5 + yields), 600_000)
            self.assertEqual((kept[0], kept[-1]), (0, 499))

    def test_histories_beside_the_section(self):
        drawn = animation.scrubbed(write(self.folder))
        self.assertIn('class="plot scrubbed"', drawn)
        self.assertIn('[["mean",""],[" slip",""]]', drawn)
        (self.folder / "coupled").mkdir()
        drawn = animation.scrubbed(write(self.folder / "coupled", interface=False, coupled=True))
        self.assertIn('[["slip",""],[" as",""],[" a",""],[" whole",""]]', drawn)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
