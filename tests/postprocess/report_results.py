"""Results that the tests of the report use: runs of shipped cases, with parts added that other scenes would have."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np

SCRIPTS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "postprocess"
PROGRAM = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).parents[2] / "build" / "upbead"
CASES = Path(sys.argv[3]) if len(sys.argv) > 3 else Path(__file__).parents[2] / "cases"
TITLE = '<b>&"</b><script>alert(1)</script>'
sys.path.insert(0, str(SCRIPTS))

COLUMN = (Path(__file__).parents[1] / "support/column.toml").read_text() + "[probes.middle]\nat = [0.5, 5.0]\n"


def run(case, folder, *settings):
    """Runs the program; returns the folder of the results."""
    command = [PROGRAM, "run", case, "--out", folder, *(word for setting in settings for word in ("--set", setting))]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return folder


def page(folder, *options, environment=None):
    """Makes the report; returns (text of the page, output of the command)."""
    target = folder / "page.html"
    done = subprocess.run(
        ["/usr/bin/python3", "-B", SCRIPTS / "report.py", folder, "-o", target, *options],
        capture_output=True,
        text=True,
        check=False,
        env=environment or os.environ,
    )
    return (target.read_text(encoding="utf-8") if done.returncode == 0 else ""), done


def column(folder):
    """A column of soil with a title that is HTML."""
    case = folder / "column_case.toml"
    case.write_text(f"title = {json.dumps(TITLE)}\n{COLUMN}")
    return run(case, folder / "column")


def with_records(source, target):
    """A copy of results with tables over the base, and with measured records."""
    shutil.copytree(source, target)
    with h5py.File(target / "results.h5", "a") as file:
        time, shear = file["history/time"][:], file["history/shear_force"][:]
        position = np.linspace(-9.0, 9.0, 41)
        base = file.require_group("base")
        for name in list(base):
            del base[name]
        base["position"] = position
        for name in ("normal_stress", "pore_pressure", "shear_stress"):
            base[name] = shear[:, None] / 18.0 * (1.0 + (position / 9.0) ** 4)
        for name, values, unit in (
            ("effective_normal_force", 4.3e6 + 0.1 * shear, "N/m"),
            ("eccentricity", 1e-6 * shear, "m"),
            ("toe_pressure", 2e5 + 0.1 * shear, "Pa"),
            ("heel_pressure", 2e5 - 0.1 * shear, "Pa"),
        ):
            if name not in file["history"]:
                file["history"][name] = values
                file["history"][name].attrs.update({"unit": unit, "description": f"made-up {name}"})
        record = file.create_group("measured/load_cell_3")
        record["time"], record["value"] = time, 1.1 * shear
        record.attrs.update({"unit": "N/m", "reading": "shear_force", "description": "a made-up <record>"})
    summary = json.loads((target / "summary.json").read_text())
    summary["measured"] = {
        "load_cell_3": {
            "reading": "shear_force",
            "peak_measured": 698012.5,
            "peak_computed": 634570.5,
            "peak_ratio": 0.9091,
            "rms": 12345.5,
            "rms_relative": 0.0181,
            "phase": 0.00125,
        }
    }
    (target / "summary.json").write_text(json.dumps(summary))
    return target
