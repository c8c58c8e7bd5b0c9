#!/usr/bin/python3
"""clang-tidy and cppcheck over src and include, and valgrind's memcheck on the smallest run. Each must be clean.

    tests/checks/static_analysis.py BUILD                   all three; hours on one core
    tests/checks/static_analysis.py BUILD --only cppcheck   one of tidy, cppcheck, valgrind
    tests/checks/static_analysis.py BUILD --layers base waves   clang-tidy over some layers

BUILD is a complete build by CMake. The presets compile many files as one (CMAKE_UNITY_BUILD), which clang-tidy would
take for one file; so its commands come from BUILD-tidy, configured beside BUILD without that option and never
compiled. clang-tidy analyses only files that have changed since they were clean on any machine
(clang_tidy_clean.json; --fresh: all files). The result goes to docs/reliability/static_analysis.json."""

import argparse
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
from concurrent import futures

CHECKS = pathlib.Path(__file__).resolve().parent
ROOT = CHECKS.parents[1]
CLEAN = CHECKS / "clang_tidy_clean.json"  # keys of the file contents that were clean, kept for later runs
LAYERS = [*sorted(path.name for path in (ROOT / "src").iterdir() if path.is_dir()), "."]
# gcc's own options, and gcc's precompiled headers, which clang cannot read
FOREIGN = re.compile(r" -Winvalid-pch| -include \S*cmake_pch\.hxx| -Wno-maybe-uninitialized")

# a run of a tenth of a second: 7 steps
SMALLEST_CASE = (ROOT / "tests/support/column.toml").read_text() + 'step = 0.02\nscheme = "sdirk4"\n'


def layer_of(path):
    parts = path.relative_to(ROOT / "src").parts
    return parts[0] if len(parts) > 1 else "."


def configured_apart(build):
    """Configures BUILD-tidy: the same sources, each with a compile command of its own."""
    folder = build.resolve().with_name(build.resolve().name + "-tidy")
    subprocess.run(["cmake", "--preset", "release", "-B", folder, "-DCMAKE_UNITY_BUILD=OFF", "-DUPBEAD_TESTS=OFF"], cwd=ROOT,
                   check=True, stdout=subprocess.DEVNULL)
    return folder


def commands_for_clang(build, folder):
    """Writes compile_commands.json without options that clang does not know; returns the sources of src in it."""
    entries = json.loads((build / "compile_commands.json").read_text())
    entries = [dict(entry, command=FOREIGN.sub("", entry["command"])) for entry in entries]
    (folder / "compile_commands.json").write_text(json.dumps(entries))
    files = {path for entry in entries if (path := pathlib.Path(entry["file"])).exists()}
    return sorted(path for path in files if ROOT / "src" in path.parents)


def name_of(path):
    return str(path.relative_to(ROOT))


def key_of(path):
    return hashlib.sha1(((ROOT / ".clang-tidy").read_text() + path.read_text()).encode()).hexdigest()


def findings_of(path, folder):
    """clang-tidy's findings in our own files for this translation unit."""
    done = subprocess.run(["clang-tidy", "-quiet", "-p", folder, path], capture_output=True, text=True)
    told = re.findall(r"^(/.*?):(\d+):\d+: ((?:warning|error): .*)", done.stdout, re.MULTILINE)
    if done.returncode != 0 and not told:
        return [f"{path}: {done.stderr}"]
    # findings in Eigen's headers, whose sizes the analyser cannot know, are left out
    return [f"{where}:{line}: {what}" for where, line, what in told if ROOT in pathlib.Path(where).parents]


def tidy(build, layers, fresh, jobs):
    clean = json.loads(CLEAN.read_text()) if CLEAN.exists() and not fresh else {}
    clean = {name: key for name, key in clean.items() if (ROOT / name).exists()}
    findings = []
    with tempfile.TemporaryDirectory() as folder, futures.ThreadPoolExecutor(jobs) as pool:
        files = commands_for_clang(configured_apart(build), pathlib.Path(folder))
        keys = {path: key_of(path) for path in files}
        due = [path for path in sorted(files, key=lambda file: LAYERS.index(layer_of(file)))
               if clean.get(name_of(path)) != keys[path] and (not layers or layer_of(path) in layers)]
        for path, ours in zip(due, pool.map(lambda path: findings_of(path, folder), due)):
            if ours:
                print("\n".join(ours), flush=True)
                clean.pop(name_of(path), None)
                findings += ours
            else:
                clean[name_of(path)] = keys[path]
                CLEAN.write_text(json.dumps(clean, indent=0, sort_keys=True) + "\n")
    current = [path for path in files if clean.get(name_of(path)) == key_of(path)]  # may have changed since
    print(f"clang-tidy: {len(due)} files looked at, {len(findings)} findings; clean: {len(current)} of {len(files)}")
    checks = subprocess.run(["clang-tidy", "--list-checks", f"--config-file={ROOT / '.clang-tidy'}"],
                            capture_output=True, text=True).stdout.count("\n    ")
    return {"what": "clang-tidy (.clang-tidy)", "tried": f"{len(current)} of {len(files)} source files, {checks} checks",
            "came_out": f"{len(set(findings))} findings"}


def cppcheck():
    begin = time.monotonic()
    done = subprocess.run(
        ["cppcheck", "--enable=warning,performance,portability", "--std=c++17", "--language=c++", "--inline-suppr",
         "--error-exitcode=1", "--quiet", f"--suppressions-list={CHECKS / 'cppcheck.txt'}", "-I", ROOT / "include",
         "-I", ROOT / "src", ROOT / "src"], capture_output=True, text=True)
    findings = re.findall(r"^.*(?:error|warning|performance|portability): .*", done.stderr, re.MULTILINE)
    print(done.stderr, f"cppcheck: {len(findings)} findings in {time.monotonic() - begin:.0f} s")
    n = len(list((ROOT / "src").rglob("*.cc")))
    return {"what": "cppcheck (warning, performance, portability)", "tried": f"{n} source files",
            "came_out": f"{len(findings)} findings"}


def valgrind(build):
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", UPBEAD_MESHES=str(ROOT / "meshes"))
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "smallest.toml"
        case.write_text(SMALLEST_CASE)
        done = subprocess.run(
            ["valgrind", "--leak-check=full", "--show-leak-kinds=definite,possible", "--errors-for-leak-kinds=definite",
             "--error-exitcode=9", "--num-callers=40", "--track-origins=no", f"--suppressions={CHECKS / 'valgrind.supp'}",
             build / "upbead-solver", "run", case, "--out", pathlib.Path(folder) / "results"],
            capture_output=True, text=True, env=environment)
    summary = re.findall(r"ERROR SUMMARY: (\d+) errors.*\(suppressed: (\d+)", done.stderr)
    errors, suppressed = summary[-1] if summary else ("no", "0")
    failed = done.returncode != 0
    print(done.stderr[-20000:] if failed else "", f"valgrind: {errors} errors, {suppressed} suppressed")
    return {"what": "valgrind memcheck on the smallest run",
            "tried": "a column of soil, 7 steps, from the case file to the results",
            "came_out": f"{errors} errors; {suppressed} of other libraries, named in tests/checks/valgrind.supp"}, failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", choices=["tidy", "cppcheck", "valgrind"])
    parser.add_argument("--layers", nargs="+", choices=LAYERS, help="for clang-tidy")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="for clang-tidy")
    parser.add_argument("--fresh", action="store_true", help="look at unchanged files too")
    options = parser.parse_args()
    wanted = [options.only] if options.only else ["cppcheck", "valgrind", "tidy"]
    path = ROOT / "docs" / "reliability" / "static_analysis.json"
    page = json.loads(path.read_text()) if path.exists() else {"rows": []}
    rows = {row["what"]: row for row in page["rows"]}
    failed = False
    for name in wanted:
        if name == "valgrind":
            row, broke = valgrind(options.build)
        else:
            row = tidy(options.build, options.layers, options.fresh, options.jobs) if name == "tidy" else cppcheck()
            broke = not row["came_out"].startswith("0 ")
        rows[row["what"]] = row
        failed = failed or broke
    page = {"title": "Static analysis and memory",
            "text": "clang-tidy and cppcheck look at the sources, valgrind at a run. Every finding in our code was mended; "
                    "what is left out is listed, with the reason, in .clang-tidy, tests/checks/cppcheck.txt and "
                    "tests/checks/valgrind.supp.",
            "command": "tests/checks/static_analysis.py build", "figure": None,
            "rows": sorted(rows.values(), key=lambda row: row["what"])}
    path.parent.mkdir(exist_ok=True)
    path.write_text(json.dumps(page, indent=1, ensure_ascii=False) + "\n")
    return failed


if __name__ == "__main__":
    sys.exit(main())
