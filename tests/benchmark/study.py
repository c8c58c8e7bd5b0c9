#!/usr/bin/python3
"""Wall time of a study of 1,000 random scenes of about 4,000 unknowns, on one process and on two.

usage: study.py PROGRAM [-n RUNS]
"""

import argparse
import csv
import json
import pathlib
import statistics
import subprocess
import tempfile

STUDY = pathlib.Path(__file__).resolve().parents[2] / "cases/study/scatter.toml"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("-n", type=int, default=1000)
    arguments = parser.parse_args()
    print("| processes | runs | unknowns (median) | wall (s) | of all runs (s) | longest run (s) |")
    print("|---:|---:|---:|---:|---:|---:|")
    for jobs in (2, 1):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([arguments.program.resolve(), "study", STUDY, "--set", f"n={arguments.n}", "--jobs",
                                   str(jobs), "--out", folder + "/out", "--json"], capture_output=True, text=True, check=True)
            timing = json.loads(done.stdout)["timing"]
            with open(folder + "/out/study.csv", newline="") as file:
                unknowns = statistics.median(int(row["discretisation.unknowns"]) for row in csv.DictReader(file))
        print(f"| {jobs} | {arguments.n} | {unknowns:.0f} | {timing['total']:.1f} | {timing['all_runs']:.1f} | "
              f"{timing['longest_run']:.2f} |", flush=True)


if __name__ == "__main__":
    main()
