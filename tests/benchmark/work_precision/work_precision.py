#!/usr/bin/python3
"""Error of F_T against work: upbead's meshes, degrees, schemes and steps, and its peers on the same scene.

usage: work_precision.py PROGRAM [--peers [--lean PROGRAM]] [--only STUDY ...] [--quick] [--processor-time] [-o FOLDER]

Writes FOLDER/work_precision.{json,md,png} and, with --peers, FOLDER/peers.png. Times are of whole processes from fork
to exit on one core, medians of three (runs above 1.5 s once); compare them as ratios. Errors are relative to the peak
of the reference: of the peak itself, and the largest of the whole history. --quick takes fewer points, once each.
--processor-time counts the seconds on the core instead, which other load on the machine disturbs less. The peers are
FEniCSx and FreeFEM; ./bootstrap peers installs them. --lean: the same runs by a program with its libraries inside.
"""

import argparse
import json
import os
import pathlib
import tempfile

import compare
import draw
import front
import peer_jobs
import run
import scenes
import table

QUICK = slice(None, None, 3)


def reference_of(program, study):
    if isinstance(study.reference, run.History):
        return study.reference, "Errors against the exact solution."
    found = run.upbead(program, study.case, study.reference, 1, study.reading)
    return found, (f"Errors against a run with {found.unknowns} unknowns and {found.solves} solves; "
                   f"its peak is {found.peak:.6g}.")


def thinned(jobs, quick):
    """Every third job of each series."""
    if not quick:
        return jobs
    series = {}
    for job in jobs:
        series.setdefault(job.series, []).append(job)
    return [job for of_series in series.values() for job in of_series[QUICK]]


def run_study(program, study, quick):
    reference, against = reference_of(program, study)
    found = {"name": study.name, "title": study.title, "against": against, "rows": [], "failed": []}
    for job in thinned(study.jobs, quick):
        add(found, job, reference, lambda repeats, job=job: run.upbead(
            program, study.case, job.settings, repeats, study.reading), quick)
    return found, reference


def add(study, job, reference, runs, quick):
    """Adds a row; a run that fails is reported and adds none."""
    try:
        found = runs(1 if quick else 3)
    except run.Failed as error:
        study["failed"].append(f"{job.series}, {job.label}: {str(error).splitlines()[-1]}")
        print(error, flush=True)
        return
    study["rows"].append(found.row(job, reference))
    print(f"{study['name']:10} {job.series}, {job.label}: {found.wall:.2f} s", flush=True)


def run_peers(program, lean, quick):
    study, reference = run_study(program, scenes.beside_peers(), quick)
    if lean is not None:
        for job in thinned(scenes.beside_peers(compare.LEAN).jobs, quick):
            add(study, job, reference, lambda repeats, job=job: run.upbead(
                lean, scenes.PEER_SCENE, job.settings, repeats), quick)
    with tempfile.TemporaryDirectory() as folder:
        jobs = peer_jobs.jobs(folder, quick)
        compiled = peer_jobs.warm_up(folder)
        for job in jobs:
            add(study, job, reference, job.run, quick)
    return study, peer_jobs.floors(program, lean), compiled


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--peers", action="store_true", help="run FEniCSx and FreeFEM too")
    parser.add_argument("--lean", type=pathlib.Path, metavar="PROGRAM", help="with --peers: the lean package's program, too")
    parser.add_argument("--only", nargs="*", metavar="STUDY",
                        help="these studies alone, by their names in the JSON; none: the peers alone")
    parser.add_argument("--quick", action="store_true", help="fewer points, once each")
    parser.add_argument("--processor-time", action="store_true", help="instead of the time from fork to exit")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("results/work_precision"))
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    if arguments.processor_time:
        run.clock = run.processor_time
    os.environ.setdefault("UPBEAD_MESHES", str(scenes.ROOT / "meshes"))
    wanted = [study for study in scenes.upbead_alone() if arguments.only is None or study.name in arguments.only]
    results = {"studies": []}
    for study in wanted:  # each result is written at once, as the last studies take minutes
        results["studies"].append(run_study(program, study, arguments.quick)[0])
        front.mark(results["studies"][-1]["rows"])
        write(results, arguments.output)
    if arguments.peers:
        study, results["floors"], results["fenicsx_forms"] = run_peers(
            program, arguments.lean and arguments.lean.resolve(), arguments.quick)
        results["studies"].append(study)
        results["comparison"] = compare.comparison(study["rows"], results["floors"])
        front.mark(study["rows"])
        write(results, arguments.output)
    print(table.page(results))


def write(results, folder):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "work_precision.json").write_text(json.dumps(results, indent=1))
    (folder / "work_precision.md").write_text(table.page(results))
    alone = [study for study in results["studies"] if study["name"] != "peers"]
    if alone:
        draw.draw_studies(alone, folder / "work_precision.png")
    if "comparison" in results:
        draw.draw_peers(results["studies"][-1], results["floors"], folder / "peers.png")


if __name__ == "__main__":
    main()
