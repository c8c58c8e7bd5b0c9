"""Finds and calls the program."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from .errors import CaseError, NumericsError, UpbeadError, UserError
from .places import WHEEL
from .toml import toml_value

ROOT = Path(__file__).resolve().parents[2]
INSIDE = WHEEL / "bin/upbead"  # of a wheel
BESIDE = ROOT / "build/upbead"  # in a source tree
INSTALLED = ROOT / "../../bin/upbead"  # from share/upbead of an installation, see docs/install.md


def find(program: str | PathLike[str] | None = None) -> str:
    """The program's path.

    The given path; else $UPBEAD; else that of the wheel; else build/upbead beside this package; else the program of the
    same installation; else `upbead` on the PATH.
    """
    places: list[tuple[str, Any]] = [("argument 'program'", program)] if program else [
        ("environment variable UPBEAD", os.environ.get("UPBEAD")),
        ("inside the wheel", INSIDE),
        ("beside the package", BESIDE),
        ("of the same installation", INSTALLED),
        ("PATH", "upbead"),
    ]
    tried = []
    for name, place in places:
        found = shutil.which(str(place)) if place else None
        if found and not is_this_package(found):
            return str(Path(found).resolve())
        tried.append(f"{name}: {place or 'not set'}")
    raise UserError("the program 'upbead' was not found; tried\n  " + "\n  ".join(tried))


def is_this_package(found: str) -> bool:
    """Whether a command is that of a wheel, which would call itself: scripts.command."""
    with open(found, "rb") as file:
        return file.read(2) == b"#!" and b"upbead.scripts.command" in file.read(2000)


def environment(program: str) -> dict[str, str]:
    """The variables for the program: that of a wheel finds its libraries beside it, and Open MPI its parts."""
    libraries = WHEEL / "lib"
    if Path(program).parent != INSIDE.parent or not libraries.is_dir():
        return dict(os.environ)
    found = os.pathsep.join(filter(None, (str(libraries), os.environ.get("LD_LIBRARY_PATH"))))
    mpi = libraries / "openmpi"
    parts = dict.fromkeys(("OPAL_PREFIX", "PMIX_INSTALL_PREFIX"), str(mpi)) if mpi.is_dir() else {}
    return {**os.environ, "LD_LIBRARY_PATH": found, **parts}


def settings(values: Mapping[str, Any] | None) -> list[str]:
    """["--set", "key=value", ...]"""
    return [word for key, value in (values or {}).items() for word in ("--set", f"{key}={toml_value(value)}")]


def call(arguments: Iterable[Any], program: str | PathLike[str] | None = None, variables: Mapping[str, str] | None = None) -> str:
    """Runs the program without showing its progress, with more variables of the environment; raises CaseError or NumericsError with its
    own text."""
    command, words = find(program), list(map(str, arguments))
    done = subprocess.run([command, *words], capture_output=True, text=True, check=False, env={**environment(command), **(variables or {})})
    if done.returncode == 0:
        return done.stdout
    text = done.stderr.strip() or done.stdout.strip()
    if done.returncode == 1:
        raise CaseError(text)
    if done.returncode == 2:
        raise NumericsError(text)
    raise UpbeadError(f"upbead {words[0]} ended with exit code {done.returncode}\n{text}")
