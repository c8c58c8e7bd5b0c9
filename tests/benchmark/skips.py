"""Savings by every rule that leaves something out (unknowns, solves, seconds), and the change of peak F_T.

    /usr/bin/python3 tests/benchmark/skips.py build/upbead [docs/reference/measured-skips.md]

Runs each scene with a rule and with it overruled, alternately, and takes medians. Writes the table between the markers
of the page, or prints it. Seconds are those of the processor (user and system, all threads), less those of a start.
"""
import json
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
REPEATS = 3
MARCHED = {"time.scheme": '"sdirk4"'}  # with and without a rule, so that solves and seconds are comparable
PROTOTYPE = (ROOT / "cases/fig2b-prototype.toml").read_text().replace('"fig2b', f'"{ROOT}/cases/fig2b')
PROTOTYPE = re.sub(r"\[probes\..*", "", PROTOTYPE, flags=re.S)
NO_SEA = {"mesh.parameters.sea_front": "0", "mesh.parameters.sea_back": "0"}


def pulse(duration, end):
    """The prototype under a triangle of that duration (s)."""
    text = re.sub(r'history = ".*impulse.csv"', f'pulse = {{ shape = "triangle", peak = 1.6e6, duration = {duration} }}',
                  PROTOTYPE)
    return text.replace("end = 1\n", f"end = {end}\n")


def concrete_caisson():
    return PROTOTYPE.replace('kind = "rigid"\ndensity', 'kind = "solid"\nshear_modulus = 12.5e9\npoissons_ratio = 0.2\ndensity')


def dry():
    """No pores, no sea: waves are slow, and do not reach the far sides beyond 200 m of sand within 0.6 s."""
    text = pulse(0.15, 0.6).replace("seabed_front = 60", "seabed_front = 200").replace("seabed_back = 60", "seabed_back = 200")
    text = re.sub(r"hydraulic_conductivity = .*", 'flow = "drained"', text)
    return re.sub(r', pressure = "\w+"', "", text)


COLUMN = """
[mesh]
geometry = "column"
parameters = {{ height = 15, cells = 60, cells_across = 4, grading = 20 }}
[regions.soil]
kind = "porous"
shear_modulus = 30e6
poissons_ratio = 0.33
porosity = 0.4
grain_density = 2650.0
hydraulic_conductivity = {k}
damping = {{ ratio = 0.05, frequencies = [1, 10] }}
[boundaries]
base = {{ displacement = "fixed", pressure = "sealed" }}
left = {{ displacement = "roller", pressure = "sealed" }}
right = {{ displacement = "roller", pressure = "sealed" }}
top = {{ displacement = "free", pressure = "{top}" }}
[loads.wave]
boundary = "top"
kind = "traction"
direction = [0.0, -1.0]
pulse = {{ shape = "triangle", peak = 1e5, duration = 0.15 }}
[time]
end = 1
[probes.top]
at = [0.5, 15.0]
"""


# scene, rule, case, settings with which the rule leaves something out, settings that overrule the rule
STUDIES = [
    ("fig2b prototype", "inertial flow in sand", PROTOTYPE, {}, {"regions.seabed.flow": '"inertial"'}),
    ("fig2b prototype", "the sea (told by the user, not by itself)", PROTOTYPE, NO_SEA, {}),
    ("prototype, 0.3 s", "compression of the sea", pulse(0.3, 1), {},
     {f"regions.{sea}.compressibility": '"compressible"' for sea in ("sea_front", "sea_back")}),
    ("prototype, concrete", "deformation of the caisson", concrete_caisson(), {},
     {"regions.caisson.deformation": '"elastic"'}),
    ("prototype, 24 s, no sea", "pores of the mound", pulse(24, 30), {**NO_SEA},
     {**NO_SEA, "regions.mound.flow": '"inertial"'}),
    ("fig2b prototype, 6 s", "the end with little energy", PROTOTYPE, {"time.end": "6", "time.stop_at_energy": "0.3"},
     {"time.end": "6"}),
    ("fig2b prototype, steps of 5 ms", "fields every 20 ms", PROTOTYPE, {"time.step": "0.005"},
     {"time.step": "0.005", "output.fields.every": "0.02"}),
    ("dry scene", "cells out of reach", dry(), {**NO_SEA}, {**NO_SEA, "mesh.full_domain": "true"}),
    ("column of sand", "inertial flow", COLUMN.format(k="1e-4", top="open"), {}, {"regions.soil.flow": '"inertial"'}),
    ("undrained column", "inertial flow", COLUMN.format(k="1e-9", top="sealed"), {}, {"regions.soil.flow": '"inertial"'}),
]


def run(program, case, overrides):
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "case.toml"
        path.write_text(case)
        sets = [part for key, value in {**MARCHED, **overrides}.items() for part in ("--set", f"{key}={value}")]
        begin = processor_time()
        done = subprocess.run([program, "run", path, "--json", "--out", Path(folder) / "out", *sets], text=True,
                              capture_output=True, env=environment)
        seconds = processor_time() - begin
    if done.returncode:
        sys.exit(done.stderr)
    return {**json.loads(done.stdout), "seconds": seconds}


def processor_time():
    """Of all children so far (s)."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def start(program):
    """Median of the seconds that a start takes."""
    times = [processor_time()]
    for _ in range(9):
        subprocess.run([program + "-solver", "--version"], stdout=subprocess.DEVNULL, check=True)
        times.append(processor_time())
    return statistics.median(b - a for a, b in zip(times, times[1:]))


def peak(summary):
    return summary["response"]["peak_shear"] if summary["response"] else None


def row(program, began, scene, rule, case, without, with_it):
    pairs = [(run(program, case, without), run(program, case, with_it)) for _ in range(REPEATS)]
    a, b = pairs[0]
    times = [statistics.median(pair[i]["seconds"] for pair in pairs) - began for i in (0, 1)]
    moved = f"{abs(peak(a) / peak(b) - 1):.1e}" if peak(a) else "no caisson"
    d = [summary["discretisation"] for summary in (a, b)]
    return (f"| {scene} | {rule} | {d[1]['unknowns']} -> {d[0]['unknowns']} | {d[1]['solves']} -> {d[0]['solves']} | "
            f"{times[1]:.2f} -> {times[0]:.2f} | {moved} |")


def main():
    program = str(Path(sys.argv[1]).resolve())
    lines = ["| scene | left out | unknowns | solves | seconds | peak F_T moves by |", "|---|---|---:|---:|---:|---:|"]
    began = start(program)
    for study in STUDIES:
        lines.append(row(program, began, *study))
        print(lines[-1], flush=True)
    if len(sys.argv) > 2:
        page = Path(sys.argv[2])
        head, _, rest = page.read_text().partition("<!-- table -->\n")
        tail = rest.partition("<!-- end of table -->")[2]
        page.write_text(head + "<!-- table -->\n" + "\n".join(lines) + "\n<!-- end of table -->" + tail)


if __name__ == "__main__":
    main()
