#!/usr/bin/python3
"""Every kind of run on several processes: by how much F_T differs from that of one process.

usage: kinds.py PROGRAM [--processes N ...] [--only WORD] [-o FILE.md]

cases/fig2b-prototype.toml on a coarse mesh that is not symmetric. Prints, and writes, a table: for each kind the largest
difference of F_T(t), over its largest value, or what is said where it is not done.
"""

import argparse
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

CASE = pathlib.Path(__file__).resolve().parents[2] / "cases/fig2b-prototype.toml"
MPIRUN = ["mpirun", "--quiet", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
MESH = ["mesh.parameters.cells=0.25", "mesh.parameters.mound_crest_front=11", "time.end=0.3"]
MARCH = [*MESH, "time.scheme=sdirk4"]
DRY = ["mesh.parameters.sea_front=0", "mesh.parameters.sea_back=0"]
DARCY = ["regions.mound.flow=darcy", "regions.seabed.flow=darcy"]
STRAIN = [f"regions.{name}.strain={{reference_strain=1e-3, smallest_damping=0.05, largest_damping=0.2}}"
          for name in ("seabed", "mound")]
YIELDING = ["loads.impulse.factor=2", "regions.mound.law=mohr_coulomb",
            "regions.mound.strength={friction_angle=42, cohesion=2e3}", "regions.seabed.law=hysteretic",
            "regions.seabed.strain={reference_strain=1e-3}"]
FRICTION = ["regions.caisson.interface.kind=friction", "loads.impulse.factor=5", "mesh.full_domain=true"]
ELASTIC = ["regions.caisson={kind='solid', youngs_modulus=1e9, poissons_ratio=0.2, density=2100, deformation='elastic'}"]
ABSORBING = ["boundaries.right={displacement='absorbing', pressure='sealed'}"]
KINDS = {
    "marched by sdirk4": MARCH,
    "marched by generalised_alpha": [*MESH, "time.scheme=generalised_alpha"],
    "an elastic caisson, a side that absorbs": [*MARCH, *ELASTIC, *ABSORBING],
    "a pressure that is prescribed": [*MARCH, *DRY, "loads.wave={boundary='bed', kind='pressure', "
                                      "pulse={shape='half_sine', peak=20e3, duration=0.3}}"],
    "a motion that is prescribed": [*MARCH, *DRY, "boundaries.left.displacement=level", "boundaries.right.displacement=level",
                                    "loads.shake={boundary='base', kind='acceleration', "
                                    "pulse={shape='half_sine', peak=1, duration=0.3}}"],
    "added mass, air by depth": [*MARCH, *DRY, "regions.caisson.added_mass={seaward=9, landward=6}",
                                 "initial.water_level=6", "regions.seabed.saturation=0.99",
                                 "regions.seabed.air_by_depth=true"],
    "consolidation": [*MARCH, *DRY, *DARCY, "time.inertia=false"],
    "reduced, by name": [*MESH, "time.scheme=reduced"],
    "reduced, by choice of the program": MESH,
    "soil by strain, reduced": [*MESH, *STRAIN],
    "soil by strain, marched": [*MARCH, *STRAIN],
    "friction node by node": [*MARCH, *FRICTION],
    "soil that yields": [*MESH, *YIELDING],
    "soil that yields, with friction node by node": [*MESH, *YIELDING, *FRICTION],
    "an early stop": [*MARCH, "time.end=3", "time.stop_at_energy=0.5"],
    "fields": [*MARCH, "output.fields.every=0.1"],
    "dense output": [*MARCH, "output.every=0.001"],
    "a checkpoint, resumed": [*MARCH, "time.step=5e-4"],
    "the error estimated": [*MESH, "accuracy.estimate=true"],
    "a mesh for the tolerance": [*MESH, "mesh.refine='auto'", "accuracy.tolerance=0.05"],
    "slip as a whole": [*MARCH, "sliding.friction=0.5", "loads.impulse.factor=5"],
    "soil that packs denser": [*MESH, *YIELDING, "regions.seabed.densification={relative_density=0.5}"],
}


def command(program, keys, n, out, more=()):
    words = [str(program), "run", str(CASE), "--json", "--out", str(out), *more]
    for key in keys:
        words += ["--set", key]
    return words if n == 1 else [*MPIRUN, "-n", str(n), *words]


def ended(words):
    done = subprocess.run(words, capture_output=True, text=True, env=os.environ)
    return done.returncode, done.stderr


def resumed(program, keys, n, out):
    """Ends the run once it has kept a checkpoint, and goes on from there."""
    run = subprocess.Popen(command(program, keys, n, out, ("--checkpoint", "0.05")), stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
    kept = pathlib.Path(f"{out}.checkpoint/state.h5")
    while run.poll() is None and not kept.exists():
        time.sleep(0.01)
    run.send_signal(signal.SIGTERM)
    run.wait()
    if not kept.exists():
        raise SystemExit("the run ended before it kept a checkpoint")
    return ended(command(program, keys, n, out, ("--resume",)))


def shear(out):
    with h5py.File(out / "results.h5") as file:
        return file["history/shear_force"][:]


def differences(program, kind, keys, numbers):
    found = []
    with tempfile.TemporaryDirectory() as folder:
        first = None
        for n in [1, *numbers]:
            out = pathlib.Path(folder) / f"on{n}"
            by = resumed if kind.startswith("a checkpoint") and n > 1 else (lambda *all: ended(command(*all)))
            code, said = by(program, keys, n, out)
            if code != 0:
                found.append("refused" if n > 1 and code == 1 else f"fails: {said.strip()[-200:]}")
                continue
            if n == 1:
                first = shear(out)
                continue
            other = shear(out)
            found.append(f"{np.abs(other - first).max() / np.abs(first).max():.0e}" if other.shape == first.shape
                         else f"{len(other)} steps, not {len(first)}")
            summary = json.loads((out / "summary.json").read_text())
            if summary["discretisation"]["processes"] != n:
                found[-1] += f", on {summary['discretisation']['processes']}"
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--processes", type=int, nargs="+", default=[2, 3, 4])
    parser.add_argument("--only", default="", help="kinds with this word")
    parser.add_argument("-o", "--output", type=pathlib.Path)
    options = parser.parse_args()
    lines = ["| kind of run | " + " | ".join(f"on {n}" for n in options.processes) + " |",
             "|---|" + "---:|" * len(options.processes)]
    for kind, keys in KINDS.items():
        if options.only not in kind:
            continue
        found = differences(options.program.resolve(), kind, keys, options.processes)
        lines.append(f"| {kind} | " + " | ".join(found) + " |")
        print(lines[-1], flush=True)
    if options.output:
        options.output.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    sys.exit(main())
