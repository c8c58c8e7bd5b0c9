#!/usr/bin/python3
"""Mutation testing: does a layer's test program notice small mistakes in the layer's formulas?

    tests/mutation/mutate.py sliding waves --count 60 --seed 1    a random sample of each layer's mutants
    tests/mutation/mutate.py sliding --again                       unexplained survivors of the last sample

Each mutant is a change of one place (operators.py). Only its file is compiled. It is linked with the layer's other
files and in front of the layers of build-mutation (preset `mutation`). Then the layer's own tests, without those at
length, run until the first fails. A mutant that survives needs a test, or a reason in equivalent.toml why no test can
see it. The result goes to docs/reliability/mutation.json."""

import argparse
import json
import os
import pathlib
import random
import resource
import shlex
import subprocess
import sys
import tempfile
import tomllib
from concurrent import futures

from operators import mutants

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build-mutation"
FACTS = ROOT / "docs" / "reliability" / "mutation.json"
MEMORY = 3 << 30  # bytes of address space of a test program
PASSED, TOO_LONG = 0, "timed out"
ENVIRONMENT = dict(os.environ, GTEST_FAIL_FAST="1", OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", CCACHE_DISABLE="1")


class Layer:
    """The test program of a layer, and how one of its files is compiled and linked into it."""

    def __init__(self, name, jobs):
        self.name, self.program = name, f"tests/{name}/test_{name}"
        subprocess.run(["cmake", "--build", BUILD, "--target", f"test_{name}", "-j", "2"], check=True, env=ENVIRONMENT)
        told = subprocess.run(["ninja", "-C", BUILD, "-t", "commands", self.program], check=True, capture_output=True, text=True)
        self.link = told.stdout.splitlines()[-1]
        entries = [entry for entry in json.loads((BUILD / "compile_commands.json").read_text())
                   if f"/upbead_{name}.dir/" in entry["command"]]
        self.alone = {entry["file"]: entry for entry in entries}
        self.together = next(entry for entry in entries if "/Unity/" in entry["file"])
        self.files = sorted((ROOT / "src" / name).glob("*.cc"))
        # the build compiles the layer's files together; here each has an object of its own, to be replaced by a mutant
        self.objects = BUILD / "mutation" / name
        self.objects.mkdir(parents=True, exist_ok=True)
        with futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(lambda path: self.compile(path, path.read_text(), self.original(path)), self.files))
        if not self.linked(BUILD / "mutation" / f"test_{name}"):
            raise SystemExit(f"{self.program} cannot be linked from the files of src/{name}")
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        if self.run(BUILD / "mutation" / f"test_{name}", 3600) != PASSED:
            raise SystemExit(f"{self.program} fails without any mutant")
        self.seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

    def all(self):
        return [(mutant, path.read_text()) for path in self.files
                for mutant in mutants(str(path.relative_to(ROOT)), path.read_text())]

    def run(self, program, seconds):
        """PASSED, TOO_LONG, or how the program failed; the limit is processor time, as other processes may use the
        machine."""
        command = ["prlimit", f"--cpu={seconds:.0f}", f"--as={MEMORY}", "--core=0", program, "--gtest_brief=1",
                   "--gtest_filter=-*AtLength*"]
        try:
            with tempfile.TemporaryDirectory() as folder:
                done = subprocess.run(command, cwd=folder, env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                                      stderr=subprocess.DEVNULL, timeout=10 * seconds)
            return TOO_LONG if done.returncode in (-24, -9) else done.returncode  # SIGXCPU, SIGKILL
        except subprocess.TimeoutExpired:
            return TOO_LONG

    def original(self, path):
        """Where the object file of the unchanged file is."""
        return self.objects / (path.stem + ".o")

    def compile(self, path, text, target):
        """Makes the object file of `text` instead of the file at `path`; False if it does not compile."""
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / path.name).write_text(text)
            entry = self.alone.get(str(path), self.together)
            command = shlex.split(entry["command"])
            command[command.index("-o") + 1] = str(target)
            command[command.index(entry["file"])] = path.name
            done = subprocess.run([*command, "-w", "-iquote", path.parent], cwd=folder, env=ENVIRONMENT, capture_output=True)
        return done.returncode == 0

    def linked(self, program, instead=None, mutant=None):
        """Links the test program with the layer's files, one of them replaced; False if that fails."""
        objects = [mutant if path == instead else self.original(path) for path in self.files]
        link = self.link.replace(f" -o {self.program} ", f" {' '.join(map(str, objects))} -o {program} ")
        return subprocess.run(link, shell=True, cwd=BUILD, env=ENVIRONMENT, capture_output=True).returncode == 0

    def verdict(self, mutant, text):
        """stillborn (does not compile), same code (the compiler sees no difference), killed, timed out or survived."""
        path = ROOT / mutant.file
        with tempfile.TemporaryDirectory() as name:
            made, program = pathlib.Path(name) / "mutant.o", pathlib.Path(name) / "test"
            if not self.compile(path, mutant.apply(text), made):
                return "stillborn"
            if made.read_bytes() == self.original(path).read_bytes():
                return "same code"
            if not self.linked(program, path, made):
                return "stillborn"
            ended = self.run(program, 4 * self.seconds + 5)
            return "survived" if ended == PASSED else TOO_LONG if ended == TOO_LONG else "killed"


def explained():
    """Mutants that no test can see: (file, line, becomes) -> why."""
    entries = tomllib.loads((HERE / "equivalent.toml").read_text()).get("mutant", [])
    return {(entry["file"], entry["line"], entry["becomes"]): entry["reason"] for entry in entries}


def key(found):
    return found["file"], found["line"], found["becomes"]


def judged(layer, mutant, text):
    number, line, becomes = mutant.told(text)
    return {"file": mutant.file, "number": number, "kind": mutant.kind, "line": line, "becomes": becomes,
            "verdict": layer.verdict(mutant, text)}


def judge(layer, chosen, jobs):
    """The verdicts of the chosen mutants; survivors are printed as they are found."""
    found = []
    with futures.ThreadPoolExecutor(jobs) as pool:
        for done in futures.as_completed([pool.submit(judged, layer, *one) for one in chosen]):
            one = done.result()
            found.append(one)
            if one["verdict"] in ("survived", TOO_LONG):
                print(f"{one['verdict']}: {one['file']}:{one['number']}: {one['kind']}\n  {one['line']}\n  {one['becomes']}",
                      flush=True)
    return found


def sample(layer, options, path):
    """Judges a new sample or, with --again, the survivors of the last sample."""
    everything = layer.all()
    if options.again:
        state = json.loads(path.read_text())
        reasons = explained()
        due = [one for one in state["mutants"] if one["verdict"] == "survived" and key(one) not in reasons]
        places = {(one["file"], one["number"], one["becomes"]) for one in due}
        chosen = [(m, text) for m, text in everything if (m.file, m.told(text)[0], m.told(text)[2]) in places]
        if len(chosen) != len(due):
            raise SystemExit(f"{layer.name} has changed since its last sample: draw a new one")
        state["mutants"] = [one for one in state["mutants"] if one not in due] + judge(layer, chosen, options.jobs)
    else:
        chosen = random.Random(options.seed).sample(everything, min(options.count, len(everything)))
        state = {"all": len(everything), "seed": options.seed, "mutants": judge(layer, chosen, options.jobs)}
        state["first"] = sum(one["verdict"] == "survived" for one in state["mutants"])
    path.write_text(json.dumps(state, indent=1) + "\n")
    return state


def row(name, state):
    """The layer's line of the page, and the number of its survivors without an explanation."""
    n = {verdict: [one for one in state["mutants"] if one["verdict"] == verdict]
         for verdict in ("stillborn", "same code", "killed", TOO_LONG, "survived")}
    reasons = explained()
    open_ones = [one for one in n["survived"] if key(one) not in reasons]
    alive = len(state["mutants"]) - len(n["stillborn"]) - len(n["same code"])
    came_out = (f"{len(n['killed']) + len(n[TOO_LONG])} killed, {len(n[TOO_LONG])} of them by time; "
                f"{len(n['survived'])} survive: {len(n['survived']) - len(open_ones)} equivalent, with a reason, "
                f"{len(open_ones)} not seen by a test")
    if state["first"] > len(n["survived"]):
        came_out += f"; before the tests that this brought {state['first']} survived"
    tried = (f"{alive} of {state['all']} mutants (seed {state['seed']}); besides {len(n['stillborn'])} that do not compile, "
             f"{len(n['same code'])} that compile to the same code")
    return {"what": name, "tried": tried, "came_out": came_out}, len(open_ones)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layers", nargs="+")
    parser.add_argument("--count", type=int, default=60, help="mutants of a layer")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--again", action="store_true", help="only what survived in the last sample without a reason")
    options = parser.parse_args()
    subprocess.run(["cmake", "--preset", "mutation"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    rows = {one["what"]: one for one in json.loads(FACTS.read_text())["rows"]} if FACTS.exists() else {}
    unexplained = 0
    for name in options.layers:
        rows[name], n = row(name, sample(Layer(name, options.jobs), options, BUILD / f"{name}.json"))
        print(f"{name}: {rows[name]['tried']}: {rows[name]['came_out']}", flush=True)
        unexplained += n
        page = {"title": "Mutation testing",
                "text": "One place of a layer's sources is changed (a relation, a sign, an operator, a constant, min and max, a "
                        "condition negated, a statement left out), and the layer's own unit tests must fail. Tests at "
                        "length, verification and tests of the command line, which see more, did not run. Why a survivor is equivalent stands in "
                        "tests/mutation/equivalent.toml.",
                "command": " ".join(["tests/mutation/mutate.py", *sorted(rows)]), "figure": None,
                "rows": sorted(rows.values(), key=lambda one: one["what"])}
        FACTS.write_text(json.dumps(page, indent=1, ensure_ascii=False) + "\n")
    return unexplained > 0


if __name__ == "__main__":
    sys.exit(main())
