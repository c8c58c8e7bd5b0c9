#!/usr/bin/python3
"""Runs the fuzz targets under address and undefined-behaviour sanitizers (clang), one after the other, and writes the
result to docs/reliability/fuzzing.json if all have run.

    tests/fuzz/run.py                    10^6 executions or 15 minutes each
    tests/fuzz/run.py --seconds 7200     longer, without a limit on the number of executions
    tests/fuzz/run.py --keep             also keeps the corpus that was found, minimised, in tests/fuzz/corpus

An input that breaks a target is left in BUILD/findings. A finding ends its target; repair the cause, add a test of
its name, and run again."""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
FUZZ = ROOT / "tests" / "fuzz"
FACTS = ROOT / "docs" / "reliability" / "fuzzing.json"
EXECUTIONS, SECONDS = 10**6, 900
MOST_KEPT = 60  # inputs of a target

# name: (input, longest input that a mutation makes (bytes), most bytes to keep in the corpus)
TARGETS = {
    "case": ("case file (TOML)", 6000, 60000),
    "design": ("design file (TOML)", 4000, 40000),
    "flow": ("output of CFD programs: OpenFOAM, DualSPHysics, Proteus, SWASH", 1500, 30000),
    "forces": ("forces.dat of OpenFOAM: rows cut, heads at will", 600, 15000),
    "history": ("CSV: histories, uplift, waves", 1000, 30000),
    "script": ("parameters of a .geo", 1000, 20000),
    "groups": (".msh as gmsh accepts: nodes, cells, groups and names at will", 300, 30000),
    "mesh": (".msh byte by byte, through gmsh", 1500, 20000),
    "model": (".h5 reduced model: valid HDF5, objects changed at will", 300, 30000),
    "checkpoint": (".h5 checkpoint: valid HDF5, objects changed at will", 300, 15000),
    "wave_file": (".h5 waves: valid HDF5, objects changed at will", 300, 15000),
    "soil_model": (".h5 model of soils: valid HDF5, objects changed at will", 300, 30000),
    "model_bytes": (".h5 reduced model byte by byte", 40000, 50000),
}
WORDS = {
    "history": ["time", "force", "impact", "slow", ",", ";", "\\x0a", "\\x0d\\x0a", "1e308", "-1e308", "4.9e-324", "nan",
                "inf", "0,0\\x0a", "\\xef\\xbb\\xbf", "#", "+", "0.1", "1e6", "%", "\\x09", "\\x22", " (kPa)", "[ms]", "kN/m2",
                "0,5;1,5\\x0a", "\\x1f\\x8b\\x08"],
    "flow": ["# ", "CofR", "Time", "forces(", "moments(", "pressure", "viscous", "porous", "total_x", "Probe", "Not Found", "(", ")",
             "FACE_DATA", "POINT_DATA", "PosX [m]:", "Press_0 [Pa]", "forcex [N]", "ForceFluid.x [N]", "Part;", "time, p [ 0 0 0]", "TABLE",
             "NOHEADER", "WATL", "DEP", "OUTPUT", "SEC", "-1e+300", "nan", "1e308", "\\x0a", "\\x0d\\x0a", ";", ","],
    "script": ["DefineConstant[", "]", "{", "}", "Name", "Include", "//", "/*", "*/", "\\x22", ";", "=", "Str(", "\\x0a"],
    "mesh": ["$MeshFormat\\x0a", "2.2 0 8", "4.1 0 8", "$EndMeshFormat\\x0a", "$PhysicalNames\\x0a", "$Nodes\\x0a",
             "$Elements\\x0a", "$EndElements\\x0a", "$EndNodes\\x0a", "$Entities\\x0a", "$EndEntities\\x0a",
             "\\x22soil\\x22", "\\x22base\\x22", "nan", "inf", "1e300"],
}
BATCHES = {"mesh": 8000, "groups": 6000}  # executions per process: gmsh does not free 0.1 MB of each
# s: these targets stop gmsh and HDF5 after 5 s of computing, which are 12 s with sanitizers
TIMEOUTS = {"mesh": 60, "model_bytes": 60}
DOCUMENTS = {"case": ["reference/case.md"], "design": ["reference/design.md"]}
NUMBERS = ["inf", "nan", "1e308", "-1e308", "1e-308", "0.0", "-1", "true", "[]", "[[0,1],[1,0]]", "{}", "\\x22\\x22",
           "\\x22auto\\x22", "9223372036854775807", "\\x0a[", "]\\x0a", "1979-05-27"]


def dictionary(name, folder):
    words = set(WORDS.get(name, []))
    for document in DOCUMENTS.get(name, []):
        text = (ROOT / "docs" / document).read_text()
        words.update(re.findall(r"`\[?([a-z_.A-Z]+)\]?`", text))
        words.update(re.findall(r"\b[a-z]+_[a-z_]+\b", text))
        words.update(NUMBERS)
    path = folder / f"{name}.dict"
    path.write_text("".join(f'"{word}"\n' for word in sorted(words)))
    return [f"-dict={path}"] if words else []


def seeds(name, folder):
    """Copies the shipped files into `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    tables = [path for path in (ROOT / "cases").rglob("*.toml")]
    files = {
        "case": [path for path in tables if "[mesh]" in path.read_text()],
        "design": [path for path in tables if "[section]" in path.read_text()],
        "history": [],
        "script": list((ROOT / "meshes").glob("*.geo")),
    }.get(name, [])
    for number, path in enumerate(files):
        (folder / f"{number}").write_bytes(path.read_bytes())
    if name == "case":
        text = (ROOT / "tests" / "support" / "good_case.h").read_text()
        (folder / "every_key").write_text(text.split('R"(')[1].split(')"')[0])
    if name == "history":
        (folder / "triangle").write_text("time,force\n0,0\n0.05,2e6\n0.1,0\n")
        (folder / "two").write_text("time,slow,impact\n0,0,1\n0.1,5,2\n0.2,1,0\n")
    if name == "model_bytes":
        sys.path.insert(0, str(ROOT / "tests" / "support"))
        import hand_made_model
        hand_made_model.write_oscillator(folder / "oscillator")
    if name == "mesh":
        (folder / "unit_cell").write_text(unit_cell())
    return folder


def unit_cell():
    sections = {
        "PhysicalNames": ['1 1 "base"', '1 2 "rest"', '2 1 "soil"'],
        "Nodes": ["1 0 0 0", "2 1 0 0", "3 1 1 0", "4 0 1 0"],
        "Elements": ["1 1 2 1 1 1 2", "2 1 2 2 2 2 3", "3 1 2 2 3 3 4", "4 1 2 2 4 4 1", "5 3 2 1 1 1 2 3 4"],
    }
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + "".join(
        f"${name}\n{len(lines)}\n" + "\n".join(lines) + f"\n$End{name}\n" for name, lines in sections.items())


def environment():
    return dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1",
                ASAN_OPTIONS="detect_leaks=0:malloc_context_size=0:quarantine_size_mb=16:max_allocation_size_mb=2048",
                UBSAN_OPTIONS="print_stacktrace=1:halt_on_error=1")


def build(folder):
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "-G", "Ninja", "-S", ROOT, "-B", folder, "-DCMAKE_CXX_COMPILER=clang++",
                        "-DCMAKE_BUILD_TYPE=Release", "-DUPBEAD_FUZZ=ON"], check=True)
    subprocess.run(["ninja", "-C", folder, "fuzz"], check=True)


def fuzz(name, folder, executions, seconds):
    """Runs one target, in batches if a library keeps memory; returns the sum of the counts."""
    begin, total = time.monotonic(), None
    while True:
        left = int(seconds - (time.monotonic() - begin))
        runs = executions and executions - (total["executions"] if total else 0)
        if name in BATCHES:
            runs = min(BATCHES[name], runs or BATCHES[name])
        batch = fuzz_batch(name, folder, runs, max(left, 1))
        if total:
            batch["executions"] += total["executions"]
            batch["memory"] = max(batch["memory"], total["memory"])
        total = dict(batch, seconds=time.monotonic() - begin)
        done = name not in BATCHES or total["seconds"] > seconds - 2
        if done or total["code"] != 0 or (executions and total["executions"] >= executions):
            return total


def fuzz_batch(name, folder, executions, seconds):
    """Runs one target in one process; returns its counts."""
    longest = TARGETS[name][1]
    corpus, findings = folder / "corpus" / name, folder / "findings" / name
    corpus.mkdir(parents=True, exist_ok=True)
    findings.mkdir(parents=True, exist_ok=True)
    shipped = seeds(name, folder / "seeds" / name)
    kept = FUZZ / "corpus" / name
    command = [folder / "tests" / "fuzz" / f"fuzz_{name}", corpus, shipped] + ([kept] if kept.exists() else [])
    command += [f"-max_total_time={seconds}", f"-max_len={longest}", f"-timeout={TIMEOUTS.get(name, 10)}", "-rss_limit_mb=2048",
                "-print_final_stats=1", "-entropic=0", f"-artifact_prefix={findings}/", "-verbosity=1", *dictionary(name, folder)]
    command += [f"-runs={executions}"] if executions else []
    with open(folder / f"{name}.log", "w") as log:
        run = subprocess.Popen(command, stdout=log, stderr=log, env=environment())
        code = run.wait()
    shutil.rmtree(f"/dev/shm/upbead-fuzz-{run.pid}", ignore_errors=True)  # libFuzzer ends without destructors
    if code == 0:  # the remaining findings broke only the confined copy of the process, as intended
        for path in findings.iterdir():
            path.unlink()
    text = (folder / f"{name}.log").read_text(errors="replace")
    stats = {key: int(value) for key, value in re.findall(r"stat::(\w+):\s+(\d+)", text)}
    edges = re.findall(r"cov: (\d+)", text)
    return {"code": code, "executions": stats.get("number_of_executed_units", 0),
            "memory": stats.get("peak_rss_mb", 0), "edges": int(edges[-1]) if edges else 0}


def keep(name, folder):
    """Minimises the corpus into tests/fuzz/corpus, as far as there is room. Named inputs stay."""
    merged, kept = folder / "merged" / name, FUZZ / "corpus" / name
    merged.mkdir(parents=True, exist_ok=True)
    for path in merged.iterdir():
        path.unlink()
    sources = [kept, folder / "corpus" / name, folder / "seeds" / name]
    subprocess.run([folder / "tests" / "fuzz" / f"fuzz_{name}", "-set_cover_merge=1", "-timeout=10", merged,
                    *[path for path in sources if path.exists()]],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment())
    kept.mkdir(parents=True, exist_ok=True)
    named = {path.name for path in kept.iterdir() if not re.fullmatch(r"[0-9a-f]{40}", path.name)}
    for path in kept.iterdir():
        if path.name not in named:
            path.unlink()
    found = sorted(merged.iterdir(), key=lambda path: path.stat().st_size)
    room = TARGETS[name][2]
    for path in found[:: -(-len(found) // MOST_KEPT)] if found else []:  # inputs of every size
        room -= path.stat().st_size
        if room < 0:
            break
        (kept / path.name).write_bytes(path.read_bytes())


def row(name, result):
    speed = result["executions"] / max(result["seconds"], 1e-9)
    size = [path.stat().st_size for path in (FUZZ / "corpus" / name).glob("*")]
    return {"what": TARGETS[name][0],
            "tried": f"{result['executions']:,} executions in {result['seconds'] / 60:.0f} min ({speed:.0f} a second)",
            "came_out": ("no finding left" if result["code"] == 0 else "a finding, see BUILD/findings") +
                        f"; {result['edges']} branches reached, {result['memory']} MB; {len(size)} inputs kept"}


def found():
    """Inputs that once broke a reader have names in the corpus."""
    names = sorted(path.name.replace("_", " ") for path in (FUZZ / "corpus").glob("*/*")
                   if not re.fullmatch(r"[0-9a-f]{40}", path.name))
    return {"what": "inputs that broke a reader, since mended", "tried": f"{len(names)} kept by name",
            "came_out": ", ".join(names)}


def facts(results, known):
    """The facts for the page: new rows of the targets that have run, the known rows of the others."""
    rows = {row["what"]: row for row in known} | {TARGETS[name][0]: row(name, result) for name, result in results.items()}
    return {
        "title": "Bad input, by machine",
        "text": "libFuzzer feeds mutated files to the readers of the program, built by clang with address and "
                "undefined-behaviour sanitizers. A reader may refuse (InputError) or read; another exception, a report "
                "of a sanitizer, a broken promise about what was read (finite, fitting sizes, the effective file is "
                "read as the same file), 10 s or 2 GB are findings. gmsh and HDF5 themselves break down on damaged files: "
                "they read in a confined process. The inputs kept are replayed with every build "
                "(ctest -R fuzz), and some thousands of random changes of them tried.",
        "command": "tests/fuzz/run.py",
        "figure": None,
        "rows": [rows[what] for what, *_ in TARGETS.values() if what in rows] + [found()],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=int, help=f"for each target (default: {SECONDS} s or {EXECUTIONS} executions)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build-fuzz", help="folder of the build")
    parser.add_argument("--keep", action="store_true", help="keep the minimised corpus")
    parser.add_argument("--as-built", action="store_true", help="do not build again")
    parser.add_argument("targets", nargs="*", help="names (default: all)")
    options = parser.parse_args()
    if not options.as_built:
        build(options.build)
    names = options.targets or list(TARGETS)
    results = {}
    failed = False
    for name in names:
        executions = None if options.seconds else EXECUTIONS
        result = fuzz(name, options.build, executions, options.seconds or SECONDS)
        failed = failed or result["code"] != 0
        if options.keep:
            keep(name, options.build)
        print(name, result, flush=True)
        results[name] = result
        known = json.loads(FACTS.read_text())["rows"] if FACTS.exists() else []
        FACTS.write_text(json.dumps(facts(results, known), indent=1, ensure_ascii=False) + "\n")
    return failed


if __name__ == "__main__":
    sys.exit(main())
