#!/usr/bin/python3
"""How well the error that `respond` states for a wave bounds the true error: the table and the figure of
docs/reduced.md.

usage: wave_errors.py BUILD_FOLDER [--figure FILE] [--waves N]

Random records on different scenes by bench_wave_errors (build that target first). A record counts as bounded if its
true error is at most the estimate plus the error of the reference (its change with twice the step); ratios are of
records whose error exceeds 1e-5 and ten times that of the reference.
"""

import argparse
import json
import pathlib
import statistics
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

CALIBRATING = ("sand", "sea", "undamped")
OTHERS = ("drained", "layers", "absorbing", "elastic caisson", "tall, dry", "slow")
RUNS = ((80, 1.5, 11), (40, 10, 12))  # steps per duration, longest record over the case's end, seed


def measure(program, scene, waves):
    runs = []
    for steps, length, seed in RUNS:
        command = [program, scene, "0.4", str(steps), str(length), str(waves), str(seed)]
        runs.append(json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout))
    return runs


def judge(runs):
    waves = [wave for run in runs for wave in run["waves"]]
    held = [w["error"] <= w["estimate"] + w["truth_error"] for w in waves]
    ratios = [w["estimate"] / w["error"] for w in waves if w["error"] > max(1e-5, 10 * w["truth_error"])]
    beyond = sum(w["error"] > runs[0]["told"] + w["truth_error"] for w in waves)
    return waves, held, ratios, beyond


def row(name, waves, held, ratios, beyond, told, modes):
    share = f"{sum(held)} of {len(held)}"
    return (f"| {name} | {modes} | {told} | {beyond} | {max(w['error'] for w in waves):.1e} | {share} | "
            f"{statistics.median(ratios):.1f} | {min(ratios):.1f} to {max(ratios):.1f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--figure", type=pathlib.Path)
    parser.add_argument("--waves", type=int, default=24, help="records of each kind of run")
    parser.add_argument("--runs", type=pathlib.Path, help="keep what was measured there, or take it from there")
    options = parser.parse_args()
    if options.runs and options.runs.exists():
        measured = json.loads(options.runs.read_text())
    else:
        program = options.build / "tests/benchmark/bench_wave_errors"
        measured = {scene: measure(program, scene, options.waves) for scene in CALIBRATING + OTHERS}
        if options.runs:
            options.runs.write_text(json.dumps(measured))
    print("| scene | modes: model, middle, reference | told of the model | records that exceed that | largest error | "
          "held by `error_estimate` | estimate / error, median | from, to |\n|---|---|---:|---:|---:|---:|---:|---:|")
    everything = {True: [[], [], [], 0], False: [[], [], [], 0]}
    for scene, runs in measured.items():
        waves, held, ratios, beyond = judge(runs)
        print(row(scene, waves, held, ratios, beyond, f"{runs[0]['told']:.1e}", ", ".join(map(str, runs[0]["modes"]))))
        for total, part in zip(everything[scene in CALIBRATING], (waves, held, ratios)):
            total.extend(part)
        everything[scene in CALIBRATING][3] += beyond
    print(row("**all that did not set the factors**", *everything[False], "", ""))
    if options.figure:
        figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
        for calibrating, colour, name in ((False, "C0", "other scenes"), (True, "0.7", "scenes that set the factors")):
            waves = everything[calibrating][0]
            left.loglog([w["error"] for w in waves], [w["estimate"] for w in waves], ".", color=colour, label=name)
        left.axline((1e-4, 1e-4), (1e-2, 1e-2), color="k", linewidth=0.8)
        left.set(xlabel="true error of F_T, over its largest value", ylabel="error_estimate")
        left.legend()
        right.hist(everything[False][2], bins=[0.05 * i for i in range(10, 81)], color="C0")
        right.axvline(1, color="k", linewidth=0.8)
        right.set(xlabel="estimate / error", ylabel="records of other scenes")
        figure.savefig(options.figure, dpi=120)


if __name__ == "__main__":
    main()
