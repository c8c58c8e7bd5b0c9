#!/usr/bin/python3
"""What 10^5 sections of a coast cost: 1,000 of them are computed here in parts, as a Slurm array does it; their processor
time and bytes are scaled, and the queue of a cluster is simulated.

usage: coast.py PROGRAM [--sections 1000] [--parts 20] [--jobs 2] [--folder DIR]
       coast.py --seconds CSV      the simulation alone, by the seconds of each run of an earlier coast.csv

With --folder it goes on where it was stopped. Writes coast.csv (processor seconds and bytes of each part).
"""

import argparse
import csv
import heapq
import json
import math
import os
import pathlib
import statistics
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

import numpy as np

STUDY = pathlib.Path(__file__).with_suffix(".toml").resolve()
COAST = 100_000  # sections
START = 0.35  # s of a process, whatever it computes


def part(arguments, folder, k):
    """(processor seconds, bytes of the journal) of one part; nan seconds of one that an earlier call had begun."""
    command = [arguments.program.resolve(), "study", STUDY, "--set", f"n={arguments.sections}", "--part", f"{k}/{arguments.parts}",
               "--jobs", "1", "--json", "--out", folder]
    process = subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                               env={**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"})
    told = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 2):
        raise SystemExit(f"part {k} ended with {os.waitstatus_to_exitcode(status)}")
    journal = sum(path.stat().st_size for path in (folder / "journal").glob(f"*part-{k}-of-*"))
    return math.nan if json.loads(told)["resumed"] else used.ru_utime + used.ru_stime, journal


def measured(arguments, folder):
    with ThreadPoolExecutor(arguments.jobs) as pool:
        parts = list(pool.map(lambda k: part(arguments, folder, k), range(1, arguments.parts + 1)))
    subprocess.run([arguments.program.resolve(), "study", STUDY, "--set", f"n={arguments.sections}", "--merge", "--out", folder],
                   check=True, stdout=subprocess.DEVNULL)
    with open("coast.csv", "w", newline="") as file:
        csv.writer(file).writerows([("processor_seconds", "bytes"), *parts])
    tables = sum((folder / name).stat().st_size for name in ("study.csv", "study.h5", "summary.json"))
    with open(folder / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    failed = sum(row["status"] != "done" for row in rows)
    unknowns = sorted(int(row["discretisation.unknowns"]) for row in rows if row["discretisation.unknowns"])
    size = arguments.sections / arguments.parts
    costs = [seconds / size for seconds, _ in parts if math.isfinite(seconds)]
    each = statistics.mean(costs)
    stored = (sum(size for _, size in parts) + tables) / arguments.sections
    print(f"{arguments.sections} sections in {arguments.parts} parts, {failed} failed; unknowns {unknowns[0]} to {unknowns[-1]}, "
          f"median {unknowns[len(unknowns) // 2]}")
    print(f"a section: {each:.2f} s of processor time (by {len(costs)} parts, {min(costs):.2f} to {max(costs):.2f}), {stored:.0f} bytes in journals and tables")
    print(f"{COAST:,} sections: {each * COAST / 3600:.1f} h of one core, {stored * COAST / 1e6:.0f} MB")
    return costs


def makespan(tasks, cores, load, longest, seed):
    """Hours until an array of tasks (s) is done on a first-come cluster, a share `load` of whose cores other people's jobs of
    one core keep busy (exponential durations, mean an hour, in the queue before us as far as they came earlier); a task that
    exceeds `longest` is killed and submitted again, from where its journal ends."""
    rng, hour = np.random.default_rng(seed), 3600.0
    free = [0.0] * cores
    for core in range(int(load * cores)):
        free[core] = rng.exponential(hour)
    heapq.heapify(free)
    arrivals = np.cumsum(rng.exponential(hour / max(load * cores, 1e-9), size=int(50 * load * cores) + 1))
    queue = [(0.0, seconds, True) for seconds in tasks] + [(at, rng.exponential(hour), False) for at in arrivals]
    heapq.heapify(queue)
    ours, end = len(tasks), 0.0
    while ours:
        come, seconds, is_ours = heapq.heappop(queue)
        begin = max(come, heapq.heappop(free))
        ran = min(seconds, longest)
        heapq.heappush(free, begin + ran)
        if is_ours and seconds > longest:
            heapq.heappush(queue, (begin + ran, seconds - ran + START, True))
        elif is_ours:
            ours, end = ours - 1, max(end, begin + ran)
    return end / hour


def simulated(each):
    """Sections of the coast, drawn from the parts that were measured, in arrays of 100 to 10,000 tasks."""
    rng = np.random.default_rng(1)
    print("\n| cores | busy | tasks | hours, median of 20 (least, largest) | of the ideal |\n|---:|---:|---:|---:|---:|")
    for cores in (64, 1024):
        for load in (0.0, 0.9):
            for tasks in (100, 1000, 10_000):
                size = COAST // tasks
                hours = [makespan(START + size * rng.choice(each, tasks), cores, load, 24 * 3600, seed) for seed in range(20)]
                ideal = COAST * statistics.mean(each) / cores / 3600
                print(f"| {cores} | {100 * load:.0f} % | {tasks:,} | {statistics.median(hours):.2f} ({min(hours):.2f}, {max(hours):.2f}) | "
                      f"{statistics.median(hours) / ideal:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, nargs="?")
    parser.add_argument("--sections", type=int, default=1000)
    parser.add_argument("--parts", type=int, default=20)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--seconds", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.seconds:
        with open(arguments.seconds, newline="") as file:
            parts = [float(row["processor_seconds"]) for row in csv.DictReader(file)]
        each = [seconds / (arguments.sections / len(parts)) for seconds in parts if math.isfinite(seconds)]
    elif arguments.folder:
        each = measured(arguments, arguments.folder)
    else:
        with tempfile.TemporaryDirectory() as folder:
            each = measured(arguments, pathlib.Path(folder))
    simulated(each)


if __name__ == "__main__":
    main()
