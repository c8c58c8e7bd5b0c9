#!/usr/bin/python3
"""Changes of the ratio of peak F_T to peak P by other causes than numerical error: arm, duration, stress exponent,
reading.

usage: spread.py PROGRAM [-o FOLDER]

One assumption of cases/fig2b-{model,prototype}.toml at a time is changed, on meshes for a tolerance of 0.2 %. Writes
FOLDER/spread.{json,md}.
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"
SCALE = 20.0  # of lengths, prototype over model
MODEL_G = {"seabed": 6.57e6, "mound": 10.95e6}  # Pa


class Section:
    """One of the two cases, and its lengths."""

    def __init__(self, name):
        self.name = name
        self.file = CASES / f"fig2b-{name}.toml"
        self.length = 1.0 if name == "prototype" else 1.0 / SCALE
        # m: height of the caisson's bottom above the bed, height of the caisson
        self.foot, self.height = 6.0 * self.length, 16.0 * self.length

    def arm(self, over_height):
        """The shape of a load, linear between bottom and top, whose line of action is at `over_height` of the
        caisson's height."""
        # intensity at the top; 2 - top at the bottom; arm/height = (bottom + 2 top)/(3 * 2)
        top = 6.0 * over_height - 2.0
        return {"loads.impulse.shape": f"[[{self.foot}, {2.0 - top}], [{self.foot + self.height}, {top}]]"}

    def duration(self, factor, folder):
        """The same impulse history, stretched in time."""
        rows = (CASES / f"fig2b-{self.name}-impulse.csv").read_text().splitlines()
        lines = [rows[0]] + [f"{float(t) * factor!r},{p}" for t, p in (row.split(",") for row in rows[1:])]
        path = pathlib.Path(folder) / f"{self.name}-{factor}.csv"
        path.write_text("\n".join(lines) + "\n")
        return {"loads.impulse.history": f'"{path}"'}

    def exponent(self, n):
        """G of the prototype if G of the model grows with the confining stress to the power n; the model is
        unchanged."""
        if self.name == "model":
            return {}
        return {f"regions.{region}.shear_modulus": G * SCALE**n for region, G in MODEL_G.items()}


def run(program, section, settings):
    command = [str(program), "run", str(section.file), "--json"]
    for key, value in {"mesh.refine": "auto", "mesh.degree": 3, "accuracy.tolerance": 0.002,
                       "accuracy.of": "peak", **settings}.items():
        command += ["--set", f"{key}={value}"]
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(command + ["--out", folder], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\n{done.stderr}")
    return json.loads(done.stdout)["response"]


def variations(section, folder):
    yield "as shipped", {}, "peak_shear"
    yield "reading: the paper's P - m x''", {}, "peak_shear_paper"
    yield "reading: the experiment's P + P_water,front - m x''", {}, "peak_shear_experiment"
    yield "P measured on the moving wall", {"loads.impulse.measured_on_wall": "true"}, "peak_shear"
    for part in (0.4, 0.6):
        yield f"arm {part:g} of the height instead of 0.5", section.arm(part), "peak_shear"
    for factor in (0.8, 1.25):
        yield f"duration times {factor:g}", section.duration(factor, folder), "peak_shear"
    for n in (0.4, 0.6):
        yield f"stress exponent {n:g} instead of 0.5", section.exponent(n), "peak_shear"


def measure(program):
    rows = {}
    for name in ("model", "prototype"):
        section = Section(name)
        with tempfile.TemporaryDirectory() as folder:
            for label, settings, reading in variations(section, folder):
                response = run(program, section, settings)
                rows.setdefault(label, {"label": label})[name] = response[reading] / response["peak_force"]
                if label == "as shipped":
                    rows[label][name + "_error"] = response["error_estimate"] * rows[label][name]
    return list(rows.values())


def table(rows):
    shipped = rows[0]
    lines = ["| | model | | prototype | |", "|---|---:|---:|---:|---:|"]
    for row in rows:
        cells = []
        for name in ("model", "prototype"):
            change = row[name] - shipped[name]
            cells += [f"{row[name]:.4f}", f"{change:+.4f}" if row is not shipped else f"± {row[name + '_error']:.4f}"]
        lines.append(f"| {row['label']} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/spread"))
    arguments = parser.parse_args()
    rows = measure(arguments.program)
    arguments.output.mkdir(parents=True, exist_ok=True)
    (arguments.output / "spread.json").write_text(json.dumps(rows, indent=1))
    (arguments.output / "spread.md").write_text(table(rows))
    print(table(rows))


if __name__ == "__main__":
    main()
