"""What a wheel contains beside the Python package: the program as `cmake --install` puts it, without what Python has
already, and on request the libraries that it is linked with."""

import re
import shutil
import subprocess
from pathlib import Path

PROGRAMS = ("upbead", "upbead-solver", "upbead-reliability")
# of the system, on which every manylinux wheel stands, too: the C library, the dynamic linker, the C++ library and the kernel's
OF_THE_SYSTEM = re.compile(r"^(lib(c|m|dl|rt|pthread|resolv|util|stdc\+\+|gcc_s)\.so\.\d+|ld-linux.*|linux-vdso.*)$")


def install(build, target, bundle):
    """Installs the program of a build folder below `target`."""
    shutil.rmtree(target, ignore_errors=True)
    subprocess.run(["cmake", "--install", build, "--prefix", target, "--component", "program", "--strip"], check=True,
                   stdout=subprocess.DEVNULL)
    for left in ("share/upbead/postprocess", "share/man", "share/bash-completion", "share/upbead/docs"):
        shutil.rmtree(target / left, ignore_errors=True)
    docs = Path(__file__).resolve().parents[1] / "docs"
    (target / "share/upbead/docs/reference").mkdir(parents=True)
    for page in ("reference/case.md", "reference/design.md"):  # from their tables a report has the meaning of keys
        shutil.copy(docs / page, target / "share/upbead/docs" / page)
    if bundle:
        add_libraries(target)


def add_libraries(target):
    """Copies every library that the programs load, and of Open MPI the parts that it opens by itself; upbead.program tells
    both where they are."""
    folder = target / "lib"
    folder.mkdir(exist_ok=True)
    found = dict(pair for name in PROGRAMS for pair in libraries(target / "bin" / name))
    for name, path in sorted(found.items()):
        copy(path, folder / name)  # a link becomes the file
    if "libmpi.so.40" in found:
        add_parts_of_mpi(found, folder / "openmpi")


def add_parts_of_mpi(found, prefix):
    """Those whose libraries are there already: others are for networks, and Open MPI goes on without them."""
    system = next(folder for folder in found["libmpi.so.40"].resolve().parents if (folder / "openmpi/lib").is_dir())
    for inside in ("openmpi/lib/openmpi3", "pmix2/lib/pmix"):
        to = prefix / "lib" / system.name / inside
        to.mkdir(parents=True)
        for part in sorted((system / inside).glob("*.so")):
            if {name for name, _ in libraries(part)} <= set(found) and "not found" not in told_by_ldd(part):
                copy(part, to / part.name)
    shutil.copytree("/usr/share/openmpi", prefix / "share/openmpi")  # its messages


def copy(path, to):
    shutil.copy(path, to)
    subprocess.run(["strip", "--strip-unneeded", to], check=False, stderr=subprocess.DEVNULL)


def told_by_ldd(program):
    return subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout


def libraries(program):
    """[(name, path)] of what the dynamic linker would load."""
    found = [(line.split()[0], Path(line.split()[2])) for line in told_by_ldd(program).splitlines() if " => /" in line]
    return [(name, path) for name, path in found if not OF_THE_SYSTEM.match(name)]
