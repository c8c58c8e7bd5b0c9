#!/usr/bin/python3
"""What both cores do during a run: how many threads want a core at each time, and the stages that the run tells.

usage: cores.py PROGRAM CASE... [--set KEY=VALUE ...] [-o FIGURE]

A thread wants a core while it runs or waits for one, by /proc/PID/task/*/schedstat, so that other load on the machine
moves the picture little but for its length: the abscissa is the processor time of the busiest thread. Prints for each
case the processor time of the run, the share of it in which a second core was used, and the time that all cores but
one would have spared. BLAS has one thread.
"""

import argparse
import json
import os
import pathlib
import subprocess
import tempfile
import time

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

EVERY = 10e-3  # s between two looks, longer than a tick of the clock that counts
STAGES = ("mesh", "compile", "factorise", "march", "output")
ENVIRONMENT = {**{name: value for name, value in os.environ.items() if name != "OMP_NUM_THREADS"}, "OPENBLAS_NUM_THREADS": "1"}


def family(pid):
    """A process and all that it has started."""
    found = [pid]
    for task in pathlib.Path(f"/proc/{pid}/task").glob("*/children"):
        for child in task.read_text().split():
            found += family(int(child))
    return found


def wanted(pid):
    """{thread: (seconds on a core, seconds on or waiting for one)}"""
    found = {}
    for process in family(pid):
        for path in pathlib.Path(f"/proc/{process}/task").glob("*/schedstat"):
            on, waiting, _ = map(int, path.read_text().split())
            found[path.parent.name] = (on / 1e9, (on + waiting) / 1e9)
    return found


def watch(process):
    """Rows of (seconds between two looks, threads that wanted a core, work on all cores)."""
    rows, before, then = [], {}, time.perf_counter()
    while process.poll() is None:
        time.sleep(EVERY)
        try:
            now = wanted(process.pid)
        except (FileNotFoundError, ProcessLookupError):
            continue
        at = time.perf_counter()
        change = [(on - before.get(thread, (0, 0))[0], want - before.get(thread, (0, 0))[1])
                  for thread, (on, want) in now.items()]
        rows.append((at - then, sum(min(want, at - then) for _, want in change) / (at - then), sum(on for on, _ in change)))
        before, then = now, at
    return rows


def traced(program, case, settings):
    with tempfile.TemporaryDirectory() as folder:
        words = [part for setting in settings for part in ("--set", setting)]
        with open(pathlib.Path(folder) / "summary", "w+") as told:
            process = subprocess.Popen([program, "run", case, *words, "--json", "--out", f"{folder}/out"], stdout=told,
                                       stderr=subprocess.DEVNULL, env=ENVIRONMENT)
            rows = watch(process)
            told.seek(0)
            return rows, json.load(told)["timing"]


def spared(rows):
    """Work of all threads, and the time of a run in which each thread that wants a core has one."""
    work = sum(on for _, _, on in rows)
    length = sum(on / max(1.0, threads) for _, threads, on in rows)
    return work, length


def draw(found, path):
    figure, axes = plt.subplots(len(found), 1, figsize=(9, 2 * len(found)), squeeze=False)
    for ax, (title, (rows, timing)) in zip(axes.flat, found.items()):
        begin, times, threads = 0.0, [], []
        for _, wanting, on in rows:
            times.append(begin)
            threads.append(wanting)
            begin += on / max(1.0, wanting)
        ax.fill_between(times, threads, step="post", color="C0", alpha=0.6, linewidth=0)
        ax.axhline(1, color="k", linewidth=0.8, alpha=0.4)
        ax.set_ylim(0, max(2.2, *threads))
        ax.set_xlim(0, begin)
        ax.set_ylabel("threads")
        stages = ", ".join(f"{stage} {timing[stage]:.2f}" for stage in STAGES if stage in timing)
        ax.set_title(f"{title} (s, as told on a shared machine: {stages})", fontsize="small")
    axes[-1, 0].set_xlabel("time of a run that has all the cores it wants (s)")
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("cases", nargs="+", type=pathlib.Path)
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("cores.png"))
    arguments = parser.parse_args()
    found = {}
    for case in arguments.cases:
        found[case.stem] = traced(arguments.program.resolve(), case, arguments.set)
        work, length = spared(found[case.stem][0])
        print(f"{case.stem}: {work:.2f} s of work, {length:.2f} s with all cores it wants, two used in {work / length - 1:.0%}")
    draw(found, arguments.output)


if __name__ == "__main__":
    main()
