#!/usr/bin/python3
"""Fig. 2b on ground that yields: F_T/P against the peak of P, for model and prototype, with elastic, hysteretic and
Mohr-Coulomb soil.

usage: yielding.py PROGRAM [-o FOLDER] [--factors F...] [--laws LAW...]
       yielding.py --from FOLDER/yielding.json [-o FOLDER]

PROGRAM: upbead. Writes FOLDER/yielding.{json,md,png}; with --from the table and the figure only. The cases are those
of Fig. 2b (G calibrated for elastic ground), phi' of mound 40 and sand 35 degrees, c' = 0, the caisson bonded, under
the measured pulse times a factor. Hysteretic soil starts from k0; its starts virgin and gravity are given as bounds.
Takes a quarter of an hour of one processor.
"""

import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

CASES = pathlib.Path(__file__).parents[2] / "cases"
SCENES = {"prototype": "15", "model": "0.75"}  # height of still water (m)
ANGLES = {"mound": 40, "seabed": 35}  # degrees
LAWS = ["elastic", "hysteretic", "mohr_coulomb"]
FACTORS = [0.1, 0.5, 1.0, 2.0, 4.0, 8.0]
PAPER = {"model": 0.75, "prototype": 0.40}


def case_text(scene, law, factor):
    text = (CASES / f"fig2b-{scene}.toml").read_text()
    for pulse in ("impulse", "slow"):
        text = text.replace(f'"fig2b-{scene}-{pulse}.csv"', f'"{CASES}/fig2b-{scene}-{pulse}.csv"')
    text = text.replace("[loads.impulse]", f"[loads.impulse]\nfactor = {factor}", 1)
    if law == "elastic":
        return text
    for region, angle in ANGLES.items():
        head = f"[regions.{region}]"
        text = text.replace(head, f'{head}\nlaw = "{law}"\nstrength = {{ friction_angle = {angle} }}', 1)
        assert f'law = "{law}"' in text
    return text + f"\n[initial]\nwater_level = {SCENES[scene]}\n"


def answer(program, scene, law, factor):
    """Numbers of a run, or the reason why it failed."""
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "case.toml"
        case.write_text(case_text(scene, law, factor))
        done = subprocess.run([program, "run", str(case), "--out", f"{folder}/out"], capture_output=True, text=True, check=False)
        row = {"scene": scene, "law": law, "factor": factor}
        if done.returncode != 0:
            return row | {"failed": (done.stderr.strip().splitlines() or ["no word"])[-1]}
        summary = json.loads(next(pathlib.Path(folder).rglob("summary.json")).read_text())
    response, sliding, nonlinear = summary["response"], summary["sliding"], summary["nonlinear"]
    return row | {
        "ratio": response["shear_to_force_ratio"],
        "residual": summary["residual"],
        "friction": sliding["sliding_history"],
        "coupled": sliding["sliding_coupled"],
        "bounds": {b["start"]: {"ratio": b["shear_to_force_ratio"], "residual": b["residual"]}
                   for b in (nonlinear or {}).get("bounds", [])},
        "updates_a_stage": nonlinear and nonlinear["iterations"] / nonlinear["stages"],
        "energy_mismatch": response["energy_mismatch"],
        "warnings": [w["name"] for w in summary["warnings"]],
    }


def measure(program, laws, factors):
    tasks = [(scene, law, factor) for scene in SCENES for law in laws for factor in factors]
    rows = [answer(program, *task) for task in tasks]
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return {"rows": rows, "processor_seconds": used.ru_utime + used.ru_stime}


def millimetres(value):
    return "-" if value is None else f"{1e3 * value:.3g}" if abs(value) < 1 else f"{1e3 * value:.0f}"


def cells_of(row):
    if "failed" in row:
        return [f"ended: {row['failed']}", "", "", "", ""]
    residual = row["residual"] or {}
    x, y, turned = (residual.get(key) for key in ("displacement_x", "displacement_y", "rotation"))
    bounds = [row["bounds"][start]["ratio"] for start in ("gravity", "virgin") if start in row["bounds"]]
    ratio = f"{row['ratio']:.3f}" + (f" ({bounds[0]:.3f} to {bounds[1]:.3f})" if len(bounds) == 2 else "")
    moved = {start: b["residual"]["displacement_x"] for start, b in row["bounds"].items()}
    span = f" ({millimetres(moved['virgin'])} to {millimetres(moved['gravity'])})" if len(moved) == 2 else ""
    return [ratio, millimetres(x) + span, millimetres(None if y is None else -y),
            "-" if turned is None else f"{turned:.1e}", millimetres(row["friction"])]


def table(found):
    lines = ["| scene | law | factor of P | F_T/P (bounds) | residual x, mm (bounds) | settlement, mm | tilt, rad | S by eq. (4), mm |",
             "|---|---|---:|---:|---:|---:|---:|---:|"]
    for row in found["rows"]:
        lines.append("| " + " | ".join([row["scene"], row["law"].replace("_", "-"), f"{row['factor']:g}", *cells_of(row)]) + " |")
    return "\n".join(lines) + "\n"


def draw(found, path):
    figure, axes = plt.subplots(1, 3, figsize=(12, 4), layout="constrained")
    colours = {"model": "C1", "prototype": "C0"}
    styles = {"elastic": "--", "hysteretic": "-", "mohr_coulomb": ":"}
    for scene, colour in colours.items():
        axes[0].plot(1, PAPER[scene], "*", color=colour, markersize=13, markeredgecolor="black",
                     label=f"{scene}: paper")
        for law, style in styles.items():
            rows = [r for r in found["rows"] if r["scene"] == scene and r["law"] == law and "failed" not in r]
            if not rows:
                continue
            factors = [r["factor"] for r in rows]
            axes[0].plot(factors, [r["ratio"] for r in rows], style, marker=".", color=colour,
                         label=f"{scene}: {law.replace('_', '-')}")
            bounds = [r["bounds"] for r in rows]
            if all(len(b) == 2 for b in bounds):
                axes[0].fill_between(factors, *([b[s]["ratio"] for b in bounds] for s in ("gravity", "virgin")),
                                     color=colour, alpha=0.15)
            length = 1.0 if scene == "prototype" else 20.0
            if law != "elastic":
                axes[1].plot(factors, [length * abs(r["residual"]["displacement_x"]) for r in rows], style, marker=".",
                             color=colour)
                axes[2].plot(factors, [length * max(-r["residual"]["displacement_y"], 1e-6) for r in rows], style,
                             marker=".", color=colour)
            elif any(r["friction"] for r in rows):
                axes[1].plot(factors, [length * r["friction"] or float("nan") for r in rows], style, marker="s",
                             markersize=4, color=colour)
    for axis, title in zip(axes, ["F_T / P", "residual x; dashed: S by friction alone, elastic", "settlement"]):
        axis.set_xscale("log")
        axis.set_xticks(FACTORS, [f"{f:g}" for f in FACTORS])
        axis.minorticks_off()
        axis.set_xlabel("peak of P over that of Fig. 2b")
        axis.set_title(title, fontsize=10)
        axis.grid(alpha=0.3)
    for axis in axes[1:]:
        axis.set_yscale("log")
        axis.set_ylabel("m, the model's times 20")
    axes[0].set_ylim(0, 0.85)
    axes[0].legend(fontsize=7)
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("yielding"))
    parser.add_argument("--factors", type=float, nargs="+", default=FACTORS)
    parser.add_argument("--laws", nargs="+", choices=LAWS, default=LAWS)
    parser.add_argument("--from", dest="known", type=pathlib.Path)
    arguments = parser.parse_args()
    if (arguments.program is None) == (arguments.known is None):
        parser.error("give PROGRAM, or --from a result")
    arguments.output.mkdir(parents=True, exist_ok=True)
    if arguments.known:
        found = json.loads(arguments.known.read_text())
    else:
        found = measure(arguments.program, arguments.laws, arguments.factors)
        (arguments.output / "yielding.json").write_text(json.dumps(found, indent=1) + "\n")
    (arguments.output / "yielding.md").write_text(table(found))
    draw(found, arguments.output / "yielding.png")
    print(table(found) + f"{found['processor_seconds']:.0f} s of processor time")


if __name__ == "__main__":
    sys.exit(main())
