#!/usr/bin/python3
"""A model of soils as a user asks it: one soil by options, many by standard input.

usage: soils_test.py PROGRAM CASES_FOLDER; UPBEAD_SAMPLE_SOILS in the environment names the program that writes a model
"""

import json
import os
import signal
import subprocess
import sys
import time

import h5py
import numpy as np
import pathlib

from program import CASES, PROGRAM, ProgramTest, main, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from hand_made_model import write_oscillator  # noqa: E402

G, k = "regions.sand.shear_modulus", "regions.sand.hydraulic_conductivity"
SLIDES = ["--friction", 0.6, "--buoyant-weight", 1e6]


class Soils(ProgramTest):
    def setUp(self):
        super().setUp()
        subprocess.run([os.environ["UPBEAD_SAMPLE_SOILS"], self.folder / "soils.h5"], check=True)
        (self.folder / "roof.csv").write_text("time,impact,slow\n0,0,0\n0.05,1.6e6,1\n0.1,4e5,0\n1.5,0,0\n")

    def respond(self, *arguments, **options):
        return upbead("respond", "soils.h5", "roof.csv", *arguments, cwd=self.folder, **options)

    def lines(self, asked, *arguments):
        done = self.respond("--soil", "-", *arguments, input=asked)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_answers_the_soil_that_is_given_and_names_it(self):
        done = self.respond("--soil", f"{G}=5e7", *SLIDES)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for part in ("F_T within ", f"soil        {k} = 0.2\nsoil        {G} = 5e7\n", "error of F_T", "S\nroof "):
            self.assertIn(part, done.stdout)
        result = self.folder / "results/soils-respond"
        summary = json.loads((result / "summary.json").read_text())
        self.assertEqual(summary["model"]["soil"], {G: 5e7, k: 0.2})
        with h5py.File(result / "responses.h5") as file:
            self.assertEqual(json.loads(file.attrs["soil"]), {G: 5e7, k: 0.2})
            peak = file["roof/peak_shear"][0]
        wave = summary["waves"][0]
        self.assertEqual(wave["peak_shear"], peak)
        self.assertGreater(wave["sliding"], 0)
        self.assertIsNotNone(wave["error_estimate"])
        own = json.loads(self.respond("--json").stdout)
        self.assertEqual(own["model"]["soil"], {G: 3e7, k: 0.2}, "the case's own soil")
        self.assertGreater(abs(own["waves"][0]["peak_shear"] / peak - 1), 0.01)

    def test_refuses_soils_and_options_that_do_not_fit(self):
        write_oscillator(self.folder / "reduced.h5")
        (self.folder / "wave.csv").write_text("time,P\n0,0\n0.05,1.6e6\n1.5,0\n")
        before = self.left_behind()
        for arguments, messages in (
                (["soils.h5", "roof.csv", "--soil", f"{G}=2e9"], ["--soil: ", "outside the box", f"{G} from "]),
                (["soils.h5", "roof.csv", "--soil", "regions.sand.porosity=0.3"],
                 ["--soil: 'regions.sand.porosity' is no key that the model varies", "the model is good for"]),
                (["soils.h5", "roof.csv", "--soil", G], [f"--soil {G}: no KEY=NUMBER", "write such as"]),
                (["soils.h5", "roof.csv", "--soil", f"{G}=3e7", "--soil", f"{G}=4e7"], ["given twice"]),
                (["reduced.h5", "wave.csv", "--soil", f"{G}=3e7"],
                 ["--soil: 'reduced.h5' is the model of one soil; leave out --soil"]),
                (["reduced.h5", "wave.csv", "--soil", "-"], ["--soil: 'reduced.h5' is the model of one soil"]),
                (["soils.h5", "roof.csv", "--soil", "-", "--soil", f"{G}=3e7"], ["--soil -: soils come from"]),
                (["soils.h5", "roof.csv", "--soil", "-", "--out", "x"], ["--out: answers to soils"]),
                (["soils.h5", "roof.csv", "--histories", "force"], ["--histories: ", "give --soil -"]),
                (["soils.h5", "roof.csv", "--soil", "-", "--histories", "shear"],
                 ["--histories: the model has no reading 'shear'; it has shear_force, probes/A/pressure, force"]),
                ([CASES / "fig2b-model.toml", "--soil", f"{G}=3e7"], ["--soil: a case is the model of its own soil"])):
            done = upbead("respond", *arguments, cwd=self.folder, input="")
            self.assertEqual((done.returncode, done.stdout), (1, ""), arguments)
            for message in messages:
                self.assertIn(message, done.stderr)
            self.assertEqual(self.left_behind(), before)

    def test_serves_soils_line_by_line(self):
        one = json.loads(self.respond("--soil", f"{G}=5e7", *SLIDES, "--json", "--out", "one").stdout)
        before = self.left_behind()
        told = self.lines(f'{{"{G}": 5e7}}\n{G}=2e9\nnonsense\n{G}=5e7 {k}=0.5\n\n', *SLIDES)
        self.assertEqual(self.left_behind(), before, "nothing is written")
        self.assertEqual([sorted(line) for line in told], [["error", "soil", "warnings", "waves"], ["soil", "why"], ["soil", "why"],
                                                           *2 * [["error", "soil", "warnings", "waves"]]])
        self.assertEqual(told[0]["waves"], one["waves"])
        self.assertEqual((told[0]["soil"], told[0]["error"]), (one["model"]["soil"], one["model"]["error"]))
        self.assertEqual((told[1]["soil"], told[2]["soil"]), ({G: 2e9}, None))
        self.assertEqual([line["soil"] for line in told[3:]], [{G: 5e7, k: 0.5}, {G: 3e7, k: 0.2}])

    def test_serves_histories_by_name(self):
        self.respond("--soil", f"{G}=5e7", "--out", "one")
        [told] = self.lines(f"{G}=5e7\n", "--histories", "shear_force,probes/A/pressure")
        wave = told["waves"][0]
        with h5py.File(self.folder / "one/responses.h5") as file:
            np.testing.assert_array_equal(wave["time"], file["roof/time"])
            np.testing.assert_allclose(wave["histories"]["shear_force"], file["roof/shear_force"][0], rtol=0,
                                       atol=1e-9 * wave["peak_shear"])
        self.assertEqual(len(wave["histories"]["probes/A/pressure"]), len(wave["time"]))
        self.assertEqual(list(wave["history_errors"]), ["shear_force", "probes/A/pressure"])

    def test_answers_at_once_and_obeys_an_interrupt(self):
        server = subprocess.Popen([PROGRAM, "respond", "soils.h5", "roof.csv", "--soil", "-"], cwd=self.folder, text=True,
                                  stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for value in (2e7, 4e7):
            server.stdin.write(f"{G}={value}\n")
            server.stdin.flush()
            self.assertEqual(json.loads(server.stdout.readline())["soil"][G], value, "before the input ends")
        server.send_signal(signal.SIGINT)
        begun = time.time()
        server.communicate(timeout=60)
        self.assertEqual(server.returncode, -signal.SIGINT)
        self.assertLess(time.time() - begun, 10)

    def test_help_teaches_soils(self):
        told = upbead("respond", "--help").stdout
        for part in ("--soil KEY=VALUE", "--histories NAMES", "standard input", '{"KEY": VALUE, ...}', "soils.h5"):
            self.assertIn(part, told)


if __name__ == "__main__":
    main()
